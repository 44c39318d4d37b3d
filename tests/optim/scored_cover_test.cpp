#include "optim/scored_cover.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "optim/region_cover.h"
#include "reference_cover.h"

namespace viewcover {
namespace {

using Index = ScoredCover::Index;
using Score = ScoredCover::Score;

/// Compares everything with what the chosen rows and the matrix give.
void expect_consistent(const BitRows& matrix, const ScoredCover& cover) {
  std::vector<std::size_t> times(matrix.columns(), 0);
  for (const Index row : cover.chosen()) {
    ASSERT_TRUE(cover.contains(row));
    for_each_bit(matrix.row(row), [&](std::size_t column) { ++times[column]; });
  }
  Score uncovered_weight = 0;
  std::size_t uncovered = 0;
  for (Index column = 0; column < times.size(); ++column) {
    if (times[column] > 0) continue;
    ++uncovered;
    uncovered_weight += cover.weight(column);
  }
  ASSERT_EQ(cover.uncovered().size(), uncovered);
  for (const Index column : cover.uncovered()) ASSERT_EQ(times[column], 0u);
  ASSERT_EQ(cover.uncovered_weight(), uncovered_weight);
  for (Index row = 0; row < matrix.rows(); ++row) {
    Score score = 0;
    for_each_bit(matrix.row(row), [&](std::size_t column) {
      if (times[column] == (cover.contains(row) ? 1 : 0)) {
        score += cover.weight(static_cast<Index>(column));
      }
    });
    ASSERT_EQ(cover.score(row), score);
  }
}

TEST(ScoredCover, StaysConsistentUnderRandomChanges) {
  // Few rows that share many columns, and many rows that share few: scan and queue.
  std::size_t raises = 0, easiest_asked = 0;
  for (const std::size_t side : {4, 16}) {
    const reference::Room room = reference::furnished_room(side, side == 4 ? 300 : 40, 6, 1);
    const CoverInstance instance(room.matrix, room.weights);
    const BitRows& matrix = instance.rows();
    const Incidence lists(matrix);
    ScoredCover cover(lists, std::vector<Score>(matrix.columns(), 1));
    std::mt19937_64 random(7);
    Index newest = ~Index{0};
    for (int change = 0; change < 1500; ++change) {
      SCOPED_TRACE(change);
      const auto row = static_cast<Index>(random() % matrix.rows());
      if (!cover.contains(row)) {
        cover.add(row);
        newest = row;
      } else if (random() % 3 == 0) {
        cover.remove(row);
      }
      if (!cover.uncovered().empty() && random() % 4 == 0) {
        cover.raise(cover.uncovered()[random() % cover.uncovered().size()], 3);
        ++raises;
      }
      ASSERT_NO_FATAL_FAILURE(expect_consistent(matrix, cover));
      if (!cover.can_remove() || random() % 2 == 0) continue;
      const Index easiest = cover.easiest_to_remove();
      ASSERT_TRUE(cover.contains(easiest));
      ASSERT_NE(easiest, newest);
      for (const Index other : cover.chosen()) {
        if (other == newest) continue;
        ASSERT_LE(std::pair(cover.score(easiest), cover.moved_at(easiest)),
                  std::pair(cover.score(other), cover.moved_at(other)));
      }
      ++easiest_asked;
    }
  }
  EXPECT_GT(raises, 20u);
  EXPECT_GT(easiest_asked, 500u);
}

TEST(ScoredCover, NewWeightsGiveNewScores) {
  const reference::Room room = reference::furnished_room(4, 200, 4, 2);
  const CoverInstance instance(room.matrix, room.weights);
  const Incidence lists(instance.rows());
  ScoredCover cover(lists, std::vector<Score>(lists.column_count(), 1));
  for (const Index row : {1u, 5u, 9u}) cover.add(row);
  std::vector<Score> weights;
  for (std::size_t c = 0; c < lists.column_count(); ++c) {
    weights.push_back(1 + static_cast<Score>(c % 7));
  }
  cover.set_weights(weights);
  expect_consistent(instance.rows(), cover);
}

}  // namespace
}  // namespace viewcover
