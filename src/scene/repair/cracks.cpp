#include "scene/repair/cracks.h"

#include <algorithm>
#include <array>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <tuple>
#include <unordered_map>

#include "scene/convex_polygon.h"
#include "scene/predicates.h"
#include "scene/repair/convex_parts.h"
#include "scene/repair/grown_box.h"

namespace viewcover {
namespace {

/// What a box is of.
struct Thing {
  std::uint32_t face = 0,
                number = 0;  ///< an edge; of a vertex the number alone, of a face the face
};
using ThingBox = GrownBox<Thing>;

class CrackFinder {
 public:
  CrackFinder(const PolygonSoup& soup, double width)
      : soup_(soup), width_(width), first_(first_at_place(soup.vertices)) {
    std::vector<char> is_used(soup.vertices.size(), 0);
    for (std::uint32_t face = 0; face < soup.faces.size(); ++face) {
      const PolygonSoup::Face& corners = soup.faces[face];
      for (std::uint32_t k = 0; k < corners.size(); ++k) {
        is_used[first_[corners[k]]] = 1;
        const Point& end = soup.vertices[corners[(k + 1) % corners.size()]];
        edges_.push_back(grown_box(bounding_box(std::array{soup.vertices[corners[k]], end}),
                                   width / 2, Thing{face, k}));
      }
    }
    for (std::uint32_t i = 0; i < is_used.size(); ++i) {
      if (is_used[i] == 0) continue;
      const Point& place = soup.vertices[i];
      vertices_.push_back(grown_box(Box(place, place), width / 2, Thing{0, i}));
    }
  }

  std::vector<NearVertices> apart() {
    std::vector<NearVertices> found;
    CGAL::box_self_intersection_d(
        vertices_.begin(), vertices_.end(), [&](const ThingBox& a, const ThingBox& b) {
          const auto [first, second] = std::minmax({a.info().number, b.info().number});
          const double distance = (soup_.vertices[first] - soup_.vertices[second]).norm();
          if (distance <= width_) found.push_back({first, second, distance});
        });
    std::ranges::sort(found, {},
                      [](const NearVertices& near) { return std::pair(near.first, near.second); });
    return found;
  }

  std::vector<VertexBesideFace> beside_faces() {
    std::vector<ThingBox> faces;
    for (std::uint32_t face = 0; face < soup_.faces.size(); ++face) {
      Box box;
      for (const std::uint32_t corner : soup_.faces[face]) box.extend(soup_.vertices[corner]);
      faces.push_back(grown_box(box, width_ / 2, Thing{face, 0}));
    }
    std::vector<VertexBesideFace> found;
    CGAL::box_intersection_d(
        vertices_.begin(), vertices_.end(), faces.begin(), faces.end(),
        [&](const ThingBox& vertex, const ThingBox& face) {
          const auto distance =
              distance_from_inside(soup_, vertex.info().number, face.info().face, width_);
          if (distance && *distance > 0) {
            found.push_back({vertex.info().number, face.info().face, *distance});
          }
        });
    std::ranges::sort(found, {}, [](const VertexBesideFace& beside) {
      return std::pair(beside.face, beside.vertex);
    });
    return found;
  }

  std::vector<Crack> beside_edges(std::size_t& junctions) {
    std::vector<Crack> found;
    std::vector<char> is_junction(soup_.vertices.size(), 0);
    CGAL::box_intersection_d(vertices_.begin(), vertices_.end(), edges_.begin(), edges_.end(),
                             [&](const ThingBox& vertex, const ThingBox& edge) {
                               look(vertex.info().number, edge.info(), found, is_junction);
                             });
    junctions = static_cast<std::size_t>(std::ranges::count(is_junction, 1));
    std::ranges::sort(found, {}, [](const Crack& crack) {
      return std::tuple(crack.face, crack.edge, crack.along, crack.vertex);
    });
    return found;
  }

 private:
  void look(std::uint32_t vertex, const Thing& edge, std::vector<Crack>& found,
            std::vector<char>& is_junction) const {
    const PolygonSoup::Face& corners = soup_.faces[edge.face];
    const auto is_this = [&](std::uint32_t corner) { return first_[corner] == vertex; };
    if (std::ranges::any_of(corners, is_this)) return;
    const Point &a = soup_.vertices[corners[edge.number]],
                &b = soup_.vertices[corners[(edge.number + 1) % corners.size()]],
                &x = soup_.vertices[vertex];
    const Point direction = b - a;
    const double length = direction.norm();
    if (length <= 2 * width_) return;
    const double along = direction.dot(x - a) / (length * length);
    const double from_a = along * length;
    if (from_a <= width_ || from_a >= length - width_) return;
    if (are_collinear(a, b, x)) {
      is_junction[vertex] = 1;
      return;
    }
    const double distance = (a + along * direction - x).norm();
    if (distance <= width_) {
      found.push_back({vertex, edge.face, edge.number, along, distance});
    }
  }

  const PolygonSoup& soup_;
  double width_;
  std::vector<std::uint32_t> first_;
  std::vector<ThingBox> vertices_, edges_;
};

}  // namespace

std::vector<std::uint32_t> first_at_place(const std::vector<Point>& vertices) {
  std::unordered_map<std::array<double, 3>, std::uint32_t, boost::hash<std::array<double, 3>>>
      places;
  std::vector<std::uint32_t> first;
  for (std::uint32_t i = 0; i < vertices.size(); ++i) {
    const Point& v = vertices[i];
    first.push_back(places.try_emplace({v.x() + 0.0, v.y() + 0.0, v.z() + 0.0}, i).first->second);
  }
  return first;
}

std::optional<double> distance_from_inside(const PolygonSoup& soup, std::uint32_t vertex,
                                           std::uint32_t face, double width) {
  const Point& x = soup.vertices[vertex];
  std::vector<Point> loop;
  for (const std::uint32_t corner : soup.faces[face]) {
    if (soup.vertices[corner] == x) return std::nullopt;
    loop.push_back(soup.vertices[corner]);
  }
  loop = without_straight_corners(loop);
  if (loop.size() < 3 || !is_planar(loop)) return std::nullopt;
  const Point normal = area_vector(loop).normalized();
  const double height = normal.dot(x - loop[0]);
  if (std::fabs(height) > width) return std::nullopt;
  const Point foot = x - height * normal;
  const int axis = projection_axis(loop), u = (axis + 1) % 3, v = (axis + 2) % 3;
  bool is_inside = false;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Point &a = loop[k], &b = loop[(k + 1) % loop.size()];
    const double along = std::clamp((b - a).dot(foot - a) / (b - a).squaredNorm(), 0.0, 1.0);
    if ((a + along * (b - a) - foot).norm() <= width) return std::nullopt;
    // Crossings of a ray along u.
    if ((a[v] > foot[v]) == (b[v] > foot[v])) continue;
    if (a[u] + (foot[v] - a[v]) / (b[v] - a[v]) * (b[u] - a[u]) > foot[u]) is_inside = !is_inside;
  }
  if (!is_inside) return std::nullopt;
  return orientation(loop[0], loop[1], loop[2], x) == 0 ? 0 : std::fabs(height);
}

std::vector<NearVertices> vertices_apart(const PolygonSoup& soup, double width) {
  return CrackFinder(soup, width).apart();
}

std::vector<Crack> vertices_beside_edges(const PolygonSoup& soup, double width) {
  std::size_t junctions = 0;
  return CrackFinder(soup, width).beside_edges(junctions);
}

std::vector<VertexBesideFace> vertices_beside_faces(const PolygonSoup& soup, double width) {
  return CrackFinder(soup, width).beside_faces();
}

Cracks find_cracks(const PolygonSoup& soup, double width) {
  CrackFinder finder(soup, width);
  Cracks cracks;
  cracks.apart = finder.apart();
  cracks.beside_edges = finder.beside_edges(cracks.junctions);
  cracks.beside_faces = finder.beside_faces();
  return cracks;
}

}  // namespace viewcover
