// What a backend must hold to, shaft by shaft (links/visibility_backend.h).

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <iostream>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "conformance/backends.h"
#include "exact/query_cases.h"
#include "exact/query_poses.h"
#include "exact/witness_judge.h"
#include "support/random_queries.h"
#include "support/shaft_case.h"

namespace viewcover {
namespace {

using testing::QueryCase;
using testing::RandomQuery;
using testing::ShaftCase;
using testing::TestedBackend;

constexpr std::uint64_t kSeed = 90125;

// ------------------------------------------------------------------------------------- shafts

/// Shafts want no corners within edges.
ConvexPolygon strict(const ConvexPolygon& polygon) {
  using testing::ExactPoint;
  const std::size_t n = polygon.size();
  ConvexPolygon corners;
  for (std::size_t i = 0; i < n; ++i) {
    const ExactPoint here(polygon[i]), before(polygon[(i + n - 1) % n]),
        after(polygon[(i + 1) % n]);
    const ExactPoint turn = testing::cross(here - before, after - here);
    if (testing::dot(turn, turn) != 0) corners.push_back(polygon[i]);
  }
  return corners;
}

/// The occluders, and the element: in a scene it stands among them, and hides nothing of itself.
std::vector<ConvexPolygon> surfaces_of(const SightQuery& query) {
  std::vector<ConvexPolygon> surfaces;
  for (const ConvexPolygon& occluder : query.occluders) surfaces.push_back(strict(occluder));
  surfaces.push_back(strict(query.element));
  return surfaces;
}

/// A query as refinement meets it: culled first, then left to a backend if that settles nothing.
class CulledShaft {
 public:
  /// At most about `limit` nodes are left, some of them unopened clusters; all are surfaces if it
  /// is kOpenAll.
  explicit CulledShaft(const SightQuery& query, std::size_t number = 0,
                       std::size_t limit = kOpenAll)
      : case_(strict(query.region), strict(query.element), surfaces_of(query)),
        shaft_(case_.shaft(query.one_sided, number)) {
    const ShaftOccluder everything{.node = 0};
    if (!shaft_.is_facing()) {
      settled_ = Verdict::kHiddenNotFacing;
    } else if (cull(shaft_, {&everything, 1}, limit, kept_)) {
      settled_ = Verdict::kHiddenByOne;
    } else if (kept_.empty()) {
      settled_ = Verdict::kFullyVisible;
    }
    shaft_.set_occluders(kept_);
  }

  /// By culling alone.
  std::optional<Verdict> settled() const { return settled_; }
  bool has_clusters() const {
    return std::ranges::any_of(kept_, [&](const ShaftOccluder& occluder) {
      return !case_.clusters.nodes()[occluder.node].is_leaf();
    });
  }
  Verdict decide(const VisibilityBackend& backend, Effort effort) const {
    return settled_ ? *settled_ : backend.decide(shaft_, effort);
  }

 private:
  ShaftCase case_;
  Shaft shaft_;
  ShaftOccluders kept_;
  std::optional<Verdict> settled_;
};

using Shafts = std::vector<std::unique_ptr<CulledShaft>>;

/// Those of the hand-made cases and of random queries that culling leaves open.
Shafts open_shafts() {
  Shafts shafts;
  const auto add = [&](const SightQuery& query) {
    auto shaft = std::make_unique<CulledShaft>(query, shafts.size());
    if (!shaft->settled()) shafts.push_back(std::move(shaft));
  };
  for (const QueryCase& c : testing::query_cases()) add(c.query);
  for (std::uint64_t index = 0; index < 700; ++index) add(RandomQuery(kSeed, index).query());
  return shafts;
}

/// 40 to 80 small triangles between two others: enough for clusters.
SightQuery crowd(std::uint64_t index) {
  RandomNumbers random(mixed(kSeed + mixed(index)));
  return testing::random_soup(random, {.least = 40});
}

class Backends : public ::testing::TestWithParam<TestedBackend> {
 protected:
  std::unique_ptr<VisibilityBackend> make(std::uint64_t seed = 1) const {
    return GetParam().make(seed);
  }
  bool is_exact() const { return make()->guarantee() == Guarantee::kExact; }
};

INSTANTIATE_TEST_SUITE_P(All, Backends, ::testing::ValuesIn(testing::tested_backends()),
                         [](const auto& instance) { return instance.param.name; });

// -------------------------------------------------------------------------------------- tests

TEST_P(Backends, DecideTheSameWhateverTheThreadAndTheOrder) {
  std::cout << "seed " << kSeed << "\n";
  const Shafts shafts = open_shafts();
  ASSERT_GE(shafts.size(), 300u);
  struct Job {
    std::size_t shaft;
    Effort effort;
  };
  std::vector<Job> jobs;
  for (std::size_t i = 0; i < shafts.size(); ++i) {
    for (const Effort effort : {Effort::kCheap, Effort::kFull}) jobs.push_back({i, effort});
  }
  const auto in_order = make();
  std::vector<Verdict> expected;
  for (const auto& [shaft, effort] : jobs) {
    expected.push_back(shafts[shaft]->decide(*in_order, effort));
  }
  EXPECT_GT(std::ranges::count_if(expected, [](Verdict v) { return is_visible(v); }), 100);
  EXPECT_GT(std::ranges::count_if(expected, [](Verdict v) { return !is_visible(v); }), 100);

  std::vector<std::size_t> order(jobs.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  RandomNumbers random(kSeed);
  for (int round = 0; round < 3; ++round) {
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    const auto in_parallel = make();
    std::vector<Verdict> verdicts(jobs.size());
    tbb::parallel_for(std::size_t{0}, order.size(), [&](std::size_t i) {
      const auto& [shaft, effort] = jobs[order[i]];
      verdicts[order[i]] = shafts[shaft]->decide(*in_parallel, effort);
    });
    EXPECT_EQ(verdicts, expected);
    EXPECT_EQ(in_parallel->statistics(), in_order->statistics());
  }
}

TEST_P(Backends, AreRightOnTheHandMadeCases) {
  const auto backend = make();
  int asked = 0, asked_visible = 0, all = 0;
  for (const QueryCase& c : testing::query_cases()) {
    SCOPED_TRACE("case: " + c.name + "\nargument: " + c.argument);
    for (const testing::Pose& pose : testing::poses()) {
      SCOPED_TRACE("pose: " + pose.name);
      const CulledShaft shaft(posed(c.query, pose), static_cast<std::size_t>(all));
      const Verdict verdict = shaft.decide(*backend, Effort::kFull);
      SCOPED_TRACE(name(verdict));
      ++all;
      asked += !shaft.settled();
      asked_visible += !shaft.settled() && c.visible;
      EXPECT_NE(verdict, Verdict::kAssumedVisible);
      EXPECT_LE(is_visible(verdict), c.visible);
      EXPECT_LE(verdict == Verdict::kFullyVisible, c.fully);
      if (is_exact()) {
        EXPECT_EQ(is_visible(verdict), c.visible);
        EXPECT_EQ(verdict == Verdict::kFullyVisible, c.fully);
        EXPECT_NE(verdict, Verdict::kHiddenAllRaysBlocked);
      }
    }
  }
  std::cout << all << " shafts, " << asked << " left to the backend, " << asked_visible
            << " of these visible\n";
  EXPECT_GE(asked_visible, 100);
  EXPECT_GE(asked - asked_visible, 100);
}

/// Against queries from a region, which ask no backend and cull nothing.
TEST_P(Backends, AreRightOnRandomShafts) {
  std::cout << "seed " << kSeed << "\n";
  const auto backend = make();
  int hidden = 0, visible = 0, missed = 0, fully = 0;
  for (std::uint64_t index = 0; index < 2100; ++index) {
    const RandomQuery made(kSeed, index);
    const SightQuery& query = made.query();
    const CulledShaft shaft(query, index);
    SCOPED_TRACE("index " + std::to_string(index) + "\n" + testing::text(query));
    const Verdict truth = decide_from_region(query).verdict;
    const Verdict verdict = shaft.decide(*backend, Effort::kFull);
    EXPECT_LE(is_visible(verdict), is_visible(truth));
    EXPECT_NE(verdict, Verdict::kAssumedVisible);
    EXPECT_EQ(verdict == Verdict::kHiddenNotFacing, truth == Verdict::kHiddenNotFacing);
    // What is behind a one-sided element only stands in the shaft.
    if (query.one_sided) {
      EXPECT_LE(verdict == Verdict::kFullyVisible, truth == Verdict::kFullyVisible);
    } else {
      EXPECT_EQ(verdict == Verdict::kFullyVisible, truth == Verdict::kFullyVisible);
    }
    fully += verdict == Verdict::kFullyVisible;
    if (shaft.settled()) continue;
    (is_visible(truth) ? visible : hidden)++;
    missed += is_visible(truth) && !is_visible(verdict);
  }
  std::cout << fully << " fully visible; left to the backend: " << hidden << " hidden, " << visible
            << " visible, " << missed << " of these missed\n";
  EXPECT_GE(fully, 20);
  EXPECT_GE(hidden, 200);
  EXPECT_GE(visible, 200);
  if (is_exact()) {
    EXPECT_EQ(missed, 0);
  }
}

TEST_P(Backends, KeepCheapVerdictsWhenTheyTryHarder) {
  std::cout << "seed " << kSeed << "\n";
  const auto backend = make();
  int hidden = 0, seen = 0, assumed = 0, with_clusters = 0;
  const auto check = [&](const CulledShaft& cheap_shaft, const CulledShaft& full_shaft) {
    if (cheap_shaft.settled()) return;
    const Verdict cheap = cheap_shaft.decide(*backend, Effort::kCheap);
    const Verdict full = full_shaft.decide(*backend, Effort::kFull);
    SCOPED_TRACE(std::string(name(cheap)) + ", then " + std::string(name(full)));
    if (!is_visible(cheap)) {
      ++hidden;
      EXPECT_FALSE(is_visible(full));
    } else if (cheap == Verdict::kAssumedVisible) {
      ++assumed;
    } else {
      ++seen;
      EXPECT_TRUE(is_visible(full));
    }
    if (cheap == Verdict::kFullyVisible) {
      EXPECT_EQ(full, Verdict::kFullyVisible);
    }
    EXPECT_NE(full, Verdict::kAssumedVisible);
  };
  for (std::uint64_t index = 0; index < 700; ++index) {
    SCOPED_TRACE("index " + std::to_string(index));
    const CulledShaft shaft(RandomQuery(kSeed, index).query(), index);
    check(shaft, shaft);
  }
  for (std::uint64_t index = 0; index < 200; ++index) {
    SCOPED_TRACE("crowd " + std::to_string(index));
    const SightQuery query = crowd(index);
    const CulledShaft full(query, index);
    check(full, full);
    for (const std::size_t limit : {1, 8, 32}) {
      const CulledShaft unopened(query, index, limit);
      with_clusters += unopened.has_clusters();
      check(unopened, full);
    }
  }
  std::cout << hidden << " hidden, " << seen << " seen, " << assumed << " left open; "
            << with_clusters << " with clusters\n";
  EXPECT_GE(hidden, 100);
  EXPECT_GE(seen, 100);
  EXPECT_GE(with_clusters, 200);
}

}  // namespace
}  // namespace viewcover
