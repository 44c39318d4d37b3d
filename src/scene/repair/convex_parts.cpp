#include "scene/repair/convex_parts.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "scene/predicates.h"
#include "scene/repair/convex_merge.h"

namespace viewcover {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Exact = CGAL::Exact_rational;

enum class Side : char { kUnknown, kOutside, kInside };

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<Side, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
    CGAL::No_constraint_intersection_requiring_constructions_tag>;

using PointLoop = std::vector<Point>;

// Loops as indices into their different points.
struct IndexedLoops {
  std::vector<Point> points;
  std::vector<std::array<std::uint32_t, 2>> edges;
  std::vector<std::array<std::uint32_t, 2>> segments{};  // inside, no part of the boundary
};

IndexedLoops indexed(std::span<const PointLoop> loops) {
  IndexedLoops result;
  std::map<std::array<double, 3>, std::uint32_t> numbers;
  for (const PointLoop& loop : loops) {
    std::vector<std::uint32_t> corners;
    for (const Point& point : loop) {
      const auto next = static_cast<std::uint32_t>(result.points.size());
      const auto [entry, is_new] =
          numbers.emplace(std::array{point.x(), point.y(), point.z()}, next);
      if (is_new) result.points.push_back(point);
      corners.push_back(entry->second);
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      result.edges.push_back({corners[i], corners[(i + 1) % corners.size()]});
    }
  }
  return result;
}

// Twice the signed area of a loop projected along `axis`.
template <class Corners>
Exact twice_area(const Corners& loop, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  Exact sum = 0;
  for (std::size_t i = 0, n = loop.size(); i < n; ++i) {
    const Point &a = loop[i], &b = loop[(i + 1) % n];
    sum += Exact(a[u]) * Exact(b[v]) - Exact(a[v]) * Exact(b[u]);
  }
  return sum;
}

// The triangulation of loops in one coordinate projection.
class ProjectedLoops {
 public:
  ProjectedLoops(const IndexedLoops& loops, int axis) : loops_(loops), axis_(axis) {}

  /// False if the projection has no area, lays two points on one another, or shows a crossing.
  bool triangulate() {
    const int u = (axis_ + 1) % 3, v = (axis_ + 2) % 3;
    for (std::uint32_t i = 0; i < loops_.points.size(); ++i) {
      const Point& point = loops_.points[i];
      const auto vertex = triangulation_.insert(Kernel::Point_2(point[u], point[v]));
      vertex->info() = i;
      vertices_.push_back(vertex);
    }
    if (triangulation_.number_of_vertices() != loops_.points.size()) return false;
    if (triangulation_.dimension() != 2) return false;
    try {
      for (const auto& [from, to] : loops_.edges) {
        triangulation_.insert_constraint(vertices_[from], vertices_[to]);
      }
      for (const auto& [from, to] : loops_.segments) {
        triangulation_.insert_constraint(vertices_[from], vertices_[to]);
      }
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
      return false;
    }
    for (const auto& [from, to] : loops_.edges) walk(vertices_[from], vertices_[to]);
    mark_sides();
    return true;
  }

  /// The triangles inside, counter-clockwise in the projection.
  std::vector<std::array<std::uint32_t, 3>> triangles() const {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    for (const auto face : triangulation_.finite_face_handles()) {
      if (face->info() != Side::kInside) continue;
      triangles.push_back(
          {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    }
    return triangles;
  }

 private:
  using Vertex = Triangulation::Vertex_handle;

  // Counts the edges of the triangulation along one edge of the loop: several where other corners
  // of the loop lie on it.
  void walk(Vertex from, const Vertex to) {
    while (from != to) {
      auto around = triangulation_.incident_vertices(from);
      const auto is_next = [&](const Vertex& vertex) {
        return !triangulation_.is_infinite(vertex) &&
               (vertex == to ||
                CGAL::are_ordered_along_line(from->point(), vertex->point(), to->point()));
      };
      while (!is_next(around)) ++around;
      const Vertex next = around;
      ++walked_[std::minmax(from->info(), next->info())];
      from = next;
    }
  }

  bool is_boundary(Vertex a, Vertex b) const {
    if (triangulation_.is_infinite(a) || triangulation_.is_infinite(b)) return false;
    const auto entry = walked_.find(std::minmax(a->info(), b->info()));
    return entry != walked_.end() && entry->second % 2 == 1;
  }

  void mark_sides() {
    for (const auto face : triangulation_.all_face_handles()) face->info() = Side::kUnknown;
    std::vector<Triangulation::Face_handle> open{triangulation_.infinite_face()};
    open.back()->info() = Side::kOutside;
    while (!open.empty()) {
      const auto face = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const auto next = face->neighbor(i);
        if (next->info() != Side::kUnknown) continue;
        const bool crosses =
            is_boundary(face->vertex(Triangulation::cw(i)), face->vertex(Triangulation::ccw(i)));
        const bool is_inside = (face->info() == Side::kInside) != crosses;
        next->info() = is_inside ? Side::kInside : Side::kOutside;
        open.push_back(next);
      }
    }
  }

  const IndexedLoops& loops_;
  int axis_;
  Triangulation triangulation_;
  std::vector<Vertex> vertices_;  // by point
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> walked_;
};

bool is_planar_loop(std::span<const Point> loop) {
  return std::all_of(loop.begin(), loop.end(), [&](const Point& point) {
    return orientation(loop[0], loop[1], loop[2], point) == 0;
  });
}

// The largest component of the area vector first.
std::array<int, 3> axes_in_order(std::span<const Point> loop) {
  const Point size = area_vector(loop).cwiseAbs();
  std::array<int, 3> axes = {0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return size[a] > size[b]; });
  return axes;
}

ConvexPolygon polygon_of(const IndexedLoops& loops, std::span<const std::uint32_t> corners) {
  ConvexPolygon polygon;
  for (const std::uint32_t corner : corners) polygon.push_back(loops.points[corner]);
  return polygon;
}

// The parts in one projection, if that has area and shows no crossing.
std::optional<ConvexParts> parts_along(const IndexedLoops& indices,
                                       std::span<const PointLoop> loops, bool is_planar, int axis) {
  ProjectedLoops projected(indices, axis);
  if (!projected.triangulate()) return std::nullopt;
  Exact area = 0;
  for (const PointLoop& loop : loops) area += twice_area(loop, axis);
  std::vector<ConvexCell> cells;
  for (auto triangle : projected.triangles()) {
    if (area < 0) std::swap(triangle[1], triangle[2]);
    cells.push_back({{triangle.begin(), triangle.end()}, 0, 0});
  }
  // Where the face is not planar, too: only what lies exactly in one plane is joined.
  cells = merge_convex(indices.points, std::move(cells));
  ConvexParts parts;
  Exact sum = 0;
  for (const ConvexCell& cell : cells) {
    parts.polygons.push_back(polygon_of(indices, cell.corners));
    sum += twice_area(parts.polygons.back(), axis);
  }
  if (sum != area) return std::nullopt;
  if (area == 0) {
    parts.kind = FaceKind::kDegenerate;
  } else {
    parts.kind = is_planar ? FaceKind::kSplit : FaceKind::kTriangulated;
  }
  return parts;
}

}  // namespace

std::vector<Point> without_straight_corners(std::span<const Point> loop) {
  // Taking a corner out may make its neighbours straight: look back after each.
  std::vector<Point> kept(loop.begin(), loop.end());
  std::size_t unchanged = 0;
  for (std::size_t i = 0; kept.size() >= 3 && unchanged < kept.size();) {
    const std::size_t n = kept.size();
    i %= n;
    if (are_collinear(kept[(i + n - 1) % n], kept[i], kept[(i + 1) % n])) {
      kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(i));
      i = i == 0 ? n - 2 : i - 1;
      unchanged = 0;
    } else {
      ++i;
      ++unchanged;
    }
  }
  return kept;
}

ConvexParts convex_parts(std::span<const Point> loop) {
  const std::vector<Point> corners = without_straight_corners(loop);
  if (corners.size() < 3) return {};
  const bool is_planar = is_planar_loop(corners);
  if (is_planar && is_strictly_convex(corners)) {
    return {FaceKind::kWhole, {ConvexPolygon(corners.begin(), corners.end())}};
  }
  const std::array loops = {corners};
  const IndexedLoops indices = indexed(loops);
  for (const int axis : axes_in_order(corners)) {
    if (auto parts = parts_along(indices, loops, is_planar, axis)) return *std::move(parts);
  }
  return {FaceKind::kCrossing, {}};
}

ConvexParts convex_parts(std::span<const PointLoop> loops) {
  std::vector<PointLoop> kept;
  for (const PointLoop& loop : loops) {
    kept.push_back(without_straight_corners(loop));
    if (kept.back().size() < 3) kept.pop_back();
  }
  if (kept.empty()) return {};
  if (kept.size() == 1) return convex_parts(kept.front());
  for (const PointLoop& loop : kept) {
    const auto is_beside = [&](const Point& point) {
      return orientation(kept[0][0], kept[0][1], kept[0][2], point) != 0;
    };
    if (std::ranges::any_of(loop, is_beside)) return {FaceKind::kCrossing, {}};
  }
  if (auto parts = parts_along(indexed(kept), kept, true, axes_in_order(kept.front()).front())) {
    return *std::move(parts);
  }
  return {FaceKind::kCrossing, {}};
}

std::vector<std::array<Point, 3>> triangles_through(
    std::span<const Point> loop, std::span<const Point> points,
    std::span<const std::array<Point, 2>> segments) {
  const std::array loops = {without_straight_corners(loop)};
  IndexedLoops indices = indexed(loops);
  indices.points.insert(indices.points.end(), points.begin(), points.end());
  const auto number = [&](const Point& point) {
    return static_cast<std::uint32_t>(std::ranges::find(indices.points, point) -
                                      indices.points.begin());
  };
  for (const auto& [from, to] : segments) {
    // Not from corners that are left out as straight, nor from a place to itself.
    const auto ends = std::array{number(from), number(to)};
    if (ends[0] == ends[1] || std::ranges::max(ends) >= indices.points.size()) continue;
    indices.segments.push_back(ends);
  }
  const int axis = axes_in_order(loop).front();
  ProjectedLoops projected(indices, axis);
  if (!projected.triangulate()) return {};
  const Exact area = twice_area(loops.front(), axis);
  Exact sum = 0;
  std::vector<std::array<Point, 3>> triangles;
  for (const auto& [a, b, c] : projected.triangles()) {
    triangles.push_back({indices.points[a], indices.points[b], indices.points[c]});
    if (area < 0) std::swap(triangles.back()[1], triangles.back()[2]);
    sum += twice_area(triangles.back(), axis);
  }
  if (sum != area) return {};
  return triangles;
}

}  // namespace viewcover
