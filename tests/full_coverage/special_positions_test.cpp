#include "full_coverage/special_positions.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "viewpoints/solved_scene.h"

namespace viewcover::testing {
namespace {

/// A box, and three surfaces beside it whose planes x = 1.5, y = 0.75 and z + x = 2.75 cut it.
SolvedScene planes_through_a_box() {
  const std::vector<ConvexPolygon> polygons = {
      {{1.5, 4, 0}, {1.5, 6, 0}, {1.5, 6, 2}, {1.5, 4, 2}},
      {{4, 0.75, 0}, {6, 0.75, 0}, {6, 0.75, 2}, {4, 0.75, 2}},
      {{0, 4, 2.75}, {1, 4, 1.75}, {1, 6, 1.75}, {0, 6, 2.75}}};
  const Box box(Point(0, 0, 0), Point(2, 2, 2));
  return SolvedScene(scene_of(polygons), make_viewing_region({}, {box}, 0), 100);
}

bool has_near(const std::vector<Viewpoint>& positions, const Point& place) {
  return std::ranges::any_of(positions, [&](const Viewpoint& viewpoint) {
    return (viewpoint.position - place).norm() < 1e-4;
  });
}

TEST(SpecialPositions, OfABoxAreOnPlanesTheirCommonLinesAndCrossings) {
  const SolvedScene solved = planes_through_a_box();
  const SpecialPositions special(solved.views);
  const Point from(1.375, 0.625, 1.25);
  const std::vector<Viewpoint> near = special.near({from, 0});
  EXPECT_TRUE(has_near(near, {1.5, 0.625, 1.25}));
  EXPECT_TRUE(has_near(near, {1.375, 0.75, 1.25}));
  EXPECT_TRUE(has_near(near, {1.4375, 0.625, 1.3125}));
  EXPECT_TRUE(has_near(near, {1.5, 0.75, 1.25})) << "a common line";
  EXPECT_TRUE(has_near(near, {1.4375, 0.75, 1.3125})) << "the third";
  EXPECT_TRUE(has_near(special.near({{1.375, 0.625, 1.125}, 0}), {1.5, 0.75, 1.25}))
      << "the crossing of all three";
  for (std::size_t i = 1; i < near.size(); ++i) {
    EXPECT_LE((near[i - 1].position - from).norm(), (near[i].position - from).norm() + 1e-4);
  }
}

TEST(SpecialPositions, OfABoxAreItsCornersAndAllRoundAPosition) {
  const SolvedScene solved = planes_through_a_box();
  const SpecialPositions special(solved.views);
  EXPECT_EQ(special.corners().size(), 8u);
  for (const double z : {0, 2}) EXPECT_TRUE(has_near(special.corners(), {2, 0, z}));
  const Point middle(1, 1, 1);
  std::set<std::array<bool, 3>> octants;
  for (const Viewpoint& viewpoint : special.beside({middle, 0})) {
    const Point d = viewpoint.position - middle;
    EXPECT_LT(d.norm(), 1e-4);
    octants.insert({d.x() > 0, d.y() > 0, d.z() > 0});
  }
  EXPECT_EQ(octants.size(), 8u);
}

}  // namespace
}  // namespace viewcover::testing
