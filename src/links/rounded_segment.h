#pragma once

#include <span>

#include "scene/plane.h"
#include "scene/types.h"

namespace viewcover {

/// A segment whose ends were rounded: each true end is within `error` of the stored one in every
/// coordinate. Its tests say "misses" only when every such segment does.
///
/// Immutable. Cost: about 20 ns a test.
class RoundedSegment {
 public:
  /// `error`: at least `position_error` of a box that holds both ends and all that is tested.
  RoundedSegment(const Point& from, const Point& to, double error)
      : from_(from), to_(to), direction_(to - from), error_(error) {}

  /// A bound on the rounding of points made by PolygonSampler (16 u times the largest coordinate),
  /// and on what `Plane::side_within` and the tests below ask for.
  static double position_error(const Box& box);

  bool misses(const Box& box) const;
  bool misses(std::span<const Point> polygon, const Plane& plane) const;

 private:
  double determinant_error(std::span<const Point> polygon) const;

  Point from_, to_, direction_;
  double error_;
};

}  // namespace viewcover
