#include "exact/query_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "exact/query_poses.h"
#include "exact/witness_judge.h"

namespace viewcover {
namespace {

using testing::ExactPoint;
using testing::Pose;
using testing::QueryCase;

bool is_integral(std::span<const Point> polygon) {
  return std::ranges::all_of(
      polygon, [](const Point& p) { return p == p.array().round().matrix() && p.norm() < 0x1p22; });
}

/// Is a point of the region off the element's plane, and in front of it if that is one-sided?
bool faces_region(const SightQuery& query) {
  return std::ranges::any_of(query.region, [&](const Point& corner) {
    const int side = testing::exact_side(query.element, ExactPoint(corner));
    return query.one_sided ? side > 0 : side != 0;
  });
}

void expect_weights(std::span<const double> weights, std::size_t corners) {
  ASSERT_EQ(weights.size(), corners);
  for (const double weight : weights) {
    EXPECT_GT(weight, 0);
    EXPECT_TRUE(std::isfinite(weight));
  }
}

void expect_free(const SightQuery& query, const Witness& witness) {
  ASSERT_NO_FATAL_FAILURE(expect_weights(witness.region_weights, query.region.size()));
  ASSERT_NO_FATAL_FAILURE(expect_weights(witness.element_weights, query.element.size()));
  const ExactPoint p = testing::weighted(query.region, witness.region_weights);
  const ExactPoint q = testing::weighted(query.element, witness.element_weights);
  EXPECT_NE(testing::exact_side(query.region, q), 0);
  const int side = testing::exact_side(query.element, p);
  EXPECT_TRUE(query.one_sided ? side > 0 : side != 0);
  for (std::size_t i = 0; i < query.occluders.size(); ++i) {
    EXPECT_FALSE(testing::open_segment_meets(p, q, query.occluders[i])) << "occluder " << i;
  }
}

void expect_right(const SightQuery& query, const QueryCase& expected) {
  const SightAnswer answer = decide_from_region(query);
  const Verdict verdict = answer.verdict;
  SCOPED_TRACE(name(verdict));
  EXPECT_EQ(is_visible(verdict), expected.visible);
  EXPECT_EQ(verdict == Verdict::kFullyVisible, expected.fully);
  EXPECT_EQ(verdict == Verdict::kHiddenNotFacing, !faces_region(query));
  EXPECT_NE(verdict, Verdict::kAssumedVisible);
  EXPECT_NE(verdict, Verdict::kHiddenAllRaysBlocked);
  EXPECT_EQ(answer.witness.has_value(), expected.visible);
  if (answer.witness) expect_free(query, *answer.witness);
}

TEST(QueryCases, AreWellFormed) {
  const std::vector<QueryCase> cases = testing::query_cases();
  EXPECT_GE(cases.size(), 60u);
  EXPECT_GE(std::ranges::count(cases, true, &QueryCase::visible), 25);
  EXPECT_GE(std::ranges::count(cases, false, &QueryCase::visible), 25);
  std::set<std::string> names;
  for (const QueryCase& c : cases) {
    SCOPED_TRACE(c.name);
    EXPECT_TRUE(names.insert(c.name).second) << "the name occurs twice";
    EXPECT_FALSE(c.argument.empty());
    EXPECT_LE(c.fully, c.visible);
    testing::Polygons polygons = c.query.occluders;
    polygons.push_back(c.query.region);
    polygons.push_back(c.query.element);
    for (const ConvexPolygon& polygon : polygons) {
      EXPECT_TRUE(is_integral(polygon));
      EXPECT_TRUE(testing::is_convex_loop(polygon));
    }
  }
}

TEST(QueryCases, AllAreRight) {
  for (const QueryCase& c : testing::query_cases()) {
    SCOPED_TRACE("case: " + c.name + "\nargument: " + c.argument);
    for (const Pose& pose : testing::poses()) {
      SCOPED_TRACE("pose: " + pose.name);
      SightQuery query = posed(c.query, pose);
      expect_right(query, c);
      if (query.one_sided) continue;
      SCOPED_TRACE("region and element swapped");
      std::swap(query.region, query.element);
      expect_right(query, c);
    }
  }
}

}  // namespace
}  // namespace viewcover
