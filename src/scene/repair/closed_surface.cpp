#include "scene/repair/closed_surface.h"

#include <algorithm>
#include <array>
#include <boost/pending/disjoint_sets.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <random>
#include <span>
#include <tuple>

#include "scene/predicates.h"

namespace viewcover {
namespace {

__extension__ typedef __int128 Wide;  // lattice coordinates fit 53 bits, moments 108
using LatticePoint = std::array<std::int64_t, 3>;

// An edge of a surface, on the line it lies on.
struct LineEdge {
  // The line in Pluecker coordinates: primitive direction, its first non-zero component positive,
  // and moment. Equal for two edges iff they lie on one line.
  LatticePoint direction;
  std::array<Wide, 3> moment;
  std::int64_t begin = 0, end = 0;  // place on the line, begin < end
  std::uint32_t surface = 0;
  bool is_forward = false;  // the surface's boundary runs along `direction`

  auto line() const { return std::tie(direction, moment); }
};

LatticePoint lattice_point(const Point& p, const Lattice& lattice) {
  const auto integer = [&](double x) {
    return static_cast<std::int64_t>(std::ldexp(x, lattice.exponent));
  };
  return {integer(p.x()), integer(p.y()), integer(p.z())};
}

LineEdge line_edge(const LatticePoint& a, const LatticePoint& b, std::uint32_t surface) {
  LineEdge edge;
  edge.surface = surface;
  LatticePoint& d = edge.direction;
  for (std::size_t i = 0; i < 3; ++i) d[i] = b[i] - a[i];
  std::int64_t divisor = std::gcd(std::gcd(d[0], d[1]), d[2]);
  const std::size_t axis = d[0] != 0 ? 0 : d[1] != 0 ? 1 : 2;
  edge.is_forward = d[axis] > 0;
  if (!edge.is_forward) divisor = -divisor;
  for (std::int64_t& component : d) component /= divisor;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    edge.moment[i] = Wide(a[j]) * d[k] - Wide(a[k]) * d[j];
  }
  std::tie(edge.begin, edge.end) = std::minmax(a[axis], b[axis]);
  return edge;
}

// Maximal stretches of lines along which the same surfaces lie.
struct Stretches {
  struct Side {
    std::uint32_t surface;
    bool is_forward;
  };
  std::vector<Side> sides;
  std::vector<std::size_t> first = {0};  // stretch s has the sides [first[s], first[s + 1])

  std::size_t size() const { return first.size() - 1; }
  std::span<const Side> operator[](std::size_t s) const {
    return {sides.data() + first[s], first[s + 1] - first[s]};
  }
};

// Adds the stretches of one line, whose edges are given.
void add_stretches(std::span<LineEdge> edges, Stretches& stretches) {
  std::vector<std::int64_t> places;
  for (const LineEdge& edge : edges) places.insert(places.end(), {edge.begin, edge.end});
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::sort(edges.begin(), edges.end(),
            [](const LineEdge& a, const LineEdge& b) { return a.begin < b.begin; });

  std::vector<const LineEdge*> active;
  std::size_t next = 0;
  for (const std::int64_t place : places) {
    std::erase_if(active, [&](const LineEdge* edge) { return edge->end <= place; });
    while (next < edges.size() && edges[next].begin == place) active.push_back(&edges[next++]);
    if (active.empty()) continue;
    for (const LineEdge* edge : active) {
      stretches.sides.push_back({edge->surface, edge->is_forward});
    }
    stretches.first.push_back(stretches.sides.size());
  }
}

Stretches find_stretches(const Scene& scene) {
  std::vector<LineEdge> edges;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const ConvexPolygon& polygon = scene.surfaces[s].polygon;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      edges.push_back(line_edge(lattice_point(polygon[i], scene.lattice),
                                lattice_point(polygon[(i + 1) % polygon.size()], scene.lattice),
                                static_cast<std::uint32_t>(s)));
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const LineEdge& a, const LineEdge& b) { return a.line() < b.line(); });
  Stretches stretches;
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t end = i + 1;
    while (end < edges.size() && edges[end].line() == edges[i].line()) ++end;
    add_stretches(std::span(edges).subspan(i, end - i), stretches);
    i = end;
  }
  return stretches;
}

bool lies_on(const Point& point, std::span<const Point> polygon) {
  if (orientation(polygon[0], polygon[1], polygon[2], point) != 0) return false;
  const int axis = projection_axis(polygon);
  bool left = false, right = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const int side = turn(polygon[i], polygon[(i + 1) % polygon.size()], point, axis);
    left = left || side > 0;
    right = right || side < 0;
  }
  return !(left && right);
}

// How the segment from `from`, not on the polygon, to `to`, outside the bounds, goes through the
// polygon: 1 from back to front, -1 from front to back, 0 not at all; none if it grazes.
std::optional<int> passage(std::span<const Point> polygon, const Point& from, const Point& to) {
  const int begin = orientation(polygon[0], polygon[1], polygon[2], from);
  const int end = orientation(polygon[0], polygon[1], polygon[2], to);
  if (begin == 0 && end == 0) return std::nullopt;
  if (begin * end >= 0) return 0;
  bool left = false, right = false, meets_edge = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const int side = orientation(from, to, polygon[i], polygon[(i + 1) % polygon.size()]);
    left = left || side > 0;
    right = right || side < 0;
    meets_edge = meets_edge || side == 0;
    if (left && right) return 0;
  }
  if (meets_edge) return std::nullopt;
  return end;
}

std::optional<Enclosure> enclosure_along(const Scene& scene, const ClosedSurface& closed,
                                         const Point& from, const Point& to) {
  Enclosure result;
  for (const SurfaceId surface : closed.surfaces) {
    const std::optional<int> passed = passage(scene[surface].polygon, from, to);
    if (!passed) return std::nullopt;
    if (*passed != 0) result.is_inside = !result.is_inside;
    result.winding += *passed;
  }
  return result;
}

}  // namespace

std::vector<ClosedSurface> closed_surfaces(const Scene& scene) {
  const Stretches stretches = find_stretches(scene);
  const std::size_t n = scene.surfaces.size();
  boost::disjoint_sets_with_storage<> pieces(n);
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    if (stretches[s].size() == 2) {
      pieces.union_set(stretches[s][0].surface, stretches[s][1].surface);
    }
  }

  std::vector<bool> is_open(n), is_mixed(n);  // by the piece's representative
  struct Tally {
    int sides = 0, balance = 0;
  };
  std::map<std::size_t, Tally> tallies;
  for (std::size_t s = 0; s < stretches.size(); ++s) {
    tallies.clear();
    for (const Stretches::Side& side : stretches[s]) {
      Tally& tally = tallies[pieces.find_set(side.surface)];
      ++tally.sides;
      tally.balance += side.is_forward ? 1 : -1;
    }
    for (const auto& [piece, tally] : tallies) {
      if (tally.sides % 2 != 0) is_open[piece] = true;
      if (tally.balance != 0) is_mixed[piece] = true;
    }
  }

  std::vector<ClosedSurface> result;
  std::map<std::size_t, std::size_t> number_of_piece;
  for (std::size_t s = 0; s < n; ++s) {
    const std::size_t piece = pieces.find_set(s);
    if (is_open[piece]) continue;
    const auto [entry, is_new] = number_of_piece.emplace(piece, result.size());
    if (is_new) result.push_back({{}, !is_mixed[piece], {}});
    ClosedSurface& closed = result[entry->second];
    closed.surfaces.emplace_back(s);
    closed.bounds.extend(bounding_box(scene.surfaces[s].polygon));
  }
  return result;
}

std::optional<Enclosure> enclosure(const Scene& scene, const ClosedSurface& closed,
                                   const Point& point) {
  if (!closed.bounds.contains(point)) return Enclosure{};
  for (const SurfaceId surface : closed.surfaces) {
    if (lies_on(point, scene[surface].polygon)) return std::nullopt;
  }
  // From within the bounds, a way as long as 4 of their sides leaves them in any direction
  // whose largest component is at least 1/2. The first is along an axis, where the predicates are
  // cheapest; it may well graze, the others hardly ever do.
  const double length = 4 * closed.bounds.sizes().maxCoeff();
  Point direction = Point::UnitX();
  std::mt19937_64 random;  // its default seed: the same ways in every run
  for (;;) {
    const auto result = enclosure_along(scene, closed, point, point + length * direction);
    if (result) return result;
    do {
      for (double& component : direction) {
        component = static_cast<double>(random() >> 11) * 0x1p-52 - 1;  // in [-1, 1)
      }
    } while (direction.cwiseAbs().maxCoeff() < 0.5);
  }
}

}  // namespace viewcover
