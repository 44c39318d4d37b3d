#include <gmock/gmock.h>

#include "bundle_files.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;

class Region : public ::testing::Test {
 protected:
  Outcome region(std::vector<std::string> more, const std::string& file = "found.json") const {
    more.insert(more.begin(), {"region", room_.scene(), "-o", path(file)});
    return viewcover_run(more);
  }
  std::string path(const std::string& file) const { return (room_.path() / file).string(); }

  RoomFolder room_;
};

TEST_F(Region, OfTheLivingRoomCanBeSolved) {
  const Outcome found = region({"--height", "1.6", "--clearance", "0.2"});
  ASSERT_EQ(found.exit_code, 0) << found.error;
  const Json line = Json::parse(last_line(found.out));
  EXPECT_EQ(line.at("region"), path("found.json"));
  EXPECT_GT(line.at("area"), 10.0);
  const Json file = Json::parse(read_file(path("found.json")));
  ASSERT_EQ(file.at("polygons").size(), line.at("parts"));
  for (const Json& polygon : file.at("polygons")) {
    for (const Json& corner : polygon) EXPECT_NEAR(corner.at(2), 1.6, 1e-6);
  }
  const Outcome solved =
      viewcover_run({"solve", room_.scene(), "--region", path("found.json"), "--clearance", "0.2",
                     "--regions", "4", "--backend", "rays", "-o", path("bundle"), "--quiet"});
  EXPECT_EQ(solved.exit_code, 0) << solved.error;

  // The same bytes again; a place in the room gives the same region.
  const std::string text = read_file(path("found.json"));
  ASSERT_EQ(
      region({"--height", "1.6", "--clearance", "0.2", "--seed-point", "2.5,2,0"}, "again.json")
          .exit_code,
      0);
  EXPECT_EQ(text, read_file(path("again.json")));
}

TEST_F(Region, BadInputIsOneLineAndNoFile) {
  const auto refused = [&](std::vector<std::string> options, const std::string& reason) {
    expect_refused(region(std::move(options)), reason);
    EXPECT_FALSE(std::filesystem::exists(path("found.json")));
  };
  refused({}, "--height: is missing");
  refused({"--height", "eye"}, "--height: ");
  refused({"--height", "16"}, "--height: 16 is outside the scene");
  refused({"--height", "1.6", "--clearance", "5"}, "--height: no free space is left");
  refused({"--height", "1.6", "--clearance", "-1"}, "--clearance: ");
  refused({"--height", "1.6", "--up", "w"}, "--up w: ");
  for (const char* place : {"1,2", "1,2,3,4", "a,b,c", ","}) {
    refused({"--height", "1.6", "--seed-point", place}, "--seed-point: ");
  }
  refused({"--height", "1.6", "--seed-point", "99,99,0"}, "--seed-point: is outside the scene");
  expect_refused(
      viewcover_run({"region", path("nothing.obj"), "--height", "1", "-o", path("found.json")}),
      "nothing.obj");
  expect_refused(viewcover_run({"region", room_.scene(), "--height", "1.6"}),
                 "--output: is missing");
  expect_refused(viewcover_run({"region", room_.scene(), "--height", "1.6", "-o",
                                path("no/such/folder.json")}),
                 "no/such/folder.json");
}

}  // namespace
}  // namespace viewcover::testing
