#pragma once

#include "scene/convex_polygon.h"
#include "scene/random_numbers.h"
#include "scene/region_shape.h"

namespace viewcover {

/// The positions for viewpoints in a region: those points of the triangles of its fan whose
/// barycentric coordinates are multiples of 2^-bits(), or of a box those that lie so many shares of
/// each side from its least corner, with bits() chosen from the corners and the
/// extent of the scene so that every position is exact in double, and so is its difference to any
/// corner of the scene. Random positions have fewer bits, which makes exact decisions cheaper.
///
/// So every position lies in the region exactly, in slanted regions too, and predicates that want
/// exact differences (scene/plane.h) take positions as they are. A region keeps --clearance as a
/// whole (check_region_is_free), so its positions do.
/// Immutable; concurrent reads are safe.
class RegionPositions {
 public:
  /// `scene`: a box of all corners that positions meet. `lattice_exponent`: these corners are
  /// multiples of 2^-lattice_exponent.
  RegionPositions(RegionShape region, const Box& scene, int lattice_exponent);

  const RegionShape& region() const { return region_; }
  int bits() const { return bits_; }

  /// The position nearest to a point, but for rounding; of the border, if the point is outside.
  Point nearest(const Point& point) const;
  /// The same with fewer bits than bits(): coordinates that exact decisions are cheaper for.
  Point nearest(const Point& point, int bits) const;
  /// Coarse, uniform by area or volume.
  Point random(RandomNumbers& random) const;
  /// About `scale` times the region's extent away from a position, in each of two directions (three
  /// in a box), and no finer than that takes.
  Point near(const Point& position, double scale, RandomNumbers& random) const;

 private:
  Point nearest_in_box(const Point& point, int bits) const;

  RegionShape region_;
  int bits_ = 0, coarse_bits_ = 0;
  Point axes_[2];  ///< of the region's plane, as long as its extent
};

}  // namespace viewcover
