#include "viewpoints/region_views.h"

#include <algorithm>

#include "links/cull.h"
#include "links/point_shaft.h"
#include "viewpoints/column_bits.h"

namespace viewcover {
namespace {

/// Surfaces tried first, such as walls round a doorway.
constexpr std::size_t kBlockers = 4;

}  // namespace

RegionViews::RegionViews(const ViewedScene& viewed)
    : viewed_(viewed),
      occluders_(viewed.scene, viewed.clusters, viewed.region),
      views_(viewed.matrix.bits.rows()) {
  for (const ElementAddress element : viewed.matrix.elements) {
    elements_.push_back({subdivided(viewed.scene[element.owner()].polygon, element),
                         occluders_.plane(viewed.clusters.place(element.owner()))});
  }
  leaves_.resize(viewed.clusters.size());
  const auto nodes = viewed.clusters.nodes();
  for (ClusterNode node = 0; node < nodes.size(); ++node) {
    if (nodes[node].is_leaf()) leaves_[nodes[node].first] = node;
  }
  for (std::size_t link = 0; link < viewed.links.size(); ++link) add_link(link);
  for (std::size_t region = 0; region < views_.size(); ++region) {
    View& view = views_[region];
    std::ranges::sort(view.partial, {}, &PartialColumn::column);
    positions_.emplace_back(viewed.region.polygon(viewed.region.address(region)),
                            viewed.scene.bounds, viewed.scene.lattice.exponent);
    const Box box = bounding_box(positions_[region].region());
    for (std::size_t s = 0; s < viewed.scene.surfaces.size(); ++s) {
      if (box.intersects(bounding_box(viewed.scene.surfaces[s].polygon))) {
        view.touching.emplace_back(s);
      }
    }
  }
}

void RegionViews::add_link(std::size_t index) {
  const Link link = viewed_.links[index];
  const auto& elements = viewed_.matrix.elements;
  const auto begin = std::lower_bound(elements.begin(), elements.end(), link.element);
  const auto end = std::find_if_not(begin, elements.end(), [&](ElementAddress address) {
    return link.element.contains(address);
  });
  const auto first = static_cast<std::uint32_t>(begin - elements.begin());
  const std::vector<OccluderId> list = viewed_.links.occluders(index);
  const auto stored_begin = static_cast<std::uint32_t>(stored_.size());
  stored_.insert(stored_.end(), list.begin(), list.end());
  const std::size_t first_row = viewed_.region.first_index(link.region);
  for (std::size_t i = 0; i < viewed_.region.index_count(link.region); ++i) {
    View& view = views_[first_row + i];
    const auto count = static_cast<std::uint32_t>(end - begin);
    if (list.empty()) {
      view.full.push_back({first, count});
      continue;
    }
    for (std::uint32_t column = first; column < first + count; ++column) {
      view.partial.push_back({column, stored_begin, static_cast<std::uint32_t>(stored_.size())});
    }
  }
}

bool RegionViews::is_free(std::size_t region, const Point& position) const {
  return std::ranges::none_of(views_[region].touching, [&](SurfaceId surface) {
    return lies_in(position, viewed_.scene[surface].polygon);
  });
}

bool RegionViews::is_facing(std::size_t column, const Point& position) const {
  const int side = elements_[column].plane.side(position);
  return viewed_.one_sided ? side > 0 : side != 0;
}

bool RegionViews::sees(const PartialColumn& partial, const Point& position,
                       const std::optional<ElementTarget>& target, Blockers& blockers) const {
  PointShaft shaft(occluders_, position, viewed_.matrix.elements[partial.column],
                   elements_[partial.column], viewed_.one_sided);
  if (!shaft.is_facing()) return false;
  // What hid the elements before is likely to hide their neighbour.
  for (std::size_t i = 0; i < blockers.size(); ++i) {
    if (shaft.meets(blockers[i]) != PointShaft::Meets::kBlocksAll) continue;
    std::rotate(blockers.begin(), blockers.begin() + static_cast<std::ptrdiff_t>(i),
                blockers.begin() + static_cast<std::ptrdiff_t>(i) + 1);
    return false;
  }
  PointShaftOccluders kept;
  const auto list = std::span(stored_).subspan(partial.occluders_begin,
                                               partial.occluders_end - partial.occluders_begin);
  if (shaft.cull(list, kept)) {
    if (blockers.size() == kBlockers) blockers.pop_back();
    blockers.insert(blockers.begin(), kept[0]);
    return false;
  }
  if (kept.empty()) return true;
  shaft.set_occluders(kept);
  if (target && target->column == partial.column) shaft.set_target(target->place);
  return viewed_.backend.sees_part(shaft);
}

void RegionViews::look(std::size_t region, const Point& position, std::span<BitRows::Word> row,
                       std::span<const BitRows::Word> wanted,
                       const std::optional<ElementTarget>& target) const {
  const View& view = views_[region];
  for (const FullColumns& full : view.full) {
    if (!is_facing(full.first, position)) continue;
    for (std::size_t column = full.first; column < full.first + full.count; ++column) {
      if (wanted.empty() || has_column(wanted, column)) add_column(row, column);
    }
  }
  Blockers blockers;
  for (const PartialColumn& partial : view.partial) {
    if (!wanted.empty() && !has_column(wanted, partial.column)) continue;
    if (sees(partial, position, target, blockers)) add_column(row, partial.column);
  }
}

std::span<const OccluderId> RegionViews::stored_occluders(std::size_t region,
                                                          std::size_t column) const {
  const auto& partial = views_[region].partial;
  const auto found = std::ranges::lower_bound(partial, column, {}, &PartialColumn::column);
  if (found == partial.end() || found->column != column) return {};
  return std::span(stored_).subspan(found->occluders_begin,
                                    found->occluders_end - found->occluders_begin);
}

SmallList<ShaftOccluder, 96> RegionViews::shaft_occluders(std::size_t region,
                                                          std::size_t column) const {
  SmallList<ShaftOccluder, 96> occluders;
  for (const OccluderId occluder : stored_occluders(region, column)) {
    occluders.push_back({.node = leaves_[occluder.value]});
  }
  return occluders;
}

std::optional<SightLine> RegionViews::find_sight_line(std::size_t region,
                                                      std::size_t column) const {
  const RegionAddress address = viewed_.region.address(region);
  const PlanarPolygon planar{positions_[region].region(),
                             Plane(viewed_.region.parts[address.owner().value])};
  Shaft shaft(occluders_, address, planar, viewed_.matrix.elements[column], elements_[column],
              viewed_.one_sided);
  if (!shaft.is_facing()) return std::nullopt;
  const auto occluders = shaft_occluders(region, column);
  shaft.set_occluders(occluders);
  return viewed_.backend.find_sight_line(shaft);
}

bool RegionViews::cell_sees(const RegionCell& cell, std::size_t column) const {
  const PlanarPolygon planar{cell.polygon, Plane(viewed_.region.parts[cell.address.owner().value])};
  Shaft shaft(occluders_, cell.address, planar, viewed_.matrix.elements[column], elements_[column],
              viewed_.one_sided);
  if (!shaft.is_facing()) return false;
  ShaftOccluders kept;
  if (cull(shaft, shaft_occluders(cell.region, column), kOpenAll, kept)) return false;
  if (kept.empty()) return true;
  shaft.set_occluders(kept);
  return is_visible(viewed_.backend.decide(shaft, Effort::kFull));
}

bool RegionViews::cell_sees_place(const RegionCell& cell, const ElementTarget& target) const {
  if (std::ranges::none_of(cell.polygon,
                           [&](const Point& corner) { return is_facing(target.column, corner); })) {
    return false;
  }
  // Sight lines run both ways: the place looks at the cell.
  const RegionAddress address = cell.address;
  const PlanarPolygon planar{cell.polygon, Plane(viewed_.region.parts[address.owner().value])};
  PointShaft shaft(
      occluders_, target.place,
      ElementAddress(SurfaceId(address.owner().value), address.level(), address.path()), planar,
      false);
  PointShaftOccluders kept;
  if (shaft.cull(stored_occluders(cell.region, target.column), kept)) return false;
  if (kept.empty()) return true;
  shaft.set_occluders(kept);
  return viewed_.backend.sees_part(shaft);
}

}  // namespace viewcover
