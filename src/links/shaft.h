#pragma once

#include <algorithm>
#include <span>

#include "links/occluder_set.h"
#include "scene/address.h"
#include "scene/convex_polygon.h"
#include "scene/plane.h"
#include "scene/small_list.h"

namespace viewcover {

/// A convex planar polygon with its plane: what a shaft joins to another.
struct PlanarPolygon {
  ConvexPolygon polygon;
  Plane plane;

  bool has_in_front(std::span<const Point> points) const {
    return std::ranges::any_of(points, [&](const Point& x) { return plane.side(x) > 0; });
  }
};

/// The convex hull of a viewing region and an element, or of a region and a cluster's box, bounded
/// by planes that support it (Haines and Wallace 1991, with the planes of two polygons in place of
/// those of two boxes).
///
/// An occluder that does not meet the open shaft cannot meet any open sight line; only such
/// occluders are dropped, on the word of exact predicates. Touching the shaft from outside is not
/// meeting it, so neighbours in a mesh and surfaces coplanar with region or element are dropped.
class Shaft {
 public:
  /// The shaft between two polygons. Keeps references to both and to `occluders`.
  Shaft(const OccluderSet& occluders, RegionAddress region_address, const PlanarPolygon& region,
        ElementAddress element_address, const PlanarPolygon& element, bool one_sided);
  /// The shaft between a region and everything in a box; only for culling.
  Shaft(const OccluderSet& occluders, const PlanarPolygon& region, const Box& box);

  const OccluderSet& occluder_set() const { return *occluders_; }
  RegionAddress region_address() const { return region_address_; }
  ElementAddress element_address() const { return element_address_; }
  /// Requires a shaft between two polygons.
  const PlanarPolygon& region() const { return *region_; }
  const PlanarPolygon& element() const { return *element_; }
  bool one_sided() const { return one_sided_; }
  const Box& box() const { return box_; }

  /// Can the region see the element at all, whatever is between? False iff they are coplanar, or
  /// the whole region is behind a one-sided element. Exact.
  bool is_facing() const { return facing_; }
  /// False if part of the region is behind a one-sided element. Exact.
  bool is_wholly_facing() const { return wholly_facing_; }

  /// The occluders left in the shaft, as set by `set_occluders`.
  std::span<const ShaftOccluder> occluders() const { return left_; }
  void set_occluders(std::span<const ShaftOccluder> left) { left_ = left; }

  /// False only if no surface in the box meets the open shaft: by planes, not by bounding box.
  bool may_meet(const Box& box) const;
  /// The same by the shaft's bounding box alone.
  bool box_overlaps(const Box& box) const;

  enum class Meets { kNo, kMaybe, kBlocksAll };
  /// kNo iff the occluder does not meet the open shaft, kBlocksAll only if it alone meets every
  /// sight line; both exact. Between two-sided polygons kBlocksAll is complete too; toward a box
  /// kNo may be missed. `occluder` is a surface; what is found out about its plane is noted in it.
  Meets meets(ShaftOccluder& occluder) const;

 private:
  /// Sides of points to a plane: which of the three occur.
  struct Sides {
    bool front = false, back = false, on = false;
    void add(int side) {
      front |= side > 0;
      back |= side < 0;
      on |= side == 0;
    }
    bool none_off() const { return !front && !back; }
  };
  static Sides sides(const Plane& plane, std::span<const Point> points);

  /// Adds the planes through `base` or an edge of it that have the whole shaft behind them.
  Sides add_support_planes(const PlanarPolygon& base, std::span<const Point> far);
  bool blocks_all(std::span<const Point> occluder, bool region_in_front) const;
  /// Does the shaft pass the occluder outside one of its edges?
  bool passes_outside(std::span<const Point> occluder, const Plane& plane) const;

  const OccluderSet* occluders_;
  const PlanarPolygon* region_ = nullptr;
  const PlanarPolygon* element_ = nullptr;
  RegionAddress region_address_;
  ElementAddress element_address_;
  bool one_sided_ = false;
  bool facing_ = true;
  bool wholly_facing_ = true;
  Box box_;
  SmallList<Point, 8> far_;      // corners of the element or the box
  SmallList<Plane, 12> planes_;  // outside is in front
  std::span<const ShaftOccluder> left_;
};

}  // namespace viewcover
