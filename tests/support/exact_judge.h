#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <span>

#include "scene/convex_polygon.h"

namespace viewcover::testing {

using Rational = boost::multiprecision::cpp_rational;

struct ExactPoint {
  Rational x, y, z;
  ExactPoint() = default;
  explicit ExactPoint(const Point& p) : x(p.x()), y(p.y()), z(p.z()) {}
  ExactPoint(Rational px, Rational py, Rational pz)
      : x(std::move(px)), y(std::move(py)), z(std::move(pz)) {}
};

inline ExactPoint operator-(const ExactPoint& a, const ExactPoint& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline Rational determinant(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c) {
  return a.x * (b.y * c.z - b.z * c.y) + a.y * (b.z * c.x - b.x * c.z) +
         a.z * (b.x * c.y - b.y * c.x);
}

/// Sign of det(b - a, c - a, d - a), by rationals.
inline int exact_orientation(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                             const ExactPoint& d) {
  return determinant(b - a, c - a, d - a).sign();
}

/// sum w_i v_i / sum w_i, exactly. Positive weights give an interior point.
inline ExactPoint combination(std::span<const Point> corners, std::span<const int> weights) {
  ExactPoint sum(0, 0, 0);
  Rational total = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const ExactPoint corner(corners[i]);
    sum.x += weights[i] * corner.x;
    sum.y += weights[i] * corner.y;
    sum.z += weights[i] * corner.z;
    total += weights[i];
  }
  return {sum.x / total, sum.y / total, sum.z / total};
}

/// Does the open segment pq meet the closed convex polygon? By rationals, with no filter and no
/// code of the library. Segments within the polygon's plane count as meeting nothing.
inline bool segment_meets(const ExactPoint& p, const ExactPoint& q,
                          std::span<const Point> polygon) {
  const ExactPoint a(polygon[0]), b(polygon[1]), c(polygon[2]);
  const int side_p = exact_orientation(a, b, c, p), side_q = exact_orientation(a, b, c, q);
  if (side_p * side_q >= 0) return false;
  int sides = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const int side = exact_orientation(p, q, ExactPoint(polygon[k]),
                                       ExactPoint(polygon[(k + 1) % polygon.size()]));
    if (side == 0) continue;
    if (sides != 0 && side != sides) return false;
    sides = side;
  }
  return true;
}

}  // namespace viewcover::testing
