#include "scene/repair/narrow_gaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/container_hash/hash.hpp>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "scene/error.h"
#include "scene/predicates.h"
#include "scene/repair/grown_box.h"

namespace viewcover {
namespace {

/// Rounding to the lattice moves a corner of a patch by less than this many steps.
constexpr double kRounding = 2;
/// Of a search for a place on an edge.
constexpr int kHalvings = 50;
/// A share of an edge within which places are the same: distances are flat where they are least.
constexpr double kSamePlace = 1e-6;

/// An edge of the scene, once for all surfaces that have it.
struct Edge {
  Point a, b;
  std::vector<SurfaceId> surfaces;

  Point at(double t) const { return a + t * (b - a); }
  /// Parameter of the nearest point, in [0, 1].
  double nearest(const Point& p) const {
    const Point d = b - a;
    return std::clamp(d.dot(p - a) / d.squaredNorm(), 0.0, 1.0);
  }
};

/// A connection from a point of an edge to the nearest one of something else.
struct Connection {
  Point from, to;
  double length() const { return (to - from).norm(); }
};

using Interval = std::pair<double, double>;
using NumberedBox = GrownBox<std::size_t>;

std::vector<Edge> edges_of(const Scene& scene) {
  using Key = std::array<double, 6>;
  std::unordered_map<Key, std::size_t, boost::hash<Key>> places;
  std::vector<Edge> edges;
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const ConvexPolygon& polygon = scene.surfaces[s].polygon;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      // Zeros of either sign are one place.
      Point a = polygon[k] + Point::Zero(), b = polygon[(k + 1) % polygon.size()] + Point::Zero();
      if (std::tuple(a.x(), a.y(), a.z()) > std::tuple(b.x(), b.y(), b.z())) std::swap(a, b);
      const auto [place, is_new] =
          places.try_emplace({a.x(), a.y(), a.z(), b.x(), b.y(), b.z()}, edges.size());
      if (is_new) edges.push_back({a, b, {}});
      edges[place->second].surfaces.emplace_back(s);
    }
  }
  return edges;
}

/// Where the convex function of [0, 1] is below `limit`; `inside` is a place where it is.
template <class Function>
Interval where_below(const Function& value, double limit, double inside) {
  const auto last_below = [&](double end) {
    if (value(end) < limit) return end;
    double below = inside, above = end;
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = (below + above) / 2;
      (value(middle) < limit ? below : above) = middle;
    }
    return below;
  };
  return {last_below(0), last_below(1)};
}

/// Where a convex function of [0, 1] is least.
template <class Function>
double least_place(const Function& value) {
  double low = 0, high = 1;
  for (int i = 0; i < 2 * kHalvings; ++i) {
    const double third = (high - low) / 3;
    if (value(low + third) <= value(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  return (low + high) / 2;
}

class GapFinder {
 public:
  GapFinder(const Scene& scene, double width)
      : scene_(scene), width_(width), step_(scene.lattice.step()), edges_(edges_of(scene)) {}

  std::vector<NarrowGap> run() {
    std::vector<NumberedBox> edges, surfaces;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      edges.push_back(grown_box(bounding_box(std::array{edges_[i].a, edges_[i].b}), width_ / 2, i));
    }
    for (std::size_t s = 0; s < scene_.surfaces.size(); ++s) {
      surfaces.push_back(grown_box(bounding_box(scene_.surfaces[s].polygon), width_ / 2, s));
    }
    CGAL::box_self_intersection_d(edges.begin(), edges.end(),
                                  [&](const NumberedBox& a, const NumberedBox& b) {
                                    const auto [first, second] = std::minmax({a.info(), b.info()});
                                    join_edges(edges_[first], edges_[second]);
                                  });
    CGAL::box_intersection_d(edges.begin(), edges.end(), surfaces.begin(), surfaces.end(),
                             [&](const NumberedBox& edge, const NumberedBox& surface) {
                               join_edge_to_surface(edges_[edge.info()], SurfaceId(surface.info()));
                             });
    leave_out_what_lies_on_surfaces(surfaces);
    std::ranges::sort(gaps_, {}, [](const NarrowGap& gap) {
      const Point& p = gap.patch[0];
      const Point& q = gap.patch[1];
      const Point& r = gap.patch[2];
      return std::tuple(gap.surface, gap.other, p.x(), p.y(), p.z(), q.x(), q.y(), q.z(), r.x(),
                        r.y(), r.z());
    });
    return std::move(gaps_);
  }

 private:
  void join_edges(const Edge& one, const Edge& two) {
    if (std::ranges::find_first_of(one.surfaces, two.surfaces) != one.surfaces.end()) return;
    join_points_to_edge(one, two, false);
    join_points_to_edge(two, one, true);
  }

  /// `was_turned`: connections that are the shortest both ways are there already.
  void join_points_to_edge(const Edge& e, const Edge& f, bool was_turned) {
    const auto connection = [&](double t) {
      const Point p = e.at(t);
      return Connection{p, f.at(f.nearest(p))};
    };
    const auto distance = [&](double t) { return connection(t).length(); };
    const double nearest = least_place(distance);
    if (distance(nearest) >= width_) return;
    const auto [begin, end] = where_below(distance, width_, nearest);
    // Edges that cross are joined on either side.
    std::vector<double> places = {begin, end};
    if (nearest > begin + kSamePlace && nearest < end - kSamePlace) {
      places.insert(places.begin() + 1, nearest);
    }
    const auto is_mutual = [&](const Connection& to_f) {
      return (e.at(e.nearest(to_f.to)) - to_f.from).norm() < step_ * kSmallestArea;
    };
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      const Connection first = connection(places[i]), last = connection(places[i + 1]);
      if (was_turned && is_mutual(first) && is_mutual(last)) continue;
      add_patches(e.surfaces.front(), f.surfaces.front(), first, last, e.b - e.a);
    }
  }

  void join_edge_to_surface(const Edge& e, SurfaceId other) {
    if (std::ranges::find(e.surfaces, other) != e.surfaces.end()) return;
    const ConvexPolygon& polygon = scene_[other].polygon;
    const Point normal = area_vector(polygon).normalized();
    const double from = normal.dot(e.a - polygon[0]), to = normal.dot(e.b - polygon[0]);
    const auto height = [&](double t) { return from + t * (to - from); };
    // An edge in the plane of the surface is joined to its edges.
    if (std::max(std::fabs(from), std::fabs(to)) < step_) return;
    Interval inside = {0, 1};
    const auto keep = [&](double at_0, double at_1) {  // where the linear function is positive
      if (at_0 <= 0 && at_1 <= 0) inside = {1, 0};
      if ((at_0 > 0) == (at_1 > 0)) return;
      const double zero = at_0 / (at_0 - at_1);
      if (at_0 > 0) {
        inside.second = std::min(inside.second, zero);
      } else {
        inside.first = std::max(inside.first, zero);
      }
    };
    keep(width_ - from, width_ - to);
    keep(width_ + from, width_ + to);
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
      const Point inwards = normal.cross(b - a);
      keep(inwards.dot(e.a - a), inwards.dot(e.b - a));
    }
    if (inside.first >= inside.second) return;
    std::vector<double> places = {inside.first, inside.second};
    if ((from > 0) != (to > 0)) {
      const double zero = from / (from - to);
      if (zero > inside.first && zero < inside.second) places.insert(places.begin() + 1, zero);
    }
    const auto connection = [&](double t) {
      const Point p = e.at(t);
      return Connection{p, p - height(t) * normal};
    };
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
      add_patches(e.surfaces.front(), other, connection(places[i]), connection(places[i + 1]),
                  e.b - e.a);
    }
  }

  /// What the connections from `first` to `last` sweep, made larger on all sides.
  void add_patches(SurfaceId surface, SurfaceId other, const Connection& first,
                   const Connection& last, const Point& along) {
    const Point across = (first.to - first.from) + (last.to - last.from);
    // Neither edges that run on in each other nor a single connection leave a gap.
    if (across.norm() == 0 || across.cross(last.from - first.from + last.to - first.to).norm() <
                                  step_ * step_ * kSmallestArea) {
      return;
    }
    const Point over = across.normalized() * (kPatchOverlap * step_),
                beyond = along.normalized() * (kPatchOverlap * step_);
    const std::array<Point, 4> corners = {first.from, last.from, last.to, first.to};
    const std::array<Point, 4> grown = {scene_.lattice.round(first.from - over - beyond),
                                        scene_.lattice.round(last.from - over + beyond),
                                        scene_.lattice.round(last.to + over + beyond),
                                        scene_.lattice.round(first.to + over - beyond)};
    const double width = std::min(first.length(), last.length());
    using Triangle = std::array<std::size_t, 3>;
    const Triangle one = {0, 1, 2}, two = {0, 2, 3};
    const auto swept = [&](const Triangle& t) {
      return std::array<Point, 3>{corners[t[0]], corners[t[1]], corners[t[2]]};
    };
    const auto has_area = [&](const Triangle& t) {
      return area(swept(t)) > step_ * step_ * kSmallestArea;
    };
    for (const Triangle& t : {one, two}) {
      const ConvexPolygon patch = {grown[t[0]], grown[t[1]], grown[t[2]]};
      if (are_collinear(patch[0], patch[1], patch[2])) continue;
      if (gaps_.size() == kMostNarrowGaps) {
        throw InputError("--aperture",
                         fmt::format("{} is wider than the scene's own detail: more than {} gaps",
                                     width_, kMostNarrowGaps),
                         "give a smaller width");
      }
      gaps_.push_back({surface, other, width, patch});
      // With one end alike, the other triangle is all that was swept.
      swept_.push_back(swept(has_area(t) ? t : t == one ? two : one));
    }
  }

  /// Patches on a surface close no gap, and rounded they would hide a part of it.
  void leave_out_what_lies_on_surfaces(std::vector<NumberedBox>& surfaces) {
    constexpr std::size_t kSamples = 4;
    std::vector<NumberedBox> patches;
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      patches.push_back(grown_box(bounding_box(swept_[i]), kRounding * step_, i));
    }
    std::vector<std::array<bool, kSamples>> lies_on(gaps_.size());
    CGAL::box_intersection_d(
        patches.begin(), patches.end(), surfaces.begin(), surfaces.end(),
        [&](const NumberedBox& patch, const NumberedBox& surface) {
          const std::array<Point, 3>& corners = swept_[patch.info()];
          const ConvexPolygon& polygon = scene_.surfaces[surface.info()].polygon;
          const Point normal = area_vector(polygon).normalized();
          const auto is_far = [&](const Point& p) {
            return std::fabs(normal.dot(p - polygon[0])) > kRounding * step_;
          };
          if (std::ranges::any_of(corners, is_far)) return;
          const Point middle = (corners[0] + corners[1] + corners[2]) / 3;
          for (std::size_t i = 0; i < kSamples; ++i) {
            const Point sample = i < 3 ? Point((corners[i] + middle) / 2) : middle;
            if (is_over(polygon, normal, sample)) lies_on[patch.info()][i] = true;
          }
        });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      if (std::ranges::count(lies_on[i], true) == kSamples) continue;
      std::swap(gaps_[kept++], gaps_[i]);
    }
    gaps_.resize(kept);
  }

  static bool is_over(const ConvexPolygon& polygon, const Point& normal, const Point& point) {
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Point &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
      if (normal.cross(b - a).dot(point - a) <= 0) return false;
    }
    return true;
  }

  /// Of a gap's patch, in squared steps of the lattice; below, no line of sight gets through.
  static constexpr double kSmallestArea = 1e-3;

  const Scene& scene_;
  double width_, step_;
  std::vector<Edge> edges_;
  std::vector<NarrowGap> gaps_;
  std::vector<std::array<Point, 3>> swept_;  // by the connections, of the gaps before rounding
};

}  // namespace

std::vector<NarrowGap> find_narrow_gaps(const Scene& scene, double width) {
  return GapFinder(scene, width).run();
}

Scene with_gaps_closed(const Scene& scene, const std::vector<NarrowGap>& gaps) {
  Scene closed = scene;
  for (const NarrowGap& gap : gaps) {
    const Surface& beside = scene[gap.surface];
    closed.surfaces.push_back({gap.patch, beside.group, beside.source_face, false});
    closed.bounds.extend(bounding_box(gap.patch));
  }
  return closed;
}

}  // namespace viewcover
