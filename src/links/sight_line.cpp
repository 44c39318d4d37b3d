#include "links/sight_line.h"

#include <CGAL/Gmpq.h>
#include <CGAL/Interval_nt.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/convex_polygon.h"

namespace viewcover {
namespace {

using Interval = CGAL::Interval_nt<false>;
using Rational = CGAL::Gmpq;

/// -1, 0, 1, or 2 for "unsure".
int sign_of(const Interval& x) {
  if (x.inf() > 0) return 1;
  if (x.sup() < 0) return -1;
  return x.inf() == 0 && x.sup() == 0 ? 0 : 2;
}
int sign_of(const Rational& x) { return static_cast<int>(CGAL::sign(x)); }

template <class Number>
using Coordinates = std::array<Number, 3>;

template <class Number>
Coordinates<Number> coordinates(const Point& p) {
  return {Number(p.x()), Number(p.y()), Number(p.z())};
}

template <class Number>
Coordinates<Number> combined(std::span<const Point> corners, std::span<const double> weights) {
  Number total(0);
  Coordinates<Number> sum = {Number(0), Number(0), Number(0)};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Number weight(weights[i]);
    total += weight;
    for (std::size_t k = 0; k < 3; ++k) {
      sum[k] += weight * Number(corners[i][static_cast<Eigen::Index>(k)]);
    }
  }
  for (Number& x : sum) x /= total;
  return sum;
}

/// det(b - a, c - a, d - a).
template <class Number>
Number determinant(const Coordinates<Number>& a, const Coordinates<Number>& b,
                   const Coordinates<Number>& c, const Coordinates<Number>& d) {
  const Number bx = b[0] - a[0], by = b[1] - a[1], bz = b[2] - a[2];
  const Number cx = c[0] - a[0], cy = c[1] - a[1], cz = c[2] - a[2];
  const Number dx = d[0] - a[0], dy = d[1] - a[1], dz = d[2] - a[2];
  return bx * (cy * dz - cz * dy) + by * (cz * dx - cx * dz) + bz * (cx * dy - cy * dx);
}

/// A segment tested against one polygon after the other, in one kind of numbers.
template <class Number>
class Segment {
 public:
  Segment(Coordinates<Number> p, Coordinates<Number> q) : p_(std::move(p)), q_(std::move(q)) {}

  /// Sides of the two ends to the polygon's plane.
  std::array<int, 2> sides(std::span<const Point> polygon) const {
    const auto a = coordinates<Number>(polygon[0]), b = coordinates<Number>(polygon[1]),
               c = coordinates<Number>(polygon[2]);
    return {sign_of(determinant(a, b, c, p_)), sign_of(determinant(a, b, c, q_))};
  }

  /// 1: the open segment meets the closed polygon; 0: it does not; 2: unsure. A segment within the
  /// polygon's plane is not decided here: 2.
  int meets(std::span<const Point> polygon) const {
    const auto [side_p, side_q] = sides(polygon);
    if (side_p != 2 && side_q != 2) {
      if (side_p == 0 && side_q == 0) return 2;
      if (side_p * side_q >= 0) return 0;  // at most an end lies in the plane
    } else if (side_p == 2 && side_q == 2) {
      return 2;
    }
    bool sure = side_p != 2 && side_q != 2;
    bool left = false, right = false;
    auto first = coordinates<Number>(polygon.back());
    for (const Point& corner : polygon) {
      const auto second = coordinates<Number>(corner);
      const int side = sign_of(determinant(p_, q_, first, second));
      if (side == 2) {
        sure = false;
      } else {
        left |= side > 0;
        right |= side < 0;
      }
      // The line passes outside, whatever the sides of its ends.
      if (left && right) return 0;
      first = second;
    }
    return sure ? 1 : 2;
  }

 private:
  Coordinates<Number> p_, q_;
};

/// Does the open segment pq meet a convex polygon in one plane with it? It does not iff p and q lie
/// on the outer closed side of one edge, or the polygon on one open side of line pq.
bool meets_in_plane(const Coordinates<Rational>& p, const Coordinates<Rational>& q,
                    std::span<const Point> polygon) {
  const Point normal = area_vector(polygon);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const auto u = static_cast<std::size_t>((axis + 1) % 3),
             v = static_cast<std::size_t>((axis + 2) % 3);
  const auto turn = [&](const Coordinates<Rational>& a, const Coordinates<Rational>& b,
                        const Coordinates<Rational>& c) {
    return sign_of(Rational((b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u])));
  };
  const int orientation = normal[axis] > 0 ? 1 : -1;
  bool left = false, right = false, on = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const auto a = coordinates<Rational>(polygon[k]),
               b = coordinates<Rational>(polygon[(k + 1) % polygon.size()]);
    const int at_p = orientation * turn(a, b, p), at_q = orientation * turn(a, b, q);
    if (at_p <= 0 && at_q <= 0 && (at_p < 0 || at_q < 0)) return false;
    const int side = turn(p, q, a);
    left |= side > 0;
    right |= side < 0;
    on |= side == 0;
  }
  return on || (left && right);
}

/// Are the ends where they may be? Rationals or intervals; for those, 2 is unsure.
template <class Number>
int ends_are_right(const Segment<Number>& segment, const ShaftPolygons& shaft) {
  const int p_side = segment.sides(shaft.element)[0];
  const int q_side = shaft.region.size() < 3 ? 1 : segment.sides(shaft.region)[1];
  if (p_side == 2 || q_side == 2) return 2;
  return p_side != 0 && q_side != 0 && !(shaft.one_sided && p_side < 0) ? 1 : 0;
}

SegmentKind classify(const ShaftPolygons& shaft, std::span<const double> region_weights,
                     std::span<const double> element_weights) {
  int ends = 2;
  std::vector<std::size_t> unsure;
  {
    const CGAL::Protect_FPU_rounding<true> protect;
    const Segment<Interval> segment(combined<Interval>(shaft.region, region_weights),
                                    combined<Interval>(shaft.element, element_weights));
    ends = ends_are_right(segment, shaft);
    if (ends == 0) return SegmentKind::kNotBetween;
    for (std::size_t i = 0; i < shaft.occluders.size(); ++i) {
      const int meets = segment.meets(shaft.occluders[i]);
      if (meets == 1 && ends == 1) return SegmentKind::kBlocked;
      if (meets != 0) unsure.push_back(i);
    }
  }
  if (unsure.empty() && ends == 1) return SegmentKind::kSightLine;

  const auto p = combined<Rational>(shaft.region, region_weights);
  const auto q = combined<Rational>(shaft.element, element_weights);
  const Segment<Rational> segment(p, q);
  if (ends_are_right(segment, shaft) == 0) return SegmentKind::kNotBetween;
  const bool blocked = std::any_of(unsure.begin(), unsure.end(), [&](std::size_t i) {
    const auto& polygon = shaft.occluders[i];
    const int meets = segment.meets(polygon);
    return meets == 2 ? meets_in_plane(p, q, polygon) : meets == 1;
  });
  return blocked ? SegmentKind::kBlocked : SegmentKind::kSightLine;
}

}  // namespace

std::vector<double> interior_weights(std::span<const Point> polygon, const Point& point) {
  const std::size_t n = polygon.size();
  const Point centre = corner_mean(polygon), normal = area_vector(polygon);
  const auto twice_area = [&](const Point& a, const Point& b, const Point& c) {
    return (b - a).cross(c - a).dot(normal);
  };
  // The fan's triangle in which the point lies deepest.
  std::vector<double> best;
  double deepest = -INFINITY;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    const Point &a = polygon[k], &b = polygon[next];
    const double whole = twice_area(centre, a, b);
    const double at_a = twice_area(centre, point, b) / whole,
                 at_b = twice_area(centre, a, point) / whole;
    const double at_centre = 1 - at_a - at_b;
    const double depth = std::min(at_a, at_b);
    if (!(depth > deepest)) continue;
    deepest = depth;
    // Never 0, where rounding has pushed the point out.
    const double share = std::max(at_centre, 0x1p-60) / static_cast<double>(n);
    best.assign(n, share);
    best[k] += std::max(at_a, 0.0);
    best[next] += std::max(at_b, 0.0);
  }
  return best;
}

Point weighted_point(std::span<const Point> corners, std::span<const double> weights) {
  Point sum = Point::Zero();
  double total = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum += weights[i] * corners[i];
    total += weights[i];
  }
  return sum / total;
}

SegmentKind classify_segment(const ShaftPolygons& shaft, const Witness& witness) {
  const auto positive = [](const std::vector<double>& weights) {
    return std::all_of(weights.begin(), weights.end(),
                       [](double w) { return w > 0 && std::isfinite(w); });
  };
  if (!positive(witness.region_weights) || !positive(witness.element_weights)) {
    return SegmentKind::kNotBetween;
  }
  const std::vector<double> viewpoint = {1};
  return classify(shaft, shaft.region.size() == 1 ? viewpoint : witness.region_weights,
                  witness.element_weights);
}

}  // namespace viewcover
