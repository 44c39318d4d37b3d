#include "scene/convex_polygon.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/exact_judge.h"

namespace viewcover {
namespace {

/// Corners on a circle, rounded to the lattice 2^-12, tilted by an exact shear.
ConvexPolygon polygon_with(int corners, double slope) {
  ConvexPolygon polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * M_PI * i / corners;
    const double x = std::nearbyint(std::ldexp(3 * std::cos(angle), 12));
    const double y = std::nearbyint(std::ldexp(2 * std::sin(angle), 12));
    polygon.emplace_back(std::ldexp(x, -12), std::ldexp(y, -12), std::ldexp(slope * x, -12));
  }
  return polygon;
}

class Quarters : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Corners, Quarters, ::testing::Values(3, 4, 5, 6, 7, 8, 9, 13, 28, 66));

TEST_P(Quarters, TileThePolygonWithStrictlyConvexPartsOfItsPlaneAndOrientation) {
  for (const double slope : {0.0, 2.0}) {
    const ConvexPolygon polygon = polygon_with(GetParam(), slope);
    ASSERT_TRUE(is_strictly_convex(polygon));
    ASSERT_TRUE(is_planar(polygon));
    double sum = 0;
    for (const ConvexPolygon& part : quarters(polygon)) {
      EXPECT_TRUE(is_strictly_convex(part));
      for (const Point& corner : part) {
        EXPECT_EQ(testing::exact_orientation(
                      testing::ExactPoint(polygon[0]), testing::ExactPoint(polygon[1]),
                      testing::ExactPoint(polygon[2]), testing::ExactPoint(corner)),
                  0);
      }
      EXPECT_GT(area_vector(part).dot(area_vector(polygon)), 0);
      sum += area(part);
    }
    EXPECT_NEAR(sum, area(polygon), 1e-14 * area(polygon));
  }
}

TEST_P(Quarters, StayExactDownToTheDeepestLevel) {
  // Coordinates of 24 bits in all; exactness shows in exact coplanarity and in exact area.
  ConvexPolygon polygon = polygon_with(GetParam(), 2);
  for (Point& corner : polygon) corner *= 256;  // 2^-12 to 2^-4, |x| < 2^11
  std::mt19937_64 random(5);
  for (int way = 0; way < 10; ++way) {
    ElementAddress address{SurfaceId(0)};
    while (address.level() < kMaxSubdivisionLevel) {
      address = address.child(static_cast<int>(random() % 4));
    }
    const ConvexPolygon leaf = subdivided(polygon, address);
    EXPECT_TRUE(is_strictly_convex(leaf));
    for (const Point& corner : leaf) {
      EXPECT_EQ(corner.z(), 2 * corner.x());
    }
  }
}

TEST(ConvexPolygon, RefusesWhatIsNotStrictlyConvex) {
  EXPECT_FALSE(is_strictly_convex(ConvexPolygon{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}}));
  EXPECT_FALSE(is_strictly_convex(ConvexPolygon{{0, 0, 0}, {4, 0, 0}, {1, 1, 0}, {0, 4, 0}}));
  // A pentagram turns the same way at every corner, but winds twice.
  ConvexPolygon star, pentagon = polygon_with(5, 0);
  for (std::size_t i = 0; i < 5; ++i) star.push_back(pentagon[2 * i % 5]);
  EXPECT_FALSE(is_strictly_convex(star));
  EXPECT_TRUE(is_strictly_convex(pentagon));
}

TEST(ConvexPolygon, PlanarityIsExact) {
  ConvexPolygon square{{0, 0, 0}, {3, 0, 1}, {3, 3, 2}, {0, 3, 1}};
  EXPECT_TRUE(is_planar(square));
  square[2].z() += 0x1p-40;
  EXPECT_FALSE(is_planar(square));
}

TEST(ConvexPolygon, AreaAndCentroidOfATrapezium) {
  // Parallel sides 4 and 2 at distance 3: area 9, centroid 4/3 above the longer side.
  const ConvexPolygon trapezium{{0, 0, 1}, {4, 0, 1}, {3, 3, 1}, {1, 3, 1}};
  EXPECT_DOUBLE_EQ(area(trapezium), 9);
  EXPECT_TRUE(centroid(trapezium).isApprox(Point(2, 4.0 / 3, 1), 1e-15));
}

}  // namespace
}  // namespace viewcover
