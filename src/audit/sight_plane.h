#pragma once

#include <cmath>
#include <limits>

#include "scene/predicates.h"
#include "scene/types.h"

namespace viewcover {

/// The plane through a viewpoint and two points, in front where det(a - viewpoint, b - viewpoint,
/// x - viewpoint) > 0, with a filter before the exact predicate: a viewpoint lies on no lattice, so
/// `Plane` does not serve.
class SightPlane {
 public:
  /// `reach`: no coordinate of a point whose side is asked differs from that of `a` by more.
  SightPlane(const Point& viewpoint, const Point& a, const Point& b, double reach)
      : viewpoint_(viewpoint), a_(a), b_(b) {
    const Point u = a - viewpoint, v = b - viewpoint;
    normal_ = u.cross(v);
    allowance_ = kBound * u.lpNorm<Eigen::Infinity>() * v.lpNorm<Eigen::Infinity>() * reach;
  }

  /// Side of a point, in {-1, 0, 1}, exact.
  int side(const Point& x) const {
    const double value = normal_.dot(x - a_);
    if (value > allowance_) return 1;
    if (value < -allowance_) return -1;
    if (x == a_ || x == b_) return 0;
    return orientation(viewpoint_, a_, b_, x);
  }

  /// True only if the whole box lies strictly behind.
  bool has_behind(const Box& box) const {
    const Point foremost(normal_.x() > 0 ? box.max().x() : box.min().x(),
                         normal_.y() > 0 ? box.max().y() : box.min().y(),
                         normal_.z() > 0 ? box.max().z() : box.min().z());
    return normal_.dot(foremost - a_) < -allowance_;
  }

 private:
  // Let e be the unit roundoff, U, V, W bounds on the components of u, v and x - a. Each component
  // of u, v, x - a has a relative error of e. One of the normal is at most 2 U V, and off by
  // 3 e for each of two products and e for their difference: 8 e U V. The scalar product is then
  // off by 3 (8 + 2 + 2) e U V W for its factors and products and 2 e 6 U V W for its sums: less
  // than 50 e U V W with terms of higher order. The allowance itself is rounded three times.
  static constexpr double kBound = 64 * std::numeric_limits<double>::epsilon() / 2;

  Point viewpoint_, a_, b_, normal_;
  double allowance_ = 0;
};

}  // namespace viewcover
