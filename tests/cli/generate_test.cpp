#include <gmock/gmock.h>

#include <algorithm>

#include "bundle_files.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;

std::size_t faces_in(const std::string& file) {
  std::istringstream in(read_file(file));
  std::size_t faces = 0;
  for (std::string line; std::getline(in, line);) faces += line.starts_with("f ");
  return faces;
}

TEST(Generate, LivingRoomsHaveTheirPolygons) {
  const ScratchFolder folder;
  const std::string file = folder.path() / "room.obj";
  for (const auto& [detail, faces] : {std::pair{"simple", 316u}, {"complex", 1228u}}) {
    ASSERT_EQ(viewcover_run({"generate", "living-room", "--detail", detail, "-o", file}).exit_code,
              0);
    EXPECT_EQ(faces_in(file), faces);
    EXPECT_TRUE(Json::parse(read_file(folder.path() / "room.region.json")).contains("polygons"));
  }
}

TEST(Generate, SameSeedSameBytes) {
  const ScratchFolder folder;
  const auto soup = [&](const std::string& name, const std::string& seed) {
    const std::string file = folder.path() / name;
    EXPECT_EQ(viewcover_run({"generate", "soup", "--triangles", "200", "--seed", seed, "-o", file})
                  .exit_code,
              0);
    EXPECT_EQ(faces_in(file), 200u);
    return read_file(file);
  };
  EXPECT_EQ(soup("a.obj", "5"), soup("b.obj", "5"));
  EXPECT_NE(soup("a.obj", "5"), soup("c.obj", "6"));
}

TEST(Generate, EveryListedAnalyticSceneSolves) {
  const ScratchFolder folder;
  const Outcome list = viewcover_run({"generate", "analytic", "--list"});
  ASSERT_EQ(list.exit_code, 0);
  std::istringstream in(list.out);
  std::size_t scenes = 0;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(' ')) continue;
    const std::string name = line.substr(0, line.find(':'));
    SCOPED_TRACE(name);
    const std::string file = folder.path() / "scene.obj";
    const Outcome outcome = viewcover_run({"generate", "analytic", name, "-o", file});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    EXPECT_EQ(viewcover_run({"solve", file, "--region", folder.path() / "scene.region.json",
                             "--regions", "4", "--quiet", "-o", folder.path() / "bundle"})
                  .exit_code,
              0);
    ++scenes;
  }
  EXPECT_GE(scenes, 6u);
}

TEST(Generate, RefusesBadOptionsInOneLine) {
  const ScratchFolder folder;
  const std::string file = folder.path() / "scene.obj";
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"generate"}, "subcommand"},
      {{"generate", "castle", "-o", file}, "castle"},
      {{"generate", "living-room"}, "--output"},
      {{"generate", "living-room", "--detail", "baroque", "-o", file}, "--detail"},
      {{"generate", "analytic", "no-such", "-o", file}, "no-such"},
      {{"generate", "soup", "-o", file}, "--triangles"},
      {{"generate", "soup", "--triangles", "0", "-o", file}, "--triangles"},
      {{"generate", "soup", "--triangles", "-5", "-o", file}, "--triangles"},
      {{"generate", "soup", "--triangles", "9", "--seed", "x", "-o", file}, "--seed"},
      {{"generate", "soup", "--triangles", "9", "-o", "/proc/none/scene.obj"}, "/proc/none"},
  };
  for (const auto& [arguments, mentioned] : cases) {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    const Outcome outcome = viewcover_run(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.error, ::testing::StartsWith("viewcover: "));
    EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
    EXPECT_THAT(outcome.error, HasSubstr(mentioned));
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(std::filesystem::exists(file));
  }
}

TEST(CommandLine, HelpAndVersion) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--help"},
                                             {"solve", "--help"},
                                             {"generate", "--help"},
                                             {"generate", "living-room", "--help"},
                                             {"generate", "analytic", "--help"},
                                             {"generate", "soup", "--help"}}) {
    const Outcome outcome = viewcover_run(arguments);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, HasSubstr("--help"));
    EXPECT_EQ(outcome.error, "");
  }
  const Outcome version = viewcover_run({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, ::testing::StartsWith("viewcover "));
}

TEST(Generate, GalleriesSolveWithOneRegionWhereOneSeesAll) {
  const ScratchFolder folder;
  const std::string plan = folder.write("plan.txt", "0 0\n4 0\n4 3\n0 3\n").string(),
                    scene = folder.path() / "gallery.obj";
  const Outcome outcome =
      viewcover_run({"generate", "gallery", plan, "--height", "2", "-o", scene});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(faces_in(scene), 6u);
  const Outcome solved =
      viewcover_run({"solve", scene, "--region", folder.path() / "gallery.region.json", "--regions",
                     "4", "-o", folder.path() / "bundle"});
  ASSERT_EQ(solved.exit_code, 0) << solved.error;
  EXPECT_EQ(Json::parse(last_line(solved.out)).at("optimal_regions"), 1);
  for (const std::vector<std::string>& more :
       {std::vector<std::string>{"--height", "0"}, {"--height", "1e-9"}}) {
    std::vector<std::string> arguments = {"generate", "gallery", plan, "-o", scene};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome refused = viewcover_run(arguments);
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_THAT(refused.error, HasSubstr("--height"));
  }
  EXPECT_EQ(viewcover_run({"generate", "gallery", "-o", scene}).exit_code, 2);
  EXPECT_EQ(
      viewcover_run({"generate", "gallery", folder.path() / "none.txt", "-o", scene}).exit_code, 2);
}

}  // namespace
}  // namespace viewcover::testing
