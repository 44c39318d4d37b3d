#include "hard_instances.h"

#include <gmock/gmock.h>

#include <atomic>

#include "cover_checks.h"
#include "reference_cover.h"
#include "scene/error.h"

namespace viewcover {
namespace {

using reference::HardInstance;

CoverOptions whole_cover(std::uint64_t seed) {
  CoverOptions options;
  options.goal = CoverGoal::kWholeCover;
  options.seed = seed;
  return options;
}

std::size_t size_by(std::string_view method, const HardInstance& hard, std::uint64_t seed = 1) {
  const std::vector<double> weights(hard.matrix.columns(), 1.0);
  const CoverOptions options = whole_cover(seed);
  const RegionCover cover = reference::solve(method, hard.matrix, weights, options);
  reference::expect_certificates(hard.matrix, weights, cover, options);
  return cover.size();
}

TEST(HardInstances, HaveTheSizesOfTheLiterature) {
  struct Expected {
    HardInstance hard;
    std::size_t rows, columns, ones_of_a_column;
  };
  for (const auto& [hard, rows, columns, ones_of_a_column] :
       {Expected{reference::affine_lines(2), 9, 12, 3},
        {reference::affine_lines(3), 27, 117, 3},
        {reference::affine_lines(4), 81, 1080, 3},
        {reference::cube_cycles(6), 192, 240, 4},
        {reference::cube_cycles(7), 448, 672, 4},
        {reference::cube_cycles(8), 1024, 1792, 4},
        // One part has a single point: the other holds 210 subsets of four.
        {reference::bipartitions(11), 330, 1023, 210}}) {
    SCOPED_TRACE(hard.name);
    EXPECT_EQ(hard.matrix.rows(), rows);
    EXPECT_EQ(hard.matrix.columns(), columns);
    std::size_t ones = 0;
    for (std::size_t r = 0; r < rows; ++r) ones += hard.matrix.test(r, 0);
    EXPECT_EQ(ones, ones_of_a_column);
  }
}

TEST(HardInstances, SmallOnesHaveTheirOptimum) {
  EXPECT_EQ(reference::minimum_cover(reference::affine_lines(2).matrix), 5u);
  EXPECT_EQ(reference::minimum_cover(reference::greedy_trap(4, 2).matrix), 4u);
  EXPECT_EQ(reference::minimum_cover(reference::planted_cover(4, 8, 20, 1).matrix), 4u);
}

TEST(HardInstances, LocalSearchReachesTheBestKnown) {
  for (const HardInstance& hard : reference::hard_instances()) {
    const CoverInstance instance(hard.matrix, std::vector<double>(hard.matrix.columns(), 1.0));
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      SCOPED_TRACE(::testing::Message() << hard.name << ", seed " << seed);
      std::atomic<bool> stop = false;
      std::vector<std::size_t> smallest;
      CoverOptions options = whole_cover(seed);
      options.stop = &stop;
      options.on_better = [&](const BetterCover& better) {
        smallest = better.chosen;
        stop = smallest.size() <= hard.best;
      };
      try {
        make_cover_method("local")->solve(instance, options);
      } catch (const Interrupted&) {
        EXPECT_TRUE(stop);
      }
      EXPECT_EQ(smallest.size(), hard.best);
      EXPECT_TRUE(instance.covers_all(smallest));
    }
  }
}

TEST(HardInstances, GreedyFallsIntoItsTrap) {
  EXPECT_EQ(size_by("greedy", reference::greedy_trap(6, 20)), 120u);
  EXPECT_EQ(size_by("greedy", reference::greedy_trap(8, 1)), 8u);
}

TEST(HardInstances, AnnealingAndTabuFindTheSmallOnes) {
  for (const std::string_view method : {"sa", "tabu"}) {
    EXPECT_EQ(size_by(method, reference::affine_lines(2)), 5u);
    EXPECT_EQ(size_by(method, reference::affine_lines(3)), 18u);
    EXPECT_EQ(size_by(method, reference::greedy_trap(5, 2)), 4u);
  }
}

}  // namespace
}  // namespace viewcover
