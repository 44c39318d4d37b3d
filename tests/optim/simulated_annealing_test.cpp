#include "optim/simulated_annealing.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <random>

#include "cover_checks.h"
#include "reference_cover.h"
#include "scene/error.h"
#include "support/sanitized.h"

namespace viewcover {
namespace {

using reference::expect_certificates;

RegionCover solve(const BitRows& matrix, const std::vector<double>& weights,
                  std::uint64_t seed = 1) {
  CoverOptions options;
  options.seed = seed;
  return SimulatedAnnealing().solve(CoverInstance(matrix, weights), options);
}

TEST(SimulatedAnnealing, EqualsBruteForceOnSmallInstances) {
  std::size_t several = 0;
  for (std::uint64_t seed = 1; seed <= 150; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const std::size_t rows = 1 + random() % 12, columns = 1 + random() % 40;
    const std::uint64_t sparsity = 2 + random() % 6;
    BitRows matrix(rows, columns);
    std::vector<double> weights(columns);
    for (std::size_t c = 0; c < columns; ++c) {
      weights[c] = static_cast<double>(random() % 100) / 8;
      for (std::size_t r = 0; r < rows; ++r) {
        if (random() % sparsity == 0) matrix.set(r, c);
      }
    }
    const RegionCover cover = solve(matrix, weights, seed);
    expect_certificates(matrix, weights, cover);
    const double total = weight_of(matrix.union_of_all(), weights);
    for (const CoverStep& step : cover.steps) {
      if (total == 0) break;
      const double best = reference::maximum_coverage(matrix, weights, step.k);
      ASSERT_NEAR(step.covered_percent, 100 * best / total, 1e-9) << "k = " << step.k;
    }
    ASSERT_EQ(cover.size(), reference::minimum_cover(matrix));
    several += cover.size() >= 3;
  }
  EXPECT_GT(several, 50u);
}

TEST(SimulatedAnnealing, FindsTheOptimumOfRoomsForEverySeed) {
  for (std::uint64_t room_seed = 1; room_seed <= (testing::sanitized() ? 2 : 6); ++room_seed) {
    const auto room =
        reference::furnished_room(8, 2500, 3 + static_cast<int>(room_seed), room_seed);
    const std::size_t optimum = reference::minimum_cover(room.matrix);
    EXPECT_GE(optimum, 5u);
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
      SCOPED_TRACE(::testing::Message() << "room " << room_seed << ", seed " << seed);
      const RegionCover cover = solve(room.matrix, room.weights, seed);
      expect_certificates(room.matrix, room.weights, cover);
      EXPECT_EQ(cover.size(), optimum);
    }
  }
}

TEST(SimulatedAnnealing, FindsTheOptimumOfARoomWithManyRegions) {
  const reference::Room room = reference::furnished_room(16, 5000, 5, 1);
  const std::size_t optimum = reference::minimum_cover(room.matrix);
  for (std::uint64_t seed = 1; seed <= (testing::sanitized() ? 1 : 3); ++seed) {
    SCOPED_TRACE(seed);
    const RegionCover cover = solve(room.matrix, room.weights, seed);
    expect_certificates(room.matrix, room.weights, cover);
    EXPECT_EQ(cover.size(), optimum);
  }
}

TEST(SimulatedAnnealing, FindsPlantedCovers) {
  // 7 of 64 rows share the columns out among them; the others see random eighths of them.
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const std::size_t rows = 64, columns = 1000, planted = 7;
    std::vector<std::size_t> order(rows);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), random);
    BitRows matrix(rows, columns);
    for (std::size_t c = 0; c < columns; ++c) {
      matrix.set(order[c % planted], c);
      for (std::size_t r = planted; r < rows; ++r) {
        if (random() % 8 == 0) matrix.set(order[r], c);
      }
    }
    const RegionCover cover = solve(matrix, std::vector<double>(columns, 1.0), seed);
    ASSERT_EQ(cover.size(), planted);
    std::vector<std::size_t> expected(order.begin(), order.begin() + planted);
    std::ranges::sort(expected);
    EXPECT_EQ(cover.steps.back().chosen, expected);
  }
}

TEST(SimulatedAnnealing, RepeatedRowsAndColumnsChangeNothing) {
  const reference::Room room = reference::furnished_room(8, 400, 5, 11);
  const std::size_t rows = room.matrix.rows(), columns = room.matrix.columns();
  BitRows doubled(rows, 2 * columns), stacked(2 * rows, columns);
  std::vector<double> halves;
  for (const double weight : room.weights) {
    halves.push_back(weight / 2);
  }
  halves.insert(halves.end(), halves.begin(), halves.end());
  for (std::size_t r = 0; r < rows; ++r) {
    for_each_bit(room.matrix.row(r), [&](std::size_t c) {
      doubled.set(r, c);
      doubled.set(r, columns + c);
      stacked.set(r, c);
      stacked.set(rows + r, c);
    });
  }
  const RegionCover plain = solve(room.matrix, room.weights);
  const RegionCover with_columns = solve(doubled, halves);
  ASSERT_EQ(with_columns.size(), plain.size());
  for (std::size_t i = 0; i < plain.steps.size(); ++i) {
    EXPECT_EQ(with_columns.steps[i].chosen, plain.steps[i].chosen);
  }
  EXPECT_EQ(solve(stacked, room.weights).size(), plain.size());
}

TEST(SimulatedAnnealing, SameSeedSameRunOtherSeedOtherRun) {
  const reference::Room room = reference::furnished_room(8, 600, 6, 5);
  RegionCover first = solve(room.matrix, room.weights, 3);
  RegionCover second = solve(room.matrix, room.weights, 3);
  RegionCover other = solve(room.matrix, room.weights, 4);
  for (RegionCover* cover : {&first, &second, &other}) {
    for (CoverStep& step : cover->steps) step.seconds = 0;
  }
  EXPECT_EQ(first.steps, second.steps);
  EXPECT_NE(first.steps, other.steps);
}

TEST(SimulatedAnnealing, StopFlagInterrupts) {
  const reference::Room room = reference::furnished_room(8, 600, 6, 5);
  const CoverInstance instance(room.matrix, room.weights);
  std::atomic<bool> stop = false;
  CoverOptions options;
  options.stop = &stop;
  options.on_step = [&](const CoverStep& step) { stop = step.k == 2; };
  EXPECT_THROW(SimulatedAnnealing().solve(instance, options), Interrupted);
}

TEST(SimulatedAnnealing, TimeLimitEndsTheSearchOfOneK) {
  const reference::Room room = reference::furnished_room(16, 3000, 10, 5);
  const CoverInstance instance(room.matrix, room.weights);
  const auto evaluations = [](const RegionCover& cover) {
    std::uint64_t sum = 0;
    for (const CoverStep& step : cover.steps) sum += step.evaluations;
    return sum;
  };
  CoverOptions options;
  options.time_limit_seconds = 0.01;
  const RegionCover limited = SimulatedAnnealing().solve(instance, options);
  const RegionCover whole = SimulatedAnnealing().solve(instance, {});
  EXPECT_TRUE(limited.time_limit_reached);
  EXPECT_FALSE(whole.time_limit_reached);
  // k = 2 alone takes four rounds of thirty levels; a hundredth of a second is a part of the first.
  EXPECT_LT(evaluations(limited), whole.steps.at(1).evaluations);
}

}  // namespace
}  // namespace viewcover
