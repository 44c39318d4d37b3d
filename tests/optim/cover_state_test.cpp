#include "optim/cover_state.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "reference_cover.h"

namespace viewcover {
namespace {

TEST(CoverState, StaysConsistentUnderRandomChanges) {
  const reference::Room room = reference::furnished_room(8, 300, 6, 1);
  const CoverInstance instance(room.matrix, room.weights);
  CoverState state(instance);
  std::mt19937_64 random(7);
  std::size_t additions = 0, removals = 0;
  for (int change = 0; change < 2000; ++change) {
    SCOPED_TRACE(change);
    const std::size_t row = random() % state.row_count();
    const CoverState::Benefit before = state.benefit();
    if (state.contains(row)) {
      const CoverState::Benefit loss = state.loss(row);
      state.remove(row);
      ASSERT_EQ(state.benefit(), before - loss);
      ++removals;
    } else {
      const CoverState::Benefit gain = state.gain(row);
      state.add(row);
      ASSERT_EQ(state.benefit(), before + gain);
      ++additions;
    }
    ASSERT_TRUE(state.check_consistency());
  }
  EXPECT_GT(additions, 500u);
  EXPECT_GT(removals, 500u);
}

TEST(CoverState, ForeseesExchanges) {
  const reference::Room room = reference::furnished_room(8, 300, 6, 2);
  const CoverInstance instance(room.matrix, room.weights);
  CoverState state(instance);
  state.assign(std::vector<std::size_t>{3, 20, 41, 60});
  std::mt19937_64 random(3);
  for (int exchange = 0; exchange < 500; ++exchange) {
    SCOPED_TRACE(exchange);
    const std::vector<std::size_t> chosen = state.chosen();
    const std::size_t out = chosen[random() % chosen.size()];
    const std::size_t in = random() % state.row_count();
    if (state.contains(in)) continue;
    const CoverState::Benefit expected =
        state.benefit() + state.gain_without(in, out) - state.loss(out);
    state.remove(out);
    state.add(in);
    ASSERT_EQ(state.benefit(), expected);
  }
  EXPECT_TRUE(state.check_consistency());
}

TEST(CoverState, AssignReplacesTheChosenRows) {
  const reference::Room room = reference::furnished_room(4, 100, 4, 3);
  const CoverInstance instance(room.matrix, room.weights);
  CoverState state(instance);
  state.assign(std::vector<std::size_t>{1, 2, 3});
  state.assign(std::vector<std::size_t>{9, 2});
  EXPECT_THAT(state.chosen(), ::testing::ElementsAre(2, 9));
  EXPECT_TRUE(state.check_consistency());
}

TEST(CoverState, ColumnsWithoutWeightStillCount) {
  BitRows matrix(2, 3);
  matrix.set(0, 0);
  matrix.set(1, 1);
  const CoverInstance instance(matrix, std::vector<double>{1, 0, 5});
  CoverState state(instance);
  state.add(0);
  EXPECT_FALSE(state.covers_all());
  EXPECT_GT(state.gain(1), 0);
  state.add(1);
  EXPECT_TRUE(state.covers_all());
  EXPECT_EQ(state.benefit(), state.total());
}

TEST(CoverState, CountsEvaluations) {
  const reference::Room room = reference::furnished_room(4, 100, 4, 4);
  const CoverInstance instance(room.matrix, room.weights);
  CoverState state(instance);
  state.add(0);
  state.gain(1);
  state.gain_without(2, 0);
  EXPECT_EQ(state.evaluations(), 2u);
}

}  // namespace
}  // namespace viewcover
