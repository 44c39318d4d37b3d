#include "optim/exact_cover.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <sstream>

#include "optim/check_cover_proof.h"
#include "optim/cover_proof.h"
#include "reference_cover.h"
#include "scene/error.h"
#include "small_instances.h"

namespace viewcover {
namespace {

using testing::affine_space;
using testing::shuffled;
using testing::small_instance;
using testing::SmallInstance;

RegionCover solve(const BitRows& matrix, const std::vector<double>& weights,
                  const CoverOptions& options) {
  return ExactCover().solve(CoverInstance(matrix, weights), options);
}

RegionCover whole_cover(const BitRows& matrix) {
  CoverOptions options;
  options.goal = CoverGoal::kWholeCover;
  return solve(matrix, std::vector<double>(matrix.columns(), 1.0), options);
}

bool proof_holds(const BitRows& matrix, const RegionCover& cover) {
  std::stringstream text;
  const CoverInstance instance(matrix, std::vector<double>(matrix.columns(), 1.0));
  write_cover_proof(text, instance.rows(), *cover.proof);
  const CoverProofVerdict verdict = check_cover_proof(matrix, text);
  return verdict.holds && verdict.lower_bound == cover.lower_bound;
}

TEST(ExactCover, EqualsBruteForceForEveryK) {
  std::size_t several = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    SCOPED_TRACE(seed);
    const auto [matrix, weights] = small_instance(seed, 12, 40);
    const RegionCover cover = solve(matrix, weights, {});
    const std::vector<BitRows::Word> all = matrix.union_of_all();
    const double total = weight_of(all, weights);
    ASSERT_EQ(cover.size(), reference::minimum_cover(matrix));
    ASSERT_TRUE(cover.proved());
    for (std::size_t i = 0; i < cover.steps.size(); ++i) {
      const CoverStep& step = cover.steps[i];
      ASSERT_EQ(step.k, i + 1);
      ASSERT_EQ(step.chosen.size(), step.k);
      ASSERT_TRUE(std::ranges::is_sorted(step.chosen, std::less_equal<>()) || step.k == 1);
      ASSERT_TRUE(step.proved);
      const std::vector<BitRows::Word> covered = matrix.union_of(step.chosen);
      ASSERT_EQ(covered == all, i + 1 == cover.steps.size());
      if (total == 0) continue;
      const double best = 100 * reference::maximum_coverage(matrix, weights, step.k) / total;
      ASSERT_NEAR(step.covered_percent, 100 * weight_of(covered, weights) / total, 1e-9);
      ASSERT_NEAR(step.covered_percent, best, 1e-9);
      ASSERT_GE(step.upper_bound_percent, best);
      ASSERT_LE(step.upper_bound_percent, best + 1e-9);
    }
    several += cover.size() >= 3;
  }
  EXPECT_GT(several, 300u);
}

TEST(ExactCover, OneKIsThatStepOfEveryK) {
  const reference::Room room = reference::furnished_room(8, 600, 6, 3);
  const RegionCover every = solve(room.matrix, room.weights, {});
  ASSERT_GE(every.size(), 4u);
  for (std::size_t k = 1; k <= every.size() + 2; ++k) {
    CoverOptions options;
    options.goal = CoverGoal::kOneK;
    options.k = k;
    const RegionCover one = solve(room.matrix, room.weights, options);
    ASSERT_EQ(one.steps.size(), 1u);
    const CoverStep& expected = every.steps[std::min(k, every.size()) - 1];
    EXPECT_EQ(one.steps[0].k, expected.k);  // more rows than a smallest cover has are not needed
    EXPECT_EQ(one.steps[0].covered_percent, expected.covered_percent);
    EXPECT_TRUE(one.steps[0].proved);
  }
}

TEST(ExactCover, AffineSpacesTakeFiveAndEighteen) {
  for (const auto& [dimension, optimum] : {std::pair<int, std::size_t>{2, 5}, {3, 18}}) {
    const BitRows matrix = affine_space(dimension);
    const RegionCover cover = whole_cover(matrix);
    EXPECT_EQ(cover.size(), optimum);
    EXPECT_TRUE(cover.proved());
    EXPECT_TRUE(proof_holds(matrix, cover));
  }
}

TEST(ExactCover, ReportsHowBoundAndCoverMeet) {
  const BitRows matrix = affine_space(3);
  std::vector<std::size_t> bounds, sizes;
  CoverOptions options;
  options.goal = CoverGoal::kWholeCover;
  options.on_bound = [&](std::size_t bound) {
    EXPECT_FALSE(sizes.empty());  // a bound is of little use before there is a cover
    bounds.push_back(bound);
  };
  options.on_better = [&](const BetterCover& better) { sizes.push_back(better.chosen.size()); };
  const CoverInstance instance(matrix, std::vector<double>(matrix.columns(), 1.0));
  ExactCover().solve(instance, options);
  EXPECT_GE(bounds.size(), 3u);  // 1, that of the first programme, and others up to the optimum
  EXPECT_TRUE(std::ranges::is_sorted(bounds, std::less_equal<>()));
  EXPECT_TRUE(std::ranges::is_sorted(sizes, std::greater_equal<>()));
  EXPECT_EQ(bounds.back(), 18u);
  EXPECT_EQ(sizes.back(), 18u);
}

TEST(ExactCover, RoomsAreProved) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const auto room = reference::furnished_room(8, 2500, 3 + static_cast<int>(seed), seed);
    const RegionCover cover = whole_cover(room.matrix);
    EXPECT_EQ(cover.size(), reference::minimum_cover(room.matrix));
    EXPECT_TRUE(cover.proved());
    EXPECT_TRUE(proof_holds(room.matrix, cover));
  }
}

TEST(ExactCover, OrderAndCopiesChangeNothing) {
  const reference::Room room = reference::furnished_room(8, 400, 5, 11);
  const std::size_t minimum = whole_cover(room.matrix).size();
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const BitRows matrix = shuffled(room.matrix, 2, seed);
    const RegionCover cover = whole_cover(matrix);
    EXPECT_EQ(cover.size(), minimum);
    EXPECT_TRUE(proof_holds(matrix, cover));
  }
}

TEST(ExactCover, ComponentsAddUp) {
  // Three affine planes that have nothing to do with each other, beside columns nobody covers.
  const BitRows plane = affine_space(2);
  BitRows matrix(27, 40);
  for (std::size_t row = 0; row < 27; ++row) {
    for_each_bit(plane.row(row / 3), [&](std::size_t c) { matrix.set(row, 12 * (row % 3) + c); });
  }
  const RegionCover cover = whole_cover(matrix);
  EXPECT_EQ(cover.size(), 15u);
  EXPECT_EQ(cover.proof->components.size(), 3u);
  EXPECT_TRUE(proof_holds(matrix, cover));
}

TEST(ExactCover, DegenerateInstances) {
  for (const BitRows& matrix : {BitRows(), BitRows(4, 0), BitRows(0, 4), BitRows(4, 3)}) {
    const RegionCover cover = whole_cover(matrix);
    EXPECT_TRUE(cover.steps.empty());
    EXPECT_EQ(cover.lower_bound, 0u);
    EXPECT_TRUE(proof_holds(matrix, cover));
  }
  BitRows one_row(1, 70);
  one_row.set_range(0, 3, 66);
  EXPECT_THAT(whole_cover(one_row).steps.at(0).chosen, ::testing::ElementsAre(0));
  BitRows unit(3, 3);
  for (std::size_t i = 0; i < 3; ++i) unit.set(i, i);
  for (const std::vector<double>& weights : {std::vector<double>{1, 0, 1}, {0, 0, 0}}) {
    const RegionCover cover = solve(unit, weights, {});
    EXPECT_EQ(cover.size(), 3u);
    for (const CoverStep& step : cover.steps) EXPECT_TRUE(step.proved);
  }
}

TEST(ExactCover, TimeLimitLeavesACoverAndAProvedBound) {
  const BitRows matrix = affine_space(4);
  CoverOptions options;
  options.goal = CoverGoal::kWholeCover;
  options.time_limit_seconds = 0.3;
  const CoverInstance instance(matrix, std::vector<double>(matrix.columns(), 1.0));
  const RegionCover cover = ExactCover().solve(instance, options);
  EXPECT_TRUE(cover.time_limit_reached);
  EXPECT_TRUE(instance.covers_all(cover.steps.at(0).chosen));
  EXPECT_GE(cover.lower_bound, 27u);
  EXPECT_LT(cover.lower_bound, cover.size());
  EXPECT_TRUE(proof_holds(matrix, cover));
}

TEST(ExactCover, NoTimeAtAllStillGivesEveryStep) {
  const reference::Room room = reference::furnished_room(8, 2500, 6, 3);
  CoverOptions options;
  options.time_limit_seconds = 1e-9;
  const RegionCover cover = solve(room.matrix, room.weights, options);
  EXPECT_TRUE(cover.time_limit_reached);
  ASSERT_FALSE(cover.steps.empty());
  EXPECT_TRUE(CoverInstance(room.matrix, room.weights).covers_all(cover.steps.back().chosen));
  for (const CoverStep& step : cover.steps) {
    EXPECT_LE(step.covered_percent, step.upper_bound_percent);
  }
  EXPECT_LE(cover.lower_bound, cover.size());
}

TEST(ExactCover, StopFlagInterrupts) {
  const std::atomic<bool> stop = true;
  CoverOptions options;
  options.stop = &stop;
  EXPECT_THROW(solve(affine_space(3), std::vector<double>(117, 1.0), options), Interrupted);
}

TEST(ExactCover, SameInstanceSameResult) {
  const reference::Room room = reference::furnished_room(8, 600, 6, 5);
  RegionCover first = solve(room.matrix, room.weights, {});
  RegionCover second = solve(room.matrix, room.weights, {});
  for (RegionCover* cover : {&first, &second}) {
    for (CoverStep& step : cover->steps) step.seconds = 0;
  }
  EXPECT_EQ(first.steps, second.steps);
}

}  // namespace
}  // namespace viewcover
