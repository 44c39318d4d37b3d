#include "audit/sight_plane.h"

#include <gtest/gtest.h>

#include "scene/random_numbers.h"
#include "support/exact_judge.h"

namespace viewcover {
namespace {

using testing::ExactPoint;

TEST(SightPlane, SidesNearThePlaneAreExact) {
  // Points a few roundings off the plane through a viewpoint on no lattice.
  RandomNumbers random(1);
  const auto place = [&] {
    return Point(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
  };
  std::size_t rounded_wrong = 0, off = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    const Point viewpoint = place(), a = place(), b = place();
    const double s = random.between(-1, 1), t = random.between(-1, 1);
    const Point x = a + s * (a - viewpoint) + t * (b - viewpoint);
    const double reach = (x - a).lpNorm<Eigen::Infinity>() * (1 + 0x1p-40);
    const int expected = testing::exact_orientation(ExactPoint(viewpoint), ExactPoint(a),
                                                    ExactPoint(b), ExactPoint(x));
    ASSERT_EQ(SightPlane(viewpoint, a, b, reach).side(x), expected) << trial;
    const double rounded = (a - viewpoint).cross(b - viewpoint).dot(x - a);
    rounded_wrong += (rounded > 0) - (rounded < 0) != expected;
    off += expected != 0;
  }
  EXPECT_GT(rounded_wrong, 1000u);
  EXPECT_GT(off, 10'000u);
}

TEST(SightPlane, BoxesBehindAreBehindInAllCorners) {
  RandomNumbers random(2);
  const auto place = [&] {
    return Point(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
  };
  std::size_t behind = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const SightPlane plane(place(), place(), place(), 4);
    Box box(place());
    box.extend(Point(box.min() + 0.1 * place()));
    bool all = true;
    for (int corner = 0; corner < 8; ++corner) {
      all = all && plane.side(box.corner(static_cast<Box::CornerType>(corner))) < 0;
    }
    behind += plane.has_behind(box);
    // Both ways here: nothing is nearer to the plane than the margin.
    EXPECT_EQ(plane.has_behind(box), all);
  }
  EXPECT_GT(behind, 500u);
}

}  // namespace
}  // namespace viewcover
