#include <gmock/gmock.h>

#include <random>

#include "optim/region_cover.h"
#include "reference_cover.h"

namespace viewcover {
namespace {

BitRows matrix_of(const std::vector<std::string>& rows) {
  BitRows matrix(rows.size(), rows.empty() ? 0 : rows.front().size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < rows[r].size(); ++c) {
      if (rows[r][c] == '1') matrix.set(r, c);
    }
  }
  return matrix;
}

TEST(CoverInstance, MergesEqualColumnsAndDropsUncoveredOnes) {
  const BitRows matrix = matrix_of({"110010", "001010", "001000"});
  const CoverInstance instance(matrix, std::vector<double>{1, 2, 4, 8, 16, 32});
  EXPECT_THAT(instance.weights(), ::testing::ElementsAre(3, 4, 16));
  EXPECT_EQ(instance.total_weight(), 23);
  EXPECT_TRUE(instance.rows().test(0, 0));
  EXPECT_FALSE(instance.rows().test(0, 1));
  EXPECT_TRUE(instance.rows().test(0, 2));
  EXPECT_TRUE(instance.rows().test(2, 1));
  EXPECT_TRUE(instance.covers_all(std::vector<std::size_t>{0, 1}));
  EXPECT_FALSE(instance.covers_all(std::vector<std::size_t>{1, 2}));
  EXPECT_EQ(instance.covered_weight(std::vector<std::size_t>{1, 2}), 20);
}

TEST(CoverInstance, LowerBoundCountsIndependentColumns) {
  // Columns 0, 3, 5 share no row; the common column 1 would leave only one more.
  const CoverInstance instance(matrix_of({"110000", "011100", "000011"}),
                               std::vector<double>(6, 1.0));
  EXPECT_EQ(instance.lower_bound(), 3u);
}

TEST(CoverInstance, LowerBoundNeverExceedsTheOptimum) {
  std::size_t tight = 0, loose = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const std::size_t rows = 1 + random() % 14, columns = random() % 30;
    BitRows matrix(rows, columns);
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t c = 0; c < columns; ++c) {
        if (random() % 4 == 0) matrix.set(r, c);
      }
    }
    const CoverInstance instance(matrix, std::vector<double>(columns, 1.0));
    const std::size_t optimum = reference::minimum_cover(matrix);
    ASSERT_LE(instance.lower_bound(), optimum);
    ++(instance.lower_bound() == optimum ? tight : loose);
  }
  EXPECT_GT(tight, 0u);
  EXPECT_GT(loose, 0u);
}

TEST(CoverInstance, UpperBoundIsNeverBelowWhatRowsCover) {
  std::size_t below_hundred = 0;
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const std::size_t rows = 1 + random() % 10, columns = 1 + random() % 40;
    BitRows matrix(rows, columns);
    std::vector<double> weights(columns);
    for (std::size_t c = 0; c < columns; ++c) {
      weights[c] = static_cast<double>(random() % 1000) * 0.1;
      for (std::size_t r = 0; r < rows; ++r) {
        if (random() % 5 == 0) matrix.set(r, c);
      }
    }
    const CoverInstance instance(matrix, weights);
    if (instance.total_weight() == 0) continue;
    for (std::size_t k = 1; k <= rows; ++k) {
      const double covered = reference::maximum_coverage(matrix, weights, k);
      const double bound = instance.upper_bound_percent(k);
      ASSERT_GE(bound, std::min(100.0, 100 * (covered / instance.total_weight())));
      ASSERT_LE(bound, 100);
      below_hundred += bound < 100;
    }
  }
  EXPECT_GT(below_hundred, 100u);
}

TEST(CoverInstance, UpperBoundIsTheSumOfTheHeaviestRows) {
  const CoverInstance instance(matrix_of({"1100", "0100", "0011"}),
                               std::vector<double>{1, 2, 3, 4});
  EXPECT_NEAR(instance.upper_bound_percent(1), 70, 1e-10);
  EXPECT_EQ(instance.upper_bound_percent(2), 100);
}

TEST(CoverInstance, WithoutColumnsNothingIsMissing) {
  const CoverInstance instance(BitRows(3, 0), {});
  EXPECT_EQ(instance.lower_bound(), 0u);
  EXPECT_TRUE(instance.covers_all({}));
  EXPECT_EQ(instance.covered_percent({}), 100);
}

}  // namespace
}  // namespace viewcover
