#include "show/cutaway.h"

#include <algorithm>
#include <array>

namespace viewcover {
namespace {

/// Corners this far on the wrong side of a plane, in diagonals of the scene, still count as in it.
constexpr double kTolerance = 1e-6;

/// -1 or 1 if all points are on that side of the plane, 0 if not.
template <class Points>
int common_side(const Points& points, const Point& normal, double offset, double tolerance) {
  double least = 0, most = 0;
  for (const Point& p : points) {
    const double distance = normal.dot(p) - offset;
    least = std::min(least, distance);
    most = std::max(most, distance);
  }
  if (most > tolerance && least >= -tolerance) return 1;
  if (least < -tolerance && most <= tolerance) return -1;
  return 0;
}

}  // namespace

std::vector<CutPlane> cut_planes(const Scene& scene, std::span<const ConvexPolygon> regions) {
  std::vector<Point> region_corners;
  for (const ConvexPolygon& region : regions) {
    region_corners.insert(region_corners.end(), region.begin(), region.end());
  }
  const std::array<Point, 8> scene_corners = box_corners(scene.bounds);
  const double tolerance = kTolerance * scene.bounds.diagonal().norm();
  std::vector<CutPlane> planes(scene.surfaces.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const ConvexPolygon& polygon = scene.surfaces[i].polygon;
    const Point normal = area_vector(polygon).normalized();
    const double offset = normal.dot(corner_mean(polygon));
    const int side = common_side(region_corners, normal, offset, tolerance);
    if (side == 0) continue;
    if (side > 0 || common_side(scene_corners, normal, offset, tolerance) == side) {
      planes[i] = {side * normal, side * offset};
    }
  }
  return planes;
}

}  // namespace viewcover
