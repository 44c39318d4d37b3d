#include "viewpoints/candidate_pool.h"

#include <gmock/gmock.h>

#include "viewpoints/column_weights.h"
#include "viewpoints/pool_cover.h"

namespace viewcover {
namespace {

using ::testing::ElementsAre;

Candidate candidate(BitRows::Word seen, std::size_t region = 0) {
  return {{Point(static_cast<double>(region), 0, 0), region}, {seen}, 0};
}

TEST(CandidatePool, KeepsWhatSeesMore) {
  CandidatePool pool(4);
  EXPECT_TRUE(pool.add(candidate(0b0011, 1)));
  EXPECT_FALSE(pool.add(candidate(0b0011, 2)));
  EXPECT_FALSE(pool.add(candidate(0b0001, 3)));
  EXPECT_TRUE(pool.add(candidate(0b0100, 4)));
  EXPECT_TRUE(pool.add(candidate(0b1110, 5)));  // in place of number 4
  ASSERT_EQ(pool.size(), 2u);
  EXPECT_EQ(pool[0].viewpoint.region, 1u);
  EXPECT_EQ(pool[1].viewpoint.region, 5u);
  EXPECT_THAT(pool.viewers(), ElementsAre(1, 2, 1, 1));
}

TEST(CandidatePool, KeepsTheBest) {
  CandidatePool pool(4);
  for (std::size_t i = 0; i < 4; ++i) pool.add(candidate(BitRows::Word{1} << i, i));
  pool.keep_best(2, std::vector<double>{1, 3, 3, 3});
  ASSERT_EQ(pool.size(), 2u);
  EXPECT_EQ(pool[0].viewpoint.region, 1u);
  EXPECT_EQ(pool[1].viewpoint.region, 2u);
}

/// The edges of a cycle of five: 3 rows are needed, 2.5 fractionally.
TEST(CoverPool, PricesBoundAFractionalCover) {
  CandidatePool pool(5);
  for (std::size_t i = 0; i < 5; ++i) {
    pool.add(candidate(BitRows::Word{1} << i | BitRows::Word{1} << (i + 1) % 5));
  }
  SearchLimits limits{CoverOptions()};
  const BitRows rows = pool.rows();
  const PoolCover cover = cover_pool(rows, {.nodes = 100}, 1, limits);
  EXPECT_EQ(cover.chosen.size(), 3u);
  EXPECT_EQ(cover.lower_bound, 3u);
  EXPECT_NEAR(cover.relaxation, 2.5, 1e-6);
  const ColumnWeights prices(cover.prices);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_LE(prices.of(rows.row(i)), 1 + 1e-6);
}

}  // namespace
}  // namespace viewcover
