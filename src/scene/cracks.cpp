#include "scene/cracks.h"

#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <boost/container_hash/hash.hpp>
#include <tuple>
#include <unordered_map>

#include "scene/convex_parts.h"
#include "scene/predicates.h"

namespace viewcover {
namespace {

/// A vertex or an edge with its bounding box, grown by half of the width.
struct Thing {
  std::uint32_t face = 0, number = 0;  ///< a vertex: the number alone
};
using GrownBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Thing>;

GrownBox grown_box(const Point& a, const Point& b, double margin, const Thing& thing) {
  const Point least = a.cwiseMin(b) - Point::Constant(margin),
              most = a.cwiseMax(b) + Point::Constant(margin);
  return {CGAL::Bbox_3(least.x(), least.y(), least.z(), most.x(), most.y(), most.z()), thing};
}

/// For each vertex the first one at the same place.
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

class CrackFinder {
 public:
  CrackFinder(const PolygonSoup& soup, double width)
      : soup_(soup), width_(width), first_(first_at_place(soup.vertices)) {
    std::vector<char> is_used(soup.vertices.size(), 0);
    for (std::uint32_t face = 0; face < soup.faces.size(); ++face) {
      const PolygonSoup::Face& corners = soup.faces[face];
      for (std::uint32_t k = 0; k < corners.size(); ++k) {
        is_used[first_[corners[k]]] = 1;
        edges_.push_back(grown_box(soup.vertices[corners[k]],
                                   soup.vertices[corners[(k + 1) % corners.size()]], width / 2,
                                   {face, k}));
      }
    }
    for (std::uint32_t i = 0; i < is_used.size(); ++i) {
      if (is_used[i] == 0) continue;
      const Point& place = soup.vertices[i];
      vertices_.push_back(grown_box(place, place, width / 2, {0, i}));
    }
  }

  std::vector<NearVertices> apart() {
    std::vector<NearVertices> found;
    CGAL::box_self_intersection_d(
        vertices_.begin(), vertices_.end(), [&](const GrownBox& a, const GrownBox& b) {
          const auto [first, second] = std::minmax({a.info().number, b.info().number});
          const double distance = (soup_.vertices[first] - soup_.vertices[second]).norm();
          if (distance <= width_) found.push_back({first, second, distance});
        });
    std::ranges::sort(found, {},
                      [](const NearVertices& near) { return std::pair(near.first, near.second); });
    return found;
  }

  void find_beside_edges(Cracks& cracks) {
    std::vector<char> is_junction(soup_.vertices.size(), 0);
    CGAL::box_intersection_d(vertices_.begin(), vertices_.end(), edges_.begin(), edges_.end(),
                             [&](const GrownBox& vertex, const GrownBox& edge) {
                               look(vertex.info().number, edge.info(), cracks, is_junction);
                             });
    cracks.junctions = static_cast<std::size_t>(std::ranges::count(is_junction, 1));
    std::ranges::sort(cracks.beside_edges, {}, [](const Crack& crack) {
      return std::tuple(crack.face, crack.edge, crack.along, crack.vertex);
    });
  }

 private:
  void look(std::uint32_t vertex, const Thing& edge, Cracks& cracks,
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
      cracks.beside_edges.push_back({vertex, edge.face, edge.number, along, distance});
    }
  }

  const PolygonSoup& soup_;
  double width_;
  std::vector<std::uint32_t> first_;
  std::vector<GrownBox> vertices_, edges_;
};

/// Every vertex goes to the earliest one that is near, if that has not gone to another.
void move_together(PolygonSoup& soup, std::span<const NearVertices> apart, Healing& healing) {
  const std::vector<std::uint32_t> first = first_at_place(soup.vertices);
  std::vector<std::uint32_t> target(soup.vertices.size());
  for (std::uint32_t i = 0; i < target.size(); ++i) target[i] = i;
  for (const NearVertices& near : apart) {
    if (target[near.first] != near.first || target[near.second] != near.second) continue;
    target[near.second] = near.first;
    healing.largest_move = std::max(healing.largest_move, near.distance);
  }
  const std::vector<Point> places = soup.vertices;
  for (std::uint32_t i = 0; i < target.size(); ++i) {
    const std::uint32_t to = target[first[i]];
    if (to == first[i]) continue;
    soup.vertices[i] = places[to];
    ++healing.moved;
  }
}

bool crosses_itself(const PolygonSoup& soup, const PolygonSoup::Face& face) {
  std::vector<Point> loop;
  for (const std::uint32_t corner : face) loop.push_back(soup.vertices[corner]);
  return convex_parts(without_straight_corners(loop)).kind == FaceKind::kCrossing;
}

/// `cracks` are beside edges of one face. A vertex may be beside two of them, such as those of a
/// bridge to a hole. A thin face that the new corners would make cross itself stays as it is.
void insert_corners(PolygonSoup& soup, std::span<const Crack> cracks, Healing& healing) {
  PolygonSoup::Face& face = soup.faces[cracks.front().face];
  PolygonSoup::Face healed = face;
  std::size_t inserted = 0;
  // From the last: corners before stay where they are.
  for (auto crack = cracks.rbegin(); crack != cracks.rend(); ++crack) {
    if (std::ranges::find(face, crack->vertex) != face.end()) continue;
    healed.insert(healed.begin() + crack->edge + 1, crack->vertex);
    ++inserted;
  }
  if (crosses_itself(soup, healed) && !crosses_itself(soup, face)) return;
  face = std::move(healed);
  healing.inserted += inserted;
}

}  // namespace

Cracks find_cracks(const PolygonSoup& soup, double width) {
  CrackFinder finder(soup, width);
  Cracks cracks;
  cracks.apart = finder.apart();
  finder.find_beside_edges(cracks);
  return cracks;
}

Healing heal(PolygonSoup& soup, double width) {
  Healing healing;
  move_together(soup, find_cracks(soup, width).apart, healing);
  const std::vector<Crack> cracks = find_cracks(soup, width).beside_edges;
  for (auto begin = cracks.begin(); begin != cracks.end();) {
    const auto end = std::find_if(begin, cracks.end(),
                                  [&](const Crack& crack) { return crack.face != begin->face; });
    insert_corners(soup, {begin, end}, healing);
    begin = end;
  }
  return healing;
}

}  // namespace viewcover
