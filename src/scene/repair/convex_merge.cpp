#include "scene/repair/convex_merge.h"

#include <algorithm>
#include <array>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "scene/convex_polygon.h"
#include "scene/predicates.h"

namespace viewcover {
namespace {

using Edge = std::pair<std::uint32_t, std::uint32_t>;  // as its cell runs along it
using Corners = std::vector<std::uint32_t>;

class Merger {
 public:
  Merger(std::span<const Point> points, std::vector<ConvexCell> cells)
      : points_(points), cells_(std::move(cells)) {
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) add_edges(cell);
  }

  std::vector<ConvexCell> run() {
    while (merge_once_over_all_edges()) {
    }
    std::erase_if(cells_, [](const ConvexCell& cell) { return cell.corners.empty(); });
    return std::move(cells_);
  }

 private:
  static Edge edge(const Corners& corners, std::size_t i) {
    return {corners[i], corners[i + 1 == corners.size() ? 0 : i + 1]};
  }
  void add_edges(std::uint32_t cell) {
    const Corners& corners = cells_[cell].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      owners_[edge(corners, i)].push_back(cell);
    }
  }
  void remove_edges(std::uint32_t cell) {
    const Corners& corners = cells_[cell].corners;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto entry = owners_.find(edge(corners, i));
      std::erase(entry->second, cell);
      if (entry->second.empty()) owners_.erase(entry);
    }
  }
  /// The cells that run along the edge.
  std::vector<std::uint32_t> owners(const Edge& edge) const {
    const auto entry = owners_.find(edge);
    return entry == owners_.end() ? std::vector<std::uint32_t>() : entry->second;
  }

  // Parallel edges together, the class with the longest edge first. The class only orders the
  // work, so a rounded direction will do.
  std::vector<Edge> edges_in_order() const {
    using Direction = std::array<long, 3>;
    struct Class {
      double longest = 0;
      std::vector<Edge> edges;
    };
    std::map<Direction, Class> classes;
    for (std::uint32_t cell = 0; cell < cells_.size(); ++cell) {
      const Corners& corners = cells_[cell].corners;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const Edge here = edge(corners, i);
        if (!owners_.contains({here.second, here.first})) continue;
        Point along = points_[here.second] - points_[here.first];
        const double length = along.norm();
        along /= length;
        Direction direction;
        for (int k = 0; k < 3; ++k) direction[k] = std::lround(std::ldexp(along[k], 20));
        Direction opposite = direction;
        for (long& component : opposite) component = -component;
        Class& parallel = classes[std::max(direction, opposite)];
        parallel.longest = std::max(parallel.longest, length);
        parallel.edges.push_back(here);
      }
    }
    std::vector<const Class*> order;
    for (const auto& [direction, parallel] : classes) order.push_back(&parallel);
    std::stable_sort(order.begin(), order.end(),
                     [](const Class* a, const Class* b) { return a->longest > b->longest; });
    std::vector<Edge> edges;
    for (const Class* parallel : order) {
      edges.insert(edges.end(), parallel->edges.begin(), parallel->edges.end());
    }
    return edges;
  }

  bool merge_once_over_all_edges() {
    bool has_changed = false;
    for (const Edge& edge : edges_in_order()) {
      // Copies: a merge changes the owners.
      for (const std::uint32_t a : owners(edge)) {
        for (const std::uint32_t b : owners({edge.second, edge.first})) {
          if (try_merge(a, b, edge)) {
            has_changed = true;
            break;
          }
        }
      }
    }
    return has_changed;
  }

  bool try_merge(std::uint32_t a, std::uint32_t b, const Edge& over) {
    if (a == b || cells_[a].group != cells_[b].group || !are_coplanar(a, b)) return false;
    auto merged = united(cells_[a].corners, cells_[b].corners, over);
    if (!merged) return false;
    remove_edges(a);
    remove_edges(b);
    const auto [kept, gone] = std::minmax(a, b);
    cells_[kept].corners = std::move(*merged);
    cells_[gone].corners.clear();
    add_edges(kept);
    return true;
  }

  bool are_coplanar(std::uint32_t a, std::uint32_t b) const {
    const Corners& plane = cells_[a].corners;
    return std::all_of(cells_[b].corners.begin(), cells_[b].corners.end(), [&](std::uint32_t v) {
      return orientation(points_[plane[0]], points_[plane[1]], points_[plane[2]], points_[v]) == 0;
    });
  }

  // a runs from u to v, b from v to u. They lie on the two sides of the edge iff they turn the
  // same way; then the union is convex iff it does not turn the other way at u and v.
  std::optional<Corners> united(const Corners& a, const Corners& b, const Edge& over) const {
    const auto [u, v] = over;
    const auto after = [](const Corners& corners, std::uint32_t corner, std::size_t steps) {
      const auto at = std::find(corners.begin(), corners.end(), corner) - corners.begin();
      return corners[(static_cast<std::size_t>(at) + steps) % corners.size()];
    };
    ConvexPolygon polygon;
    for (const std::uint32_t corner : a) polygon.push_back(points_[corner]);
    const int axis = projection_axis(polygon);
    const auto turn_at = [&](std::uint32_t p, std::uint32_t q, std::uint32_t r) {
      return turn(points_[p], points_[q], points_[r], axis);
    };
    const int front = turn_at(a[0], a[1], a[2]);
    if (turn_at(b[0], b[1], b[2]) != front) return std::nullopt;
    const int at_u = turn_at(after(a, u, a.size() - 1), u, after(b, u, 1)) * front;
    const int at_v = turn_at(after(b, v, b.size() - 1), v, after(a, v, 1)) * front;
    if (at_u < 0 || at_v < 0) return std::nullopt;
    Corners corners;
    for (std::size_t i = at_v > 0 ? 0 : 1; i + 1 < a.size(); ++i) {
      corners.push_back(after(a, v, i));
    }
    for (std::size_t i = at_u > 0 ? 0 : 1; i + 1 < b.size(); ++i) {
      corners.push_back(after(b, u, i));
    }
    return corners;
  }

  std::span<const Point> points_;
  std::vector<ConvexCell> cells_;  // those that have gone into others have no corners
  std::unordered_map<Edge, std::vector<std::uint32_t>, boost::hash<Edge>> owners_;
};

}  // namespace

std::vector<ConvexCell> merge_convex(std::span<const Point> points, std::vector<ConvexCell> cells) {
  return Merger(points, std::move(cells)).run();
}

}  // namespace viewcover
