#pragma once

#include <cmath>

#include "scene/types.h"

namespace viewcover {

/// A turn about the vertical axis in whole numbers, counter-clockwise seen from above: the x axis
/// goes to (cosine, sine) / 128. Its length is 1 to within half a per cent for the turns used.
struct Turn {
  int cosine = 128;
  int sine = 0;
};
inline constexpr Turn kFacingSouth{128, 0};  ///< furniture faces -y in its own frame
inline constexpr Turn kFacingEast{0, 128};
inline constexpr Turn kFacingNorth{-128, 0};
inline constexpr Turn kFacingWest{0, -128};

/// Where a piece of furniture stands: its own frame (x to the right, y from front to back, z up,
/// metres) in the room.
///
/// Coordinates of the own frame are rounded to multiples of 2^-8 m (4 mm) and then mapped by whole
/// numbers, so room coordinates are multiples of 2^-15 m and the map is exactly affine: what is
/// planar, parallel, convex or touching in the own frame is so in the room, whatever the turn.
class Placement {
 public:
  Placement() = default;
  Placement(double x, double y, double z, Turn turn = {})
      : origin_(rounded(x), rounded(y), rounded(z)), turn_(turn) {}

  static double rounded(double metres) { return std::nearbyint(metres * 256) / 256; }

  /// The place in the room of a point of the own frame.
  Point operator()(double x, double y, double z) const {
    const double u = rounded(x);
    const double v = rounded(y);
    return {origin_.x() + (turn_.cosine * u - turn_.sine * v) / 128,
            origin_.y() + (turn_.sine * u + turn_.cosine * v) / 128, origin_.z() + rounded(z)};
  }
  Point operator()(const Point& local) const { return (*this)(local.x(), local.y(), local.z()); }

  /// The same turn with the origin at a point of the own frame.
  Placement moved(double x, double y, double z) const {
    Placement result = *this;
    result.origin_ = (*this)(x, y, z);
    return result;
  }

 private:
  Point origin_ = Point::Zero();
  Turn turn_;
};

}  // namespace viewcover
