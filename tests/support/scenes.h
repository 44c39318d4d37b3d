#pragma once

#include <random>
#include <span>
#include <utility>
#include <vector>

#include "scene/scene.h"
#include "scene/viewing_region.h"

namespace viewcover::testing {

/// A scene of the given polygons in one group, on the lattice 2^-20.
inline Scene scene_of(std::span<const ConvexPolygon> polygons) {
  Scene scene;
  scene.name = "made";
  scene.groups = {"made"};
  scene.lattice.exponent = 20;
  for (const ConvexPolygon& polygon : polygons) {
    scene.surfaces.push_back({polygon, GroupId(0), static_cast<std::uint32_t>(scene.faces++)});
    scene.bounds.extend(bounding_box(polygon));
  }
  return scene;
}

inline ViewingRegion region_of(ConvexPolygon polygon, int level) {
  ViewingRegion region;
  region.parts.push_back(std::move(polygon));
  region.level = level;
  return region;
}

/// The rectangle [x0, x1] x [y0, y1] at height z, facing up.
inline ConvexPolygon horizontal(double x0, double y0, double x1, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

/// Small random triangles in [0, 1]^2 x [low, high], corners multiples of 2^-10, none degenerate.
inline std::vector<ConvexPolygon> random_triangles(std::size_t count, double radius, double low,
                                                   double high, std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1), offset(-radius, radius);
  const Lattice lattice{10};
  std::vector<ConvexPolygon> triangles;
  while (triangles.size() < count) {
    const Point centre(unit(random), unit(random), low + (high - low) * unit(random));
    ConvexPolygon triangle;
    for (int i = 0; i < 3; ++i) {
      Point corner = centre + Point(offset(random), offset(random), offset(random));
      corner.z() = std::clamp(corner.z(), low, high);
      triangle.push_back(lattice.round(corner));
    }
    if (is_strictly_convex(triangle)) triangles.push_back(triangle);
  }
  return triangles;
}

}  // namespace viewcover::testing
