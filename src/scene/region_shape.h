#pragma once

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "scene/convex_polygon.h"
#include "scene/types.h"

namespace viewcover {

/// The points of a viewing region, or of a node below one: a convex planar polygon, or an
/// axis-parallel box with a volume.
class RegionShape {
 public:
  RegionShape() = default;
  RegionShape(ConvexPolygon polygon) : polygon_(std::move(polygon)) {}
  RegionShape(const Box& box) : box_(box) {}

  bool is_box() const { return box_.has_value(); }
  /// Requires that it is no box.
  const ConvexPolygon& polygon() const { return polygon_; }
  /// Requires is_box().
  const Box& box() const { return *box_; }

  Box bounds() const { return box_ ? *box_ : bounding_box(polygon_); }
  /// Centre of mass, rounded.
  Point middle() const { return box_ ? Point(box_->center()) : centroid(polygon_); }
  /// Of the polygon; of all faces of the box.
  double surface_area() const;
  /// True iff the point, taken exactly, lies in the closed polygon or box. Exact.
  bool contains(const Point& point) const;
  /// The polygons from which, together, all is seen that is seen from here, if the box is free of
  /// surfaces (paper, section 3): the polygon, or the six faces with their fronts inward.
  std::vector<ConvexPolygon> faces() const;
  /// The four nodes below. `quarters` of a polygon; a box is cut in the middle of its longest side,
  /// and the halves again: cells become cubes as far as they can. Of sides of the same length, the
  /// first is cut. Exact, with at most two further bits a coordinate.
  std::array<RegionShape, 4> quarters() const;
  /// For pictures: the polygon, or the rectangle in the middle of the box across its shortest side.
  ConvexPolygon picture() const;

  friend bool operator==(const RegionShape& a, const RegionShape& b) {
    return a.is_box() == b.is_box() &&
           (a.is_box() ? a.box_->min() == b.box_->min() && a.box_->max() == b.box_->max()
                       : a.polygon_ == b.polygon_);
  }

 private:
  ConvexPolygon polygon_;
  std::optional<Box> box_;
};

/// The faces across x, y and z, each at the least and the greatest coordinate, with the front
/// inward.
std::array<ConvexPolygon, 6> box_faces(const Box& box);

/// The node below `root` that `address` names. Cost: one `quarters` a level.
template <class Owner>
RegionShape subdivided(const RegionShape& root, QuadAddress<Owner> address) {
  RegionShape shape = root;
  for (int depth = 0; depth < address.level(); ++depth) {
    shape = shape.quarters()[static_cast<std::size_t>(address.digit(depth))];
  }
  return shape;
}

/// True iff the point, taken exactly, lies in the closed convex planar polygon. Exact.
bool lies_in(const Point& point, std::span<const Point> polygon);

}  // namespace viewcover
