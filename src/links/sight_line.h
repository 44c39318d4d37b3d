#pragma once

#include <span>
#include <vector>

#include "scene/types.h"

namespace viewcover {

/// A region, an element and what may stand between them; strictly convex planar polygons whose
/// coordinates are exact numbers, on no lattice. A region of a single corner is a viewpoint.
/// Borrowed.
struct ShaftPolygons {
  std::span<const Point> region;
  std::span<const Point> element;
  std::span<const std::span<const Point>> occluders;
  bool one_sided = false;
};

/// Two points, interior to region and element, exactly: sum w_i v_i / sum w_i over the corners v_i
/// of the polygon, all w_i > 0.
struct Witness {
  std::vector<double> region_weights;  ///< empty for a viewpoint
  std::vector<double> element_weights;
};

enum class SegmentKind {
  kSightLine,   ///< no occluder meets the open segment
  kBlocked,     ///< an occluder meets it
  kNotBetween,  ///< an end is not inside its polygon, in the other polygon's plane, or behind a
                ///< one-sided element
};

/// What the open segment between the two points of a witness is. Exact, and independent of how a
/// backend decides: interval arithmetic, then rationals (CGAL).
/// Cost: about 0.1 us an occluder. Thread-safe.
SegmentKind classify_segment(const ShaftPolygons& shaft, const Witness& witness);

/// Positive weights of the corners of a convex polygon whose combination is near `point`, which
/// lies inside or near the polygon: fan about the corner mean.
std::vector<double> interior_weights(std::span<const Point> polygon, const Point& point);
/// sum w_i v_i / sum w_i, rounded.
Point weighted_point(std::span<const Point> corners, std::span<const double> weights);

}  // namespace viewcover
