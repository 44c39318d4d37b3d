#include <gmock/gmock.h>

#include "bundle_files.h"

namespace viewcover::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// A box 4 x 4 x 3 whose ceiling is two rectangles; where they meet the wall at y = 0 the vertex is
/// 2^-9 too low, and nobody joined it to the wall.
constexpr const char* kCrackedRoom =
    "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 0 0 3\nv 4 0 3\nv 4 4 3\nv 0 4 3\n"
    "v 2 0 2.998046875\nv 2 4 3\n"
    "g floor\nf 1 2 3 4\ng wall\nf 1 5 6 2\nf 2 6 7 3\nf 3 7 8 4\nf 4 8 5 1\n"
    "g ceiling\nf 5 8 10 9\nf 9 10 7 6\n";
constexpr const char* kRegion = R"({"polygons": [[[1,1,1.5],[3,1,1.5],[3,3,1.5],[1,3,1.5]]]})";

class Inspect : public ::testing::Test {
 protected:
  Json inspected(std::vector<std::string> more) const {
    more.insert(more.begin(), "inspect");
    const Outcome outcome = viewcover_run(more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return Json::parse(last_line(outcome.out));
  }
  std::string room() const { return folder_.write("room.obj", kCrackedRoom).string(); }

  ScratchFolder folder_;
};

TEST_F(Inspect, FindsTheCrackAndWhatTheSceneIsLike) {
  const Json found = inspected({room(), "--width", "0.01"});
  EXPECT_EQ(found.at("size").at("faces"), 7);
  EXPECT_EQ(found.at("size").at("units_guess"), "metres");
  EXPECT_THAT(found.at("size").at("greatest_corner").get<std::vector<double>>(),
              ElementsAre(4, 4, 3));
  EXPECT_EQ(found.at("cracks").at("vertices_beside_edges"), 1);
  EXPECT_EQ(found.at("cracks").at("vertices_on_edges"), 1);
  EXPECT_EQ(found.at("cracks").at("widest"), 0.001953125);
  const Json& crack = found.at("cracks").at("listed").at(0);
  EXPECT_THAT(crack.at("place").get<std::vector<double>>(), ElementsAre(2, 0, 2.998046875));
  EXPECT_EQ(crack.at("face"), 2);
  EXPECT_EQ(crack.at("group"), "wall");
  EXPECT_EQ(found.at("surface").at("closed_pieces"), 0);
  EXPECT_EQ(found.at("far_out").at("vertices"), 0);
  EXPECT_EQ(inspected({room(), "--width", "0.001"}).at("cracks").at("vertices_beside_edges"), 0);

  const Outcome told = viewcover_run({"inspect", room(), "--width", "0.01"});
  EXPECT_THAT(
      told.out,
      HasSubstr("a crack 0.001953125 wide at [2.0,0.0,2.998046875] beside face 2 (\"wall\")"));
}

TEST_F(Inspect, FindsAVertexFarOut) {
  std::string text = kCrackedRoom;
  for (int i = 0; i < 30; ++i) text += "v 1 " + std::to_string(0.1 * i) + " 1\n";
  const std::string scene =
      folder_
          .write("far.obj", text + "g bird\nv 300000 0 0\nv 300001 0 0\nv 300000 1 0\nf 41 42 43\n")
          .string();
  const Json far = inspected({scene}).at("far_out");
  EXPECT_EQ(far.at("vertices"), 3);
  EXPECT_EQ(far.at("places").at(0), scene + ":52");
}

TEST_F(Inspect, SolveHealsTheCrackAndTheRunIsVerified) {
  const std::string region = folder_.write("region.json", kRegion).string(),
                    bundle = (folder_.path() / "bundle").string();
  const auto solved = [&](std::vector<std::string> more) {
    more.insert(more.begin(),
                {"solve", room(), "--region", region, "-o", bundle, "--regions", "4"});
    const Outcome outcome = viewcover_run(more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return run_json(bundle);
  };
  EXPECT_EQ(solved({}).at("scene").at("repairs").at("healed_edges"), 0);
  const Json healed = solved({"--heal", "0.01"});
  EXPECT_EQ(healed.at("scene").at("repairs").at("healed_edges"), 1);
  EXPECT_EQ(healed.at("options").at("heal"), 0.01);
  // The scene is read again, and healed again.
  const Outcome verified = viewcover_run({"verify", bundle});
  EXPECT_EQ(verified.exit_code, 0) << verified.error;
  EXPECT_EQ(viewcover_run({"audit", bundle, "--quiet"}).exit_code, 0);
}

TEST_F(Inspect, CropLeavesOutTheBirdAndTheRunIsVerified) {
  const std::string scene = folder_
                                .write("far.obj", std::string(kCrackedRoom) +
                                                      "g bird\nv 300000 0 0\nv 300001 0 0\n"
                                                      "v 300000 1 0\nf 11 12 13\n")
                                .string(),
                    region = folder_.write("region.json", kRegion).string(),
                    bundle = (folder_.path() / "bundle").string();
  const std::string warning = "face 8 ('bird') reaches 300001 from the origin";
  EXPECT_THAT(viewcover_run({"inspect", scene}).error, HasSubstr(warning));
  EXPECT_EQ(viewcover_run({"inspect", scene, "--quiet"}).error, "");
  EXPECT_EQ(inspected({scene}).at("size").at("lattice_step"), 0x1p-4);
  const Json cropped = inspected({scene, "--crop", "-1,-1,-1,5,5,5"});
  EXPECT_EQ(cropped.at("size").at("lattice_step"), 0x1p-20);
  EXPECT_EQ(cropped.at("repairs").at("cropped_faces"), 1);
  EXPECT_EQ(cropped.at("far_out").at("faces"), 0);

  const auto solve = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"solve", scene, "--region", region, "-o", bundle, "--regions", "4"});
    return viewcover_run(more);
  };
  EXPECT_THAT(solve({}).error, HasSubstr(warning));
  const Outcome solved = solve({"--crop", "5,5,5,-1,-1,-1"});
  ASSERT_EQ(solved.exit_code, 0) << solved.error;
  EXPECT_THAT(solved.error, HasSubstr("1 face left out by --crop"));
  EXPECT_THAT(solved.error, Not(HasSubstr(warning)));
  EXPECT_THAT(run_json(bundle).at("options").at("crop").get<std::vector<double>>(),
              ElementsAre(-1, -1, -1, 5, 5, 5));
  // The scene is read again, and cropped again.
  const Outcome verified = viewcover_run({"verify", bundle});
  EXPECT_EQ(verified.exit_code, 0) << verified.error;
  EXPECT_EQ(viewcover_run({"audit", bundle, "--quiet"}).exit_code, 0);

  const auto find_region = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"region", scene, "--height", "1.5", "-o",
                               (folder_.path() / "found.json").string()});
    return viewcover_run(more);
  };
  EXPECT_THAT(find_region({}).error, HasSubstr(warning));
  const Outcome found = find_region({"--crop", "-1,-1,-1,5,5,5"});
  EXPECT_EQ(found.exit_code, 0);
  EXPECT_NEAR(Json::parse(last_line(found.out)).at("area"), 16.0, 0.01);
}

TEST_F(Inspect, BadInputIsOneLine) {
  expect_refused(viewcover_run({"inspect"}), "SCENE: is missing");
  expect_refused(viewcover_run({"inspect", (folder_.path() / "none.obj").string()}), "none.obj");
  expect_refused(viewcover_run({"inspect", room(), "--width", "0"}), "--width");
  for (const char* box :
       {"1", "1,2,3", "0,0,0,1,1,1,1", "a,b,c,d,e,f", "0,0,0,1,1,nan", "9,9,9,10,10,10"}) {
    expect_refused(viewcover_run({"inspect", room(), "--crop", box}), "--crop: ");
  }
  const std::string region = folder_.write("region.json", kRegion).string();
  expect_refused(viewcover_run({"solve", room(), "--region", region, "-o",
                                (folder_.path() / "b").string(), "--heal", "-1"}),
                 "--heal");
}

}  // namespace
}  // namespace viewcover::testing
