#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "scene/predicates.h"
#include "scene/types.h"

namespace viewcover {

/// The oriented plane through three points of the lattice, front side where they run
/// counter-clockwise, with a filter in front of the exact predicate.
///
/// Thread-safe, immutable. Cost of a side: about 3 ns, of `orientation` where the filter is unsure.
class Plane {
 public:
  Plane() = default;
  /// `reach`: no coordinate of a point whose `side` is asked differs from that of `a` by more; a
  /// bound makes `side` cheaper. Three points on a line give a plane that has everything on it.
  Plane(const Point& a, const Point& b, const Point& c,
        double reach = std::numeric_limits<double>::infinity())
      : a_(a), b_(b), c_(c) {
    const Point u = b - a, v = c - a;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const double plus = u[j] * v[k], minus = u[k] * v[j];
      normal_[i] = plus - minus;
      slack_[i] = kBound * (std::fabs(plus) + std::fabs(minus));
    }
    // With one component left the sign of the product with a coordinate is exact.
    if ((slack_.array() != 0).count() == 1) slack_.setZero();
    size_ = normal_.lpNorm<1>();
    const double slack = slack_.sum();
    enough_ = slack == 0 ? 0 : slack * reach;
  }
  /// The plane of a strictly convex polygon.
  explicit Plane(std::span<const Point> polygon,
                 double reach = std::numeric_limits<double>::infinity())
      : Plane(polygon[0], polygon[1], polygon[2], reach) {}

  Plane reversed() const {
    Plane plane = *this;
    std::swap(plane.b_, plane.c_);
    plane.normal_ = -normal_;
    return plane;
  }

  /// Side of a point, in {-1, 0, 1}, exact. Requires that `point - a` is exact (true on one
  /// lattice).
  int side(const Point& point) const {
    const Point d = point - a_;
    const double value = normal_.x() * d.x() + normal_.y() * d.y() + normal_.z() * d.z();
    if (value > enough_) return 1;
    if (value < -enough_) return -1;
    const double unsure = slack_.x() * std::fabs(d.x()) + slack_.y() * std::fabs(d.y()) +
                          slack_.z() * std::fabs(d.z());
    if (value > unsure) return 1;
    if (value < -unsure) return -1;
    return unsure == 0 ? 0 : orientation(a_, b_, c_, point);
  }

  /// Side of a point of which each coordinate is known to within `error`: 0 if that leaves the
  /// side open. Requires error >= 4 u times the largest magnitude among coordinates.
  int side_within(const Point& point, double error) const {
    const Point d = point - a_;
    const double value = normal_.x() * d.x() + normal_.y() * d.y() + normal_.z() * d.z();
    // Twice the error: once for the point, once for the rounded difference and the sums.
    const double moved = 2 * error * size_;
    if (std::fabs(value) > enough_ + moved) return value > 0 ? 1 : -1;
    const double unsure = slack_.dot(d.cwiseAbs()) + moved;
    return (value > unsure) - (value < -unsure);
  }

  /// True only if the whole box lies on the closed front side. May miss boxes that nearly touch.
  bool has_in_front(const Box& box) const {
    // The corner farthest back.
    const double x = (normal_.x() > 0 ? box.min().x() : box.max().x()) - a_.x();
    const double y = (normal_.y() > 0 ? box.min().y() : box.max().y()) - a_.y();
    const double z = (normal_.z() > 0 ? box.min().z() : box.max().z()) - a_.z();
    const double value = normal_.x() * x + normal_.y() * y + normal_.z() * z;
    if (value < 0) return false;
    if (value >= enough_) return true;
    const Point from = (box.min() - a_).cwiseAbs(), to = (box.max() - a_).cwiseAbs();
    return value >= slack_.dot(from.cwiseMax(to));
  }

 private:
  // With exact differences d the computed value is sum_i (p_i - m_i) d_i of products p_i, m_i
  // rounded once. Errors: p_i - m_i by (2u + u^2)(|p_i| + |m_i|), the product with d_i by another
  // factor (1 + u), the two additions by (1 + u)^2: in all less than 5.01 u sum_i (|p_i| + |m_i|)
  // |d_i|. The slack itself and the sum over it are rounded down by at most a factor (1 - 5u).
  static constexpr double kBound = 6 * std::numeric_limits<double>::epsilon() / 2;

  // What most calls read comes first.
  Point a_ = Point::Zero();
  Point normal_ = Point::Zero();
  double enough_ = 0;            // more than the allowance within reach
  double size_ = 0;              // sum of the components' magnitudes of the normal
  Point slack_ = Point::Zero();  // allowance for rounding, by component of the difference
  Point b_ = Point::Zero(), c_ = Point::Zero();
};

}  // namespace viewcover
