#include "viewpoints/candidate_search.h"

#include <gtest/gtest.h>

#include "viewpoints/solved_scene.h"

namespace viewcover {
namespace {

using testing::SolvedScene;

TEST(CandidateSearch, TakesASmallerCoverByItsCandidates) {
  // Two viewpoints under each chimney, where one sees as much.
  constexpr int kCount = 4;
  const SolvedScene solved(testing::scene_of(testing::chimneys(kCount)),
                           testing::under_chimneys(kCount, 0), 100);
  SearchLimits limits{CoverOptions()};
  Looks looks(solved.views, limits, nullptr);
  std::vector<Look> places;
  for (int i = 0; i < kCount; ++i) {
    for (const double x : {0.5, 0.4375}) {
      places.push_back({0, solved.views.positions(0).nearest({i + x, 0.5, 0})});
    }
  }
  const std::vector<Candidate> twice = looks.from(places);
  ASSERT_EQ(twice.size(), 2u * kCount);
  CandidatePool pool(solved.views.column_count());
  for (const Candidate& candidate : twice) pool.add(candidate);
  const ViewpointOptions options = solved.options();
  CandidateSearch search(looks, options, pool, twice);
  search.run(kCount, 1);
  EXPECT_EQ(search.best().size(), static_cast<std::size_t>(kCount));
  std::vector<BitRows::Word> seen(solved.matrix.bits.words_per_row());
  for (const Candidate& candidate : search.best()) {
    for (std::size_t w = 0; w < seen.size(); ++w) seen[w] |= candidate.seen[w];
  }
  EXPECT_EQ(seen, solved.matrix.bits.union_of_all());
}

TEST(CandidateSearch, GathersViewersOfWhatChanceDoesNotFind) {
  // A chimney of width 2^-12 between multiples of 2^-10, where random positions are.
  const double unit = 0x1p-12;
  const Point low(0.5 + unit, 0.5 + unit, 1), high(0.5 + 2 * unit, 0.5 + 2 * unit, 9);
  std::vector<ConvexPolygon> polygons = testing::box_walls(low, high);
  polygons.push_back(testing::horizontal(low.x(), low.y(), high.x(), high.y(), 9));
  const SolvedScene solved(testing::scene_of(polygons), testing::under_chimneys(1, 0), 100);
  const auto lid = std::ranges::find(solved.matrix.elements, ElementAddress(SurfaceId(4)));
  ASSERT_NE(lid, solved.matrix.elements.end());
  SearchLimits limits{CoverOptions()};
  Looks looks(solved.views, limits, nullptr);
  CandidatePool pool(solved.views.column_count());
  const ViewpointOptions options = solved.options();
  CandidateSearch search(looks, options, pool, {});
  search.gather();
  EXPECT_GT(pool.viewers()[static_cast<std::size_t>(lid - solved.matrix.elements.begin())], 0u);
}

}  // namespace
}  // namespace viewcover
