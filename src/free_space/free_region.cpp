#include "free_space/free_region.h"

#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <CGAL/convex_hull_2.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <list>
#include <numbers>
#include <string>

#include "scene/convex_parts.h"
#include "scene/error.h"

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

class FreeSpace {
 public:
  FreeSpace(const Scene& scene, const FreeRegionOptions& options, double step)
      : scene_(scene), options_(options), frame_{options.up_axis}, step_(step) {
    const double reach = options_.clearance + kMarginSteps * step_;
    const Number low = options_.height - reach, high = options_.height + reach;
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
    if (!(a0 < a1 && b0 < b1)) throw InputError("--height", "the scene has no floor area", "");
    free_.insert(whole);
    free_.difference(blocked);
    free_.polygons_with_holes(std::back_inserter(areas_));
  }

  /// Connected with the seed, or the largest.
  const Area& chosen() const {
    if (areas_.empty()) {
      throw InputError("--height",
                       fmt::format("no free space is left {} from surfaces at height {}",
                                   options_.clearance, options_.height),
                       "give another height or a smaller --clearance");
    }
    if (!options_.seed) {
      return *std::ranges::max_element(areas_, {}, [](const Area& area) { return area_of(area); });
    }
    const Place seed((*options_.seed)[frame_.u()], (*options_.seed)[frame_.v()]);
    for (const Area& area : areas_) {
      if (Areas(area).oriented_side(seed) != CGAL::ON_NEGATIVE_SIDE) return area;
    }
    throw InputError(
        "--seed-point",
        fmt::format("is outside the scene, or nearer than {} to a surface at height {}",
                    options_.clearance, options_.height),
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

 private:
  std::vector<Point> rounded(const Outline& outline) const {
    std::vector<Point> loop;
    const auto nearest = [&](const Number& x) {
      return std::nearbyint(CGAL::to_double(x) / step_) * step_;
    };
    for (const Place& place : outline.container()) {
      const Point corner = frame_.at(nearest(place.x()), nearest(place.y()), options_.height);
      if (loop.empty() || loop.back() != corner) loop.push_back(corner);
    }
    while (loop.size() > 1 && loop.front() == loop.back()) loop.pop_back();
    return loop;
  }

  const Scene& scene_;
  const FreeRegionOptions& options_;
  HeightFrame frame_;
  double step_;
  Areas free_;
  std::list<Area> areas_;
};

}  // namespace

FreeRegion find_free_region(const Scene& scene, const FreeRegionOptions& asked) {
  if (!(asked.clearance >= 0)) {
    throw InputError("--clearance", "is negative or no number", "give a distance >= 0");
  }
  const double lowest = scene.bounds.min()[asked.up_axis],
               highest = scene.bounds.max()[asked.up_axis];
  if (!(asked.height >= lowest && asked.height <= highest)) {
    throw InputError("--height",
                     fmt::format("{} is outside the scene, which goes from {} to {} there",
                                 asked.height, lowest, highest),
                     "give a height between, or another --up");
  }
  FreeRegionOptions options = asked;
  options.height = scene.lattice.round(asked.height);
  for (int attempt = 1; attempt <= kMostTries; ++attempt) {
    const FreeSpace space(scene, options, std::ldexp(scene.lattice.step(), kCoarser * attempt));
    const Area& chosen = space.chosen();
    const ConvexParts parts = convex_parts(space.loops_of(chosen));
    if (parts.kind == FaceKind::kCrossing) continue;
    FreeRegion region;
    region.holes = chosen.number_of_holes();
    region.others = space.areas().size() - 1;
    for (const Area& area : space.areas()) region.area_of_others += FreeSpace::area_of(area);
    region.area_of_others -= FreeSpace::area_of(chosen);
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

}  // namespace viewcover
