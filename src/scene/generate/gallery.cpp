#include "scene/generate/gallery.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/error.h"
#include "scene/generate/scene_builder.h"
#include "scene/lattice.h"
#include "scene/predicates.h"
#include "scene/repair/convex_parts.h"

namespace viewcover {
namespace {

using PlanLoop = std::vector<PlanCorner>;

int turn_of(const Point& a, const Point& b, const Point& c) { return turn(a, b, c, 2); }

bool is_within_box(const Point& a, const Point& b, const Point& x) {
  return (x.array() >= a.cwiseMin(b).array()).all() && (x.array() <= a.cwiseMax(b).array()).all();
}

/// Do the closed segments ab and cd meet? Exact.
bool segments_meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  const int c_side = turn_of(a, b, c), d_side = turn_of(a, b, d), a_side = turn_of(c, d, a),
            b_side = turn_of(c, d, b);
  if (c_side * d_side < 0 && a_side * b_side < 0) return true;
  return (c_side == 0 && is_within_box(a, b, c)) || (d_side == 0 && is_within_box(a, b, d)) ||
         (a_side == 0 && is_within_box(c, d, a)) || (b_side == 0 && is_within_box(c, d, b));
}

const PlanCorner& next_of(const PlanLoop& loop, std::size_t i) {
  return loop[(i + 1) % loop.size()];
}

/// Is the point strictly inside the loop, on whose boundary it does not lie? By crossings of the
/// half-line toward +x.
bool is_inside(const PlanLoop& loop, const Point& x) {
  bool inside = false;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point *low = &loop[i].position, *high = &next_of(loop, i).position;
    if (low->y() > high->y()) std::swap(low, high);
    if (low->y() <= x.y() && x.y() < high->y() && turn_of(*low, *high, x) > 0) inside = !inside;
  }
  return inside;
}

bool is_counter_clockwise(const PlanLoop& loop) {
  const auto lowest = static_cast<std::size_t>(
      std::ranges::min_element(loop,
                               [](const PlanCorner& a, const PlanCorner& b) {
                                 return std::pair(a.position.y(), a.position.x()) <
                                        std::pair(b.position.y(), b.position.x());
                               }) -
      loop.begin());
  const std::size_t n = loop.size();
  return turn_of(loop[(lowest + n - 1) % n].position, loop[lowest].position,
                 loop[(lowest + 1) % n].position) > 0;
}

/// A floor plan whose loops are known to be simple and nested as they should be.
class CheckedPlan {
 public:
  CheckedPlan(std::string file, FloorPlan plan) : file_(std::move(file)), plan_(std::move(plan)) {
    check_edges();
    check_nesting();
    for (std::size_t i = 0; i < plan_.size(); ++i) {
      if (is_counter_clockwise(plan_[i]) != (i == 0)) std::ranges::reverse(plan_[i]);
    }
  }

  std::span<const PlanLoop> loops() const { return plan_; }

  std::vector<std::vector<Point>> corners() const {
    std::vector<std::vector<Point>> loops;
    for (const PlanLoop& loop : plan_) {
      loops.emplace_back();
      for (const PlanCorner& corner : loop) loops.back().push_back(corner.position);
    }
    return loops;
  }

 private:
  [[noreturn]] void refuse(std::size_t line, const std::string& wrong) const {
    throw InputError(InputError::at_line(file_, line), wrong,
                     "give one outer loop and holes within it that touch nothing");
  }

  void check_edges() const {
    for (std::size_t p = 0; p < plan_.size(); ++p) {
      for (std::size_t q = 0; q <= p; ++q) {
        for (std::size_t i = 0; i < plan_[p].size(); ++i) {
          for (std::size_t k = 0; k < (p == q ? i : plan_[q].size()); ++k) check_pair(p, i, q, k);
        }
      }
    }
  }

  /// Edge k of loop q comes before edge i of loop p.
  void check_pair(std::size_t p, std::size_t i, std::size_t q, std::size_t k) const {
    const PlanCorner &a = plan_[p][i], &b = next_of(plan_[p], i), &c = plan_[q][k],
                     &d = next_of(plan_[q], k);
    bool meet = false;
    if (&d == &a || &b == &c) {
      // Neighbours share a corner; they meet elsewhere only where they run back.
      const Point &before = (&d == &a ? c : a).position, &shared = (&d == &a ? a : b).position,
                  &after = (&d == &a ? b : d).position;
      meet = before == shared || shared == after ||
             (turn_of(before, shared, after) == 0 && (before - shared).dot(after - shared) > 0);
    } else {
      meet = segments_meet(a.position, b.position, c.position, d.position);
    }
    if (meet) refuse(a.line, fmt::format("the edge from here meets that from line {}", c.line));
  }

  void check_nesting() const {
    for (std::size_t hole = 1; hole < plan_.size(); ++hole) {
      const PlanCorner& corner = plan_[hole][0];
      if (!is_inside(plan_[0], corner.position)) refuse(corner.line, "the hole is outside");
      for (std::size_t other = 1; other < plan_.size(); ++other) {
        if (other != hole && is_inside(plan_[other], corner.position)) {
          refuse(corner.line, "the hole is within another");
        }
      }
    }
  }

  std::string file_;
  FloorPlan plan_;
};

std::vector<Point> at_height(std::span<const Point> loop, double z) {
  std::vector<Point> result;
  for (const Point& p : loop) result.emplace_back(p.x(), p.y(), z);
  return result;
}

}  // namespace

GeneratedScene gallery(const std::filesystem::path& file, FloorPlan plan, double height) {
  double largest = height;
  for (const PlanLoop& loop : plan) {
    for (const PlanCorner& corner : loop) {
      largest = std::max(largest, corner.position.cwiseAbs().maxCoeff());
    }
  }
  const Lattice lattice = Lattice::for_extent(largest);
  for (PlanLoop& loop : plan) {
    for (PlanCorner& corner : loop) corner.position = lattice.round(corner.position);
  }
  const double top = lattice.round(height), middle = lattice.round(height / 2);
  if (!(middle > 0 && middle < top)) {
    throw InputError("--height", fmt::format("{} is too low for the plan", height),
                     "give a positive height nearer to its size");
  }
  const CheckedPlan checked(file.string(), std::move(plan));

  SceneBuilder builder(fmt::format("viewcover gallery of height {}", top));
  builder.begin_group("wall");
  for (const PlanLoop& loop : checked.loops()) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      // The inside is to the left.
      const Point &a = loop[i].position, &b = next_of(loop, i).position;
      const Point up(0, 0, top);
      builder.add_face({b, a, Point(a + up), Point(b + up)});
    }
  }
  const ConvexParts parts = convex_parts(checked.corners());
  builder.begin_group("floor");
  for (const ConvexPolygon& part : parts.polygons) builder.add_face(part);
  builder.begin_group("ceiling");
  for (const ConvexPolygon& part : parts.polygons) {
    std::vector<Point> corners = at_height(part, top);
    std::ranges::reverse(corners);
    builder.add_face(corners);
  }
  for (const ConvexPolygon& part : parts.polygons) builder.add_region(at_height(part, middle));
  return std::move(builder).finish();
}

}  // namespace viewcover
