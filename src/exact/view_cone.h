#pragma once

#include <CGAL/Gmpq.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "exact/statistics.h"
#include "scene/convex_polygon.h"

namespace viewcover::exact {

using RationalPoint = std::array<CGAL::Gmpq, 3>;

/// Corners of a polygon in order round the boundary, exact.
using RationalPolygon = std::vector<RationalPoint>;

/// What a viewpoint sees of an element: lines through the viewpoint are directions, a space of
/// dimension 3 in which every cell is real; otherwise as from a region (papers/exact.md, section
/// 6).
struct ViewOfElement {
  /// The seen part as disjoint convex polygons with positive areas.
  std::vector<RationalPolygon> visible_parts;
  /// Share of the element's area seen, in [0, 1].
  CGAL::Gmpq visible_fraction = 0;
  /// No occluder meets the interior of the cone between viewpoint and element.
  bool fully = false;
  bool hidden_by_one = false;  ///< one occluder covers the element
  bool edge_on = false;        ///< the viewpoint lies in the element's plane
};

/// The viewpoint is sum w_i p_i / sum w_i over its support: a single point with weight 1, or the
/// region end of a witness. Element and occluders: strictly convex planar polygons.
ViewOfElement view_element(std::span<const Point> support, std::span<const double> weights,
                           std::span<const Point> element,
                           std::span<const std::span<const Point>> occluders,
                           ExactStatistics& statistics);

/// Does the viewpoint see a part of the element that has area? As view_element, but ends with the
/// first cell that no occluder meets. Cost: about 20 us and 4 us an occluder.
bool sees_part(const Point& viewpoint, std::span<const Point> element,
               std::span<const std::span<const Point>> occluders, ExactStatistics& statistics);

}  // namespace viewcover::exact
