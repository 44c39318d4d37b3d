#include "exact/view_cone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/integer_geometry.h"
#include "exact/point_cases.h"
#include "support/exact_judge.h"

namespace viewcover::exact {
namespace {

/// A query's polygons, the viewpoint first, then the element.
using Polygons = std::vector<ConvexPolygon>;

Polygons polygons_of(const SightQuery& query) {
  Polygons polygons = {ConvexPolygon{query.viewpoint}, query.element};
  polygons.insert(polygons.end(), query.occluders.begin(), query.occluders.end());
  return polygons;
}

IntegerFrame frame_of(const Polygons& polygons) {
  IntegerFrame frame;
  for (const auto& polygon : polygons) frame.include(polygon);
  frame.set_origin(polygons[1][0]);
  return frame;
}

/// Under a linear map, which keeps who sees what. Nothing may be rounded.
Polygons mapped(Polygons polygons, const Eigen::Matrix3d& map) {
  using testing::Rational;
  for (auto& polygon : polygons) {
    for (Point& point : polygon) {
      const Point image = map * point;
      for (Eigen::Index k = 0; k < 3; ++k) {
        Rational exact = 0;
        for (Eigen::Index i = 0; i < 3; ++i) exact += Rational(map(k, i)) * Rational(point[i]);
        EXPECT_EQ(Rational(image[k]), exact) << "rounded";
      }
      point = image;
    }
  }
  return polygons;
}

/// Does the plane of the element, seen from the viewpoint, fit 128 bits? All answers begin with it.
bool plane_fits(const Polygons& polygons) {
  const IntegerFrame frame = frame_of(polygons);
  if (!frame.is_narrow()) return false;
  std::vector<HomogeneousPoint<CheckedWide>> element;
  const auto viewpoint = frame.operator()<CheckedWide>(polygons[0][0]);
  for (const Point& corner : polygons[1]) {
    element.push_back({frame.operator()<CheckedWide>(corner) - viewpoint});
  }
  try {
    [[maybe_unused]] const IntegerPlane<CheckedWide> plane(element);
    return true;
  } catch (const CheckedWide::Overflow&) {
    return false;
  }
}

void expect_right(const testing::PointCase& expected, const Polygons& polygons) {
  const std::vector<std::span<const Point>> occluders(polygons.begin() + 2, polygons.end());
  ExactStatistics statistics;
  EXPECT_EQ(sees_part(polygons[0][0], polygons[1], occluders, statistics), expected.seen > 0);
  constexpr double kWeight = 1;
  const ViewOfElement view =
      view_element(polygons[0], {&kWeight, 1}, polygons[1], occluders, statistics);
  EXPECT_EQ(view.visible_fraction * CGAL::Gmpq(expected.of), CGAL::Gmpq(expected.seen));
}

TEST(ViewCone, IsTheSameBeyond128Bits) {
  int too_long = 0, too_wide = 0, seen = 0;
  for (const testing::PointCase& c : testing::point_cases()) {
    SCOPED_TRACE(c.name);
    const Polygons given = polygons_of(c.query);
    if (c.query.one_sided || !std::ranges::all_of(given.begin() + 1, given.end(),
                                                  [](auto& p) { return is_strictly_convex(p); })) {
      continue;
    }
    expect_right(c, given);
    EXPECT_TRUE(plane_fits(given));
    seen += c.seen > 0;

    // Sums of three terms of up to 53 bits in all, their products of three too long.
    Eigen::Matrix3d skew;
    const double large = std::ldexp(1.0, 49 - frame_of(given).bits());
    skew << large, 3, 5, 1, large, 7, 1, 2, large;
    const Polygons longer = mapped(given, skew);
    EXPECT_TRUE(frame_of(longer).is_narrow());
    expect_right(c, longer);
    too_long += !plane_fits(longer);

    // Coordinates of too many bits themselves.
    const Polygons wider = mapped(given, Eigen::Vector3d(0x1p44, 0x1p-20, 1).asDiagonal());
    expect_right(c, wider);
    too_wide += !frame_of(wider).is_narrow();
  }
  EXPECT_GE(seen, 8);
  EXPECT_GE(too_long, 8);
  EXPECT_GE(too_wide, 8);
}

}  // namespace
}  // namespace viewcover::exact
