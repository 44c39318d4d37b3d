#include "viewpoints/region_views.h"

#include <gtest/gtest.h>

#include <iostream>

#include "approx/ray_backend.h"
#include "exact/sight_query.h"
#include "support/generated.h"
#include "support/sanitized.h"
#include "viewpoints/solved_scene.h"

namespace viewcover {
namespace {

using testing::SolvedScene;

using Words = std::vector<BitRows::Word>;

bool has(const Words& row, std::size_t column) { return row[column / 64] >> (column % 64) & 1; }

Words seen_from(const RegionViews& views, std::size_t region, const Point& position) {
  Words row(views.matrix().bits.words_per_row());
  views.look(region, position, row);
  return row;
}

std::unique_ptr<SolvedScene> solved_room(std::size_t regions, bool one_sided = false) {
  auto loaded = testing::load_generated(living_room(RoomDetail::kSimple), regions);
  const double area = default_element_area(loaded.scene);
  return std::make_unique<SolvedScene>(std::move(loaded.scene), std::move(loaded.region), area,
                                       std::make_unique<ExactBackend>(1), one_sided);
}

/// Against queries that know nothing of links and culling: all surfaces are occluders.
void expect_right(const SolvedScene& solved, std::size_t region, const Point& position,
                  RandomNumbers& random, int& seen, int& unseen) {
  const Words row = seen_from(solved.views, region, position);
  for (int i = 0; i < 60; ++i) {
    // Half of them from what the region sees: the others are known to be hidden.
    std::size_t column = random.below(solved.views.column_count());
    while (i % 2 == 0 && !solved.matrix.bits.test(region, column)) {
      column = random.below(solved.views.column_count());
    }
    const ElementAddress element = solved.matrix.elements[column];
    SightQuery query;
    query.viewpoint = position;
    query.element = subdivided(solved.scene[element.owner()].polygon, element);
    query.one_sided = solved.one_sided;
    for (const Surface& surface : solved.scene.surfaces) {
      if (surface.polygon.size() > 0 && &surface != &solved.scene[element.owner()]) {
        query.occluders.push_back(surface.polygon);
      }
    }
    const bool truth = is_visible(decide_from_point(query).verdict);
    EXPECT_EQ(has(row, column), truth) << "region " << region << " column " << column;
    (truth ? seen : unseen)++;
  }
}

TEST(RegionViews, AgreeWithQueriesOfTheWholeScene) {
  RandomNumbers random(11);
  int seen = 0, unseen = 0;
  for (const bool one_sided : {false, true}) {
    const auto solved = solved_room(16, one_sided);
    for (int i = 0; i < (testing::sanitized() ? 1 : 6); ++i) {
      const std::size_t region = random.below(solved->views.region_count());
      const Point position = solved->views.positions(region).random(random);
      if (!solved->views.is_free(region, position)) continue;
      expect_right(*solved, region, position, random, seen, unseen);
    }
  }
  EXPECT_GE(seen, testing::sanitized() ? 10 : 100);
  EXPECT_GE(unseen, testing::sanitized() ? 10 : 100);
}

TEST(RegionViews, SeeNoMoreThanTheirRegion) {
  const auto solved = solved_room(64);
  RandomNumbers random(12);
  std::size_t seen = 0, of_regions = 0;
  for (int i = 0; i < (testing::sanitized() ? 24 : 120); ++i) {
    const std::size_t region = random.below(solved->views.region_count());
    const RegionPositions& positions = solved->views.positions(region);
    // Borders and corners too.
    const Point position = i % 3 == 0 ? positions.random(random)
                           : i % 3 == 1
                               ? positions.nearest(positions.region().polygon()[random.below(4)])
                               : positions.near(positions.region().polygon()[0], 1, random);
    if (!solved->views.is_free(region, position)) continue;
    const Words row = seen_from(solved->views, region, position);
    const auto of_region = solved->matrix.bits.row(region);
    for (std::size_t w = 0; w < row.size(); ++w) ASSERT_EQ(row[w] & ~of_region[w], 0u);
    seen += count_bits(row);
    of_regions += count_bits(of_region);
  }
  EXPECT_LT(seen, of_regions);
  EXPECT_GT(seen, of_regions / 2);
}

TEST(RegionViews, LookAtWantedColumnsOnly) {
  const auto solved = solved_room(16);
  RandomNumbers random(13);
  const Point position = solved->views.positions(5).random(random);
  const Words all = seen_from(solved->views, 5, position);
  Words wanted(all.size()), row(all.size());
  for (BitRows::Word& word : wanted) word = random.bits();
  solved->views.look(5, position, row, wanted);
  for (std::size_t w = 0; w < all.size(); ++w) EXPECT_EQ(row[w], all[w] & wanted[w]);
}

TEST(RegionViews, RaysSeeNothingThatIsHidden) {
  const auto exact = solved_room(16);
  const RayBackend rays({.rays = 16, .seed = 1});
  const RegionViews by_rays(
      {exact->scene, exact->clusters, exact->region, exact->links, exact->matrix, rays, false});
  RandomNumbers random(14);
  std::size_t more = 0, same = 0;
  for (int i = 0; i < 20; ++i) {
    const std::size_t region = random.below(exact->views.region_count());
    const Point position = exact->views.positions(region).random(random);
    const Words truth = seen_from(exact->views, region, position),
                row = seen_from(by_rays, region, position);
    for (std::size_t w = 0; w < row.size(); ++w) EXPECT_EQ(row[w] & ~truth[w], 0u);
    more += count_bits(truth) - count_bits(row);
    same += count_bits(row);
  }
  EXPECT_GT(more, 0u);
  EXPECT_GT(same, more);
}

TEST(RegionViews, WallsSeenEdgeOnOrFromBehindAreNotSeen) {
  // A wall above the middle of the region, its front toward +x.
  const std::vector<ConvexPolygon> wall = {{{1, 0, 1}, {1, 1, 1}, {1, 1, 2}, {1, 0, 2}}};
  for (const bool one_sided : {false, true}) {
    const SolvedScene solved(testing::scene_of(wall),
                             testing::region_of(testing::horizontal(0, 0, 2, 1, 0), 0), 10,
                             std::make_unique<ExactBackend>(1), one_sided);
    const RegionPositions& positions = solved.views.positions(0);
    const auto is_seen_from = [&](double x) {
      return has(seen_from(solved.views, 0, positions.nearest({x, 0.5, 0})), 0);
    };
    EXPECT_TRUE(is_seen_from(1.5));
    EXPECT_FALSE(is_seen_from(1));
    EXPECT_EQ(is_seen_from(0.5), !one_sided);
  }
}

TEST(RegionViews, CellsSeeWhatTheirPositionsSee) {
  const auto solved = solved_room(16);
  RandomNumbers random(15);
  std::size_t seen = 0, unseen = 0;
  for (const std::size_t region : {3, 6}) {
    const RegionAddress cell = solved->region.address(region).child(2).child(1);
    const ConvexPolygon polygon = solved->region.polygon(cell);
    const RegionPositions positions(polygon, solved->scene.bounds, solved->scene.lattice.exponent);
    Words from_cell(solved->matrix.bits.words_per_row());
    for (int i = 0; i < 8; ++i) {
      const Point position = positions.random(random);
      if (solved->views.is_free(region, position)) {
        solved->views.look(region, position, from_cell);
      }
    }
    for (std::size_t column = region; column < solved->views.column_count(); column += 5) {
      if (!solved->matrix.bits.test(region, column)) continue;
      const bool cell_sees = solved->views.cell_sees({cell, region, polygon}, column);
      EXPECT_TRUE(cell_sees || !has(from_cell, column)) << "region " << region << " " << column;
      ++(cell_sees ? seen : unseen);
    }
  }
  EXPECT_GT(seen, 100u);
  EXPECT_GT(unseen, 10u);
}

/// A wall that stands on the region: from a point of its foot both sides would be seen.
TEST(RegionViews, PositionsThatTouchASurfaceAreNotFree) {
  std::vector<ConvexPolygon> polygons = {{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}},
                                         testing::horizontal(-4, -4, 4, 4, 2)};
  const SolvedScene solved(testing::scene_of(polygons),
                           testing::region_of(testing::horizontal(0, 0, 1, 1, 0), 1), 100);
  const RegionPositions& positions = solved.views.positions(0);
  EXPECT_FALSE(solved.views.is_free(0, positions.nearest({0, 0.25, 0})));
  EXPECT_TRUE(solved.views.is_free(0, positions.nearest({0.25, 0.25, 0})));
}

TEST(RegionViews, SightLinesStartInTheRegionAndEndOnTheElement) {
  const auto solved = solved_room(16);
  int found = 0;
  for (std::size_t column = 0; column < solved->views.column_count(); column += 17) {
    if (!solved->matrix.bits.test(3, column)) continue;
    const auto line = solved->views.find_sight_line(3, column);
    ASSERT_TRUE(line);
    ++found;
    const RegionPositions& positions = solved->views.positions(3);
    EXPECT_LT((positions.nearest(line->from) - line->from).norm(), 1e-5);
  }
  EXPECT_GT(found, 20);
}

}  // namespace
}  // namespace viewcover
