#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"
#include "scene/types.h"

namespace viewcover {

/// A connected piece of a scene's surface without boundary: it has an inside and an outside.
struct ClosedSurface {
  std::vector<SurfaceId> surfaces;  ///< in order
  bool is_oriented = false;         ///< neighbours agree which side is the front
  Box bounds;
};

/// The closed pieces of the scene, in the order of their first surfaces.
///
/// Surfaces are neighbours where two of them, and no third, share a stretch of an edge; a piece is
/// closed if an even number of its surfaces lies at every stretch. Stretches are found exactly on
/// the lattice, so an edge may be met by several shorter ones (T-junctions, corners within edges).
/// Not promised: pieces that are only closed together with a surface they do not share edges with,
/// such as a box without bottom on a floor, and those with a crack.
/// Cost: O(n log n) for n edges, unless many of them overlap on one line.
std::vector<ClosedSurface> closed_surfaces(const Scene& scene);

/// Times that a closed surface goes round a point.
struct Enclosure {
  bool is_inside = false;  ///< an odd number of crossings on the way out
  /// Crossings from back to front less those from front to back. For an oriented surface the same
  /// on every way out: 1 within a surface that faces outward, -1 within one that faces inward.
  int winding = 0;
};

/// Where `point` lies; none if it lies on the surface. Exact for all finite doubles.
/// Cost: O(surfaces), and nothing for a point outside the bounds.
std::optional<Enclosure> enclosure(const Scene& scene, const ClosedSurface& closed,
                                   const Point& point);

}  // namespace viewcover
