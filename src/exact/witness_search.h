#pragma once

#include <optional>

#include "exact/real_lines.h"
#include "exact/shaft_parts.h"
#include "exact/view_cone.h"
#include "scene/random_numbers.h"

namespace viewcover::exact {

/// What random segments between region and element tell.
struct RandomSegments {
  std::optional<Witness> witness;  ///< the first sight line found
  bool any_blocked = false;        ///< one was met by an occluder: not fully visible
};

/// Tries up to `tries` random segments, classified exactly; ends when it has seen both kinds.
RandomSegments try_exact_segments(const ShaftPolygons& shaft, int tries, RandomNumbers& random);

/// A sight line from a cell that no blocker meets: real lines between points of the cell on which
/// the Klein form has opposite signs, rounded and confirmed. Where rounding spoils all of them, the
/// region end of each is kept and what it sees is computed exactly. None is left to be found only
/// if the free lines are too few for pairs of points with double weights.
std::optional<Witness> witness_in_cell(const ShaftPolygons& shaft, const ShaftPart& part,
                                       const LineCell& cell, const RealLineBracket& bracket,
                                       RandomNumbers& random, ExactStatistics& statistics);

/// A sight line from a viewpoint, or from the point of the region with the given weights, to the
/// parts of the element that it sees.
std::optional<Witness> witness_in_parts(const ShaftPolygons& shaft,
                                        const std::vector<double>& region_weights,
                                        std::span<const RationalPolygon> parts);

}  // namespace viewcover::exact
