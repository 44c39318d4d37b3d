#include "optim/reductions.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <set>

#include "reference_cover.h"
#include "small_instances.h"

namespace viewcover {
namespace {

using testing::small_instance;
using testing::SmallInstance;
using Kind = ReductionStep::Kind;

/// The fewest rows by the reduction: the taken ones, and brute force on every component.
std::size_t reduced_minimum(const Reduction& reduction) {
  std::size_t sum = reduction.taken.size();
  for (const CoverComponent& component : reduction.components) {
    sum += reference::minimum_cover(component.incidence.bits());
  }
  return sum;
}

TEST(Reductions, KeepTheMinimum) {
  std::size_t reduced_away = 0, left = 0;
  std::set<Kind> kinds;
  for (std::uint64_t seed = 1; seed <= 4000; ++seed) {
    SCOPED_TRACE(seed);
    const SmallInstance instance = small_instance(seed, 14, 40);
    const Reduction reduction = reduce_cover(instance.matrix);
    ASSERT_EQ(reduced_minimum(reduction), reference::minimum_cover(instance.matrix));
    for (const ReductionStep& step : reduction.steps) kinds.insert(step.kind);
    ++(reduction.components.empty() ? reduced_away : left);
  }
  EXPECT_EQ(kinds.size(), 3u);
  EXPECT_GT(reduced_away, 100u);
  EXPECT_GT(left, 100u);
}

TEST(Reductions, ComponentsShareNothing) {
  // Three rings of five rows, each neighbour pair with a common column: no reduction applies.
  BitRows matrix(15, 15);
  for (std::size_t ring = 0; ring < 3; ++ring) {
    for (std::size_t i = 0; i < 5; ++i) {
      matrix.set(ring + 3 * i, 5 * ring + i);
      matrix.set(ring + 3 * ((i + 1) % 5), 5 * ring + i);
    }
  }
  const Reduction reduction = reduce_cover(matrix);
  EXPECT_TRUE(reduction.steps.empty());
  ASSERT_EQ(reduction.components.size(), 3u);
  for (std::uint32_t ring = 0; ring < 3; ++ring) {
    const CoverComponent& component = reduction.components[ring];
    EXPECT_THAT(component.rows,
                ::testing::ElementsAre(ring, ring + 3, ring + 6, ring + 9, ring + 12));
    EXPECT_THAT(component.columns, ::testing::ElementsAre(5 * ring, 5 * ring + 1, 5 * ring + 2,
                                                          5 * ring + 3, 5 * ring + 4));
  }
}

TEST(Reductions, OfEqualThingsTheFirstStays) {
  BitRows matrix(3, 2);
  for (std::size_t row = 0; row < 3; ++row) matrix.set_range(row, 0, 2);
  EXPECT_THAT(rows_without_dominated(matrix), ::testing::ElementsAre(0));
  EXPECT_THAT(columns_without_implied(matrix), ::testing::ElementsAre(0));
  EXPECT_THAT(reduce_cover(matrix).taken, ::testing::ElementsAre(0));
}

TEST(Reductions, RowsWithoutDominatedKeepMaximumCoverage) {
  std::size_t dropped = 0;
  for (std::uint64_t seed = 1; seed <= 500; ++seed) {
    SCOPED_TRACE(seed);
    const SmallInstance instance = small_instance(seed, 10, 20);
    const std::vector<std::uint32_t> rows = rows_without_dominated(instance.matrix);
    BitRows kept(rows.size(), instance.matrix.columns());
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for_each_bit(instance.matrix.row(rows[row]), [&](std::size_t c) { kept.set(row, c); });
    }
    dropped += rows.size() < instance.matrix.rows();
    for (std::size_t k = 1; k <= rows.size(); ++k) {
      ASSERT_EQ(reference::maximum_coverage(kept, instance.weights, k),
                reference::maximum_coverage(instance.matrix, instance.weights, k));
    }
  }
  EXPECT_GT(dropped, 100u);
}

TEST(Reductions, NothingToCoverLeavesNothing) {
  for (const BitRows& matrix : {BitRows(), BitRows(3, 0), BitRows(0, 3), BitRows(3, 3)}) {
    const Reduction reduction = reduce_cover(matrix);
    EXPECT_TRUE(reduction.taken.empty());
    EXPECT_TRUE(reduction.components.empty());
  }
}

}  // namespace
}  // namespace viewcover
