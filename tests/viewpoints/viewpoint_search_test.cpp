#include "viewpoints/viewpoint_search.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstdlib>

#include "approx/ray_backend.h"
#include "optim/cover_proof.h"
#include "support/generated.h"
#include "support/sanitized.h"
#include "viewpoints/paper_search.h"
#include "viewpoints/refined_bound.h"
#include "viewpoints/solved_scene.h"

namespace viewcover {
namespace {

using testing::SolvedScene;

/// What holds of any result, recomputed.
void expect_consistent(const SolvedScene& solved, const ViewpointSet& set) {
  const std::size_t count = set.viewpoints.size();
  ASSERT_EQ(set.seen.rows(), count);
  ASSERT_EQ(set.covered_percent.size(), count);
  ASSERT_EQ(set.seconds.size(), count);
  EXPECT_TRUE(set.missing.empty());
  EXPECT_LE(set.lower_bound, count);
  EXPECT_EQ(set.seen.union_of_all(), solved.matrix.bits.union_of_all());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [position, region] = set.viewpoints[i];
    EXPECT_TRUE(lies_in(position, solved.region.polygon(solved.region.address(region))));
    EXPECT_TRUE(solved.views.is_free(region, position));
    std::vector<BitRows::Word> row(set.seen.words_per_row());
    solved.views.look(region, position, row);
    const auto stated = set.seen.row(i);
    for (std::size_t w = 0; w < row.size(); ++w) {
      // A target may show rays what they miss without.
      EXPECT_EQ(row[w] & ~stated[w], 0u);
      EXPECT_EQ(stated[w] & ~solved.matrix.bits.row(region)[w], 0u);
    }
    if (i > 0) {
      EXPECT_GT(set.covered_percent[i], set.covered_percent[i - 1]);
    }
  }
  if (count > 0) {
    EXPECT_EQ(set.covered_percent.back(), 100);
  }
}

TEST(ViewpointSearch, OneViewpointSeesAConvexRoom) {
  std::vector<ConvexPolygon> room = testing::box_walls({0, 0, 0}, {4, 3, 2});
  room.push_back(testing::horizontal(0, 0, 4, 3, 0));
  room.push_back(testing::horizontal(0, 0, 4, 3, 2));
  const SolvedScene solved(testing::scene_of(room),
                           testing::region_of(testing::horizontal(1, 1, 2, 2, 1), 2), 0.5);
  const ViewpointSet set = find_viewpoints(solved.views, solved.options());
  expect_consistent(solved, set);
  EXPECT_EQ(set.viewpoints.size(), 1u);
  EXPECT_EQ(set.lower_bound, 1u);
}

class Chimneys : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Counts, Chimneys, ::testing::Range(1, testing::sanitized() ? 3 : 6));

TEST_P(Chimneys, NeedAViewpointEach) {
  const int count = GetParam();
  // One region: the cover by regions says 1, and the bound must be raised from there.
  for (const int level : {0, 2}) {
    const SolvedScene solved(testing::scene_of(testing::chimneys(count)),
                             testing::under_chimneys(count, level), 100);
    ViewpointOptions options = solved.options();
    options.gap_rounds = 30;
    const ViewpointSet set = find_viewpoints(solved.views, options);
    expect_consistent(solved, set);
    EXPECT_EQ(set.viewpoints.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(set.lower_bound, static_cast<std::size_t>(count));
    if (level == 0 && count > 1) {
      ASSERT_NE(set.refined_bound, nullptr);
      EXPECT_EQ(set.refined_bound->lower_bound, set.lower_bound);
      ASSERT_NE(set.refined_bound->proof, nullptr);
      EXPECT_EQ(set.refined_bound->proof->lower_bound, set.lower_bound);
    }
  }
}

TEST(ViewpointSearch, WithoutAnythingVisibleThereIsNothingToDo) {
  // Behind all surfaces.
  const SolvedScene solved(
      testing::scene_of(std::vector<ConvexPolygon>{testing::horizontal(0, 0, 1, 1, 1)}),
      testing::region_of(testing::horizontal(0, 0, 1, 1, 2), 1), 1,
      std::make_unique<ExactBackend>(1), true);
  ASSERT_GT(solved.cover.size(), 0u);  // the front is seen from above
  const SolvedScene hidden(
      testing::scene_of(std::vector<ConvexPolygon>{testing::horizontal(0, 0, 1, 1, 1)}),
      testing::region_of(testing::horizontal(0, 0, 1, 1, 0), 1), 1,
      std::make_unique<ExactBackend>(1), true);
  const ViewpointSet set = find_viewpoints(hidden.views, hidden.options());
  expect_consistent(hidden, set);
  EXPECT_TRUE(set.viewpoints.empty());
}

class LivingRooms : public ::testing::TestWithParam<std::tuple<RoomDetail, bool>> {};
INSTANTIATE_TEST_SUITE_P(Details, LivingRooms,
                         ::testing::Combine(::testing::Values(RoomDetail::kSimple,
                                                              RoomDetail::kComplex),
                                            ::testing::Bool()));

TEST_P(LivingRooms, AreSeenWholeWhateverTheThreads) {
  const auto [detail, exact] = GetParam();
  if (testing::sanitized()) GTEST_SKIP() << "minutes under sanitizers";
  if (exact && detail == RoomDetail::kComplex && std::getenv("VIEWCOVER_TEST_ALL") == nullptr) {
    GTEST_SKIP() << "takes half a minute: VIEWCOVER_TEST_ALL=1 runs it";
  }
  auto loaded = testing::load_generated(living_room(detail), 16);
  // Large elements for the larger room: as many pairs, and more occluders.
  const double area = default_element_area(loaded.scene) * (detail == RoomDetail::kSimple ? 2 : 16);
  std::unique_ptr<VisibilityBackend> backend;
  if (exact) {
    backend = std::make_unique<ExactBackend>(1);
  } else {
    backend = std::make_unique<RayBackend>(RayOptions{.rays = 16, .seed = 1});
  }
  const SolvedScene solved(std::move(loaded.scene), std::move(loaded.region), area,
                           std::move(backend));
  ViewpointOptions options = solved.options();
  options.gap_rounds = exact ? 2 : 0;
  std::vector<ViewpointSet> sets;
  for (const std::size_t threads : {1, 2}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    sets.push_back(find_viewpoints(solved.views, options));
  }
  expect_consistent(solved, sets[0]);
  EXPECT_EQ(sets[0].viewpoints, sets[1].viewpoints);
  EXPECT_EQ(sets[0].seen.union_of_all(), sets[1].seen.union_of_all());
  EXPECT_EQ(sets[0].positions, sets[1].positions);
  EXPECT_EQ(sets[0].lower_bound, sets[1].lower_bound);
  EXPECT_LE(sets[0].viewpoints.size(), sets[0].paper_viewpoints);
}

TEST(ViewpointSearch, NamesWhatNoPositionSees) {
  // Positions are multiples of 2^-17 here; a chimney of a quarter of that stands between them, and
  // what is beside it by its width does not see its lid.
  const double unit = 0x1p-20;
  const Point low(4 + 2 * unit, 4 + 2 * unit, 1), high(4 + 4 * unit, 4 + 4 * unit, 9);
  std::vector<ConvexPolygon> polygons = testing::box_walls(low, high);
  polygons.push_back(testing::horizontal(low.x(), low.y(), high.x(), high.y(), 9));
  const SolvedScene solved(testing::scene_of(polygons),
                           testing::region_of(testing::horizontal(0, 0, 8, 8, 0), 0), 100);
  ASSERT_EQ(solved.views.positions(0).bits(), 20);
  const auto lid = std::ranges::find(solved.matrix.elements, ElementAddress(SurfaceId(4)));
  ASSERT_NE(lid, solved.matrix.elements.end());
  const ViewpointSet set = find_viewpoints(solved.views, solved.options());
  EXPECT_EQ(set.missing, std::vector<std::size_t>{
                             static_cast<std::size_t>(lid - solved.matrix.elements.begin())});
}

/// Four annealing runs from one region, and the best of their positions is taken first.
TEST(PaperSearch, TakesWhatAddsMost) {
  // A floor at height 1, seen through what plates leave open, from (x, y) an area of x y.
  const std::vector<ConvexPolygon> polygons = {testing::horizontal(0, 0, 1, 1, 1),
                                               testing::horizontal(-2, -2, 0.5, 2, 0.5),
                                               testing::horizontal(0.5, -2, 2, 0.5, 0.5)};
  const SolvedScene solved(testing::scene_of(polygons),
                           testing::region_of(testing::horizontal(0, 0, 1, 1, 0), 0), 0x1p-8);
  SearchLimits limits{CoverOptions()};
  Looks looks(solved.views, limits, nullptr);
  CandidatePool pool(solved.views.column_count());
  const PaperViewpoints paper = paper_search(looks, solved.options(), pool);
  ASSERT_FALSE(paper.chosen.empty());
  double seen = 0;
  for_each_bit(std::span<const BitRows::Word>(paper.chosen[0].seen), [&](std::size_t column) {
    if (solved.matrix.elements[column].owner() == SurfaceId(0)) seen += solved.matrix.areas[column];
  });
  EXPECT_GT(seen, 0.9);
}

TEST(ViewpointSearch, ATimeLimitLeavesAWholeSet) {
  const SolvedScene solved(testing::scene_of(testing::chimneys(4)), testing::under_chimneys(4, 0),
                           100);
  ViewpointOptions options = solved.options();
  options.time_limit_seconds = 1e-9;
  const ViewpointSet set = find_viewpoints(solved.views, options);
  expect_consistent(solved, set);
  EXPECT_TRUE(set.time_limit_reached);
}

TEST(ViewpointSearch, StopsWhenTold) {
  const SolvedScene solved(testing::scene_of(testing::chimneys(2)), testing::under_chimneys(2, 0),
                           100);
  ViewpointOptions options = solved.options();
  const std::atomic<bool> stop = true;
  options.stop = &stop;
  EXPECT_THROW(find_viewpoints(solved.views, options), Interrupted);
}

void expect_cells_see_what_positions_see(const SolvedScene& solved, const RefinedBound& bound) {
  RandomNumbers random(1);
  for (std::size_t i = 0; i < bound.cells.size(); ++i) {
    const RegionPositions positions(solved.region.polygon(bound.cells[i]), solved.scene.bounds,
                                    solved.scene.lattice.exponent);
    const Point position = positions.random(random);
    if (!solved.views.is_free(0, position)) continue;
    std::vector<BitRows::Word> seen(bound.seen.words_per_row());
    solved.views.look(0, position, seen);
    for (std::size_t w = 0; w < seen.size(); ++w) EXPECT_EQ(seen[w] & ~bound.seen.row(i)[w], 0u);
  }
}

/// Cells under chimneys: as many as chimneys, and each certificate holds what it says.
TEST(BoundRefinement, NeverFallsAndTilesTheRegion) {
  const SolvedScene solved(testing::scene_of(testing::chimneys(3)), testing::under_chimneys(3, 0),
                           100);
  std::vector<std::uint32_t> columns;
  for (std::uint32_t c = 0; c < solved.views.column_count(); ++c) columns.push_back(c);
  SearchLimits limits{CoverOptions()};
  BoundRefinement refinement(solved.views, columns, limits, 1);
  std::size_t bound = 0, rises = 0;
  for (int round = 0; round < 12 && refinement.lower_bound() < 3; ++round) {
    ASSERT_TRUE(refinement.refine());
    EXPECT_GE(refinement.lower_bound(), bound);
    rises += refinement.lower_bound() > bound;
    bound = refinement.lower_bound();
    EXPECT_EQ(refinement.middles_of_cover().size() >= bound, true);
  }
  EXPECT_EQ(bound, 3u);
  EXPECT_GE(rises, 2u);
  double area = 0;
  for (const RegionAddress cell : refinement.bound().cells) {
    area += std::ldexp(1.0, -2 * cell.level());
  }
  EXPECT_EQ(area, 1);
  expect_cells_see_what_positions_see(solved, refinement.bound());
  EXPECT_TRUE(std::is_sorted(refinement.bound().cells.begin(), refinement.bound().cells.end()));
}

}  // namespace
}  // namespace viewcover
