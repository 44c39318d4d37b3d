#include "scene/convex_polygon.h"

#include <cmath>
#include <utility>

#include "scene/predicates.h"

namespace viewcover {
namespace {

Point midpoint(const Point& a, const Point& b) { return 0.5 * (a + b); }

// The corners from number `from` to number `to`, both included, walking forward round the polygon.
ConvexPolygon run_of_corners(const ConvexPolygon& polygon, std::size_t from, std::size_t to) {
  ConvexPolygon run;
  const std::size_t n = polygon.size();
  for (std::size_t i = from; i != to; i = (i + 1) % n) run.push_back(polygon[i]);
  run.push_back(polygon[to]);
  return run;
}

using Halves = std::pair<ConvexPolygon, ConvexPolygon>;

// Cut along the shortest of the diagonals that leave nearly equal corner counts.
Halves halves_by_diagonal(const ConvexPolygon& polygon) {
  const std::size_t n = polygon.size(), half = n / 2;
  std::size_t best = 0;
  double shortest = INFINITY;
  for (std::size_t i = 0; i < n; ++i) {
    const double length = (polygon[(i + half) % n] - polygon[i]).squaredNorm();
    if (length < shortest) {
      shortest = length;
      best = i;
    }
  }
  const std::size_t other = (best + half) % n;
  return {run_of_corners(polygon, best, other), run_of_corners(polygon, other, best)};
}

// Cut a triangle from a corner to the middle of the longest edge, a quadrilateral through the
// middles of the longer pair of opposite edges.
Halves halves_by_midpoints(const ConvexPolygon& p) {
  if (p.size() == 3) {
    std::size_t longest = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if ((p[(i + 1) % 3] - p[i]).squaredNorm() >
          (p[(longest + 1) % 3] - p[longest]).squaredNorm()) {
        longest = i;
      }
    }
    const Point &a = p[longest], &b = p[(longest + 1) % 3], &c = p[(longest + 2) % 3];
    const Point middle = midpoint(a, b);
    return {{a, middle, c}, {middle, b, c}};
  }
  const double even = (p[1] - p[0]).squaredNorm() + (p[3] - p[2]).squaredNorm();
  const double odd = (p[2] - p[1]).squaredNorm() + (p[0] - p[3]).squaredNorm();
  const std::size_t s = even >= odd ? 0 : 1;
  const Point &a = p[s], &b = p[s + 1], &c = p[(s + 2) % 4], &d = p[(s + 3) % 4];
  const Point ab = midpoint(a, b), cd = midpoint(c, d);
  return {{a, ab, cd, d}, {ab, b, c, cd}};
}

Halves halves(const ConvexPolygon& polygon) {
  return polygon.size() > 4 ? halves_by_diagonal(polygon) : halves_by_midpoints(polygon);
}

}  // namespace

Point area_vector(std::span<const Point> loop) {
  Point sum = Point::Zero();
  for (std::size_t i = 2; i < loop.size(); ++i) {
    sum += (loop[i - 1] - loop[0]).cross(loop[i] - loop[0]);
  }
  return sum;
}

double area(std::span<const Point> loop) { return 0.5 * area_vector(loop).norm(); }

Point corner_mean(std::span<const Point> loop) {
  Point sum = Point::Zero();
  for (const Point& corner : loop) sum += corner;
  return sum / static_cast<double>(loop.size());
}

Point centroid(std::span<const Point> polygon) {
  Point sum = Point::Zero();
  double total = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Point u = polygon[i - 1] - polygon[0], v = polygon[i] - polygon[0];
    const double weight = u.cross(v).norm();
    sum += weight * (u + v);
    total += weight;
  }
  return polygon[0] + sum / (3 * total);
}

Box bounding_box(std::span<const Point> points) {
  Box box;
  for (const Point& point : points) box.extend(point);
  return box;
}

std::array<Point, 8> box_corners(const Box& box) {
  std::array<Point, 8> corners;
  for (int k = 0; k < 8; ++k) {
    corners[static_cast<std::size_t>(k)] = box.corner(static_cast<Box::CornerType>(k));
  }
  return corners;
}

int projection_axis(std::span<const Point> loop) {
  int axis = 0;
  area_vector(loop).cwiseAbs().maxCoeff(&axis);
  return axis;
}

bool is_planar(std::span<const Point> loop) {
  const int axis = projection_axis(loop);
  // Any three corners that turn span the plane.
  const Point &a = loop[0], *b = nullptr, *c = nullptr;
  for (std::size_t i = 1; i < loop.size() && c == nullptr; ++i) {
    if (b == nullptr) {
      if (loop[i] != a) b = &loop[i];
    } else if (turn(a, *b, loop[i], axis) != 0) {
      c = &loop[i];
    }
  }
  if (c == nullptr) return true;
  for (const Point& corner : loop) {
    if (orientation(a, *b, *c, corner) != 0) return false;
  }
  return true;
}

bool is_strictly_convex(std::span<const Point> loop) {
  const std::size_t n = loop.size();
  if (n < 3) return false;
  const int axis = projection_axis(loop);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto is_ahead = [&](std::size_t i) {
    const Point &from = loop[i % n], &to = loop[(i + 1) % n];
    return std::pair(from[u], from[v]) < std::pair(to[u], to[v]);
  };
  const int expected = turn(loop[0], loop[1], loop[2], axis);
  if (expected == 0) return false;
  int direction_changes = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (turn(loop[i], loop[(i + 1) % n], loop[(i + 2) % n], axis) != expected) return false;
    direction_changes += is_ahead(i) != is_ahead(i + 1);
  }
  return direction_changes == 2;  // more: it winds round more than once
}

std::vector<std::size_t> turning_corners(std::span<const Point> loop) {
  const std::size_t n = loop.size();
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const Point &before = loop[(i + n - 1) % n], &here = loop[i], &after = loop[(i + 1) % n];
    for (int axis = 0; axis < 3; ++axis) {
      if (turn(before, here, after, axis) == 0) continue;
      corners.push_back(i);
      break;
    }
  }
  return corners;
}

std::array<ConvexPolygon, 4> quarters(const ConvexPolygon& p) {
  if (p.size() == 3) {
    const Point ab = midpoint(p[0], p[1]), bc = midpoint(p[1], p[2]), ca = midpoint(p[2], p[0]);
    return {ConvexPolygon{p[0], ab, ca}, {p[1], bc, ab}, {p[2], ca, bc}, {ab, bc, ca}};
  }
  if (p.size() == 4) {
    const Point ab = midpoint(p[0], p[1]), bc = midpoint(p[1], p[2]);
    const Point cd = midpoint(p[2], p[3]), da = midpoint(p[3], p[0]);
    const Point centre = midpoint(ab, cd);
    return {ConvexPolygon{p[0], ab, centre, da},
            {p[1], bc, centre, ab},
            {p[2], cd, centre, bc},
            {p[3], da, centre, cd}};
  }
  const auto [first, second] = halves(p);
  auto [a, b] = halves(first);
  auto [c, d] = halves(second);
  return {std::move(a), std::move(b), std::move(c), std::move(d)};
}

}  // namespace viewcover
