#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "optim/coverage_curve.h"
#include "optim/exchange_search.h"
#include "optim/swap_search.h"
#include "reference_cover.h"

namespace viewcover {
namespace {

using Index = Incidence::Index;

/// What the searches for the k rows that cover most promise alike.
template <class Search>
class CoverageSearch : public ::testing::Test {};

using Searches = ::testing::Types<SwapSearch, ExchangeSearch>;
TYPED_TEST_SUITE(CoverageSearch, Searches);

TYPED_TEST(CoverageSearch, FindsTheBestOfSmallInstancesFromAnyStart) {
  std::size_t improved = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const std::size_t rows = 4 + random() % 11, columns = 5 + random() % 60;
    BitRows matrix(rows, columns);
    std::vector<double> column_weights;
    for (std::size_t c = 0; c < columns; ++c) {
      column_weights.push_back(1 + static_cast<double>(random() % 100));
      for (std::size_t r = 0; r < rows; ++r) {
        if (random() % 4 == 0) matrix.set(r, c);
      }
    }
    const CoverInstance instance(matrix, column_weights);
    const Incidence lists(instance.rows());
    const IntegerWeights weights(instance);
    RandomNumbers numbers(seed);
    TypeParam search(lists, weights, numbers);
    for (const std::size_t k : {rows / 4, rows / 2}) {
      std::vector<Index> start(rows);
      for (Index r = 0; r < rows; ++r) start[r] = r;
      std::ranges::shuffle(start, random);
      start.resize(k);
      SearchLimits limits{CoverOptions{}};
      SearchEffort effort(limits, 1, 500'000, search.work());
      std::vector<Index> found = search.improved(start, effort);
      std::ranges::sort(found);
      ASSERT_EQ(found.size(), k);
      ASSERT_EQ(std::ranges::adjacent_find(found), found.end());
      const std::vector<std::size_t> chosen(found.begin(), found.end());
      ASSERT_NEAR(weight_of(matrix.union_of(chosen), column_weights),
                  reference::maximum_coverage(matrix, column_weights, k), 1e-9);
      improved += !std::ranges::is_permutation(start, found);
    }
  }
  EXPECT_GT(improved, 100u);
}

TYPED_TEST(CoverageSearch, NeverLeavesLessThanItsStart) {
  const reference::Room room = reference::furnished_room(16, 1000, 8, 3);
  const CoverInstance instance(room.matrix, room.weights);
  const Incidence lists(instance.rows());
  const IntegerWeights weights(instance);
  RandomNumbers numbers(1);
  TypeParam search(lists, weights, numbers);
  std::vector<Index> rows = {1, 2, 3, 4, 5, 6, 7, 8};
  double before = 0;
  for (int round = 0; round < 20; ++round) {
    SearchLimits limits{CoverOptions{}};
    SearchEffort effort(limits, 1, 2'000'000, search.work());
    rows = search.improved(rows, effort);
    const double percent =
        instance.covered_percent(std::vector<std::size_t>(rows.begin(), rows.end()));
    ASSERT_GE(percent, before);
    before = percent;
  }
  EXPECT_GT(before, 95);
}

// With few nodes the bound is weaker, but one.
TEST(CoverageCurve, SaysWhatIsProvedWhereTheTreeIsCutShort) {
  std::size_t open = 0, closed = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    constexpr std::size_t kRows = 14, kColumns = 120;
    BitRows matrix(kRows, kColumns);
    for (std::size_t c = 0; c < kColumns; ++c) {
      for (int i = 0; i < 3; ++i) matrix.set(random() % kRows, c);
    }
    const std::vector<double> weights(kColumns, 1.0);
    const CoverInstance instance(matrix, weights);
    SearchLimits limits{CoverOptions{}};
    CoverageCurve curve(instance, limits, 3);
    for (std::size_t k = 2; k <= 6; ++k) {
      const CoverStep step = curve.step(k);
      const double best = reference::maximum_coverage(matrix, weights, k) / 1.2;
      ASSERT_EQ(step.chosen.size(), k);
      EXPECT_LE(step.covered_percent, best + 1e-9);
      EXPECT_GE(step.upper_bound_percent, best - 1e-9);
      if (step.proved) {
        EXPECT_NEAR(step.covered_percent, best, 1e-9);
      }
      ++(step.proved ? closed : open);
    }
  }
  EXPECT_GT(open, 10u);
  EXPECT_GT(closed, 0u);
}

TEST(IntegerWeights, BoundWhatKRowsCover) {
  BitRows matrix(3, 4);
  matrix.set_range(0, 0, 2);
  matrix.set_range(1, 1, 2);
  matrix.set_range(2, 3, 1);
  const IntegerWeights weights(CoverInstance(matrix, std::vector<double>{0, 1, 2, 5}));
  EXPECT_EQ(weights.columns[0], 1);
  EXPECT_EQ(weights.upper_bound(1), weights.columns[3]);
  EXPECT_EQ(weights.upper_bound(2), weights.columns[1] + weights.columns[2] + weights.columns[3]);
  EXPECT_EQ(weights.upper_bound(7), weights.total);
}

}  // namespace
}  // namespace viewcover
