#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "support/second_opinion/bivariate.h"

namespace viewcover::testing::second_opinion {

template <class N>
using Vector = std::array<N, 3>;

template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class N>
Vector<N> minus(const Vector<N>& a, const Vector<N>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class N>
bool is_zero(const Vector<N>& a) {
  return sign_of(a[0]) == 0 && sign_of(a[1]) == 0 && sign_of(a[2]) == 0;
}

template <class N>
using Corners = std::vector<Vector<N>>;

/// Without corners within edges.
template <class N>
Corners<N> corners_of(std::span<const Point> polygon) {
  Corners<N> all, result;
  for (const Point& p : polygon) all.push_back({N(p.x()), N(p.y()), N(p.z())});
  for (std::size_t i = 0, n = all.size(); i < n; ++i) {
    const Vector<N>& here = all[i];
    const Vector<N> from = minus(here, all[(i + n - 1) % n]);
    if (!is_zero(cross(from, minus(all[(i + 1) % n], here)))) result.push_back(here);
  }
  return result;
}

/// normal . v = offset; its points are given by their coordinates along two axes.
template <class N>
struct Plane {
  Vector<N> normal{};
  N offset{};
  std::size_t first = 0, second = 1, dropped = 2;

  explicit Plane(const Corners<N>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector<N> part = cross(corners[i], corners[(i + 1) % corners.size()]);
      for (std::size_t k = 0; k < 3; ++k) normal[k] += part[k];
    }
    offset = dot(normal, corners[0]);
    std::array<N, 4> all{normal[0], normal[1], normal[2], offset};
    Numbers<N>::reduce(all);
    normal = {all[0], all[1], all[2]};
    offset = all[3];
    for (std::size_t k = 0; k < 3; ++k) {
      if (abs_of(normal[k]) > abs_of(normal[dropped])) dropped = k;
    }
    first = (dropped + 1) % 3;
    second = (dropped + 2) % 3;
  }

  static N abs_of(const N& value) { return value < 0 ? N(-value) : value; }
  N height(const Vector<N>& v) const { return dot(normal, v) - offset; }

  /// The function g . v + c on this plane, times a positive constant of the plane.
  Affine<N> restricted(const Vector<N>& g, const N& c) const {
    const N scale = abs_of(normal[dropped]);
    const N share = normal[dropped] < 0 ? N(-g[dropped]) : g[dropped];
    return {scale * g[first] - normal[first] * share, scale * g[second] - normal[second] * share,
            scale * c + offset * share};
  }
  Affine<N> restricted_height_over(const Plane& other) const {
    return restricted(other.normal, N(-other.offset));
  }
};

/// The part of a polygon where sign * height over the plane >= 0.
template <class N>
Corners<N> part_above(const Corners<N>& polygon, const Plane<N>& plane, int sign) {
  Corners<N> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector<N>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const N ha = sign * plane.height(a), hb = sign * plane.height(b);
    if (ha >= 0) result.push_back(a);
    if (sign_of(ha) * sign_of(hb) < 0) {
      const N t = ha / (ha - hb);
      result.push_back(
          {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
    }
  }
  return result;
}

template <class N>
bool has_area(const Corners<N>& polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    if (!is_zero(cross(minus(polygon[i], polygon[0]), minus(polygon[i - 1], polygon[0])))) {
      return true;
    }
  }
  return false;
}

}  // namespace viewcover::testing::second_opinion
