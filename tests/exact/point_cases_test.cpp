#include "exact/point_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/query_poses.h"
#include "exact/witness_judge.h"

namespace viewcover {
namespace {

using testing::ExactPoint;
using testing::PointCase;
using testing::Pose;
using testing::Rational;

bool faces_viewpoint(const SightQuery& query) {
  const int side = testing::exact_side(query.element, ExactPoint(query.viewpoint));
  return query.one_sided ? side > 0 : side != 0;
}

bool is_coplanar(std::span<const Point> a, std::span<const Point> b) {
  return std::ranges::all_of(
      a, [b](const Point& corner) { return testing::exact_side(b, ExactPoint(corner)) == 0; });
}

/// The first occluder that meets the open segment to q, but for those seen edge-on or coplanar
/// with the element.
std::optional<std::size_t> blocker(const SightQuery& query, const ExactPoint& q) {
  const ExactPoint p(query.viewpoint);
  for (std::size_t i = 0; i < query.occluders.size(); ++i) {
    if (testing::exact_side(query.occluders[i], p) == 0) continue;
    if (is_coplanar(query.occluders[i], query.element)) continue;
    if (testing::open_segment_meets(p, q, query.occluders[i])) return i;
  }
  return std::nullopt;
}

void expect_seen(const SightQuery& query, const Witness& witness) {
  EXPECT_TRUE(witness.region_weights.empty());
  ASSERT_EQ(witness.element_weights.size(), query.element.size());
  for (const double weight : witness.element_weights) {
    EXPECT_GT(weight, 0);
    EXPECT_TRUE(std::isfinite(weight));
  }
  EXPECT_EQ(blocker(query, testing::weighted(query.element, witness.element_weights)),
            std::nullopt);
}

/// The parts are seen, and their areas sum up to the fraction: they do not overlap.
void expect_parts(const SightQuery& query, const PointAnswer& answer, double fraction) {
  const ExactPoint normal = testing::exact_area_vector(query.element);
  Rational seen = 0;
  for (const ConvexPolygon& part : answer.visible_parts) {
    ASSERT_GE(part.size(), 3u);
    const Rational share = dot(testing::exact_area_vector(part), normal) / dot(normal, normal);
    seen += abs(share);
    const std::vector<double> equal(part.size(), 1.0);
    EXPECT_EQ(blocker(query, testing::weighted(part, equal)), std::nullopt);
  }
  // Corners are rounded: 2^-53 of a coordinate, in strips down to 2^-20 of the element.
  EXPECT_NEAR(seen.convert_to<double>(), fraction, 0x1p-24 * fraction);
}

void expect_right(const SightQuery& query, const PointCase& expected) {
  const PointAnswer answer = decide_from_point(query);
  const Verdict verdict = answer.verdict;
  SCOPED_TRACE(name(verdict));
  const bool visible = expected.seen > 0;
  EXPECT_EQ(is_visible(verdict), visible);
  if (expected.fully) {
    EXPECT_EQ(verdict == Verdict::kFullyVisible, *expected.fully);
  }
  EXPECT_EQ(verdict == Verdict::kHiddenNotFacing, !faces_viewpoint(query));
  EXPECT_NE(verdict, Verdict::kAssumedVisible);
  EXPECT_NE(verdict, Verdict::kHiddenAllRaysBlocked);
  const double fraction = expected.seen / expected.of;
  EXPECT_NEAR(answer.visible_fraction, fraction, 1e-15 * fraction);
  EXPECT_EQ(answer.visible_parts.empty(), !visible);
  expect_parts(query, answer, fraction);
  EXPECT_EQ(answer.witness.has_value(), visible);
  if (answer.witness) expect_seen(query, *answer.witness);
}

TEST(PointCases, AreWellFormed) {
  const std::vector<PointCase> cases = testing::point_cases();
  EXPECT_GE(cases.size(), 15u);
  for (const PointCase& c : cases) {
    SCOPED_TRACE(c.name);
    EXPECT_FALSE(c.argument.empty());
    EXPECT_LE(c.seen, c.of);
    testing::Polygons polygons = c.query.occluders;
    polygons.push_back(c.query.element);
    for (const ConvexPolygon& polygon : polygons) {
      EXPECT_TRUE(testing::is_convex_loop(polygon));
    }
  }
}

TEST(PointCases, AllAreRight) {
  for (const PointCase& c : testing::point_cases()) {
    SCOPED_TRACE("case: " + c.name + "\nargument: " + c.argument);
    for (const Pose& pose : testing::poses()) {
      SCOPED_TRACE("pose: " + pose.name);
      expect_right(posed(c.query, pose), c);
    }
  }
}

}  // namespace
}  // namespace viewcover
