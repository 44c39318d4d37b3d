#pragma once

#include <functional>
#include <span>
#include <vector>

#include "exact/real_lines.h"
#include "exact/subtraction.h"
#include "links/sight_line.h"

namespace viewcover::exact {

using LineBlocker = Blocker<6>;

/// Part of a shaft in which region and element lie on one side of each other's plane.
struct ShaftPart {
  /// Pointed cones that together hold all lines from the region's part to the element's; one, or
  /// two where region and element touch along a segment.
  std::vector<LineCell> roots;
  std::vector<LineBlocker> blockers;
  std::vector<std::size_t> occluder_of_blocker;
  /// Random lines from region to element, rounded, uniform over triangles.
  std::vector<std::array<double, 6>> samples;
  /// Doubles of lines stand for points (x - origin) / 2^unit_exponent.
  Point origin = Point::Zero();
  int unit_exponent = 0;
};

/// Takes a shaft apart (papers/exact.md, section 2): region and element are cut at each other's
/// planes, polygons with many corners into pieces; each pair of pieces gets its root cells and
/// blocking cones. Calls `visit` for each until it returns true; returns whether it did.
/// Coplanar pairs, and those behind a one-sided element, have no parts.
bool visit_shaft_parts(LinePool& pool, const ShaftPolygons& shaft,
                       const std::function<bool(const ShaftPart&)>& visit);

}  // namespace viewcover::exact
