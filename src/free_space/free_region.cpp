#include "free_space/free_region.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/convex_hull_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <list>
#include <numbers>
#include <string>

#include "scene/error.h"
#include "scene/repair/convex_parts.h"

namespace viewcover {
namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Place = Kernel::Point_2;
using Outline = CGAL::Polygon_2<Kernel>;
using Area = CGAL::Polygon_with_holes_2<Kernel>;
using Areas = CGAL::Polygon_set_2<Kernel>;

/// Corners are rounded to a lattice this much coarser than the scene's: corners that nearly meet
/// become one. Where that makes edges cross, to coarser ones still.
constexpr int kCoarser = 3, kMostTries = 4;
/// Obstacles grow by so many steps of that lattice besides: rounding moves a corner by less than
/// one.
constexpr double kMarginSteps = 2;
/// Boxes are rounded to so many steps a cell: coordinates of few bits make exact decisions about
/// them twice as cheap as those of the lattice.
constexpr double kStepsPerCell = 64;
/// Parts smaller than this share of the whole are left out.
constexpr double kSliver = 1e-6;

/// The plane at camera height, with the axes in cyclic order after the one that is up.
struct HeightFrame {
  int up;
  int u() const { return (up + 1) % 3; }
  int v() const { return (up + 2) % 3; }
  Point at(double a, double b, double height) const {
    Point point;
    point[up] = height;
    point[u()] = a;
    point[v()] = b;
    return point;
  }
};

struct Corner {
  Number a, b, height;
};

/// What of a convex polygon lies on one side of a height. `above`: at or above it.
std::vector<Corner> clipped(const std::vector<Corner>& polygon, const Number& height, bool above) {
  std::vector<Corner> kept;
  const auto side = [&](const Corner& corner) {
    return above ? corner.height - height : height - corner.height;
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Corner &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
    const Number s = side(from), t = side(to);
    if (s >= 0) kept.push_back(from);
    if ((s > 0 && t < 0) || (s < 0 && t > 0)) {
      const Number share = s / (s - t);
      kept.push_back({from.a + share * (to.a - from.a), from.b + share * (to.b - from.b), height});
    }
  }
  return kept;
}

/// The corners of a regular octagon that holds the disc of a radius.
std::vector<std::pair<double, double>> octagon(double radius) {
  constexpr double kAgainstRounding = 1 + 1e-12;
  const double out = radius / std::cos(std::numbers::pi / 8) * kAgainstRounding;
  std::vector<std::pair<double, double>> corners;
  for (int k = 0; k < 8; ++k) {
    const double angle = (2 * k + 1) * std::numbers::pi / 8;
    corners.emplace_back(out * std::cos(angle), out * std::sin(angle));
  }
  return corners;
}

/// What is asked for, between two heights that may be equal.
struct Slab {
  const char* option;  ///< to blame in messages
  int up_axis;
  double low, high, clearance;
  std::optional<Point> seed;

  std::string heights() const {
    return low == high ? fmt::format("height {}", low) : fmt::format("heights {} to {}", low, high);
  }
};

class FreeSpace {
 public:
  FreeSpace(const Scene& scene, const Slab& slab, double step)
      : slab_(slab), frame_{slab.up_axis}, step_(step) {
    const double reach = slab_.clearance + kMarginSteps * step_;
    const Number low = slab_.low - reach, high = slab_.high + reach;
    const auto disc = octagon(reach);
    std::list<Outline> obstacles;
    for (const Surface& surface : scene.surfaces) {
      std::vector<Corner> corners;
      for (const Point& p : surface.polygon) {
        corners.push_back({p[frame_.u()], p[frame_.v()], p[frame_.up]});
      }
      corners = clipped(clipped(corners, low, true), high, false);
      std::vector<Place> grown;
      for (const Corner& corner : corners) {
        for (const auto& [da, db] : disc) grown.emplace_back(corner.a + da, corner.b + db);
      }
      if (grown.empty()) continue;
      Outline obstacle;
      CGAL::convex_hull_2(grown.begin(), grown.end(), std::back_inserter(obstacle));
      obstacles.push_back(std::move(obstacle));
    }
    Areas blocked;
    blocked.join(obstacles.begin(), obstacles.end());
    const Point &least = scene.bounds.min(), &most = scene.bounds.max();
    const Number a0 = least[frame_.u()], b0 = least[frame_.v()], a1 = most[frame_.u()],
                 b1 = most[frame_.v()];
    Outline whole;
    for (const Place& corner : {Place(a0, b0), Place(a1, b0), Place(a1, b1), Place(a0, b1)}) {
      whole.push_back(corner);
    }
    if (!(a0 < a1 && b0 < b1)) throw InputError(slab_.option, "the scene has no floor area", "");
    free_.insert(whole);
    free_.difference(blocked);
    free_.polygons_with_holes(std::back_inserter(areas_));
  }

  /// Connected with the seed, or the largest.
  const Area& chosen() const {
    if (areas_.empty()) {
      throw InputError(slab_.option,
                       fmt::format("no free space is left {} from surfaces at {}", slab_.clearance,
                                   slab_.heights()),
                       "give another height or a smaller --clearance");
    }
    if (!slab_.seed) {
      return *std::ranges::max_element(areas_, {}, [](const Area& area) { return area_of(area); });
    }
    const Place seed((*slab_.seed)[frame_.u()], (*slab_.seed)[frame_.v()]);
    for (const Area& area : areas_) {
      if (Areas(area).oriented_side(seed) != CGAL::ON_NEGATIVE_SIDE) return area;
    }
    throw InputError("--seed-point",
                     fmt::format("is outside the scene, or nearer than {} to a surface at {}",
                                 slab_.clearance, slab_.heights()),
                     "give a place in free space");
  }

  /// The loops of an area with corners on the lattice, those that are left of them.
  std::vector<std::vector<Point>> loops_of(const Area& area) const {
    std::vector<std::vector<Point>> loops{rounded(area.outer_boundary())};
    for (const Outline& hole : area.holes()) loops.push_back(rounded(hole));
    return loops;
  }

  static double area_of(const Area& area) {
    double sum = CGAL::to_double(area.outer_boundary().area());
    for (const Outline& hole : area.holes()) sum += CGAL::to_double(hole.area());
    return sum;
  }
  const std::list<Area>& areas() const { return areas_; }

  /// The boxes of a grid over the area that are wholly in it.
  std::vector<Box> boxes_in(const Area& area, const std::array<std::size_t, 3>& cells) const {
    const CGAL::Bbox_2 extent = area.outer_boundary().bbox();
    const int u = frame_.u(), v = frame_.v();
    const Box whole(frame_.at(extent.xmin(), extent.ymin(), slab_.low),
                    frame_.at(extent.xmax(), extent.ymax(), slab_.high));
    const double step = grid_step(whole, cells);
    std::array<std::vector<double>, 3> lines;
    for (int axis = 0; axis < 3; ++axis) {
      lines[index(axis)] =
          grid_lines(whole.min()[axis], whole.max()[axis], cells[index(axis)], step);
    }
    const Areas free(area);
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < cells[index(u)]; ++i) {
      for (std::size_t j = 0; j < cells[index(v)]; ++j) {
        const Box plan(frame_.at(lines[index(u)][i], lines[index(v)][j], 0),
                       frame_.at(lines[index(u)][i + 1], lines[index(v)][j + 1], 0));
        if (!lies_in(plan, free)) continue;
        const std::vector<double>& heights = lines[index(slab_.up_axis)];
        for (std::size_t k = 0; k + 1 < heights.size(); ++k) {
          Box box = plan;
          box.min()[slab_.up_axis] = heights[k];
          box.max()[slab_.up_axis] = heights[k + 1];
          boxes.push_back(box);
        }
      }
    }
    return boxes;
  }

 private:
  static std::size_t index(int axis) { return static_cast<std::size_t>(axis); }

  /// The least power of two that leaves kStepsPerCell to the shortest side of a cell, or the
  /// lattice's step.
  double grid_step(const Box& whole, const std::array<std::size_t, 3>& cells) const {
    double shortest = HUGE_VAL;
    for (int axis = 0; axis < 3; ++axis) {
      shortest = std::min(shortest, whole.sizes()[axis] / static_cast<double>(cells[index(axis)]));
    }
    return std::max(step_, std::ldexp(1.0, std::ilogb(shortest / kStepsPerCell)));
  }

  /// Ends of `count` equal steps, rounded to multiples of `step`; the outermost inward.
  static std::vector<double> grid_lines(double first, double last, std::size_t count, double step) {
    std::vector<double> lines;
    for (std::size_t i = 0; i <= count; ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count);
      const double at = (first + share * (last - first)) / step;
      lines.push_back(step * (i == 0       ? std::ceil(at)
                              : i == count ? std::floor(at)
                                           : std::nearbyint(at)));
      if (i > 0 && !(lines[i - 1] < lines[i])) {
        throw InputError("--cells", fmt::format("{} cells are finer than the lattice", count),
                         "give fewer");
      }
    }
    return lines;
  }

  bool lies_in(const Box& plan, const Areas& free) const {
    const double a0 = plan.min()[frame_.u()], a1 = plan.max()[frame_.u()],
                 b0 = plan.min()[frame_.v()], b1 = plan.max()[frame_.v()];
    Outline outline;
    for (const Place& corner : {Place(a0, b0), Place(a1, b0), Place(a1, b1), Place(a0, b1)}) {
      outline.push_back(corner);
    }
    Areas rest(outline);
    rest.difference(free);
    return rest.is_empty();
  }

  std::vector<Point> rounded(const Outline& outline) const {
    std::vector<Point> loop;
    const auto nearest = [&](const Number& x) {
      return std::nearbyint(CGAL::to_double(x) / step_) * step_;
    };
    for (const Place& place : outline.container()) {
      const Point corner = frame_.at(nearest(place.x()), nearest(place.y()), slab_.low);
      if (loop.empty() || loop.back() != corner) loop.push_back(corner);
    }
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    return loop;
  }

  const Slab& slab_;
  HeightFrame frame_;
  double step_;
  Areas free_;
  std::list<Area> areas_;
};

/// Heights on the lattice. Errors: InputError where they are outside the scene.
Slab checked(const Scene& scene, Slab slab) {
  if (!(slab.clearance >= 0)) {
    throw InputError("--clearance", "is negative or no number", "give a distance >= 0");
  }
  const double lowest = scene.bounds.min()[slab.up_axis],
               highest = scene.bounds.max()[slab.up_axis];
  for (double* height : {&slab.low, &slab.high}) {
    if (!(*height >= lowest && *height <= highest)) {
      throw InputError(slab.option,
                       fmt::format("{} is outside the scene, which goes from {} to {} there",
                                   *height, lowest, highest),
                       "give a height between, or another --up");
    }
    *height = scene.lattice.round(*height);
  }
  return slab;
}

double step_of(const Scene& scene, int attempt) {
  return std::ldexp(scene.lattice.step(), kCoarser * attempt);
}

/// The areas that were not chosen.
template <class Region>
void count_others(const FreeSpace& space, const Area& chosen, Region& region) {
  region.others = space.areas().size() - 1;
  for (const Area& area : space.areas()) region.area_of_others += FreeSpace::area_of(area);
  region.area_of_others -= FreeSpace::area_of(chosen);
}

}  // namespace

FreeRegion find_free_region(const Scene& scene, const FreeRegionOptions& asked) {
  const Slab slab = checked(
      scene, {"--height", asked.up_axis, asked.height, asked.height, asked.clearance, asked.seed});
  for (int attempt = 1; attempt <= kMostTries; ++attempt) {
    const FreeSpace space(scene, slab, step_of(scene, attempt));
    const Area& chosen = space.chosen();
    const ConvexParts parts = convex_parts(space.loops_of(chosen));
    if (parts.kind == FaceKind::kCrossing) continue;
    FreeRegion region;
    region.holes = chosen.number_of_holes();
    count_others(space, chosen, region);
    const double whole = FreeSpace::area_of(chosen);
    for (const ConvexPolygon& part : parts.polygons) {
      const double size = area(part);
      (size < kSliver * whole ? region.left_out : region.area) += size;
      if (size >= kSliver * whole) region.parts.push_back(part);
    }
    if (!region.parts.empty()) return region;
  }
  throw InputError("--height",
                   fmt::format("the free space at height {} is too ragged for the scene's lattice",
                               asked.height),
                   "give another height or a larger --clearance");
}

FreeBoxes find_free_boxes(const Scene& scene, const FreeBoxOptions& asked) {
  const Slab slab = checked(
      scene, {"--volume", asked.up_axis, asked.low, asked.high, asked.clearance, asked.seed});
  if (!(slab.high - slab.low >= 2 * step_of(scene, 1))) {
    throw InputError(
        "--volume",
        fmt::format("{} is not above {} by more than the lattice", asked.high, asked.low),
        "give the lower height first");
  }
  const FreeSpace space(scene, slab, step_of(scene, 1));
  const Area& chosen = space.chosen();
  FreeBoxes free;
  free.boxes = space.boxes_in(chosen, asked.cells);
  if (free.boxes.empty()) {
    throw InputError("--cells",
                     fmt::format("none of {} x {} x {} is wholly free", asked.cells[0],
                                 asked.cells[1], asked.cells[2]),
                     "give more cells");
  }
  count_others(space, chosen, free);
  for (const Box& box : free.boxes) free.area += box.volume() / box.sizes()[slab.up_axis];
  free.area /= static_cast<double>(asked.cells[static_cast<std::size_t>(slab.up_axis)]);
  free.left_out = FreeSpace::area_of(chosen) - free.area;
  return free;
}

}  // namespace viewcover
