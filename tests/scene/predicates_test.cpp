#include "scene/predicates.h"

#include <gtest/gtest.h>

#include <random>

#include "scene/plane.h"
#include "support/exact_judge.h"

namespace viewcover {
namespace {

using testing::exact_orientation;
using testing::ExactPoint;

int judged(const Point& a, const Point& b, const Point& c, const Point& d) {
  return exact_orientation(ExactPoint(a), ExactPoint(b), ExactPoint(c), ExactPoint(d));
}

TEST(Orientation, IsPositiveInFrontOfACounterClockwiseTriangle) {
  EXPECT_EQ(orientation({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orientation({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}), -1);
  EXPECT_EQ(orientation({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {5, 7, 0}), 0);
}

/// Coplanar points on a tilted plane, and the same with one coordinate moved by `step`.
struct NearlyCoplanar {
  std::mt19937_64 random{7};

  Point lattice_point(int bits) {
    std::uniform_int_distribution<int> coordinate(-(1 << bits), 1 << bits);
    return {double(coordinate(random)), double(coordinate(random)), double(coordinate(random))};
  }
};

TEST(Orientation, AgreesWithRationalsOnCoplanarPointsAndOneUnitBeside) {
  NearlyCoplanar make;
  int zeros = 0, others = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    SCOPED_TRACE(trial);
    const Point a = make.lattice_point(9), u = make.lattice_point(9), v = make.lattice_point(9);
    std::uniform_int_distribution<int> factor(-60, 60);
    Point d = a + factor(make.random) * u + factor(make.random) * v;
    if (trial % 2 == 1) d[trial / 2 % 3] += trial % 4 == 1 ? 1 : -1;
    const double scale = std::ldexp(1.0, trial % 41 - 20);
    const int expected = judged(a, a + u, a + v, d);
    (expected == 0 ? zeros : others) += 1;
    ASSERT_EQ(orientation(scale * a, scale * (a + u), scale * (a + v), scale * d), expected);
  }
  EXPECT_GT(zeros, 5000);
  EXPECT_GT(others, 5000);
}

TEST(Orientation, IsExactBeyondWhatIntegersOf128BitsHold) {
  // Doubles of full precision and mixed magnitude: differences are not exact in double.
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  int zeros = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    SCOPED_TRACE(trial);
    const auto point = [&] {
      return Point(coordinate(random), coordinate(random), std::ldexp(coordinate(random), -30));
    };
    const Point a = point(), b = point(), c = point();
    const Point d = trial % 3 == 0 ? Point(a) : Point(0.5 * (a + b) + 0.25 * (c - a));
    const int expected = judged(a, b, c, d);
    zeros += expected == 0;
    ASSERT_EQ(orientation(a, b, c, d), expected);
  }
  EXPECT_GT(zeros, 900);
}

TEST(Orientation, ChangesSignUnderExchange) {
  NearlyCoplanar make;
  for (int trial = 0; trial < 2000; ++trial) {
    const Point a = make.lattice_point(3), b = make.lattice_point(3);
    const Point c = make.lattice_point(3), d = make.lattice_point(3);
    const int sign = orientation(a, b, c, d);
    ASSERT_EQ(orientation(b, a, c, d), -sign);
    ASSERT_EQ(orientation(a, b, d, c), -sign);
    ASSERT_EQ(orientation(b, c, a, d), sign);
  }
}

TEST(Turn, AgreesWithOrientationInThePlane) {
  NearlyCoplanar make;
  int zeros = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    Point a = make.lattice_point(4), b = make.lattice_point(4), c = make.lattice_point(4);
    const int axis = trial % 3;
    a[axis] = b[axis] = c[axis] = 0;
    Point above = a;
    above[axis] = 1;
    const int expected = judged(a, b, c, above);
    zeros += expected == 0;
    ASSERT_EQ(turn(a, b, c, axis), expected);
  }
  EXPECT_GT(zeros, 10);
}

TEST(Plane, SideIsExactWithAndWithoutReach) {
  NearlyCoplanar make;
  int zeros = 0;
  for (int trial = 0; trial < 20000; ++trial) {
    SCOPED_TRACE(trial);
    const int bits = trial % 5 == 0 ? 2 : 18;
    const Point a = make.lattice_point(bits), b = make.lattice_point(bits);
    const Point c = make.lattice_point(bits);
    Point d = 0.25 * (2 * a + b + c);
    if (trial % 2 == 1) d[trial / 2 % 3] += 0.25;
    const int expected = judged(a, b, c, d);
    zeros += expected == 0;
    ASSERT_EQ(Plane(a, b, c).side(d), expected);
    ASSERT_EQ(Plane(a, b, c, 1 << 20).side(d), expected);
    ASSERT_EQ(Plane(a, b, c).reversed().side(d), -expected);
  }
  EXPECT_GT(zeros, 5000);
}

TEST(Plane, BoxInFrontIsCertainAndExactForAxisPlanes) {
  NearlyCoplanar make;
  int in_front = 0;
  for (int trial = 0; trial < 5000; ++trial) {
    const Plane plane(make.lattice_point(3), make.lattice_point(3), make.lattice_point(3));
    Box box(make.lattice_point(4));
    box.extend(Point(box.min() + make.lattice_point(2)));
    if (!plane.has_in_front(box)) continue;
    ++in_front;
    for (int corner = 0; corner < 8; ++corner) {
      ASSERT_GE(plane.side(box.corner(static_cast<Box::CornerType>(corner))), 0);
    }
  }
  EXPECT_GT(in_front, 500);
  const Plane floor({0, 0, 0.1}, {0.3, 0, 0.1}, {0, 0.7, 0.1});
  EXPECT_TRUE(floor.has_in_front(Box(Point(-1, -1, 0.1), Point(1, 1, 2))));
  EXPECT_FALSE(floor.has_in_front(Box(Point(-1, -1, 0.0999999), Point(1, 1, 2))));
}

TEST(Plane, SideWithinIsSilentWhereTheErrorReaches) {
  const Plane plane({0, 0, 0}, {1, 0, 1}, {0, 1, 0});
  EXPECT_EQ(plane.side_within({0, 0, 1}, 1e-9), 1);
  EXPECT_EQ(plane.side_within({1, 0, 0}, 1e-9), -1);
  EXPECT_EQ(plane.side_within({0.5, 0.5, 0.5 + 1e-9}, 1e-9), 0);
}

}  // namespace
}  // namespace viewcover
