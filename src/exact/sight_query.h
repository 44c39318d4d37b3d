#pragma once

#include <optional>
#include <span>
#include <vector>

#include "exact/statistics.h"
#include "links/sight_line.h"
#include "links/verdict.h"
#include "scene/convex_polygon.h"

namespace viewcover {

/// One question: is there a sight line from a viewing region, or from a viewpoint, to an element?
///
/// Polygons are planar and convex with at least 3 corners in order round the boundary; corners
/// within edges are allowed. Coordinates are taken as exact numbers, whatever their exponents.
struct SightQuery {
  ConvexPolygon region;  ///< for queries from a region
  Point viewpoint;       ///< for queries from a viewpoint
  ConvexPolygon element;
  std::vector<ConvexPolygon> occluders;
  /// Only the front of the element counts as visible, and only the part of the region in front.
  bool one_sided = false;
};

struct SightAnswer {
  /// kFullyVisible iff no occluder meets the interior of the shaft; never kAssumedVisible.
  Verdict verdict = Verdict::kHiddenNotFacing;
  std::optional<Witness> witness;  ///< whenever visible
  ExactStatistics statistics;
};

/// Decides exactly whether the element is visible from the region (papers/exact.md): true iff the
/// pairs of a point of the region and a point of the element whose open segment meets no occluder
/// have an interior. An occluder coplanar with region or element blocks nothing.
/// Cost: see bench/exact.txt; it grows about linearly with the occluders. Thread-safe.
SightAnswer decide_from_region(const SightQuery& query);

struct PointAnswer : SightAnswer {
  double visible_fraction = 0;  ///< share of the element's area seen, exact up to one rounding
  /// The seen part of the element as disjoint convex polygons; corners rounded to double.
  std::vector<ConvexPolygon> visible_parts;
};

/// Decides exactly which part of the element is visible from the viewpoint: all points whose open
/// segment to it meets no occluder. Visible iff that part has positive area. Occluders and elements
/// whose plane holds the viewpoint are seen edge-on: they neither block nor are visible. An
/// edge-on occluder inside the cone of view still keeps the element from being fully visible.
PointAnswer decide_from_point(const SightQuery& query);

}  // namespace viewcover
