#include "full_coverage/witnesses.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "scene/polygon_contact.h"
#include "scene/predicates.h"

namespace viewcover {
namespace {

/// Bits of positions on an element, coarse ones first: decisions about them are cheaper.
constexpr int kFewestBits = 4, kMostBits = 20, kMoreBits = 4;
/// Where the middle of a part will not do: so much of the way to a corner.
constexpr double kAside = 0.3;
/// Of the extent of scene and region: what is nearer counts as touching.
constexpr double kContact = 1e-9;

/// Strictly inside, by more than rounding? May say no for points very near the border.
bool is_well_inside(const Point& x, std::span<const Point> polygon) {
  constexpr double kMargin = 1e-9;
  const Point normal = area_vector(polygon);
  const double size = normal.norm();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point &a = polygon[k], edge = polygon[k + 1 < polygon.size() ? k + 1 : 0] - a;
    const double scale = edge.norm() * size;
    if (scale == 0) continue;
    if (edge.cross(x - a).dot(normal) < kMargin * scale * edge.norm()) return false;
  }
  return true;
}

struct Sides {
  bool front = false, back = false;
};

/// A cell of a region, as surfaces and other cells touch it.
struct CellBody {
  std::vector<ConvexPolygon> faces;
  Box bounds;
  bool is_box = false;

  explicit CellBody(const RegionShape& shape)
      : faces(shape.faces()), bounds(shape.bounds()), is_box(shape.is_box()) {}

  Sides sides_of(const Plane& plane) const {
    Sides sides;
    for (const ConvexPolygon& face : faces) {
      for (const Point& corner : face) {
        const int side = plane.side(corner);
        sides.front |= side > 0;
        sides.back |= side < 0;
      }
    }
    return sides;
  }
  /// Of a surface, which does not enter boxes.
  bool is_near(const ConvexPolygon& surface, double distance) const {
    return std::ranges::any_of(
        faces, [&](const ConvexPolygon& face) { return is_nearer_than(face, surface, distance); });
  }
  /// By bounding boxes if one of the two is a box: never no where they meet.
  bool is_near(const CellBody& other, double distance) const {
    if (is_box || other.is_box) return bounds.exteriorDistance(other.bounds) < distance;
    return is_nearer_than(faces.front(), other.faces.front(), distance);
  }
};

}  // namespace

Witnesses::Witnesses(const RegionViews& views)
    : views_(views), segments_(views.occluders()), box_(views.viewed().scene.bounds) {
  const ViewingRegion& region = views.region();
  for (const ConvexPolygon& part : region.parts) box_.extend(bounding_box(part));  // and faces
  contact_ = kContact * box_.sizes().maxCoeff();
  const auto& surfaces = views.viewed().scene.surfaces;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const bool touches = std::ranges::any_of(region.parts, [&](const ConvexPolygon& part) {
      return is_nearer_than(part, surfaces[s].polygon, contact_);
    });
    if (touches) near_region_.emplace_back(s);
  }
}

std::optional<ElementTarget> Witnesses::place_in(std::size_t column,
                                                 std::span<const Point> part) const {
  const Scene& scene = views_.viewed().scene;
  const ElementAddress element = views_.matrix().elements[column];
  const RegionPositions positions(subdivided(scene[element.owner()].polygon, element), box_,
                                  scene.lattice.exponent);
  const auto usable = [&](const Point& x) {
    return is_well_inside(x, part) && !is_on_another_surface({column, x}) &&
           std::ranges::none_of(views_.region().polygons(), [&](const ConvexPolygon& polygon) {
             return orientation(polygon[0], polygon[1], polygon[2], x) == 0;
           });
  };
  // Near the middle, but for what is there; else on the way to a corner.
  const Point middle = centroid(part);
  std::vector<Point> centres{middle};
  for (const Point& corner : part) centres.push_back(middle + kAside * (corner - middle));
  for (const Point& centre : centres) {
    for (int bits = kFewestBits; bits <= std::min(kMostBits, positions.bits()); bits += kMoreBits) {
      const Point place = positions.nearest(centre, bits);
      if (usable(place)) return ElementTarget{column, place};
    }
  }
  return std::nullopt;
}

bool Witnesses::is_on_another_surface(const ElementTarget& place) const {
  const ClusterTree& clusters = views_.viewed().clusters;
  const Scene& scene = views_.viewed().scene;
  const SurfaceId own = views_.matrix().elements[place.column].owner();
  const auto nodes = clusters.nodes();
  std::vector<std::size_t> open{0};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    if (!nodes[at].box.contains(place.place)) continue;
    if (!nodes[at].is_leaf()) {
      open.push_back(nodes[at].right);
      open.push_back(at + 1);
      continue;
    }
    const SurfaceId surface = clusters.surface(OccluderId(nodes[at].first));
    if (surface != own && lies_in(place.place, scene[surface].polygon)) return true;
  }
  return false;
}

std::vector<bool> Witnesses::regions_that_see(const ElementTarget& place) const {
  const ViewingRegion& region = views_.region();
  std::vector<bool> see(region.region_count(), false);
  for (std::size_t i = 0; i < see.size(); ++i) {
    if (!views_.region_sees(i, place.column)) continue;
    see[i] = views_.cell_sees_place({region.address(i), i, views_.positions(i).region()}, place);
  }
  return see;
}

std::size_t Witnesses::add(std::span<const ElementTarget> places) {
  std::vector<std::vector<bool>> regions(places.size());
  tbb::parallel_for(std::size_t{0}, places.size(),
                    [&](std::size_t i) { regions[i] = regions_that_see(places[i]); });
  std::size_t added = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::ranges::find(regions[i], true) == regions[i].end()) continue;
    places_.push_back(places[i]);
    regions_.push_back(std::move(regions[i]));
    ++added;
  }
  return added;
}

// A viewpoint x on a surface, in cells C and D. What it sees along a direction on one side of the
// surface's plane is seen from places of C near x too, if C has places on that side, since the
// surface is all that is near. If only D has, C does not see it, yet x does, and x is in C.
std::vector<std::pair<std::size_t, std::size_t>> Witnesses::lends(
    std::span<const RegionCell> cells) const {
  std::vector<std::pair<std::size_t, std::size_t>> lends;
  if (near_region_.empty()) return lends;
  std::vector<CellBody> bodies;
  for (const RegionCell& cell : cells) bodies.emplace_back(cell.shape);
  const Scene& scene = views_.viewed().scene;
  for (const SurfaceId surface : near_region_) {
    const ConvexPolygon& polygon = scene[surface].polygon;
    const Plane plane(polygon);
    Box box = bounding_box(polygon);
    const Point margin = Point::Constant(contact_);
    box = Box(box.min() - margin, box.max() + margin);
    std::vector<std::size_t> near;
    std::vector<Sides> sides;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!box.intersects(bodies[i].bounds) || !bodies[i].is_near(polygon, contact_)) continue;
      near.push_back(i);
      sides.push_back(bodies[i].sides_of(plane));
    }
    for (std::size_t a = 0; a < near.size(); ++a) {
      for (std::size_t b = 0; b < near.size(); ++b) {
        const bool reaches_farther =
            (sides[b].front && !sides[a].front) || (sides[b].back && !sides[a].back);
        if (reaches_farther && bodies[near[a]].is_near(bodies[near[b]], contact_)) {
          lends.emplace_back(near[a], near[b]);
        }
      }
    }
  }
  std::ranges::sort(lends);
  lends.erase(std::ranges::unique(lends).begin(), lends.end());
  return lends;
}

}  // namespace viewcover
