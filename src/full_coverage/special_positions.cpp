#include "full_coverage/special_positions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace viewcover {
namespace {

/// Lines that a position is moved to.
constexpr std::size_t kNearestLines = 6;
/// Shares of the extent: what counts as the same, and how far from a line positions are moved.
constexpr double kSame = 1e-9, kReach = 0.15, kBeside = 1e-6;
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
    const Box of_region = views.positions(i).region().bounds();
    boxes_.emplace_back(of_region.min() - margin, of_region.max() + margin);
  }
  for (const ConvexPolygon& part : region.polygons()) {
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
    remove_repeated(lines);
  }
  if (region.boxes.empty()) return;
  for (const Surface& surface : scene.surfaces) {
    const Point normal = area_vector(surface.polygon).normalized();
    planes_.push_back({normal, normal.dot(surface.polygon[0])});
  }
  remove_repeated(planes_);
}

void SpecialPositions::remove_repeated(std::vector<Line>& lines) const {
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
    return std::fabs(a.offset - b.offset) < kSame * extent_ && (a.normal - b.normal).norm() < kSame;
  };
  lines.erase(std::unique(lines.begin(), lines.end(), same), lines.end());
}

void SpecialPositions::add_at(const Point& point, std::vector<Viewpoint>& positions) const {
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    if (!boxes_[i].contains(point)) continue;
    const RegionPositions& region = views_.positions(i);
    Point position = region.nearest(point);
    if ((position - point).norm() > kRounding * boxes_[i].sizes().maxCoeff()) continue;
    if (!views_.is_free(i, position)) {
      position = region.nearest(point + kStepOff * (region.region().middle() - point));
      if (!views_.is_free(i, position)) continue;
    }
    positions.push_back({position, i});
  }
}

std::vector<Viewpoint> SpecialPositions::corners() const {
  std::vector<Viewpoint> positions;
  const ViewingRegion& region = views_.region();
  for (const ConvexPolygon& part : region.polygons()) {
    for (const Point& corner : part) add_at(corner, positions);
  }
  for (const Box& box : region.boxes) {
    for (const Point& corner : box_corners(box)) add_at(corner, positions);
  }
  return positions;
}

std::optional<Point> SpecialPositions::crossing(const Line& a, const Line& b, const Point& from,
                                                const Point& up) {
  // from + d with a.normal . d = r, b.normal . d = s, d in the part's plane.
  const double r = a.offset - a.normal.dot(from), s = b.offset - b.normal.dot(from);
  const double det = a.normal.cross(b.normal).dot(up);
  if (std::fabs(det) < kSame) return std::nullopt;
  return from + (r * b.normal.cross(up) - s * a.normal.cross(up)) / det;
}

std::vector<Viewpoint> SpecialPositions::beside(const Viewpoint& viewpoint) const {
  constexpr int kDirections = 8;
  const RegionShape& region = views_.positions(viewpoint.region).region();
  std::vector<Point> directions;
  if (region.is_box()) {
    for (int k = 0; k < kDirections; ++k) {
      directions.push_back(
          Point((k & 1) - 0.5, (k >> 1 & 1) - 0.5, (k >> 2 & 1) - 0.5).normalized());
    }
  } else {
    const ConvexPolygon& polygon = region.polygon();
    const Point u = (polygon[1] - polygon[0]).normalized(),
                v = area_vector(polygon).normalized().cross(u);
    for (int k = 0; k < kDirections; ++k) {
      const double angle = 2 * std::numbers::pi * (k + 0.5) / kDirections;
      directions.push_back(std::cos(angle) * u + std::sin(angle) * v);
    }
  }
  std::vector<Viewpoint> positions;
  for (const Point& direction : directions) {
    add_at(viewpoint.position + kBeside * extent_ * direction, positions);
  }
  return positions;
}

std::vector<Point> SpecialPositions::near_in_polygon(std::span<const Line> lines, const Point& from,
                                                     const Point& up) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    points.push_back(from + (lines[i].offset - lines[i].normal.dot(from)) * lines[i].normal);
    for (std::size_t j = 0; j < i; ++j) {
      const auto ij = crossing(lines[i], lines[j], from, up);
      if (!ij) continue;
      points.push_back(*ij);
      for (std::size_t k = 0; k < j; ++k) {
        const auto ik = crossing(lines[i], lines[k], from, up),
                   jk = crossing(lines[j], lines[k], from, up);
        if (ik && jk) points.push_back((*ij + *ik + *jk) / 3);
      }
    }
  }
  return points;
}

std::vector<Point> SpecialPositions::near_in_box(std::span<const Line> planes, const Point& from) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const Line& a = planes[i];
    points.push_back(from + (a.offset - a.normal.dot(from)) * a.normal);
    for (std::size_t j = 0; j < i; ++j) {
      // Nearest on the common line; the plane across it is the third of a corner.
      const Line& b = planes[j];
      const Point along = a.normal.cross(b.normal);
      if (along.norm() < kSame) continue;
      const Line across{along.normalized(), along.normalized().dot(from)};
      std::vector<Line> thirds(planes.begin(), planes.begin() + static_cast<std::ptrdiff_t>(j));
      thirds.push_back(across);
      for (const Line& c : thirds) {
        const double det = along.dot(c.normal);
        if (std::fabs(det) < kSame) continue;
        points.push_back((a.offset * b.normal.cross(c.normal) +
                          b.offset * c.normal.cross(a.normal) + c.offset * along) /
                         det);
      }
    }
  }
  return points;
}

std::vector<Viewpoint> SpecialPositions::near(const Viewpoint& viewpoint) const {
  const std::size_t part = viewpoint.region / views_.region().regions_per_part();
  const bool in_box = part >= lines_.size();
  const Point& from = viewpoint.position;
  std::vector<Line> lines = in_box ? planes_ : lines_[part];
  const std::size_t kept = std::min(kNearestLines, lines.size());
  std::ranges::partial_sort(lines, lines.begin() + static_cast<std::ptrdiff_t>(kept), {},
                            [&](const Line& line) { return line.distance(from); });
  lines.resize(kept);
  std::vector<Point> points =
      in_box ? near_in_box(lines, from)
             : near_in_polygon(lines, from, area_vector(views_.region().parts[part]).normalized());
  std::erase_if(points,
                [&](const Point& point) { return (point - from).norm() > kReach * extent_; });
  std::ranges::sort(points, {}, [&](const Point& point) { return (point - from).norm(); });
  std::vector<Viewpoint> positions;
  for (const Point& point : points) add_at(point, positions);
  return positions;
}

}  // namespace viewcover
