#include "scene/repair/narrow_gaps.h"

#include <gmock/gmock.h>

#include <random>
#include <set>
#include <span>

#include "scene/error.h"
#include "scene/made_scene.h"
#include "scene/random_numbers.h"
#include "support/scenes.h"

namespace viewcover {
namespace {

using testing::horizontal;
using testing::scene_of;

/// Two squares side by side at height 0 with a slit along y between them.
Scene slit(double width) {
  return scene_of(std::vector{horizontal(-1, 0, 0, 1, 0), horizontal(width, 0, 1, 1, 0)});
}

/// True iff the vertical line at (x, y) meets a patch.
bool is_closed_at(const std::vector<NarrowGap>& gaps, double x, double y) {
  return std::ranges::any_of(gaps, [&](const NarrowGap& gap) {
    int sides = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &a = gap.patch[k], &b = gap.patch[(k + 1) % 3];
      const double turn = (b.x() - a.x()) * (y - a.y()) - (b.y() - a.y()) * (x - a.x());
      sides += turn > 0 ? 1 : turn < 0 ? -1 : 0;
    }
    return std::abs(sides) == 3;
  });
}

TEST(NarrowGaps, AreNarrowerThanTheWidth) {
  const double width = 1.0 / 64;
  EXPECT_TRUE(find_narrow_gaps(slit(width), width).empty());
  const std::vector<NarrowGap> gaps = find_narrow_gaps(slit(width), 1.01 * width);
  ASSERT_FALSE(gaps.empty());
  for (const NarrowGap& gap : gaps) {
    EXPECT_NEAR(gap.width, width, 1e-12);
    EXPECT_EQ(std::set({gap.surface, gap.other}), std::set({SurfaceId(0), SurfaceId(1)}));
  }
}

TEST(NarrowGaps, AreClosedWhollyAndOverlapWhatTheyJoin) {
  const double width = 1.0 / 64, step = slit(width).lattice.step();
  const std::vector<NarrowGap> gaps = find_narrow_gaps(slit(width), 2 * width);
  for (double y = 1.0 / 512; y < 1; y += 1.0 / 256) {
    for (const double x : {-step, step / 3, width / 2, width - step / 3, width + step}) {
      EXPECT_TRUE(is_closed_at(gaps, x, y)) << x << ' ' << y;
    }
    EXPECT_FALSE(is_closed_at(gaps, -8 * step, y));
    EXPECT_FALSE(is_closed_at(gaps, width + 8 * step, y));
  }
}

TEST(NarrowGaps, AreClosedOnTheLattice) {
  const Scene scene = slit(1.0 / 64);
  for (const NarrowGap& gap : find_narrow_gaps(scene, 0.02)) {
    for (const Point& corner : gap.patch) EXPECT_EQ(corner, scene.lattice.round(corner));
    EXPECT_TRUE(is_strictly_convex(gap.patch));
  }
}

// A vertex half a step beside an edge: what rounding to the lattice makes of a T-junction.
TEST(NarrowGaps, HairlinesThinnerThanTheLatticeAreGaps) {
  const double step = std::ldexp(1.0, -20);
  const Point junction(1 + step, 1, 0);
  const Scene scene =
      scene_of(std::vector<ConvexPolygon>{{{0, 0, 0}, {1, 0, 0}, {1 + step, 2.5, 0}, {0, 2.5, 0}},
                                          {{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, junction},
                                          {junction, {2, 1, 0}, {2, 2.5, 0}, {1 + step, 2.5, 0}}});
  const std::vector<NarrowGap> gaps = find_narrow_gaps(scene, 1e-4);
  for (double y = 0.05; y < 2.45; y += 0.1) {
    const double edge = 1 + step * y / 2.5, other = y < 1 ? 1 + step * y : 1 + step;
    EXPECT_TRUE(is_closed_at(gaps, (edge + other) / 2, y)) << y;
  }
}

TEST(NarrowGaps, ClosedSolidsHaveNone) {
  std::vector<ConvexPolygon> faces = reversed(box_outward({0, 0, 0}, {4, 4, 2}));
  // A table leg that stands on the floor, thinner than the width.
  for (const ConvexPolygon& face : box_outward({1, 1, 0}, {1.0625, 1.0625, 1})) {
    faces.push_back(face);
  }
  for (const NarrowGap& gap : find_narrow_gaps(scene_of(faces), 0.125)) {
    // Inside of the leg, where nobody looks.
    const Box leg(Point(1, 1, 0) - Point::Constant(1e-4),
                  Point(1.0625, 1.0625, 1) + Point::Constant(1e-4));
    for (const Point& corner : gap.patch) EXPECT_TRUE(leg.contains(corner)) << corner;
  }
  EXPECT_TRUE(find_narrow_gaps(scene_of(reversed(box_outward({0, 0, 0}, {4, 4, 2}))), 1).empty());
}

TEST(NarrowGaps, AreFoundBetweenAnEdgeAndTheInsideOfASurface) {
  // A door leaf a little above the floor.
  std::vector<ConvexPolygon> faces = {horizontal(0, 0, 4, 4, 0)};
  faces.push_back({{1, 2, 0.0078125}, {2, 2, 0.0078125}, {2, 2, 2}, {1, 2, 2}});
  const std::vector<NarrowGap> gaps = find_narrow_gaps(scene_of(faces), 0.01);
  ASSERT_FALSE(gaps.empty());
  Box closed;
  for (const NarrowGap& gap : gaps) {
    EXPECT_EQ(gap.surface, SurfaceId(1));
    EXPECT_EQ(gap.other, SurfaceId(0));
    EXPECT_NEAR(gap.width, 0.0078125, 1e-12);
    closed.extend(bounding_box(gap.patch));
  }
  EXPECT_LE(closed.min().x(), 1);
  EXPECT_GE(closed.max().x(), 2);
  EXPECT_LE(closed.min().z(), 0);
  EXPECT_GE(closed.max().z(), 0.0078125);
  EXPECT_NEAR(closed.max().y() - closed.min().y(), 0, 1e-5);
}

bool is_inside(std::span<const Point> polygon, const Point& p, double tolerance) {
  const Point normal = area_vector(polygon).normalized();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point &a = polygon[k], &b = polygon[(k + 1) % polygon.size()];
    if (normal.cross(b - a).dot(p - a) < -tolerance * (b - a).norm()) return false;
  }
  return true;
}

bool is_on_patch(const std::vector<NarrowGap>& gaps, const Point& p, double step) {
  return std::ranges::any_of(gaps, [&](const NarrowGap& gap) {
    const Point normal = area_vector(gap.patch).normalized();
    return std::fabs(normal.dot(p - gap.patch[0])) < 1e-3 && is_inside(gap.patch, p, step);
  });
}

/// Calls visit(p, other) for 16 places p on each edge of each triangle and all other triangles.
template <class Visit>
void for_each_place_on_edges(const Scene& scene, const Visit& visit) {
  for (const Surface& surface : scene.surfaces) {
    for (const Surface& other : scene.surfaces) {
      if (&other == &surface) continue;
      for (std::size_t i = 0; i < 3 * 16; ++i) {
        const Point &a = surface.polygon[i / 16], &b = surface.polygon[(i / 16 + 1) % 3];
        visit(Point(a + (static_cast<double>(i % 16) + 0.5) / 16 * (b - a)), other.polygon);
      }
    }
  }
}

// The definition, point by point: the middle of every short connection is on a patch.
TEST(NarrowGaps, FromEdgesToTheInsideOfSurfaces) {
  std::mt19937_64 random(1);
  std::size_t connections = 0;
  for (int round = 0; round < 20; ++round) {
    const Scene scene = scene_of(testing::random_triangles(12, 0.3, 0, 1, random));
    const double width = 0.1, step = scene.lattice.step();
    const std::vector<NarrowGap> gaps = find_narrow_gaps(scene, width);
    for_each_place_on_edges(scene, [&](const Point& p, const ConvexPolygon& other) {
      const Point normal = area_vector(other).normalized();
      const double height = normal.dot(p - other[0]);
      if (std::fabs(height) >= width || std::fabs(height) < 16 * step) return;
      if (!is_inside(other, p - height * normal, 0)) return;
      ++connections;
      EXPECT_TRUE(is_on_patch(gaps, p - height / 2 * normal, step)) << p.transpose();
    });
  }
  EXPECT_GT(connections, 200u);
}

TEST(NarrowGaps, FromEdgesToEdges) {
  std::mt19937_64 random(2);
  std::size_t connections = 0;
  for (int round = 0; round < 20; ++round) {
    // In one plane, where connections do, too.
    const Scene scene = scene_of(testing::random_triangles(8, 0.2, 0, 0, random));
    const double width = 0.1, step = scene.lattice.step();
    const std::vector<NarrowGap> gaps = find_narrow_gaps(scene, width);
    for_each_place_on_edges(scene, [&](const Point& p, const ConvexPolygon& other) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Point &c = other[k], &d = other[(k + 1) % 3];
        const double along = std::clamp((d - c).dot(p - c) / (d - c).squaredNorm(), 0.0, 1.0);
        const Point q = c + along * (d - c), middle = (p + q) / 2;
        if ((p - q).norm() >= width || (p - q).norm() < 16 * step) continue;
        const bool is_covered = std::ranges::any_of(scene.surfaces, [&](const Surface& any) {
          return is_inside(any.polygon, middle, 1e-3);
        });
        if (is_covered) continue;
        ++connections;
        EXPECT_TRUE(is_on_patch(gaps, middle, step)) << p.transpose();
      }
    });
  }
  EXPECT_GT(connections, 200u);
}

TEST(NarrowGaps, SurfacesKeepTheirNumbersAndPatchesAreNoTargets) {
  const Scene scene = slit(1.0 / 64);
  const std::vector<NarrowGap> gaps = find_narrow_gaps(scene, 0.02);
  const Scene closed = with_gaps_closed(scene, gaps);
  ASSERT_EQ(closed.surfaces.size(), scene.surfaces.size() + gaps.size());
  for (std::size_t i = 0; i < closed.surfaces.size(); ++i) {
    const bool is_patch = i >= scene.surfaces.size();
    EXPECT_EQ(closed.surfaces[i].is_target, !is_patch);
    if (is_patch) continue;
    EXPECT_EQ(closed.surfaces[i].polygon, scene.surfaces[i].polygon);
  }
}

}  // namespace
}  // namespace viewcover
