#include "links/point_shaft.h"

#include <algorithm>

namespace viewcover {
namespace {

/// The plane through a viewpoint and edge `k` of a polygon, in front of which lines from the
/// viewpoint pass the polygon outside that edge.
Plane plane_outside_edge(const Point& viewpoint, std::span<const Point> polygon, std::size_t k,
                         bool in_front, double reach) {
  const Point &a = polygon[k], &b = polygon[k + 1 < polygon.size() ? k + 1 : 0];
  return in_front ? Plane(viewpoint, a, b, reach) : Plane(viewpoint, b, a, reach);
}

}  // namespace

PointShaft::PointShaft(const OccluderSet& occluders, const Point& viewpoint,
                       ElementAddress element_address, const PlanarPolygon& element, bool one_sided)
    : occluders_(&occluders),
      viewpoint_(viewpoint),
      element_address_(element_address),
      element_(&element),
      one_sided_(one_sided) {
  const int side = element.plane.side(viewpoint);
  facing_ = one_sided ? side > 0 : side != 0;
  if (!facing_) return;
  planes_.push_back(side > 0 ? element.plane.reversed() : element.plane);
  for (std::size_t k = 0; k < element.polygon.size(); ++k) {
    planes_.push_back(
        plane_outside_edge(viewpoint, element.polygon, k, side > 0, occluders.reach()));
  }
}

PointShaft::Meets PointShaft::meets(OccluderId occluder) const {
  const std::span<const Point> polygon = occluders_->polygon(occluder);
  const Plane& plane = occluders_->plane(occluder);
  const int at_viewpoint = plane.side(viewpoint_);
  if (at_viewpoint == 0) return Meets::kNo;
  bool any_behind = false, all_behind = true;
  for (const Point& corner : element_->polygon) {
    const int side = at_viewpoint * plane.side(corner);
    any_behind |= side < 0;
    all_behind &= side <= 0;
  }
  if (!any_behind) return Meets::kNo;
  for (const Plane& bound : planes_) {
    if (std::none_of(polygon.begin(), polygon.end(),
                     [&](const Point& corner) { return bound.side(corner) < 0; })) {
      return Meets::kNo;
    }
  }
  // Of the lines to the element those are blocked that pass all edges of the occluder inside.
  bool covers = all_behind;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Plane bound =
        plane_outside_edge(viewpoint_, polygon, k, at_viewpoint > 0, occluders_->reach());
    bool any_inside = false;
    for (const Point& corner : element_->polygon) {
      const int side = bound.side(corner);
      any_inside |= side < 0;
      covers &= side <= 0;
    }
    if (!any_inside) return Meets::kNo;
  }
  return covers ? Meets::kBlocksAll : Meets::kMaybe;
}

bool PointShaft::cull(std::span<const OccluderId> candidates, PointShaftOccluders& kept) const {
  kept.clear();
  for (const OccluderId candidate : candidates) {
    switch (meets(candidate)) {
      case Meets::kBlocksAll:
        return true;
      case Meets::kMaybe:
        kept.push_back(candidate);
        break;
      case Meets::kNo:
        break;
    }
  }
  return false;
}

}  // namespace viewcover
