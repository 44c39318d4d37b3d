#pragma once

#include <cstddef>
#include <vector>

#include "scene/scene.h"

namespace viewcover {

/// A place where an edge of a surface comes near to another surface, and the triangle that joins
/// the two there.
struct NarrowGap {
  SurfaceId surface, other;  ///< the edge is one of `surface`
  double width = 0;          ///< least distance between them along this triangle, scene units
  ConvexPolygon patch;       ///< corners on the lattice
};

/// More are no gaps but the detail of a scene that is finer than the width.
inline constexpr std::size_t kMostNarrowGaps = 1'000'000;

/// Patches for all gaps narrower than `width`: the shortest connections, each shorter than `width`,
/// from the points of every edge to every other edge, and straight on to the inside of every other
/// surface, where that does not have the edge. A line through a gap meets one of them. Patches
/// are triangles with corners rounded to the lattice, and overlap what they join by
/// kPatchOverlap steps of it, so that rounding leaves no slit beside them. What would lie on a
/// surface already is left out; an edge that touches without leaving a gap makes none.
///
/// Grooves narrower than `width` count as gaps, too, and so does the tip of a wedge. Two surfaces
/// that cut each other, with no edge of either near the other, leave none.
///
/// Ordered by surfaces. Cost: O(n log n) and the pairs nearer than `width`.
/// Errors: InputError for more than kMostNarrowGaps.
std::vector<NarrowGap> find_narrow_gaps(const Scene& scene, double width);

inline constexpr int kPatchOverlap = 4;

/// The scene with patches that block views and are no targets; the surfaces keep their numbers.
Scene with_gaps_closed(const Scene& scene, const std::vector<NarrowGap>& gaps);

}  // namespace viewcover
