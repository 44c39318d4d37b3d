#include "show/difference.h"

#include <gmock/gmock.h>

#include <random>

#include "made_run.h"
#include "scene/error.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

using Random = std::mt19937_64;

void subdivide(ElementAddress node, Random& random, std::vector<ElementAddress>& leaves) {
  if (node.level() == 3 || random() % 3 == 0) {
    leaves.push_back(node);
    return;
  }
  for (int digit = 0; digit < 4; ++digit) subdivide(node.child(digit), random, leaves);
}

/// Two surfaces, cut at random; regions see elements at random.
RunData random_run(Random& random) {
  RunData run = made_run({level(0, 8, 0, 8, 0), upright(0, 8, 0, 8, 8)}, {"a"},
                         {level(1, 2, 1, 2, 3), level(2, 3, 1, 2, 3)}, {{}, {}});
  run.bundle.elements.clear();
  for (std::size_t surface = 0; surface < 2; ++surface) {
    subdivide({SurfaceId(surface), 0, 0}, random, run.bundle.elements);
  }
  run.seen = BitRows(2, run.bundle.elements.size());
  for (std::size_t region = 0; region < 2; ++region) {
    for (std::size_t i = 0; i < run.bundle.elements.size(); ++i) {
      if (random() % 2 == 0) run.seen.set(region, i);
    }
  }
  return run;
}

TEST(ShownElements, AreTheCommonRefinementWithWhatTheRunsSay) {
  std::size_t finer_in_first = 0, finer_in_second = 0, missed = 0, excess = 0;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const RunData first = random_run(random), second = random_run(random);
    const ShownElements shown = shown_elements(first, second);
    std::size_t filled = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
      const ElementAddress piece = shown.addresses[i], a = first.bundle.elements[shown.first[i]],
                           b = second.bundle.elements[shown.second[i]];
      ASSERT_TRUE(a.contains(piece) && b.contains(piece));
      ASSERT_TRUE(piece == a || piece == b);
      ASSERT_TRUE(i == 0 || shown.addresses[i - 1] < piece);
      filled += std::size_t{64} >> (2 * piece.level());
      finer_in_first += a != b && piece == a;
      finer_in_second += a != b && piece == b;
      Difference expected;
      for (std::size_t region = 0; region < 2; ++region) {
        const bool in_first = first.seen.test(region, shown.first[i]),
                   in_second = second.seen.test(region, shown.second[i]);
        expected.missed += in_first && !in_second;
        expected.excess += !in_first && in_second;
      }
      ASSERT_EQ(shown.differences[i].missed, expected.missed);
      ASSERT_EQ(shown.differences[i].excess, expected.excess);
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

TEST(ShownElements, RefuseRunsOfOtherRegionsAndScenes) {
  const RunData run = made_run({level(0, 1, 0, 1, 0)}, {"a"}, {level(0, 1, 0, 1, 1)}, {{0}}),
                region = made_run({level(0, 1, 0, 1, 0)}, {"a"}, {level(0, 1, 0, 1, 2)}, {{0}}),
                scene = made_run({level(0, 2, 0, 1, 0)}, {"a"}, {level(0, 1, 0, 1, 1)}, {{0}});
  EXPECT_THAT([&] { shown_elements(run, region); },
              ThrowsMessage<InputError>(HasSubstr("different regions")));
  EXPECT_THAT([&] { shown_elements(run, scene); },
              ThrowsMessage<InputError>(HasSubstr("different scenes")));
}

}  // namespace
}  // namespace viewcover::testing
