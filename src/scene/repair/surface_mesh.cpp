#include "scene/repair/surface_mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <array>
#include <boost/container_hash/hash.hpp>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cassert>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "scene/predicates.h"
#include "scene/read/open_mesh.h"
#include "scene/repair/convex_merge.h"

namespace viewcover {
namespace {

using CgalPoint = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Loop = std::vector<std::size_t>;                // vertices of a surface, in order
using EdgeKey = std::pair<std::size_t, std::size_t>;  // the smaller first
using FacesByEdge = std::unordered_map<EdgeKey, std::vector<SurfaceId>, boost::hash<EdgeKey>>;

EdgeKey edge_key(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

// The different corners of some surfaces.
class Vertices {
 public:
  std::size_t id(const Point& point) {
    const auto [entry, is_new] =
        ids_.try_emplace({point.x() + 0.0, point.y() + 0.0, point.z() + 0.0}, points_.size());
    if (is_new) points_.push_back(point);
    return entry->second;
  }
  const std::vector<Point>& points() const { return points_; }

 private:
  using Coordinates = std::array<double, 3>;
  std::vector<Point> points_;
  std::unordered_map<Coordinates, std::size_t, boost::hash<Coordinates>> ids_;
};

// Finds the vertices that lie on an edge.
class EdgeCutter {
 public:
  explicit EdgeCutter(const std::vector<Point>& points) : points_(points), tree_(entries(points)) {}

  /// The vertices strictly between two others, from a to b. Exact.
  Loop between(std::size_t a, std::size_t b) const {
    const Point &from = points_[a], &to = points_[b];
    const Point low = from.cwiseMin(to), high = from.cwiseMax(to);
    Loop inside;
    const auto is_between = [&](const Entry& entry) {
      const std::size_t v = entry.second;
      if (v == a || v == b) return false;
      for (int axis = 0; axis < 3; ++axis) {
        if (turn(from, to, points_[v], axis) != 0) return false;
      }
      return true;  // in the box of the segment and on its line
    };
    const boost::geometry::model::box<TreePoint> box(tree_point(low), tree_point(high));
    for (auto entry = tree_.qbegin(boost::geometry::index::intersects(box) &&
                                   boost::geometry::index::satisfies(is_between));
         entry != tree_.qend(); ++entry) {
      inside.push_back(entry->second);
    }
    // On a line the order along the longest coordinate is the order along the line, exactly.
    int axis = 0;
    (to - from).cwiseAbs().maxCoeff(&axis);
    std::sort(inside.begin(), inside.end(), [&](std::size_t p, std::size_t q) {
      return (points_[p][axis] < points_[q][axis]) == (from[axis] < to[axis]) && p != q;
    });
    return inside;
  }

 private:
  using TreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using Entry = std::pair<TreePoint, std::size_t>;

  static TreePoint tree_point(const Point& p) { return {p.x(), p.y(), p.z()}; }
  static std::vector<Entry> entries(const std::vector<Point>& points) {
    std::vector<Entry> entries;
    for (std::size_t i = 0; i < points.size(); ++i) entries.emplace_back(tree_point(points[i]), i);
    return entries;
  }

  const std::vector<Point>& points_;
  boost::geometry::index::rtree<Entry, boost::geometry::index::rstar<16>> tree_;
};

std::vector<Loop> cut_loops(std::span<const Surface> surfaces, Vertices& vertices) {
  std::vector<Loop> corners(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (const Point& corner : surfaces[i].polygon) corners[i].push_back(vertices.id(corner));
  }
  const EdgeCutter cutter(vertices.points());
  std::vector<Loop> loops(surfaces.size());
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t k = 0; k < corners[i].size(); ++k) {
      const std::size_t a = corners[i][k], b = corners[i][(k + 1) % corners[i].size()];
      loops[i].push_back(a);
      const Loop inside = cutter.between(a, b);
      loops[i].insert(loops[i].end(), inside.begin(), inside.end());
    }
  }
  return loops;
}

FacesByEdge faces_by_edge(const std::vector<Loop>& loops) {
  FacesByEdge faces;
  for (std::size_t i = 0; i < loops.size(); ++i) {
    for (std::size_t k = 0; k < loops[i].size(); ++k) {
      faces[edge_key(loops[i][k], loops[i][(k + 1) % loops[i].size()])].emplace_back(i);
    }
  }
  return faces;
}

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parents_(size) {
    for (std::size_t i = 0; i < size; ++i) parents_[i] = i;
  }
  std::size_t find(std::size_t i) {
    while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parents_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parents_;
};

}  // namespace

struct SurfaceMesh::Mesh {
  explicit Mesh(std::span<const Surface> all) : surfaces(all.begin(), all.end()) {
    Vertices vertices;
    const std::vector<Loop> loops = cut_loops(surfaces, vertices);
    FacesByEdge faces = faces_by_edge(loops);
    edges = faces.size();
    for (const auto& [edge, meeting] : faces) {
      boundary_edges += meeting.size() == 1;
      non_manifold_edges += meeting.size() > 2;
    }
    find_components(faces);
    add_faces(loops, vertices);
    find_cuts(faces);
  }

  void find_components(const FacesByEdge& faces) {
    DisjointSets sets(surfaces.size());
    for (const auto& [edge, meeting] : faces) {
      for (const SurfaceId surface : meeting) sets.join(surface.value, meeting[0].value);
    }
    std::unordered_map<std::size_t, std::size_t> numbers;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
      component.push_back(numbers.try_emplace(sets.find(i), numbers.size()).first->second);
    }
    is_closed.assign(numbers.size(), true);
    for (const auto& [edge, meeting] : faces) {
      if (meeting.size() % 2 == 1) is_closed[component[meeting[0].value]] = false;
    }
  }

  // One mesh face a surface, in order. Vertices of the mesh remember what they were welded from.
  void add_faces(const std::vector<Loop>& loops, Vertices& vertices) {
    std::vector<CgalPoint> points;
    for (const Point& p : vertices.points()) points.emplace_back(p.x(), p.y(), p.z());
    std::vector<Loop> oriented = loops;
    // Turns polygons round and doubles points where the surface branches; drops nothing.
    CGAL::Polygon_mesh_processing::orient_polygon_soup(points, oriented);
    const auto add_vertex = [&](const CgalPoint& p) {
      welded.push_back(vertices.id({p.x(), p.y(), p.z()}));
      return mesh.add_vertex(OpenMeshPolygons::Point(p.x(), p.y(), p.z()));
    };
    for (const CgalPoint& point : points) add_vertex(point);
    for (std::size_t i = 0; i < oriented.size(); ++i) {
      std::vector<OpenMeshPolygons::VertexHandle> corners;
      for (const std::size_t v : oriented[i]) corners.emplace_back(static_cast<int>(v));
      auto face = can_add(corners) ? mesh.add_face(corners) : OpenMeshPolygons::FaceHandle();
      if (!face.is_valid()) {
        for (auto& corner : corners) {
          corner = add_vertex(points[static_cast<std::size_t>(corner.idx())]);
        }
        face = mesh.add_face(corners);
      }
      assert(face.idx() == static_cast<int>(i));
      const Loop& loop = loops[i];
      const auto first = std::find_if(corners.begin(), corners.end(), [&](auto v) {
        return welded[static_cast<std::size_t>(v.idx())] == loop[0];
      });
      const auto next = std::next(first) == corners.end() ? corners.begin() : std::next(first);
      is_reversed.push_back(welded[static_cast<std::size_t>(next->idx())] != loop[1]);
    }
  }

  // OpenMesh reports faces it cannot add on standard error; better not to ask.
  bool can_add(const std::vector<OpenMeshPolygons::VertexHandle>& corners) const {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      if (!mesh.is_boundary(corners[k])) return false;
      const auto halfedge = mesh.find_halfedge(corners[k], corners[(k + 1) % corners.size()]);
      if (halfedge.is_valid() && !mesh.is_boundary(halfedge)) return false;
    }
    return true;
  }

  // Keeps the edges of several surfaces at which the mesh had to be cut.
  void find_cuts(FacesByEdge& faces) {
    for (const auto halfedge : mesh.halfedges()) {
      if (!mesh.is_boundary(halfedge)) continue;
      const EdgeKey edge = welded_edge(halfedge);
      auto& meeting = faces.at(edge);
      if (meeting.size() > 1 && !cuts.contains(edge)) cuts.emplace(edge, meeting);
    }
  }

  EdgeKey welded_edge(OpenMeshPolygons::HalfedgeHandle halfedge) const {
    return edge_key(welded[static_cast<std::size_t>(mesh.from_vertex_handle(halfedge).idx())],
                    welded[static_cast<std::size_t>(mesh.to_vertex_handle(halfedge).idx())]);
  }

  std::vector<SurfaceId> neighbours(SurfaceId surface) const {
    std::vector<SurfaceId> found;
    const OpenMeshPolygons::FaceHandle face(static_cast<int>(surface.value));
    for (auto halfedge = mesh.cfh_iter(face); halfedge.is_valid(); ++halfedge) {
      const auto opposite = mesh.opposite_halfedge_handle(*halfedge);
      if (!mesh.is_boundary(opposite)) {
        found.emplace_back(static_cast<std::size_t>(mesh.face_handle(opposite).idx()));
      } else if (const auto cut = cuts.find(welded_edge(*halfedge)); cut != cuts.end()) {
        found.insert(found.end(), cut->second.begin(), cut->second.end());
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::erase(found, surface);
    return found;
  }

  std::vector<Surface> surfaces;
  OpenMeshPolygons mesh;
  std::vector<std::size_t> welded;  // by mesh vertex: the vertex before the mesh was cut
  FacesByEdge cuts;
  std::vector<bool> is_reversed;
  std::vector<std::size_t> component;
  std::vector<bool> is_closed;
  std::size_t edges = 0, boundary_edges = 0, non_manifold_edges = 0;
};

SurfaceMesh::SurfaceMesh(std::span<const Surface> surfaces)
    : mesh_(std::make_unique<const Mesh>(surfaces)) {}
SurfaceMesh::~SurfaceMesh() = default;
SurfaceMesh::SurfaceMesh(SurfaceMesh&&) noexcept = default;
SurfaceMesh& SurfaceMesh::operator=(SurfaceMesh&&) noexcept = default;

std::vector<SurfaceId> SurfaceMesh::neighbours(SurfaceId surface) const {
  return mesh_->neighbours(surface);
}

std::vector<SurfaceId> SurfaceMesh::coplanar_neighbours(SurfaceId surface) const {
  std::vector<SurfaceId> found = neighbours(surface);
  const ConvexPolygon& plane = mesh_->surfaces[surface.value].polygon;
  std::erase_if(found, [&](SurfaceId other) {
    const ConvexPolygon& polygon = mesh_->surfaces[other.value].polygon;
    return std::any_of(polygon.begin(), polygon.end(), [&](const Point& corner) {
      return orientation(plane[0], plane[1], plane[2], corner) != 0;
    });
  });
  return found;
}

std::size_t SurfaceMesh::faces() const { return mesh_->mesh.n_faces(); }
std::size_t SurfaceMesh::edges() const { return mesh_->edges; }
std::size_t SurfaceMesh::boundary_edges() const { return mesh_->boundary_edges; }
std::size_t SurfaceMesh::non_manifold_edges() const { return mesh_->non_manifold_edges; }
std::size_t SurfaceMesh::components() const { return mesh_->is_closed.size(); }
std::size_t SurfaceMesh::component_of(SurfaceId surface) const {
  return mesh_->component[surface.value];
}
bool SurfaceMesh::is_closed(std::size_t component) const { return mesh_->is_closed[component]; }
bool SurfaceMesh::is_reversed(SurfaceId surface) const { return mesh_->is_reversed[surface.value]; }

std::size_t merge_coplanar(std::vector<Surface>& surfaces) {
  Vertices vertices;
  std::vector<ConvexCell> cells;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    ConvexCell cell;
    for (const Point& corner : surfaces[i].polygon) {
      cell.corners.push_back(static_cast<std::uint32_t>(vertices.id(corner)));
    }
    cell.group = surfaces[i].group.value;
    cell.source = static_cast<std::uint32_t>(i);
    cells.push_back(std::move(cell));
  }
  cells = merge_convex(vertices.points(), std::move(cells));
  std::vector<Surface> merged;
  for (const ConvexCell& cell : cells) {
    Surface surface = surfaces[cell.source];
    surface.polygon.clear();
    for (const std::uint32_t corner : cell.corners) {
      surface.polygon.push_back(vertices.points()[corner]);
    }
    merged.push_back(std::move(surface));
  }
  const std::size_t gone = surfaces.size() - merged.size();
  surfaces = std::move(merged);
  return gone;
}

}  // namespace viewcover
