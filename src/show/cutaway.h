#pragma once

#include <span>
#include <vector>

#include "scene/scene.h"

namespace viewcover {

/// A plane that may be cut away: where the camera is at `normal . p < offset`, its surface stands
/// between the camera and the viewing region and would hide the inside.
struct CutPlane {
  Point normal = Point::Zero();  ///< unit length, towards the region; zero: never cut
  double offset = 0;

  bool cuts(const Point& camera) const { return !normal.isZero(0) && normal.dot(camera) < offset; }
};

/// Which surfaces are walls and ceilings round the viewing region, by surface: those whose plane
/// has the whole region on one side, and that show their front to it (a wall's inside) or have
/// the whole scene on that side too (a wall's outside, or one whose faces are turned any way).
/// Rounded: for pictures only.
std::vector<CutPlane> cut_planes(const Scene& scene, std::span<const ConvexPolygon> regions);

}  // namespace viewcover
