#pragma once

#include <optional>
#include <span>
#include <vector>

#include "exact/shaft_parts.h"
#include "exact/sight_query.h"
#include "exact/view_cone.h"

namespace viewcover::exact {

/// Positive weights of the corners of a convex polygon whose combination is near `point`, which
/// lies inside or near the polygon: fan about the corner mean.
std::vector<double> interior_weights(std::span<const Point> polygon, const Point& point);
/// The same for a point inside the polygon given exactly: a triangle of its fan that holds it, with
/// weights rounded, and next to nothing for the other corners.
std::vector<double> exact_interior_weights(std::span<const Point> polygon,
                                           const RationalPoint& point);
/// sum w_i v_i / sum w_i, rounded.
Point combination(std::span<const Point> corners, std::span<const double> weights);

enum class SegmentKind {
  kSightLine,   ///< no occluder meets the open segment
  kBlocked,     ///< an occluder meets it
  kNotBetween,  ///< an end is not inside its polygon, in the other polygon's plane, or behind a
                ///< one-sided element
};

/// What the open segment between the two combinations is. Exact, and independent of the decision:
/// interval arithmetic, then rationals (CGAL). Without `region_weights` the region is a single
/// corner, the viewpoint.
SegmentKind classify_segment(const ShaftPolygons& shaft, const Witness& witness);

}  // namespace viewcover::exact
