#include "exact/view_cone.h"

#include <algorithm>

#include "exact/double_description.h"
#include "exact/integer_geometry.h"
#include "exact/subtraction.h"

namespace viewcover::exact {
namespace {

using Rational = CGAL::Gmpq;
using Direction = LazyVector<3>;
using DirectionPool = VectorPool<3>;
using DirectionCell = Cell<3>;

/// Collects free cells.
struct FreeDirectionCells {
  std::vector<DirectionCell> cells{};
  bool holds_anything(const DirectionCell& /*cell*/) { return true; }
  bool on_free(const DirectionCell& cell) {
    cells.push_back(cell);
    return false;
  }
};

/// Ends at the first free cell.
struct FirstFreeCell {
  bool holds_anything(const DirectionCell& /*cell*/) { return true; }
  bool on_free(const DirectionCell& /*cell*/) { return true; }
};

/// Element and occluders relative to the viewpoint, all in integers, times the viewpoint's weight.
/// Number is BigInteger, or CheckedWide to find out if anything is seen.
template <class Number>
class ViewCone {
  using Components = std::array<Number, 3>;
  using Plane = IntegerPlane<Number>;
  using Polygon = std::vector<HomogeneousPoint<Number>>;

 public:
  ViewCone(std::span<const Point> support, std::span<const double> weights,
           std::span<const Point> element, std::span<const std::span<const Point>> occluders,
           ExactStatistics& statistics)
      : occluder_points_(occluders), pool_(statistics) {
    frame_.include(support);
    frame_.include(element);
    for (const std::span<const Point> occluder : occluders) frame_.include(occluder);
    frame_.set_origin(element[0]);
    if (std::is_same_v<Number, CheckedWide> && !frame_.is_narrow()) throw CheckedWide::Overflow();
    locate(support, weights);
    element_ = relative(element);
  }

  ViewOfElement run() {
    ViewOfElement view;
    const std::optional<DirectionCell> root = find_root();
    if (!root) {
      view.edge_on = true;
      return view;
    }
    view.fully = !find_blockers_and_edge_on(*root);
    FreeDirectionCells rules;
    const auto cells_before = pool_.statistics().cells;
    Subtraction<3, FreeDirectionCells>(pool_, blockers_, rules).run(*root);
    view.hidden_by_one = rules.cells.empty() && pool_.statistics().cells == cells_before + 1;
    const Rational whole = projected_area(polygon_of(*root, plane_), plane_);
    for (const DirectionCell& cell : rules.cells) {
      RationalPolygon part = polygon_of(cell, plane_);
      view.visible_fraction += projected_area(part, plane_);
      view.visible_parts.push_back(absolute(std::move(part)));
    }
    view.visible_fraction /= whole;
    view.fully = view.fully && view.visible_fraction == 1;
    return view;
  }

  bool sees_part() {
    const std::optional<DirectionCell> root = find_root();
    if (!root) return false;
    for (const std::span<const Point> points : occluder_points_) add_blockers(relative(points));
    FirstFreeCell rules;
    return Subtraction<3, FirstFreeCell>(pool_, blockers_, rules).run(*root) ==
           SubtractionOutcome::kEnded;
  }

 private:
  void locate(std::span<const Point> support, std::span<const double> weights) {
    IntegerFrame weight_frame;
    std::vector<Point> weight_points;
    for (const double weight : weights) weight_points.emplace_back(weight, 0, 0);
    weight_frame.include(weight_points);
    viewpoint_ = {Number(0), Number(0), Number(0)};
    weight_ = Number(0);
    for (std::size_t i = 0; i < support.size(); ++i) {
      const Number weight = weight_frame.template operator()<Number>(weight_points[i])[0];
      const auto point = frame_.template operator()<Number>(support[i]);
      for (std::size_t k = 0; k < 3; ++k) viewpoint_[k] = viewpoint_[k] + weight * point[k];
      weight_ = weight_ + weight;
    }
  }

  /// All directions toward the element; none if the viewpoint lies in its plane.
  std::optional<DirectionCell> find_root() {
    plane_ = Plane(element_);
    if (sign(plane_.offset) == 0) return std::nullopt;
    // All of them cross the element's plane to the front.
    if (sign(plane_.offset) < 0) plane_.reverse();
    std::vector<const Direction*> corners;
    for (const auto& corner : element_) corners.push_back(pool_.add(Role::kRay, corner.x));
    return cone_of<3>(pool_, corners);
  }

  /// True if an occluder seen edge-on meets the interior of the cone.
  bool find_blockers_and_edge_on(const DirectionCell& root) {
    bool any_inside = false;
    for (const std::span<const Point> points : occluder_points_) {
      const Polygon polygon = relative(points);
      const bool edge_on = !add_blockers(polygon);
      any_inside = any_inside || (edge_on && meets_inside(root, polygon));
    }
    return any_inside;
  }

  Polygon relative(std::span<const Point> points) const {
    Polygon result;
    for (const Point& point : points) {
      const auto x = frame_.template operator()<Number>(point);
      result.push_back({weight_ * x - viewpoint_, Number(1)});
    }
    return result;
  }

  /// The occluder, if it can block at all: it does where a direction passes all edges on the inner
  /// side and the element lies behind the occluder's plane, seen from the viewpoint. False if the
  /// occluder is seen edge-on.
  bool add_blockers(const Polygon& polygon) {
    const Plane occluder(polygon);
    if (sign(occluder.offset) == 0) return false;
    const Sides sides = Sides::of<Number>(occluder, element_);
    const int near = -sign(occluder.offset);
    if (!(near > 0 ? sides.back : sides.front)) return true;
    const Direction* behind = nullptr;
    if (sides.front && sides.back) {
      // Where the direction d meets the element's plane, d offset / (normal . d), the occluder's
      // plane has this value, times normal . d > 0.
      behind = pool_.add(Role::kFunctional,
                         plane_.offset * occluder.normal - occluder.offset * plane_.normal);
    }
    std::vector<const Direction*> edges;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      edges.push_back(
          pool_.add(Role::kFunctional, cross(polygon[k].x, polygon[(k + 1) % polygon.size()].x)));
    }
    // Pieces of at most 60 edges, cut by planes through the first corner.
    constexpr std::size_t kMostEdges = 60;
    const std::size_t n = polygon.size();
    for (std::size_t first = 0; first < n; first += kMostEdges) {
      Blocker<3>& blocker = blockers_.emplace_back();
      const std::size_t last = std::min(first + kMostEdges, n);
      for (std::size_t k = first; k < last; ++k) blocker.sides.push_back({edges[k], -near});
      const auto add_diagonal = [&](std::size_t from, std::size_t to) {
        blocker.sides.push_back(
            {pool_.add(Role::kFunctional, cross(polygon[from].x, polygon[to].x)), -near});
      };
      if (first > 0) add_diagonal(0, first);
      if (last < n) add_diagonal(last, 0);
      if (behind != nullptr) blocker.sides.push_back({behind, -near});
    }
    return true;
  }

  /// Does a polygon seen edge-on meet the interior of the cone between viewpoint and element? What
  /// is left of it after closed cuts at all sides does, iff it touches none of them all along.
  bool meets_inside(const DirectionCell& root, Polygon polygon) {
    Plane beyond = plane_;  // the element's side of the plane is not inside
    beyond.reverse();
    std::vector<Plane> bounds = {beyond};
    for (const Direction* facet : root.facets()) {
      if (facet == nullptr) continue;
      Plane bound = plane_;
      bound.normal = pool_.exact(*facet);
      bound.offset = BigInteger(0);
      bounds.push_back(bound);
    }
    for (const Plane& bound : bounds) {
      const Sides sides = Sides::of<Number>(bound, polygon);
      if (!sides.front) return false;
      if (sides.back) polygon = cut_polygon<Number>(polygon, bound, 1);
    }
    return std::all_of(bounds.begin(), bounds.end(),
                       [&](const Plane& bound) { return Sides::of<Number>(bound, polygon).front; });
  }

  /// Where the cell's rays meet the element's plane, in order round the boundary.
  RationalPolygon polygon_of(const DirectionCell& cell, const Plane& plane) {
    RationalPolygon result;
    std::vector<bool> used(cell.size(), false);
    std::size_t at = 0;
    for (std::size_t count = 0; count < cell.size(); ++count) {
      used[at] = true;
      const Components& d = pool_.exact(*cell.ray(at));
      const BigInteger below = dot(plane.normal, d);
      result.push_back({Rational(plane.offset * d[0], below), Rational(plane.offset * d[1], below),
                        Rational(plane.offset * d[2], below)});
      for (std::size_t next = 0; next < cell.size(); ++next) {
        if (!used[next] && cell.are_adjacent(at, next)) {
          at = next;
          break;
        }
      }
    }
    return result;
  }

  /// Twice the area, seen along the axis in which the plane's normal is largest.
  static Rational projected_area(const RationalPolygon& polygon, const Plane& plane) {
    std::size_t axis = 0;
    for (std::size_t k = 1; k < 3; ++k) {
      if (CGAL::abs(plane.normal[k]) > CGAL::abs(plane.normal[axis])) axis = k;
    }
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    Rational sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const RationalPoint &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      sum += a[u] * b[v] - a[v] * b[u];
    }
    return CGAL::abs(sum);
  }

  /// Back to scene units.
  RationalPolygon absolute(RationalPolygon polygon) const {
    for (RationalPoint& point : polygon) {
      for (std::size_t k = 0; k < 3; ++k) {
        point[k] = frame_.absolute((point[k] + Rational(viewpoint_[k])) / Rational(weight_), k);
      }
    }
    return polygon;
  }

  std::span<const std::span<const Point>> occluder_points_;
  DirectionPool pool_;
  IntegerFrame frame_;
  Components viewpoint_;
  Number weight_;
  Polygon element_;
  Plane plane_;
  std::vector<Blocker<3>> blockers_;
};

}  // namespace

ViewOfElement view_element(std::span<const Point> support, std::span<const double> weights,
                           std::span<const Point> element,
                           std::span<const std::span<const Point>> occluders,
                           ExactStatistics& statistics) {
  return ViewCone<BigInteger>(support, weights, element, occluders, statistics).run();
}

bool sees_part(const Point& viewpoint, std::span<const Point> element,
               std::span<const std::span<const Point>> occluders, ExactStatistics& statistics) {
  constexpr double kWeight = 1;
  const auto decide = [&]<class Number>(Number /*kind*/) {
    return ViewCone<Number>({&viewpoint, 1}, {&kWeight, 1}, element, occluders, statistics)
        .sees_part();
  };
  try {
    return decide(CheckedWide());
  } catch (const CheckedWide::Overflow&) {
    return decide(BigInteger());
  }
}

}  // namespace viewcover::exact
