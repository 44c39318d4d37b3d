#include "links/rounded_segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace viewcover {

double RoundedSegment::position_error(const Box& box) {
  constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return 16 * kUnitRoundoff * largest;
}

bool RoundedSegment::misses(const Box& box) const {
  // Separating axes of a segment and a box. A box grown by `error_` outweighs the rounding too:
  // it adds error_ * |direction| to products that err by 4 u * |coordinates| * |direction|.
  const Point half = (0.5 * box.sizes()).array() + error_;
  const Point middle = 0.5 * (from_ + to_) - box.center();
  const Point reach = 0.5 * direction_.cwiseAbs();
  if (((middle.cwiseAbs() - reach).array() > half.array()).any()) return true;
  const Point d = 0.5 * direction_;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    if (std::fabs(middle[j] * d[k] - middle[k] * d[j]) > half[j] * reach[k] + half[k] * reach[j]) {
      return true;
    }
  }
  return false;
}

bool RoundedSegment::misses(std::span<const Point> polygon, const Plane& plane) const {
  const int side_from = plane.side_within(from_, error_);
  const int side_to = plane.side_within(to_, error_);
  if (side_from * side_to > 0) return true;
  if (side_from * side_to == 0) return false;  // an end may lie in the plane: count as blocked

  // The segment crosses the plane; it misses the polygon iff it passes an edge on the outer side:
  // det(direction, a - from, b - from) has not the sign of side_to for the edge a, b.
  const std::size_t n = polygon.size();
  double outermost = 0;
  Point first = polygon[n - 1] - from_;
  for (const Point& corner : polygon) {
    const Point second = corner - from_;
    outermost = std::min(outermost, side_to * direction_.dot(first.cross(second)));
    first = second;
  }
  return outermost < 0 && outermost < -determinant_error(polygon);
}

/// |det(a, b, c)| <= |a|_1 |b|_1 |c|_1. Rows err by at most 2 error_ a coordinate (both ends),
/// 6 error_ in the 1-norm, so the determinant by 18 error_ size^2; evaluating it adds at most
/// 10 u size^3, where error_ is at least 16 u times the largest coordinate and size at most six
/// times that.
double RoundedSegment::determinant_error(std::span<const Point> polygon) const {
  double size = direction_.lpNorm<1>();
  for (const Point& corner : polygon) size = std::max(size, (corner - from_).lpNorm<1>());
  return 24 * error_ * size * size;
}

}  // namespace viewcover
