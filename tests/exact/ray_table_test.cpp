#include "exact/ray_table.h"

#include <gtest/gtest.h>

#include "scene/random_numbers.h"

namespace viewcover::exact {
namespace {

using Components = std::array<BigInteger, 6>;

/// An integer of at most `bits` bits, of either sign.
std::int64_t random_integer(RandomNumbers& random, int bits) {
  const auto value = static_cast<std::int64_t>(random.below(std::uint64_t{1} << bits));
  return random.below(2) == 0 ? value : -value;
}

/// Lines and functionals whose products are as small as about one unit of their last component,
/// times a power of two: on both sides of what single precision can tell from 0.
TEST(RayTable, CertainSignsAreRight) {
  RandomNumbers random(7);
  ExactStatistics statistics;
  VectorPool<6> pool(statistics);
  int certain = 0, unsure = 0;
  for (int trial = 0; trial < 400; ++trial) {
    Components f;
    for (BigInteger& x : f) x = to_big(random_integer(random, 24) | 1);
    const LazyVector<6>* functional = pool.add(Role::kFunctional, f);
    RayTable<6> table;
    std::vector<int> expected;
    for (std::size_t place = 0; place < RayPlaces::kMost; ++place) {
      Components ray;
      BigInteger sum(0);
      for (std::size_t k = 0; k < 5; ++k) {
        ray[k] = to_big(random_integer(random, 30));
        sum += f[k] * ray[k];
      }
      ray[5] = -(sum / f[5]) + to_big(random_integer(random, static_cast<int>(place % 30) + 1));
      const LazyVector<6>* vector = pool.add(Role::kRay, ray);
      ASSERT_NE(vector, nullptr);
      table.set(place, vector->approximate());
      expected.push_back(sign(pool.exact_product(*functional, *vector)));
    }
    for (const int way : {1, -1}) {
      const KnownSigns signs = table.signs(RayTable<6>::row(*functional, way));
      for (std::size_t place = 0; place < RayPlaces::kMost; ++place) {
        const int found = signs.at(place);
        ++(found == 0 ? unsure : certain);
        if (found == 0) continue;
        ASSERT_EQ(found, way * expected[place]) << trial << ' ' << place;
      }
    }
  }
  EXPECT_GT(certain, 10'000);
  EXPECT_GT(unsure, 10'000);
}

TEST(RayTable, ForgetsWhatItHeld) {
  ExactStatistics statistics;
  VectorPool<3> pool(statistics);
  const auto vector = [&](Role role, int x, int y, int z) {
    return pool.add(role,
                    std::array<BigInteger, 3>{to_big(std::int64_t{x}), to_big(std::int64_t{y}),
                                              to_big(std::int64_t{z})});
  };
  RayTable<3> table;
  for (std::size_t place = 0; place < RayPlaces::kMost; ++place) {
    table.set(place, vector(Role::kRay, 1, 2, 3)->approximate());
  }
  const SingleRow<3> row = RayTable<3>::row(*vector(Role::kFunctional, 1, 1, 1), 1);
  EXPECT_EQ(table.signs(row).at_least_0, ~std::uint64_t{0});
  table.clear();
  table.set(5, vector(Role::kRay, -1, -2, -3)->approximate());
  EXPECT_EQ(table.signs(row).at_least_0, 0u);
  EXPECT_EQ(table.signs(row).at_most_0, std::uint64_t{1} << 5);
}

TEST(RayPlaces, RaysThatStayKeepTheirs) {
  const RayPlaces root(5);
  EXPECT_EQ(root.used(), 0b11111u);
  const std::vector<std::int8_t> signs = {1, -1, 0, -1, 1};
  const RayPlaces part = root.of_part(signs, 1, 3);
  // Rays 0, 2 and 4 stay, then three new ones.
  const std::vector<std::size_t> expected = {0, 2, 4, 1, 3, 5};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(part[i], expected[i]);
  EXPECT_EQ(part.used(), 0b111111u);
}

TEST(RayPlaces, ThereAre64) {
  const RayPlaces many(70);
  EXPECT_EQ(many.used(), ~std::uint64_t{0});
  EXPECT_EQ(many[63], 63u);
  EXPECT_EQ(many[64], RayPlaces::kMost);
  std::vector<std::int8_t> signs(70, 1);
  signs[3] = -1;
  const RayPlaces part = many.of_part(signs, 1, 2);
  EXPECT_EQ(part[69], 3u);  // new, where there is room again
  EXPECT_EQ(part[70], RayPlaces::kMost);
}

}  // namespace
}  // namespace viewcover::exact
