#include "scene/repair/heal.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "scene/repair/convex_parts.h"
#include "scene/repair/cracks.h"

namespace viewcover {
namespace {

/// Calls visit(those of one face) for each face in turn; `beside` is ordered by face.
template <class Beside, class Visit>
void for_each_face(const std::vector<Beside>& beside, const Visit& visit) {
  for (auto begin = beside.begin(); begin != beside.end();) {
    const auto end = std::find_if(begin, beside.end(),
                                  [&](const Beside& other) { return other.face != begin->face; });
    visit(std::span(begin, end));
    begin = end;
  }
}

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

/// Faces as triangles that have vertices beside the face's inside among their corners.
class FaceBender {
 public:
  FaceBender(PolygonSoup& soup, double width)
      : soup_(soup), width_(width), first_(first_at_place(soup.vertices)) {}

  void run(Healing& healing) {
    const std::vector<VertexBesideFace> beside = vertices_beside_faces(soup_, width_);
    if (beside.empty()) return;
    find_neighbours();
    std::map<std::uint32_t, std::vector<PolygonSoup::Face>> triangles;
    for_each_face(beside, [&](std::span<const VertexBesideFace> of_face) {
      std::vector<PolygonSoup::Face> bent = bend(of_face, healing);
      if (!bent.empty()) triangles.emplace(of_face.front().face, std::move(bent));
    });
    replace_faces(triangles);
  }

 private:
  /// Edges of other faces that lie beside a face with both ends are to be edges of its triangles.
  void find_neighbours() {
    neighbours_.resize(soup_.vertices.size());
    for (const PolygonSoup::Face& face : soup_.faces) {
      for (std::size_t k = 0; k < face.size(); ++k) {
        const std::uint32_t a = first_[face[k]], b = first_[face[(k + 1) % face.size()]];
        neighbours_[a].push_back(b);
        neighbours_[b].push_back(a);
      }
    }
    for (std::vector<std::uint32_t>& vertices : neighbours_) {
      std::ranges::sort(vertices);
      vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    }
  }

  /// `beside` are beside one face. No triangles if it stays as it is.
  std::vector<PolygonSoup::Face> bend(std::span<const VertexBesideFace> beside, Healing& healing) {
    const std::uint32_t face = beside.front().face;
    std::vector<VertexBesideFace> nearest(beside.begin(), beside.end());
    std::ranges::stable_sort(nearest, {}, &VertexBesideFace::distance);
    std::vector<std::uint32_t> inner;
    double largest = 0;
    for (const VertexBesideFace& candidate : nearest) {
      if (is_crowded(candidate.vertex, inner)) continue;
      inner.push_back(candidate.vertex);
      largest = candidate.distance;
    }
    const std::size_t bent = inner.size();
    add_those_in_the_plane(face, inner);

    std::map<std::array<double, 3>, std::uint32_t> numbers;
    const auto key = [&](std::uint32_t vertex) {
      const Point& p = soup_.vertices[vertex];
      return std::array{p.x(), p.y(), p.z()};
    };
    std::vector<Point> loop, points;
    std::set<std::uint32_t> corners(inner.begin(), inner.end());
    for (const std::uint32_t corner : soup_.faces[face]) {
      loop.push_back(soup_.vertices[corner]);
      numbers.emplace(key(corner), corner);
      corners.insert(first_[corner]);
    }
    std::vector<std::array<Point, 2>> segments;
    for (const std::uint32_t vertex : inner) {
      points.push_back(soup_.vertices[vertex]);
      numbers.emplace(key(vertex), vertex);
      for (const std::uint32_t other : neighbours_[vertex]) {
        if (corners.contains(other)) {
          segments.push_back({soup_.vertices[vertex], soup_.vertices[other]});
        }
      }
    }
    auto parts = triangles_through(loop, points, segments);
    // Edges that cross each other beside the face cannot all be in it.
    if (parts.empty()) parts = triangles_through(loop, points, {});
    if (parts.empty()) return {};
    healing.bent += bent;
    healing.largest_move = std::max(healing.largest_move, largest);
    std::vector<PolygonSoup::Face> triangles;
    for (const std::array<Point, 3>& part : parts) {
      PolygonSoup::Face triangle;
      for (const Point& p : part) triangle.push_back(numbers.at({p.x(), p.y(), p.z()}));
      triangles.push_back(std::move(triangle));
    }
    return triangles;
  }

  bool is_crowded(std::uint32_t vertex, std::span<const std::uint32_t> inner) const {
    // Both are at most the width from the face.
    return std::ranges::any_of(inner, [&](std::uint32_t other) {
      return (soup_.vertices[other] - soup_.vertices[vertex]).norm() <= 2 * width_;
    });
  }

  /// Neighbours of inner vertices that touch the face: edges between them are on it, too.
  void add_those_in_the_plane(std::uint32_t face, std::vector<std::uint32_t>& inner) {
    std::set<std::uint32_t> touching;
    for (const std::uint32_t vertex : inner) {
      for (const std::uint32_t other : neighbours_[vertex]) {
        if (distance_from_inside(soup_, other, face, width_) == 0.0) touching.insert(other);
      }
    }
    for (const std::uint32_t vertex : touching) {
      if (!is_crowded(vertex, inner)) inner.push_back(vertex);
    }
  }

  void replace_faces(const std::map<std::uint32_t, std::vector<PolygonSoup::Face>>& triangles) {
    PolygonSoup bent = soup_;
    bent.faces.clear();
    bent.face_groups.clear();
    bent.face_lines.clear();
    bent.numbers_in_file.clear();
    for (std::uint32_t face = 0; face < soup_.faces.size(); ++face) {
      const auto entry = triangles.find(face);
      const std::size_t count = entry == triangles.end() ? 1 : entry->second.size();
      for (std::size_t i = 0; i < count; ++i) {
        bent.faces.push_back(entry == triangles.end() ? soup_.faces[face] : entry->second[i]);
        bent.face_groups.push_back(soup_.face_groups[face]);
        if (!soup_.face_lines.empty()) bent.face_lines.push_back(soup_.face_lines[face]);
        bent.numbers_in_file.push_back(static_cast<std::uint32_t>(soup_.number_in_file(face)));
      }
    }
    soup_ = std::move(bent);
  }

  PolygonSoup& soup_;
  double width_;
  std::vector<std::uint32_t> first_;
  std::vector<std::vector<std::uint32_t>> neighbours_;  // by vertex, ascending
};

}  // namespace

Healing heal(PolygonSoup& soup, double width) {
  Healing healing;
  move_together(soup, vertices_apart(soup, width), healing);
  const std::vector<Crack> cracks = vertices_beside_edges(soup, width);
  for_each_face(cracks,
                [&](std::span<const Crack> of_face) { insert_corners(soup, of_face, healing); });
  FaceBender(soup, width).run(healing);
  return healing;
}

}  // namespace viewcover
