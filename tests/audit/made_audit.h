#pragma once

#include <span>
#include <string>
#include <vector>

#include "audit/audit.h"
#include "support/exact_judge.h"
#include "support/scenes.h"

namespace viewcover::testing {

/// All nodes of one level over all surfaces.
inline std::vector<ElementAddress> elements_of(const Scene& scene, int level) {
  std::vector<ElementAddress> elements;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    for (std::uint64_t path = 0; path < std::uint64_t{1} << (2 * level); ++path) {
      elements.emplace_back(SurfaceId(s), level, path);
    }
  }
  return elements;
}

inline Audit audit_of(std::span<const ConvexPolygon> polygons, std::span<const Point> viewpoints,
                      int level = 0, bool one_sided = false) {
  const Scene scene = scene_of(polygons);
  const ClusterTree clusters(scene);
  return audit_images(scene, clusters, elements_of(scene, level), viewpoints,
                      {.one_sided = one_sided});
}

inline std::vector<std::string> shares_of(const Audit& audit) {
  std::vector<std::string> shares;
  for (const ElementAudit& element : audit.elements) shares.push_back(element.imaged_share);
  return shares;
}

inline Rational share_of(const ElementAudit& element) { return Rational(element.imaged_share); }

/// Triangles between a floor and a ceiling, and viewpoints between them: on no lattice, on a corner
/// and in the plane of a triangle.
struct RandomRoom {
  std::vector<ConvexPolygon> polygons;
  std::vector<Point> viewpoints;

  explicit RandomRoom(std::uint64_t seed, std::size_t triangles = 14) {
    std::mt19937_64 random(seed);
    polygons = random_triangles(triangles, 0.4, 0.125, 0.875, random);
    polygons.push_back(horizontal(0, 0, 1, 1, 0));
    polygons.push_back(horizontal(0, 0, 1, 1, 1));
    std::uniform_real_distribution<double> unit(0, 1);
    const auto place = [&] { return Point(unit(random), unit(random), unit(random)); };
    viewpoints = {place(), place(), polygons[0][0],
                  polygons[1][0] + polygons[1][1] - polygons[1][2]};
  }
};

}  // namespace viewcover::testing
