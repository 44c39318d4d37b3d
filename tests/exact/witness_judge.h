#pragma once

#include <algorithm>
#include <span>

#include "support/exact_judge.h"

namespace viewcover::testing {

// Rational judges of queries, with no code of the library. Polygons are closed and convex; corners
// within edges are allowed, also as the first three.

inline Rational dot(const ExactPoint& a, const ExactPoint& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline ExactPoint cross(const ExactPoint& a, const ExactPoint& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

inline ExactPoint plus(const ExactPoint& a, const Rational& factor, const ExactPoint& b) {
  return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}

/// Twice the area times the unit normal.
inline ExactPoint exact_area_vector(std::span<const Point> polygon) {
  const ExactPoint origin(polygon[0]);
  ExactPoint sum(0, 0, 0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum = plus(sum, 1, cross(ExactPoint(polygon[i]) - origin, ExactPoint(polygon[i + 1]) - origin));
  }
  return sum;
}

/// 1 in front of the polygon's plane, -1 behind it, 0 on it.
inline int exact_side(std::span<const Point> polygon, const ExactPoint& p) {
  return dot(exact_area_vector(polygon), p - ExactPoint(polygon[0])).sign();
}

/// sum w_i v_i / sum w_i.
inline ExactPoint weighted(std::span<const Point> corners, std::span<const double> weights) {
  ExactPoint sum(0, 0, 0);
  Rational total = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Rational weight(weights[i]);
    sum = plus(sum, weight, ExactPoint(corners[i]));
    total += weight;
  }
  return {sum.x / total, sum.y / total, sum.z / total};
}

/// Does the open segment pq meet the polygon? Segments within its plane may meet it too.
inline bool open_segment_meets(const ExactPoint& p, const ExactPoint& q,
                               std::span<const Point> polygon) {
  const ExactPoint normal = exact_area_vector(polygon);
  const Rational height_p = dot(normal, p - ExactPoint(polygon[0]));
  const Rational height_q = dot(normal, q - ExactPoint(polygon[0]));
  Rational from = 0, to = 1;  // the part of the segment in the plane, by its parameter
  if (height_p != 0 || height_q != 0) {
    if (height_p.sign() * height_q.sign() >= 0) return false;
    from = to = height_p / (height_p - height_q);
  }
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactPoint corner(polygon[i]);
    const ExactPoint inward = cross(normal, ExactPoint(polygon[(i + 1) % polygon.size()]) - corner);
    const Rational at_p = dot(inward, p - corner), at_q = dot(inward, q - corner);
    // Inside the edge where (1 - t) at_p + t at_q >= 0.
    if (at_p == at_q) {
      if (at_p < 0) return false;
      continue;
    }
    const Rational t = at_p / (at_p - at_q);
    if (at_p < at_q) {
      from = std::max(from, t);
    } else {
      to = std::min(to, t);
    }
    if (from > to) return false;
  }
  return from < 1 && to > 0;
}

/// Planar and convex, every corner turning left or straight on, once round.
inline bool is_convex_loop(std::span<const Point> polygon) {
  const ExactPoint normal = exact_area_vector(polygon);
  if (dot(normal, normal) == 0) return false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactPoint corner(polygon[i]);
    const ExactPoint edge = ExactPoint(polygon[(i + 1) % polygon.size()]) - corner;
    const ExactPoint inward = cross(normal, edge);
    const ExactPoint next = ExactPoint(polygon[(i + 2) % polygon.size()]) - corner;
    if (dot(edge, edge) == 0) return false;
    // Straight on, not back.
    if (dot(inward, next) == 0 && dot(edge, next) <= dot(edge, edge)) return false;
    for (const Point& other : polygon) {
      const ExactPoint reach = ExactPoint(other) - corner;
      if (dot(normal, reach) != 0 || dot(inward, reach) < 0) return false;
    }
  }
  return true;
}

}  // namespace viewcover::testing
