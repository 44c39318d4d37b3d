#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "scene/types.h"

namespace viewcover {

/// A strictly convex polygon to be joined with others.
struct ConvexCell {
  std::vector<std::uint32_t> corners;  ///< indices into the points, as ConvexPolygon
  std::uint32_t group = 0;             ///< only cells of one group are joined
  std::uint32_t source = 0;            ///< the caller's; a union keeps that of its first cell
};

/// Joins cells of one group over edges that both have whole, while the union is strictly convex
/// after corners that have become straight are left out. Cells must lie exactly in one plane and
/// face the same way to be joined. The union of a set of cells stands where its first one stood.
///
/// Greedy (Hertel and Mehlhorn 1983): long parallel edges go first, so that a grid becomes one
/// cell whatever the order of its cells; fewest cells are not promised. No two cells are left that
/// could be joined. Deterministic. Exact for points whose coordinates are doubles.
/// Cost: O(n log n) a round, a few rounds for real scenes.
std::vector<ConvexCell> merge_convex(std::span<const Point> points, std::vector<ConvexCell> cells);

}  // namespace viewcover
