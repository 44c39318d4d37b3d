#include "viewpoints/position_annealing.h"

#include <gtest/gtest.h>

#include "viewpoints/solved_scene.h"

namespace viewcover {
namespace {

using testing::SolvedScene;

double benefit_of(const SolvedScene& solved, const Point& position, const ColumnWeights& weights) {
  std::vector<BitRows::Word> row(solved.matrix.bits.words_per_row());
  solved.views.look(0, position, row);
  return weights.of(row);
}

/// One region under a chimney, of which a plate covers a part.
std::vector<ConvexPolygon> chimney_and_plate() {
  std::vector<ConvexPolygon> polygons = testing::chimneys(1);
  polygons.push_back(testing::horizontal(0, 0, 0.5, 0.25, 0));
  return polygons;
}

TEST(AnnealPosition, RecordsAreFreeAndRise) {
  const SolvedScene solved(testing::scene_of(chimney_and_plate()), testing::under_chimneys(1, 0),
                           0.1);
  const ColumnWeights weights(solved.matrix.areas);
  std::size_t records = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const AnnealedPosition found = anneal_position(solved.views, 0, weights, {.seed = seed});
    double benefit = -1;
    for (const Point& position : found.records) {
      EXPECT_TRUE(solved.views.is_free(0, position));
      EXPECT_GT(benefit_of(solved, position, weights), benefit);
      benefit = benefit_of(solved, position, weights);
    }
    EXPECT_EQ(benefit, found.benefit);
    records += found.records.size();
  }
  EXPECT_GT(records, 100u);
}

TEST(AnnealPosition, BeginsWhereItIsTold) {
  const SolvedScene solved(testing::scene_of(chimney_and_plate()), testing::under_chimneys(1, 0),
                           0.1);
  const ColumnWeights weights(solved.matrix.areas);
  const Point start = solved.views.positions(0).nearest({0.75, 0.75, 0});
  const AnnealedPosition found =
      anneal_position(solved.views, 0, weights, {.evaluations = 1, .start = start});
  EXPECT_EQ(found.records, std::vector<Point>{start});
}

/// A ceiling [0, 1]^2 at height 1 over plates at height 1/2 that leave x > 1/2, y > 1/2 open: from
/// (x, y) at height 0 the part beyond (1 - x, 1 - y) is seen, of area x y. The best is a corner.
TEST(AnnealPosition, FindsMoreThanChance) {
  const std::vector<ConvexPolygon> polygons = {testing::horizontal(0, 0, 1, 1, 1),
                                               testing::horizontal(-2, -2, 0.5, 2, 0.5),
                                               testing::horizontal(0.5, -2, 2, 0.5, 0.5)};
  const SolvedScene solved(testing::scene_of(polygons),
                           testing::region_of(testing::horizontal(0, 0, 1, 1, 0), 0), 0x1p-10);
  std::vector<double> ceiling = solved.matrix.areas;
  for (std::size_t i = 0; i < ceiling.size(); ++i) {
    if (solved.matrix.elements[i].owner() != SurfaceId(0)) ceiling[i] = 0;
  }
  const ColumnWeights weights(ceiling);
  constexpr std::uint64_t kSeeds = 10;
  double annealed = 0, by_chance = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    annealed += anneal_position(solved.views, 0, weights, {.seed = seed}).benefit;
    RandomNumbers random(seed);
    double best = 0;
    for (std::size_t i = 0; i < AnnealingOptions().evaluations; ++i) {
      best = std::max(best, benefit_of(solved, solved.views.positions(0).random(random), weights));
    }
    by_chance += best;
  }
  EXPECT_GT(annealed, 0.93 * kSeeds);
  EXPECT_GT(annealed, by_chance);
}

}  // namespace
}  // namespace viewcover
