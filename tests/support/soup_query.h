#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exact/sight_query.h"
#include "scene/random_numbers.h"

namespace viewcover::testing {

/// Two parallel equilateral triangles of circumradius 1/2 at distance 1, and `count` equilateral
/// triangles of random direction and circumradius in [least, most] strictly between them, all on
/// the lattice 2^-22: the soups of Haumont et al. (2005). Same trial, same query.
inline SightQuery soup_query(std::size_t count, double least, double most, std::uint64_t trial) {
  constexpr double kThird = 2 * std::numbers::pi / 3, kLattice = 0x1p22;
  RandomNumbers random(mixed(trial) ^ count);
  const auto on_lattice = [&](const Point& p) -> Point {
    return (p * kLattice).array().round() / kLattice;
  };
  const auto triangle = [&](const Point& centre, double radius, const Point& u, const Point& v) {
    ConvexPolygon corners;
    for (int i = 0; i < 3; ++i) {
      const double angle = i * kThird;
      corners.push_back(on_lattice(centre + radius * (std::cos(angle) * u + std::sin(angle) * v)));
    }
    return corners;
  };
  const auto direction = [&] {  // uniform on the sphere, by rejection
    while (true) {
      const Point p(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
      const double length = p.norm();
      if (length > 0.01 && length < 1) return Point(p / length);
    }
  };
  SightQuery query;
  query.region = triangle({0, 0, 0}, 0.5, {1, 0, 0}, {0, 1, 0});
  query.element = triangle({0, 0, 1}, 0.5, {1, 0, 0}, {0, 1, 0});
  while (query.occluders.size() < count) {
    const Point normal = direction();
    const Point u = normal.unitOrthogonal(), v = normal.cross(u);
    const double turn = random.between(0, kThird);
    const Point centre(random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.unit());
    const ConvexPolygon corners =
        triangle(centre, random.between(least, most), std::cos(turn) * u + std::sin(turn) * v,
                 std::cos(turn) * v - std::sin(turn) * u);
    const bool between = std::all_of(corners.begin(), corners.end(),
                                     [](const Point& p) { return p.z() > 0 && p.z() < 1; });
    if (between && is_strictly_convex(corners)) query.occluders.push_back(corners);
  }
  return query;
}

}  // namespace viewcover::testing
