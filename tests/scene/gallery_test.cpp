#include "scene/generate/gallery.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scene/error.h"
#include "scene/scratch_folder.h"
#include "support/generated.h"

namespace viewcover {
namespace {

using ::testing::HasSubstr;

class Gallery : public ::testing::Test {
 protected:
  GeneratedScene made(const std::string& text, double height = 1) {
    const auto file = folder_.write("plan.txt", text);
    return gallery(file, read_floor_plan(file), height);
  }
  void expect_refused(const std::string& text, const std::string& message) {
    SCOPED_TRACE(text);
    try {
      made(text);
      ADD_FAILURE() << "not refused";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
  }
  /// Area of the faces of a group, or of the region.
  static double area_of(const GeneratedScene& scene, const std::string& group) {
    double sum = 0;
    for (const GeneratedScene::Face& face : scene.faces) {
      if (scene.groups[face.group] != group) continue;
      std::vector<Point> corners;
      for (const std::uint32_t corner : face.corners) corners.push_back(scene.vertices[corner]);
      sum += area(corners);
    }
    return sum;
  }
  static double region_area(const GeneratedScene& scene) {
    double sum = 0;
    for (const auto& polygon : scene.region) sum += area(polygon);
    return sum;
  }

  ScratchFolder folder_;
};

// An L of area 3 with a square hole of side 1/4.
const std::string kEll = "0 0\n2 0\n2 1\n1 1\n1 2\n0 2\n";
const std::string kHole = "0.25 0.25\n0.5 0.25\n0.5 0.5\n0.25 0.5\n";

TEST_F(Gallery, HasWallsFloorAndCeiling) {
  const GeneratedScene scene = made(kEll, 2);
  EXPECT_EQ(scene.groups, (std::vector<std::string>{"wall", "floor", "ceiling"}));
  EXPECT_DOUBLE_EQ(area_of(scene, "wall"), 2 * 8);
  EXPECT_DOUBLE_EQ(area_of(scene, "floor"), 3);
  EXPECT_DOUBLE_EQ(area_of(scene, "ceiling"), 3);
  EXPECT_DOUBLE_EQ(region_area(scene), 3);
  for (const auto& polygon : scene.region) {
    for (const Point& corner : polygon) EXPECT_EQ(corner.z(), 1);
  }
}

TEST_F(Gallery, HolesAreWalledRoundAndOpenAbove) {
  for (const char* separator : {"\n", "hole\n", "\n# a pillar\nhole # here\n"}) {
    const GeneratedScene scene = made(kEll + separator + kHole);
    EXPECT_DOUBLE_EQ(area_of(scene, "wall"), 8 + 1);
    EXPECT_DOUBLE_EQ(area_of(scene, "floor"), 3 - 0.0625);
    EXPECT_DOUBLE_EQ(region_area(scene), 3 - 0.0625);
  }
}

TEST_F(Gallery, FrontsFaceInwardWhateverTheDirectionOfLoops) {
  // For fronts inward the flux of x through a closed surface is -3 volumes.
  const std::string clockwise = "0 2\n1 2\n1 1\n2 1\n2 0\n0 0\n";
  for (const std::string& text : {kEll + "\n" + kHole, clockwise + "\n" + kHole}) {
    const GeneratedScene scene = made(text);
    double flux = 0;
    for (const GeneratedScene::Face& face : scene.faces) {
      std::vector<Point> corners;
      for (const std::uint32_t corner : face.corners) corners.push_back(scene.vertices[corner]);
      flux += area_vector(corners).dot(corners[0]) / 2;
    }
    EXPECT_NEAR(flux, -3 * (3 - 0.0625), 1e-12);
  }
}

TEST_F(Gallery, LoadsWithoutRepairAndItsRegionIsFree) {
  // A star with 30 irrational corners and three pillars in it.
  std::string text;
  for (int i = 0; i < 30; ++i) {
    const double angle = 0.2094395 * i, radius = i % 2 == 0 ? 10 : 6.5;
    text += std::to_string(radius * std::cos(angle)) + " " +
            std::to_string(radius * std::sin(angle)) + "\n";
  }
  for (const char* pillar :
       {"-3 0\n-2 0.3\n-2.5 1\n", "2 1\n3.1 1\n3 2.2\n2 2\n", "0 -4\n1 -4\n0 -3\n"}) {
    text += "\n" + std::string(pillar);
  }
  const testing::LoadedScene loaded = testing::load_generated(made(text, 3.3), 4);
  EXPECT_FALSE(loaded.scene.repairs.any()) << loaded.scene.repairs.summary();
  EXPECT_EQ(loaded.scene.repairs.largest_move, 0);
}

TEST_F(Gallery, BadPlansAreRefusedWithTheirLine) {
  expect_refused("0 0\n1 0\n", "plan.txt:2: the loop that ends here");
  expect_refused("0 0\n1 0\n0 1\n\n2 2\n3 3\n", "plan.txt:6: the loop that ends here");
  expect_refused("# nothing\n", "has no corners");
  expect_refused("0 0\n1 0 0\n0 1\n", "plan.txt:2: '1 0 0'");
  expect_refused("0 0\n1 x\n0 1\n", "plan.txt:2: '1 x'");
  expect_refused("0 0\n1 1\n1 0\n0 1\n", "plan.txt:3: the edge from here meets that from line 1");
  expect_refused("0 0\n2 0\n1 0\n1 1\n", "meets");       // runs back
  expect_refused("0 0\n2 0\n2 2\n1 0\n0 2\n", "meets");  // touches itself
  expect_refused("0 0\n1 0\n1 0\n0 1\n", "meets");       // repeats a corner
  expect_refused(kEll + "\n3 3\n4 3\n4 4\n", "plan.txt:8: the hole is outside");
  expect_refused(kEll + "\n0.5 0.5\n3 0.5\n0.5 0.75\n", "meets");
  expect_refused(kEll + "\n" + kHole + "\n0.3 0.3\n0.4 0.3\n0.3 0.4\n", "is within another");
}

TEST_F(Gallery, ALastCornerMayRepeatTheFirst) {
  EXPECT_EQ(made("0 0\n1 0\n0 1\n0 0\n").faces.size(), 5u);
}

}  // namespace
}  // namespace viewcover
