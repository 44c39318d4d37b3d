#include "viewpoints/region_positions.h"

#include <gtest/gtest.h>

#include <cmath>

#include "scene/predicates.h"
#include "scene/viewing_region.h"
#include "support/scenes.h"

namespace viewcover {
namespace {

const Box kScene(Point(-4, -4, -4), Point(4, 4, 4));
constexpr int kLattice = 20;

/// Slanted polygons of 3 to 6 corners on the lattice, in planes no axis lies in.
std::vector<ConvexPolygon> slanted_polygons() {
  const Point a(0.125, -0.25, 1), u(1, 0.5, 0.25), v(-0.375, 1, -0.5);
  const auto at = [&](double s, double t) { return Point(a + s * u + t * v); };
  return {{at(0, 0), at(1, 0), at(0, 1)},
          {at(0, 0), at(1, 0), at(1, 1), at(0, 1)},
          {at(0, 0), at(2, 0), at(1, 1), at(0, 1)},
          {at(0, 0), at(1, 0), at(1.5, 0.5), at(1, 1.5), at(0.5, 1.25), at(-0.5, 0.5)}};
}

/// a - b without rounding: 64 bits of significand hold it as 53 do. Both are below 8 and above
/// 2^-50 or 0, so the longer format is exact.
bool is_exact_difference(double a, double b) {
  const long double exact = static_cast<long double>(a) - static_cast<long double>(b);
  return static_cast<long double>(a - b) == exact;
}

TEST(RegionPositions, LieInTheirRegionExactly) {
  RandomNumbers random(7);
  int inside = 0, outside = 0;
  for (const ConvexPolygon& polygon : slanted_polygons()) {
    for (const int level : {0, 3, 6, 10}) {
      ViewingRegion region = testing::region_of(polygon, level);
      for (int i = 0; i < 20; ++i) {
        const std::size_t number = random.below(region.region_count());
        const RegionPositions positions(region.polygon(region.address(number)), kScene, kLattice);
        EXPECT_GE(positions.bits(), 6);
        Point position = positions.random(random);
        for (int step = 0; step < 30; ++step) {
          ASSERT_TRUE(positions.region().contains(position));
          ASSERT_EQ(orientation(polygon[0], polygon[1], polygon[2], position), 0);
          for (int axis = 0; axis < 3; ++axis) {
            ASSERT_TRUE(is_exact_difference(position[axis], 4 - std::ldexp(1.0, -kLattice)));
            ASSERT_TRUE(is_exact_difference(position[axis], -4));
          }
          // A point a little beside the plane is outside, whatever the projection says.
          const Point beside = position + 1e-13 * area_vector(polygon).normalized();
          (positions.region().contains(beside) ? inside : outside)++;
          position = positions.near(position, std::ldexp(1.0, -step), random);
        }
      }
    }
  }
  EXPECT_EQ(inside, 0);
  EXPECT_GT(outside, 1000);
}

TEST(RegionPositions, TheNearestIsNear) {
  RandomNumbers random(8);
  for (const ConvexPolygon& polygon : slanted_polygons()) {
    const RegionPositions positions(polygon, kScene, kLattice);
    for (int i = 0; i < 200; ++i) {
      // Any point of the polygon: a combination of its corners.
      Point point = Point::Zero();
      double total = 0;
      for (const Point& corner : polygon) {
        const double weight = random.open_unit();
        point += weight * corner;
        total += weight;
      }
      point /= total;
      EXPECT_LT((positions.nearest(point) - point).norm(), 1e-5);
    }
    for (const Point& corner : polygon) {
      EXPECT_LT((positions.nearest(corner) - corner).norm(), 1e-5);
      const Point beyond = corner + 3 * (corner - corner_mean(polygon));
      EXPECT_TRUE(lies_in(positions.nearest(beyond), polygon));
    }
  }
}

TEST(RegionPositions, AreSpreadByArea) {
  RandomNumbers random(9);
  const RegionPositions positions(testing::horizontal(0, 0, 2, 1, 0.5), kScene, kLattice);
  int left = 0;
  constexpr int kPositions = 4000;
  for (int i = 0; i < kPositions; ++i) left += positions.random(random).x() < 1;
  EXPECT_NEAR(left, kPositions / 2, 4 * std::sqrt(kPositions));
}

TEST(LiesIn, CountsTheBorder) {
  const ConvexPolygon square = testing::horizontal(0, 0, 1, 1, 0.25);
  EXPECT_TRUE(lies_in({0, 0, 0.25}, square));
  EXPECT_TRUE(lies_in({0.5, 1, 0.25}, square));
  EXPECT_TRUE(lies_in({0.5, 0.5, 0.25}, square));
  EXPECT_FALSE(lies_in({0.5, 1 + 0x1p-52, 0.25}, square));
  EXPECT_FALSE(lies_in({0.5, 0.5, 0.25 + 0x1p-54}, square));
}

}  // namespace
}  // namespace viewcover
