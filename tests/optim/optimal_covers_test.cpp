#include "optim/optimal_covers.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "optim/exact_cover.h"
#include "reference_cover.h"
#include "small_instances.h"

namespace viewcover {
namespace {

using testing::affine_space;
using testing::small_instance;

/// All covers of that many rows, by trying all sets of rows.
std::vector<std::vector<std::size_t>> all_covers(const BitRows& matrix, std::size_t size) {
  const std::vector<BitRows::Word> all = matrix.union_of_all();
  std::vector<std::vector<std::size_t>> covers;
  for (std::uint32_t set = 0; set < 1u << matrix.rows(); ++set) {
    if (static_cast<std::size_t>(std::popcount(set)) != size) continue;
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < matrix.rows(); ++row) {
      if ((set >> row & 1) != 0) rows.push_back(row);
    }
    if (matrix.union_of(rows) == all) covers.push_back(rows);
  }
  std::ranges::sort(covers);
  return covers;
}

RegionCover solve(const BitRows& matrix, std::size_t solutions) {
  CoverOptions options;
  options.goal = CoverGoal::kWholeCover;
  options.solutions = solutions;
  return ExactCover().solve(CoverInstance(matrix, std::vector<double>(matrix.columns(), 1.0)),
                            options);
}

TEST(OptimalCovers, AreAllThatBruteForceFinds) {
  std::size_t several = 0;
  for (std::uint64_t seed = 1; seed <= 600; ++seed) {
    SCOPED_TRACE(seed);
    const BitRows matrix = small_instance(seed, 10, 24).matrix;
    RegionCover cover = solve(matrix, 1000);
    if (cover.size() == 0) continue;
    const std::vector<std::vector<std::size_t>> expected = all_covers(matrix, cover.size());
    std::ranges::sort(cover.solutions);
    ASSERT_EQ(cover.solutions, expected);
    ASSERT_TRUE(cover.solutions_complete);
    several += expected.size() > 1;
  }
  EXPECT_GT(several, 100u);
}

TEST(OptimalCovers, AsManyAsAskedForAlwaysTheSame) {
  const BitRows plane = affine_space(2);
  const RegionCover all = solve(plane, 1000);
  // The four points left over hold no line: AG(2, 3) has 54 such sets (ovals).
  EXPECT_EQ(all.solutions.size(), 54u);
  EXPECT_TRUE(all.solutions_complete);
  const RegionCover exactly = solve(plane, 54);
  EXPECT_EQ(exactly.solutions, all.solutions);
  EXPECT_TRUE(exactly.solutions_complete);
  const RegionCover some = solve(plane, 7);
  ASSERT_EQ(some.solutions.size(), 7u);
  EXPECT_FALSE(some.solutions_complete);
  EXPECT_TRUE(std::ranges::equal(some.solutions, std::span(all.solutions).first(7)));
  EXPECT_TRUE(solve(plane, 0).solutions.empty());
}

TEST(OptimalCovers, DominatedRowsMakeCoversOfTheirOwn) {
  BitRows matrix(3, 2);  // row 0 covers all, row 1 too, row 2 half of it
  matrix.set_range(0, 0, 2);
  matrix.set_range(1, 0, 2);
  matrix.set(2, 0);
  EXPECT_THAT(solve(matrix, 9).solutions,
              ::testing::ElementsAre(::testing::ElementsAre(0), ::testing::ElementsAre(1)));
}

}  // namespace
}  // namespace viewcover
