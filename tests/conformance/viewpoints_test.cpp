// What a backend must hold to from viewpoints (links/visibility_backend.h), against queries that
// cull nothing.

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <iostream>

#include "conformance/backends.h"
#include "exact/point_cases.h"
#include "exact/query_poses.h"
#include "links/point_shaft.h"
#include "support/random_queries.h"
#include "support/shaft_case.h"

namespace viewcover {
namespace {

using testing::RandomQuery;
using testing::ShaftCase;
using testing::TestedBackend;

constexpr std::uint64_t kSeed = 2112;

class BackendsFromViewpoints : public ::testing::TestWithParam<TestedBackend> {};
INSTANTIATE_TEST_SUITE_P(All, BackendsFromViewpoints,
                         ::testing::ValuesIn(testing::tested_backends()),
                         [](const auto& instance) { return instance.param.name; });

/// How a query from a viewpoint was settled, and what is seen.
struct Answer {
  bool seen = false;
  bool by_backend = false;
};

Answer answer(const VisibilityBackend& backend, const SightQuery& query) {
  // Only the element and the occluders of the case matter.
  const ShaftCase shaft_case(query.element, query.element, query.occluders);
  PointShaft shaft(shaft_case.occluders, query.viewpoint, ElementAddress(SurfaceId(0)),
                   shaft_case.element, query.one_sided);
  if (!shaft.is_facing()) return {};
  std::vector<OccluderId> all;
  for (std::size_t i = 0; i < query.occluders.size(); ++i) all.emplace_back(i);
  PointShaftOccluders kept;
  if (shaft.cull(all, kept)) return {};
  if (kept.empty()) return {.seen = true};
  shaft.set_occluders(kept);
  return {.seen = backend.sees_part(shaft), .by_backend = true};
}

/// A viewpoint in the region's plane, at times on its border or on a corner.
SightQuery query_of(std::uint64_t index) {
  RandomQuery made(kSeed, index);
  SightQuery query = made.query();
  RandomNumbers& random = made.random();
  const ConvexPolygon& region = query.region;
  const std::size_t i = random.below(region.size()), j = random.below(region.size());
  const double s = std::ldexp(static_cast<double>(random.below(17)), -4);
  query.viewpoint = region[i] + s * (region[j] - region[i]);
  return query;
}

TEST_P(BackendsFromViewpoints, AreRightOnRandomQueries) {
  std::cout << "seed " << kSeed << "\n";
  const auto backend = GetParam().make(1);
  const bool exact = backend->guarantee() == Guarantee::kExact;
  int seen = 0, hidden = 0, missed = 0;
  for (std::uint64_t index = 0; index < 2100; ++index) {
    const SightQuery query = query_of(index);
    if (query.occluders.empty()) continue;
    SCOPED_TRACE("index " + std::to_string(index) + "\n" + testing::text(query));
    const bool truth = is_visible(decide_from_point(query).verdict);
    const Answer found = answer(*backend, query);
    EXPECT_LE(found.seen, truth);
    if (exact || !found.by_backend) {
      EXPECT_EQ(found.seen, truth);
    }
    if (!found.by_backend) continue;
    (truth ? seen : hidden)++;
    missed += truth && !found.seen;
  }
  std::cout << seen << " seen, " << missed << " of these missed, " << hidden << " hidden\n";
  EXPECT_GE(seen, 100);
  EXPECT_GE(hidden, 30);
}

TEST_P(BackendsFromViewpoints, AreRightOnTheHandMadeCases) {
  const auto backend = GetParam().make(1);
  const bool exact = backend->guarantee() == Guarantee::kExact;
  int asked = 0;
  for (const testing::PointCase& c : testing::point_cases()) {
    SCOPED_TRACE("case: " + c.name + "\nargument: " + c.argument);
    for (const testing::Pose& pose : testing::poses()) {
      SCOPED_TRACE("pose: " + pose.name);
      SightQuery query = posed(c.query, pose);
      if (query.occluders.empty()) continue;
      // Shafts want no corners within edges.
      const auto is_strict = [](const ConvexPolygon& polygon) {
        return turning_corners(polygon).size() == polygon.size();
      };
      if (!is_strict(query.element) || !std::ranges::all_of(query.occluders, is_strict)) continue;
      const Answer found = answer(*backend, query);
      ++asked;
      EXPECT_LE(found.seen, c.seen > 0);
      if (exact) {
        EXPECT_EQ(found.seen, c.seen > 0);
      }
    }
  }
  EXPECT_GE(asked, 100);
}

TEST_P(BackendsFromViewpoints, AnswerTheSameWhateverTheThread) {
  const auto in_order = GetParam().make(3), in_parallel = GetParam().make(3);
  std::vector<SightQuery> queries;
  for (std::uint64_t index = 0; index < 400; ++index) {
    queries.push_back(query_of(index));
    if (queries.back().occluders.empty()) queries.pop_back();
  }
  std::vector<char> expected(queries.size()), answers(queries.size());
  for (std::size_t i = 0; i < queries.size(); ++i) {
    expected[i] = answer(*in_order, queries[i]).seen;
  }
  tbb::parallel_for(std::size_t{0}, queries.size(), [&](std::size_t i) {
    answers[i] = answer(*in_parallel, queries[queries.size() - 1 - i]).seen;
  });
  for (std::size_t i = 0; i < queries.size(); ++i) {
    EXPECT_EQ(answers[queries.size() - 1 - i], expected[i]);
  }
  EXPECT_EQ(in_parallel->statistics(), in_order->statistics());
}

}  // namespace
}  // namespace viewcover
