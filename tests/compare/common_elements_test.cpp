#include "compare/common_elements.h"

#include <gmock/gmock.h>

#include "random_run.h"
#include "scene/error.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(CommonElements, AreTheCommonRefinementWithWhatTheRunsSay) {
  std::size_t finer_in_first = 0, finer_in_second = 0, missed = 0, excess = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const RunData first = random_run(random), second = random_run(random);
    const CommonElements common = common_elements(first, second, "B");
    std::size_t filled = 0;
    for (std::size_t i = 0; i < common.size(); ++i) {
      const ElementAddress piece = common.addresses[i], a = first.bundle.elements[common.first[i]],
                           b = second.bundle.elements[common.second[i]];
      ASSERT_TRUE(a.contains(piece) && b.contains(piece));
      ASSERT_TRUE(piece == a || piece == b);
      ASSERT_TRUE(i == 0 || common.addresses[i - 1] < piece);
      filled += std::size_t{64} >> (2 * piece.level());
      finer_in_first += a != b && piece == a;
      finer_in_second += a != b && piece == b;
      Difference expected;
      for (std::size_t region = 0; region < 2; ++region) {
        const bool in_first = first.seen.test(region, common.first[i]),
                   in_second = second.seen.test(region, common.second[i]);
        expected.missed += in_first && !in_second;
        expected.excess += !in_first && in_second;
      }
      ASSERT_EQ(common.differences[i].missed, expected.missed);
      ASSERT_EQ(common.differences[i].excess, expected.excess);
      missed += expected.missed;
      excess += expected.excess;
    }
    ASSERT_EQ(filled, 2 * 64u);  // both surfaces, counted in the smallest elements
  }
  EXPECT_GT(finer_in_first, 100u);
  EXPECT_GT(finer_in_second, 100u);
  EXPECT_GT(missed, 100u);
  EXPECT_GT(excess, 100u);
}

TEST(CommonElements, RefuseRunsOfOtherRegionsAndScenes) {
  const RunData run = made_run({level(0, 1, 0, 1, 0)}, {"a"}, {level(0, 1, 0, 1, 1)}, {{0}}),
                region = made_run({level(0, 1, 0, 1, 0)}, {"a"}, {level(0, 1, 0, 1, 2)}, {{0}}),
                scene = made_run({level(0, 2, 0, 1, 0)}, {"a"}, {level(0, 1, 0, 1, 1)}, {{0}});
  EXPECT_THAT([&] { common_elements(run, region, "B"); },
              ThrowsMessage<InputError>(HasSubstr("B: the runs have different regions")));
  EXPECT_THAT([&] { common_elements(run, scene, "B"); },
              ThrowsMessage<InputError>(HasSubstr("different scenes")));
}

}  // namespace
}  // namespace viewcover::testing
