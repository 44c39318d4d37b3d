#include "optim/cover_methods.h"

#include <gmock/gmock.h>

#include <atomic>
#include <numeric>
#include <random>

#include "cover_checks.h"
#include "optim/stopwatch.h"
#include "reference_cover.h"
#include "scene/error.h"

namespace viewcover {
namespace {

using reference::expect_certificates;

struct Instance {
  BitRows matrix;
  std::vector<double> weights;
};

/// `most_rows` rows at most; some columns without weight, some that no row covers.
Instance random_instance(std::uint64_t seed, std::size_t most_rows) {
  std::mt19937_64 random(seed);
  const std::size_t rows = 1 + random() % most_rows, columns = 1 + random() % 40;
  const std::uint64_t sparsity = 2 + random() % 8;
  Instance instance{BitRows(rows, columns), {}};
  for (std::size_t c = 0; c < columns; ++c) {
    instance.weights.push_back(static_cast<double>(random() % 100) / 8);
    for (std::size_t r = 0; r < rows; ++r) {
      if (random() % sparsity == 0) instance.matrix.set(r, c);
    }
  }
  return instance;
}

/// Row r of the result is row row_order[r] of the matrix, and so on.
Instance permuted(const Instance& instance, std::mt19937_64& random) {
  std::vector<std::size_t> row_order(instance.matrix.rows());
  std::vector<std::size_t> column_order(instance.matrix.columns());
  std::iota(row_order.begin(), row_order.end(), std::size_t{0});
  std::iota(column_order.begin(), column_order.end(), std::size_t{0});
  std::ranges::shuffle(row_order, random);
  std::ranges::shuffle(column_order, random);
  Instance result{BitRows(row_order.size(), column_order.size()), {}};
  for (std::size_t c = 0; c < column_order.size(); ++c) {
    result.weights.push_back(instance.weights[column_order[c]]);
    for (std::size_t r = 0; r < row_order.size(); ++r) {
      if (instance.matrix.test(row_order[r], column_order[c])) result.matrix.set(r, c);
    }
  }
  return result;
}

/// Every row twice, every column twice with half its weight, an empty row and an empty column.
Instance doubled(const Instance& instance) {
  const std::size_t rows = instance.matrix.rows(), columns = instance.matrix.columns();
  Instance result{BitRows(2 * rows + 1, 2 * columns + 1), {}};
  for (std::size_t r = 0; r < 2 * rows; ++r) {
    for_each_bit(instance.matrix.row(r % rows), [&](std::size_t c) {
      result.matrix.set(r, c);
      result.matrix.set(r, columns + c);
    });
  }
  for (std::size_t c = 0; c < 2 * columns; ++c) {
    result.weights.push_back(instance.weights[c % columns] / 2);
  }
  result.weights.push_back(5);
  return result;
}

class EveryCoverMethod : public ::testing::TestWithParam<std::string_view> {
 protected:
  RegionCover solve(const BitRows& matrix, const std::vector<double>& weights,
                    const CoverOptions& options = {}) const {
    return reference::solve(GetParam(), matrix, weights, options);
  }
  RegionCover solve(const Instance& instance, const CoverOptions& options = {}) const {
    return solve(instance.matrix, instance.weights, options);
  }
  /// Greedy choices are not expected to be best.
  bool searches() const { return GetParam() != "greedy"; }
};

std::vector<std::string_view> method_names() {
  std::vector<std::string_view> names;
  for (const CoverMethodEntry& entry : cover_methods()) names.push_back(entry.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryCoverMethod, ::testing::ValuesIn(method_names()),
                         [](const auto& method) { return std::string(method.param); });

TEST_P(EveryCoverMethod, CoversWithinItsBounds) {
  std::size_t several = 0, uncoverable = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const Instance instance = random_instance(seed, 20);
    const std::size_t optimum = reference::minimum_cover(instance.matrix);
    for (const CoverGoal goal : {CoverGoal::kEveryK, CoverGoal::kWholeCover}) {
      CoverOptions options;
      options.goal = goal;
      options.seed = seed;
      const RegionCover cover = solve(instance, options);
      expect_certificates(instance.matrix, instance.weights, cover, options);
      ASSERT_LE(cover.lower_bound, optimum);
      ASSERT_GE(cover.size(), optimum);
      if (searches()) {
        ASSERT_EQ(cover.size(), optimum);
      }
    }
    several += optimum >= 3;
    uncoverable += count_bits(instance.matrix.union_of_all()) < instance.matrix.columns();
  }
  EXPECT_GT(several, 30u);
  EXPECT_GT(uncoverable, 5u);
}

TEST_P(EveryCoverMethod, CoverageOfEachKIsAtMostAndMostlyTheBest) {
  std::size_t steps = 0, best = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const Instance instance = random_instance(seed, 14);
    const double total = weight_of(instance.matrix.union_of_all(), instance.weights);
    if (total == 0) continue;
    const RegionCover cover = solve(instance);
    for (const CoverStep& step : cover.steps) {
      const double most =
          100 * reference::maximum_coverage(instance.matrix, instance.weights, step.k) / total;
      ASSERT_LE(step.covered_percent, most + 1e-9);
      CoverOptions options;
      options.goal = CoverGoal::kOneK;
      options.k = step.k;
      const RegionCover one = solve(instance, options);
      expect_certificates(instance.matrix, instance.weights, one, options);
      ASSERT_EQ(one.steps.size(), 1u);
      ASSERT_LE(one.steps[0].covered_percent, most + 1e-9);
      steps += 2;
      best += (step.covered_percent > most - 1e-9) + (one.steps[0].covered_percent > most - 1e-9);
    }
  }
  EXPECT_GT(steps, 100u);
  EXPECT_GE(best, searches() ? steps : steps / 2);
}

TEST_P(EveryCoverMethod, OrderAndRepetitionChangeNothingButNames) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    const Instance instance = random_instance(seed, 16);
    std::mt19937_64 random(seed);
    const Instance other = permuted(doubled(permuted(instance, random)), random);
    const RegionCover cover = solve(instance), other_cover = solve(other);
    expect_certificates(other.matrix, other.weights, other_cover);
    ASSERT_EQ(other_cover.lower_bound > 0, cover.lower_bound > 0);
    if (!searches()) continue;
    ASSERT_EQ(other_cover.size(), cover.size());
    for (std::size_t i = 0; i < cover.size(); ++i) {
      ASSERT_NEAR(other_cover.steps[i].covered_percent, cover.steps[i].covered_percent, 1e-9);
    }
  }
}

TEST_P(EveryCoverMethod, NothingToCoverGivesNoSteps) {
  for (const CoverGoal goal : {CoverGoal::kEveryK, CoverGoal::kWholeCover, CoverGoal::kOneK}) {
    CoverOptions options;
    options.goal = goal;
    options.k = 2;
    for (const auto& [rows, columns] : {std::pair{0, 0}, {4, 0}, {0, 3}, {4, 3}}) {
      const BitRows matrix(static_cast<std::size_t>(rows), static_cast<std::size_t>(columns));
      const RegionCover cover =
          solve(matrix, std::vector<double>(static_cast<std::size_t>(columns), 1.0), options);
      EXPECT_TRUE(cover.steps.empty());
      EXPECT_TRUE(cover.proved());
    }
  }
}

TEST_P(EveryCoverMethod, OneRowCoversAlone) {
  BitRows matrix(3, 70);
  matrix.set_range(1, 3, 66);
  for (const CoverGoal goal : {CoverGoal::kEveryK, CoverGoal::kWholeCover, CoverGoal::kOneK}) {
    CoverOptions options;
    options.goal = goal;
    options.k = 2;
    const RegionCover cover = solve(matrix, std::vector<double>(70, 0.1), options);
    ASSERT_EQ(cover.size(), 1u);
    EXPECT_THAT(cover.steps[0].chosen, ::testing::ElementsAre(1));
    EXPECT_EQ(cover.steps[0].covered_percent, 100);
    EXPECT_TRUE(cover.proved());
  }
}

TEST_P(EveryCoverMethod, ColumnsWithoutWeightAreCoveredToo) {
  BitRows matrix(3, 3);
  for (std::size_t i = 0; i < 3; ++i) matrix.set(i, i);
  for (const std::vector<double>& weights : {std::vector<double>{1, 0, 1}, {0, 0, 0}}) {
    const RegionCover cover = solve(matrix, weights);
    EXPECT_EQ(cover.size(), 3u);
    expect_certificates(matrix, weights, cover);
  }
}

TEST_P(EveryCoverMethod, MoreRowsThanNeededAreNotChosen) {
  const Instance instance = random_instance(3, 16);
  const std::size_t whole = solve(instance).size();
  ASSERT_GE(whole, 2u);
  CoverOptions options;
  options.goal = CoverGoal::kOneK;
  for (const std::size_t k : {whole, whole + 1, std::size_t{1000}}) {
    options.k = k;
    const RegionCover cover = solve(instance, options);
    EXPECT_EQ(cover.size(), whole);
    EXPECT_TRUE(cover.whole);
  }
  options.k = whole - 1;
  EXPECT_FALSE(solve(instance, options).whole);
  EXPECT_FALSE(solve(instance, options).proved());
  options.k = 0;
  EXPECT_TRUE(solve(instance, options).steps.empty());
  EXPECT_FALSE(solve(instance, options).whole);
}

TEST_P(EveryCoverMethod, SameSeedSameRun) {
  const reference::Room room = reference::furnished_room(8, 600, 6, 5);
  CoverOptions options;
  options.seed = 3;
  RegionCover first = solve(room.matrix, room.weights, options);
  RegionCover second = solve(room.matrix, room.weights, options);
  for (RegionCover* cover : {&first, &second}) {
    for (CoverStep& step : cover->steps) step.seconds = 0;
  }
  EXPECT_EQ(first.steps, second.steps);
}

TEST_P(EveryCoverMethod, StopFlagInterrupts) {
  const reference::Room room = reference::furnished_room(8, 600, 6, 5);
  for (const CoverGoal goal : {CoverGoal::kEveryK, CoverGoal::kWholeCover, CoverGoal::kOneK}) {
    const std::atomic<bool> stop = true;
    CoverOptions options;
    options.goal = goal;
    options.k = 4;
    options.stop = &stop;
    EXPECT_THROW(solve(room.matrix, room.weights, options), Interrupted);
  }
}

TEST_P(EveryCoverMethod, TimeLimitStillGivesAWholeCover) {
  const reference::Room room = reference::furnished_room(16, 2000, 10, 5);
  for (const double seconds : {1e-9, 0.05}) {
    CoverOptions options;
    options.time_limit_seconds = seconds;
    const Stopwatch watch;
    const RegionCover cover = solve(room.matrix, room.weights, options);
    EXPECT_LT(watch.seconds(), seconds + 1);
    EXPECT_EQ(cover.time_limit_reached, searches());
    expect_certificates(room.matrix, room.weights, cover);
  }
}

TEST_P(EveryCoverMethod, ReportsEverySmallerCover) {
  const Instance instance = random_instance(3, 16);
  for (const CoverGoal goal : {CoverGoal::kEveryK, CoverGoal::kWholeCover}) {
    std::vector<BetterCover> reported;
    std::vector<CoverStep> steps;
    CoverOptions options;
    options.goal = goal;
    options.on_better = [&](const BetterCover& better) { reported.push_back(better); };
    options.on_step = [&](const CoverStep& step) { steps.push_back(step); };
    const RegionCover cover = solve(instance, options);
    ASSERT_FALSE(reported.empty());
    for (std::size_t i = 0; i < reported.size(); ++i) {
      EXPECT_EQ(instance.matrix.union_of(reported[i].chosen), instance.matrix.union_of_all());
      EXPECT_GE(reported[i].seconds, 0);
      if (i > 0) {
        EXPECT_LT(reported[i].chosen.size(), reported[i - 1].chosen.size());
      }
    }
    EXPECT_EQ(reported.back().chosen, cover.steps.back().chosen);
    ASSERT_FALSE(steps.empty());
    EXPECT_EQ(steps.back(), cover.steps.back());
  }
}

TEST(CoverMethods, AreFoundByName) {
  ASSERT_FALSE(cover_methods().empty());
  for (const CoverMethodEntry& entry : cover_methods()) {
    ASSERT_NE(make_cover_method(entry.name), nullptr);
    EXPECT_EQ(make_cover_method(entry.name)->name(), entry.name);
  }
  EXPECT_EQ(make_cover_method("guess"), nullptr);
}

}  // namespace
}  // namespace viewcover
