#include "full_coverage/special_positions.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace viewcover {
namespace {

/// Lines that a position is moved to.
constexpr std::size_t kNearestLines = 6;
/// Shares of the extent: what counts as the same, and how far from a line positions are moved.
constexpr double kSame = 1e-9, kReach = 0.15;
/// Of a region's extent: how far a position may be rounded.
constexpr double kRounding = 1e-5;
/// From a surface into the region, as a share of the way to the region's middle.
constexpr double kStepOff = 0x1p-18;

}  // namespace

SpecialPositions::SpecialPositions(const RegionViews& views) : views_(views) {
  const ViewingRegion& region = views.region();
  const Scene& scene = views.viewed().scene;
  Box box = scene.bounds;
  for (const ConvexPolygon& part : region.parts) box.extend(bounding_box(part));
  extent_ = box.sizes().maxCoeff();
  const Point margin = Point::Constant(kSame * extent_);
  for (std::size_t i = 0; i < region.region_count(); ++i) {
    const Box of_region = bounding_box(views.positions(i).region());
    boxes_.emplace_back(of_region.min() - margin, of_region.max() + margin);
  }
  for (const ConvexPolygon& part : region.parts) {
    const Point up = area_vector(part).normalized();
    std::vector<Line>& lines = lines_.emplace_back();
    for (const Surface& surface : scene.surfaces) {
      const Point normal = area_vector(surface.polygon).normalized();
      const Point in_part = normal - normal.dot(up) * up;
      const double length = in_part.norm();
      if (length < kSame) continue;
      // normal . x = normal . corner for points x of the part: what is along `up` is a constant.
      const double along = normal.dot(up) * up.dot(part[0]);
      lines.push_back({in_part / length, (normal.dot(surface.polygon[0]) - along) / length});
    }
    for (Line& line : lines) {
      // One direction for each line, so that equal ones are neighbours.
      const Point& n = line.normal;
      const double first = std::fabs(n.x()) > kSame   ? n.x()
                           : std::fabs(n.y()) > kSame ? n.y()
                                                      : n.z();
      if (first < 0) line = {-line.normal, -line.offset};
    }
    const auto key = [](const Line& line) {
      return std::array{line.offset, line.normal.x(), line.normal.y(), line.normal.z()};
    };
    std::ranges::sort(lines, {}, key);
    const auto same = [&](const Line& a, const Line& b) {
      return std::fabs(a.offset - b.offset) < kSame * extent_ &&
             (a.normal - b.normal).norm() < kSame;
    };
    lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
  }
}

void SpecialPositions::add_at(const Point& point, std::vector<Viewpoint>& positions) const {
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (!boxes_[i].contains(point)) continue;
    const RegionPositions& region = views_.positions(i);
    Point position = region.nearest(point);
    if ((position - point).norm() > kRounding * boxes_[i].sizes().maxCoeff()) continue;
    if (!views_.is_free(i, position)) {
      position = region.nearest(point + kStepOff * (centroid(region.region()) - point));
      if (!views_.is_free(i, position)) continue;
    }
    positions.push_back({position, i});
  }
}

std::vector<Viewpoint> SpecialPositions::corners() const {
  std::vector<Viewpoint> positions;
  for (const ConvexPolygon& part : views_.region().parts) {
    for (const Point& corner : part) add_at(corner, positions);
  }
  return positions;
}

std::vector<Viewpoint> SpecialPositions::near(const Viewpoint& viewpoint) const {
  const std::size_t part = viewpoint.region / views_.region().regions_per_part();
  const Point& from = viewpoint.position;
  const Point up = area_vector(views_.region().parts[part]).normalized();
  const auto distance = [&](const Line& line) {
    return std::fabs(line.normal.dot(from) - line.offset);
  };
  std::vector<Line> lines = lines_[part];
  const std::size_t kept = std::min(kNearestLines, lines.size());
  std::ranges::partial_sort(lines, lines.begin() + static_cast<std::ptrdiff_t>(kept), {}, distance);
  lines.resize(kept);
  std::vector<Point> points;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    points.push_back(from + (lines[i].offset - lines[i].normal.dot(from)) * lines[i].normal);
    for (std::size_t j = 0; j < i; ++j) {
      // from + d with normal_i . d = r_i, normal_j . d = r_j, d in the part's plane.
      const double r = lines[i].offset - lines[i].normal.dot(from),
                   s = lines[j].offset - lines[j].normal.dot(from);
      const double det = lines[i].normal.cross(lines[j].normal).dot(up);
      if (std::fabs(det) < kSame) continue;
      points.push_back(from +
                       (r * lines[j].normal.cross(up) - s * lines[i].normal.cross(up)) / det);
    }
  }
  std::erase_if(points,
                [&](const Point& point) { return (point - from).norm() > kReach * extent_; });
  std::ranges::sort(points, {}, [&](const Point& point) { return (point - from).norm(); });
  std::vector<Viewpoint> positions;
  for (const Point& point : points) add_at(point, positions);
  return positions;
}

}  // namespace viewcover
