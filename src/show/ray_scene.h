#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "scene/convex_polygon.h"

namespace viewcover {

/// Polygons to shoot rays at (Embree). Single precision and without a rule for edges: for pictures,
/// never for a verdict. `hit` is thread-safe, and its answers do not depend on threads.
class RayScene {
 public:
  static constexpr std::uint32_t kNone = UINT32_MAX;

  struct Hit {
    std::uint32_t polygon = kNone;  ///< its place in the list
    float distance = 0;             ///< in lengths of the direction; infinite if none is hit
  };

  /// Polygons with fewer than 3 corners are never hit.
  explicit RayScene(std::span<const ConvexPolygon> polygons);
  ~RayScene();
  RayScene(const RayScene&) = delete;
  RayScene& operator=(const RayScene&) = delete;

  /// The polygon that the ray meets first, from either side.
  Hit hit(const Point& origin, const Point& direction) const;

 private:
  struct Embree;
  std::unique_ptr<Embree> embree_;
};

}  // namespace viewcover
