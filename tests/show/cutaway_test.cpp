#include "show/cutaway.h"

#include <gmock/gmock.h>

#include "support/made_run.h"

namespace viewcover::testing {
namespace {

/// A floor, a ceiling, a wall to the south and a table in a room, faces turned inwards (the table's
/// up), and a region above the table.
class Cutaway : public ::testing::Test {
 protected:
  static ConvexPolygon reversed(ConvexPolygon polygon) {
    std::reverse(polygon.begin(), polygon.end());
    return polygon;
  }
  std::vector<bool> cut_from(const Point& camera, bool turn_round = false) const {
    std::vector<ConvexPolygon> surfaces = {level(0, 4, 0, 4, 0), reversed(level(0, 4, 0, 4, 3)),
                                           reversed(upright(0, 4, 0, 3, 0)), level(1, 2, 1, 2, 1)};
    if (turn_round) {
      for (ConvexPolygon& surface : surfaces) surface = reversed(surface);
    }
    const RunData run = made_run(surfaces, {"room"}, {level(1, 3, 1, 3, 1.5)}, {{}});
    std::vector<bool> cut;
    for (const CutPlane& plane : cut_planes(run.bundle.scene, run.region_pictures())) {
      cut.push_back(plane.cuts(camera));
    }
    return cut;
  }
};

TEST_F(Cutaway, TakesAwayCeilingAndNearWall) {
  EXPECT_EQ(cut_from({2, -5, 8}), (std::vector<bool>{false, true, true, false}));
}
TEST_F(Cutaway, FromBelowTakesAwayTheFloor) {
  EXPECT_EQ(cut_from({2, 9, -5}), (std::vector<bool>{true, false, false, true}));
}
TEST_F(Cutaway, TheRoomsHullIsFoundWhicheverWayFacesTurn) {
  EXPECT_EQ(cut_from({2, -5, 8}, true), (std::vector<bool>{false, true, true, false}));
}
TEST_F(Cutaway, FromInsideNothingIsCut) {
  EXPECT_EQ(cut_from({2, 2, 1.5}), (std::vector<bool>{false, false, false, false}));
}

}  // namespace
}  // namespace viewcover::testing
