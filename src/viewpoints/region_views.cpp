#include "viewpoints/region_views.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "links/cull.h"
#include "links/point_shaft.h"
#include "viewpoints/column_bits.h"

namespace viewcover {
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
    positions_.emplace_back(viewed.region.shape(viewed.region.address(region)), viewed.scene.bounds,
                            viewed.scene.lattice.exponent);
    const Box box = positions_[region].region().bounds();
    for (std::size_t s = 0; s < viewed.scene.surfaces.size(); ++s) {
      if (box.intersects(bounding_box(viewed.scene.surfaces[s].polygon))) {
        view.touching.emplace_back(s);
      }
    }
  }
  add_boxes();
}

/// The links of faces do not do for points inside a box: such a point may look at an element
/// through a face that the element is hidden from, and hidden pairs have no list.
void RegionViews::add_boxes() {
  const std::size_t first = viewed_.region.polygon_count() * viewed_.region.regions_per_part();
  std::vector<std::vector<OccluderId>> lists(views_.size());
  tbb::parallel_for(first, views_.size(),
                    [&](std::size_t region) { lists[region] = add_box(region); });
  for (std::size_t region = first; region < views_.size(); ++region) {
    const auto begin = static_cast<std::uint32_t>(stored_.size());
    for (PartialColumn& partial : views_[region].partial) {
      partial.occluders_begin += begin;
      partial.occluders_end += begin;
    }
    stored_.insert(stored_.end(), lists[region].begin(), lists[region].end());
  }
}

std::vector<OccluderId> RegionViews::add_box(std::size_t region) {
  const Box& box = positions_[region].region().box();
  View& view = views_[region];
  std::vector<OccluderId> list;
  std::optional<SurfaceId> surface;  // the one that `of_surface` is about
  ShaftOccluders of_surface, kept;
  const auto hides_surface = [&](SurfaceId id) {
    const OccluderId place = viewed_.clusters.place(id);
    const std::span<const Point> corners = occluders_.polygon(place);
    const PlanarPolygon whole{ConvexPolygon(corners.begin(), corners.end()),
                              occluders_.plane(place)};
    const ShaftOccluder everything{.node = 0};
    // Between a polygon and a box, as for clusters.
    return cull(Shaft(occluders_, whole, box), {&everything, 1}, kOpenAll, of_surface);
  };
  bool is_hidden = false;
  for_each_bit(viewed_.matrix.bits.row(region), [&](std::size_t column) {
    const SurfaceId owner = viewed_.matrix.elements[column].owner();
    const bool is_same = surface == owner;
    if (!is_same) is_hidden = hides_surface(owner);
    surface = owner;
    // Seen by nothing but a face on a surface, past the edge of which the element comes in front.
    if (is_hidden) return;
    if (cull(Shaft(occluders_, elements_[column], box), of_surface, kOpenAll, kept)) return;
    const auto number = static_cast<std::uint32_t>(column);
    if (kept.empty()) {
      if (is_same && !view.full.empty() &&
          view.full.back().first + view.full.back().count == number) {
        ++view.full.back().count;
      } else {
        view.full.push_back({number, 1});
      }
      return;
    }
    const auto begin = static_cast<std::uint32_t>(list.size());
    for (const ShaftOccluder& occluder : kept) {
      list.emplace_back(viewed_.clusters.nodes()[occluder.node].first);
    }
    view.partial.push_back({number, begin, static_cast<std::uint32_t>(list.size())});
  });
  return list;
}

void RegionViews::add_link(std::size_t index) {
  const Link link = viewed_.links[index];
  if (viewed_.region.is_face(link.region)) return;
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
                       const std::optional<ElementTarget>& target) const {
  PointShaft shaft(occluders_, position, viewed_.matrix.elements[partial.column],
                   elements_[partial.column], viewed_.one_sided);
  if (!shaft.is_facing()) return false;
  PointShaftOccluders kept;
  const auto list = std::span(stored_).subspan(partial.occluders_begin,
                                               partial.occluders_end - partial.occluders_begin);
  if (shaft.cull(list, kept)) return false;
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
  for (const PartialColumn& partial : view.partial) {
    if (!wanted.empty() && !has_column(wanted, partial.column)) continue;
    if (sees(partial, position, target)) add_column(row, partial.column);
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
  const auto occluders = shaft_occluders(region, column);
  const bool is_box = viewed_.region.is_in_box(address);
  for (const PlanarPolygon& face :
       faces_toward(elements_[column].polygon, address, positions_[region].region())) {
    Shaft shaft(occluders_, address, face, viewed_.matrix.elements[column], elements_[column],
                viewed_.one_sided);
    if (!shaft.is_facing()) continue;
    ShaftOccluders kept(occluders.begin(), occluders.end());
    if (is_box && cull(shaft, occluders, kOpenAll, kept)) continue;
    shaft.set_occluders(kept);
    if (auto line = viewed_.backend.find_sight_line(shaft)) return line;
  }
  return std::nullopt;
}

std::vector<PlanarPolygon> RegionViews::faces_toward(std::span<const Point> points,
                                                     RegionAddress address,
                                                     const RegionShape& shape) const {
  if (!shape.is_box()) {
    return {{shape.polygon(), Plane(viewed_.region.parts[address.owner().value])}};
  }
  std::vector<PlanarPolygon> faces;
  for (ConvexPolygon& polygon : shape.faces()) {
    PlanarPolygon face{std::move(polygon), {}};
    face.plane = Plane(face.polygon);
    if (face.has_in_front(points)) faces.push_back(std::move(face));
  }
  return faces;
}

bool RegionViews::cell_sees(const RegionCell& cell, std::size_t column) const {
  return std::ranges::any_of(
      faces_toward(elements_[column].polygon, cell.address, cell.shape),
      [&](const PlanarPolygon& face) { return face_sees(cell, face, column); });
}

bool RegionViews::face_sees(const RegionCell& cell, const PlanarPolygon& face,
                            std::size_t column) const {
  Shaft shaft(occluders_, cell.address, face, viewed_.matrix.elements[column], elements_[column],
              viewed_.one_sided);
  if (!shaft.is_facing()) return false;
  ShaftOccluders kept;
  if (cull(shaft, shaft_occluders(cell.region, column), kOpenAll, kept)) return false;
  if (kept.empty()) return true;
  shaft.set_occluders(kept);
  return is_visible(viewed_.backend.decide(shaft, Effort::kFull));
}

bool RegionViews::cell_sees_place(const RegionCell& cell, const ElementTarget& target) const {
  return std::ranges::any_of(
      faces_toward({&target.place, 1}, cell.address, cell.shape),
      [&](const PlanarPolygon& face) { return face_sees_place(cell, face, target); });
}

bool RegionViews::face_sees_place(const RegionCell& cell, const PlanarPolygon& face,
                                  const ElementTarget& target) const {
  if (std::ranges::none_of(face.polygon,
                           [&](const Point& corner) { return is_facing(target.column, corner); })) {
    return false;
  }
  // Sight lines run both ways: the place looks at the face.
  const RegionAddress address = cell.address;
  PointShaft shaft(
      occluders_, target.place,
      ElementAddress(SurfaceId(address.owner().value), address.level(), address.path()), face,
      false);
  PointShaftOccluders kept;
  if (shaft.cull(stored_occluders(cell.region, target.column), kept)) return false;
  if (kept.empty()) return true;
  shaft.set_occluders(kept);
  return viewed_.backend.sees_part(shaft);
}

}  // namespace viewcover
