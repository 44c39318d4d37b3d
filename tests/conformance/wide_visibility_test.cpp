// What is seen only through gaps that are narrower than some width, marked by every backend.

#include "links/wide_visibility.h"

#include <gtest/gtest.h>

#include "exact/exact_backend.h"
#include "support/sanitized.h"
#include "support/scenes.h"

namespace viewcover {
namespace {

using testing::scene_of;

/// The rectangle [y0, y1] x [z0, z1] at x.
ConvexPolygon upright(double x, double y0, double y1, double z0, double z1) {
  return {{x, y0, z0}, {x, y1, z0}, {x, y1, z1}, {x, y0, z1}};
}

constexpr double kSlit = 1.0 / 128;

/// A wall with a slit at x = 0; a region and a target on each side of it.
struct SlitWall {
  Scene scene = scene_of(std::vector{upright(0, 0, 4, 0, 1), upright(0, 0, 4, 1 + kSlit, 2),
                                     upright(-2, 1.5, 2.5, 0.5, 1.5),
                                     upright(0.5, 1.75, 2.25, 0.875, 1.125)});
  ViewingRegion region;
  ClusterTree clusters{scene};
  RefineOptions options{.element_area = 10};
  ExactBackend backend{1};
  VisibilityMatrix matrix;

  SlitWall() {
    region.parts = {testing::horizontal(-1.5, 1.5, -1, 2.5, 1),
                    testing::horizontal(0.125, 1.5, 0.25, 2.5, 1)};
    see();
  }
  void see() {
    clusters = ClusterTree(scene);
    matrix =
        make_visibility_matrix(scene, region, refine(scene, clusters, region, backend, options));
  }
  WideVisibility wide(double width) const {
    return find_wide_visibility(scene, region, matrix, backend, options, width);
  }
};

TEST(WideVisibility, WhatIsSeenThroughNarrowGapsOnlyIsLeftOut) {
  const SlitWall wall;
  ASSERT_EQ(wall.matrix.elements.size(), 4u);
  const auto expect_seen = [&](const BitRows& bits, bool through_slit) {
    for (std::size_t column : {0, 1}) {  // the wall itself
      EXPECT_TRUE(bits.test(0, column));
      EXPECT_TRUE(bits.test(1, column));
    }
    EXPECT_TRUE(bits.test(0, 2));
    EXPECT_TRUE(bits.test(1, 3));
    EXPECT_EQ(bits.test(0, 3), through_slit);
    EXPECT_EQ(bits.test(1, 2), through_slit);
  };
  expect_seen(wall.matrix.bits, true);
  expect_seen(wall.wide(kSlit).bits, true);
  EXPECT_TRUE(wall.wide(kSlit).gaps.empty());
  expect_seen(wall.wide(1.5 * kSlit).bits, false);
}

TEST(WideVisibility, ALinkIsNarrowWhereNothingItJoinsIsSeenOtherwise) {
  const SlitWall wall;
  const LinkSet links = refine(wall.scene, wall.clusters, wall.region, wall.backend, wall.options);
  const WideVisibility wide = wall.wide(1.5 * kSlit);
  std::size_t narrow = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link link = links[i];
    const std::size_t row = link.region.owner().value, surface = link.element.owner().value;
    const bool expected = (row == 0 && surface == 3) || (row == 1 && surface == 2);
    EXPECT_EQ(is_narrow(link, wall.region, wall.matrix, wide), expected) << row << ' ' << surface;
    narrow += expected ? 1 : 0;
  }
  EXPECT_EQ(narrow, 2u);
}

TEST(WideVisibility, AnOpeningBesideTheGapKeepsTheViewWide) {
  SlitWall wall;
  // A window in the upper part of the wall: what is beside, above and below it is left.
  wall.scene = scene_of(std::vector{
      upright(0, 0, 4, 0, 1), upright(0, 0, 1.75, 1 + kSlit, 2), upright(0, 2.25, 4, 1 + kSlit, 2),
      upright(0, 1.75, 2.25, 1.5, 2), upright(0, 1.75, 2.25, 1 + kSlit, 1.0625),
      upright(-2, 1.5, 2.5, 0.5, 1.5), upright(0.5, 1.75, 2.25, 0.875, 1.125)});
  wall.see();
  const WideVisibility wide = wall.wide(1.5 * kSlit);
  EXPECT_FALSE(wide.gaps.empty());
  EXPECT_TRUE(wall.matrix.bits.test(0, 6));
  EXPECT_TRUE(wide.bits.test(0, 6));
}

// Its two long edges are near to each other, but what joins them is the surface itself.
TEST(WideVisibility, AThinSurfaceIsNoGap) {
  SlitWall wall;
  const auto slanted = [](double x0, double x1, double y0, double y1) {
    return ConvexPolygon{{x0, y0, x0 / 2}, {x1, y0, x1 / 2}, {x1, y1, x1 / 2}, {x0, y1, x0 / 2}};
  };
  // No edge of the strip is one of its neighbours'.
  wall.scene = scene_of(std::vector{slanted(-1, 0, -1, 0.5), slanted(-1, 0, 0.5, 2),
                                    slanted(0, kSlit, -1, 2), slanted(kSlit, 1, -1, 2)});
  wall.region = testing::region_of(testing::horizontal(-1, 0, 1, 1, 2), 1);
  wall.see();
  const WideVisibility wide = wall.wide(1.5 * kSlit);
  EXPECT_TRUE(wide.gaps.empty());
  EXPECT_EQ(count_in_columns(wall.matrix.bits), std::vector<std::uint32_t>(4, 4));
  EXPECT_EQ(count_in_columns(wide.bits), std::vector<std::uint32_t>(4, 4));
}

// Through a wedge between two boards, with neither of them in the way: the element is whole as long
// as the wedge is open, and seen in part where its narrow end is closed.
TEST(WideVisibility, APartOfAnElementIsEnough) {
  SlitWall wall;
  const double middle = 1.0 / 64, half = 1.0 / 1024;
  wall.scene = scene_of(std::vector<ConvexPolygon>{
      {{-1, 0, 0}, {middle - 2 * half, 0, 0}, {middle - 16 * half, 1, 0}, {-1, 1, 0}},
      {{middle + 2 * half, 0, 0}, {1, 0, 0}, {1, 1, 0}, {middle + 16 * half, 1, 0}},
      testing::horizontal(middle - half, 0, middle + half, 1, -1)});
  wall.region = testing::region_of(testing::horizontal(middle - half, 0, middle + half, 1, 1), 0);
  wall.options.element_area = 1e-4;
  wall.see();
  const WideVisibility wide = wall.wide(16 * half);
  EXPECT_FALSE(wide.gaps.empty());
  const std::size_t element = wall.matrix.elements.size() - 1;
  ASSERT_EQ(wall.matrix.elements[element], ElementAddress(SurfaceId(2)));
  EXPECT_TRUE(wall.matrix.bits.test(0, element));
  EXPECT_TRUE(wide.bits.test(0, element));
  EXPECT_FALSE(wall.wide(64 * half).bits.test(0, element));
}

TEST(WideVisibility, GapsThatTheRegionPassesThroughStayOpen) {
  SlitWall wall;
  wall.region.parts[0] = testing::horizontal(-1, 1.5, 0.125, 2.5, 1 + kSlit / 2);
  wall.see();
  const WideVisibility wide = wall.wide(1.5 * kSlit);
  EXPECT_GT(wide.gaps_entered, 0u);
  EXPECT_TRUE(wide.bits.test(0, 3));
}

// Whatever the elements of the second look are.
TEST(WideVisibility, HasNothingThatTheMatrixLacks) {
  std::mt19937_64 random(3);
  std::size_t narrow = 0;
  for (int round = 0; round < (testing::sanitized() ? 1 : 6); ++round) {
    const Scene scene = scene_of(testing::random_triangles(60, 0.25, 0, 1, random));
    const ViewingRegion region = testing::region_of(testing::horizontal(0, 0, 1, 1, 1.5), 1);
    const ClusterTree clusters(scene);
    const ExactBackend backend(1);
    const RefineOptions options{.element_area = 0.01};
    const VisibilityMatrix matrix =
        make_visibility_matrix(scene, region, refine(scene, clusters, region, backend, options));
    for (const double width : {0.02, 0.05}) {
      const WideVisibility wide =
          find_wide_visibility(scene, region, matrix, backend, options, width);
      for (std::size_t row = 0; row < matrix.bits.rows(); ++row) {
        for_each_bit(wide.bits.row(row),
                     [&](std::size_t column) { EXPECT_TRUE(matrix.bits.test(row, column)); });
        narrow += count_bits(matrix.bits.row(row)) - count_bits(wide.bits.row(row));
      }
    }
  }
  EXPECT_GT(narrow, 0u);
}

}  // namespace
}  // namespace viewcover
