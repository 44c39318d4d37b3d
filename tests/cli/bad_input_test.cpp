#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <sstream>

#include "bundle_files.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;

/// One line on standard error, nothing that looks like a result, exit code 2.
void expect_refused(const Outcome& outcome, const std::filesystem::path& bundle,
                    const std::string& mentioned) {
  testing::expect_refused(outcome, mentioned);
  EXPECT_THAT(outcome.error, ::testing::StartsWith("viewcover: "));
  EXPECT_THAT(outcome.error, ::testing::EndsWith("\n"));
  EXPECT_EQ(outcome.out, "");
  EXPECT_FALSE(is_complete(bundle));
}

class BadScene : public ::testing::Test {
 protected:
  void expect_scene_refused(const std::string& name, std::string_view content,
                            const std::string& mentioned) {
    SCOPED_TRACE(std::string(content.substr(0, 200)));
    const std::string scene = room_.write(name, content);
    expect_refused(
        viewcover_run({"solve", scene, "--region", room_.region(), "-o", room_.bundle()}),
        room_.bundle(), mentioned);
    EXPECT_FALSE(std::filesystem::exists(room_.bundle()));
  }

  RoomFolder room_;
};

TEST_F(BadScene, Missing) {
  expect_refused(viewcover_run({"solve", room_.bundle("none.obj"), "--region", room_.region(), "-o",
                                room_.bundle()}),
                 room_.bundle(), "none.obj");
  EXPECT_FALSE(std::filesystem::exists(room_.bundle()));
}

TEST_F(BadScene, Empty) {
  for (const char* name : {"empty.obj", "empty.off", "empty.ply", "empty.stl"}) {
    expect_scene_refused(name, "", name);
  }
}

TEST_F(BadScene, NoFaces) {
  expect_scene_refused("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "points.obj");
}

TEST_F(BadScene, CoordinatesThatAreNotFinite) {
  for (const char* number : {"nan", "inf", "-inf", "1e999"}) {
    expect_scene_refused("coordinates.obj",
                         std::string("v 0 0 0\nv 1 0 0\nv 0 ") + number + " 0\nf 1 2 3\n",
                         "coordinates.obj:3");
  }
}

TEST_F(BadScene, IndicesOutOfRange) {
  for (const char* face : {"f 1 2 4", "f 0 1 2", "f -4 1 2", "f 1 2 99999999999999999999"}) {
    expect_scene_refused("indices.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n") + face + "\n",
                         "indices.obj:4");
  }
}

TEST_F(BadScene, FacesWithTooFewCorners) {
  for (const char* face : {"f 1", "f 1 2"}) {
    expect_scene_refused("corners.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\n") + face + "\n",
                         "corners.obj:4");
  }
}

TEST_F(BadScene, UnknownSuffix) { expect_scene_refused("scene.doc", "v 0 0 0\n", "scene.doc"); }

TEST_F(BadScene, ADirectory) {
  expect_refused(viewcover_run({"solve", room_.path().string(), "--region", room_.region(), "-o",
                                room_.bundle()}),
                 room_.bundle(), room_.path().string());
}

class BadRegion : public BadScene {
 protected:
  void expect_region_refused(const std::string& name, std::string_view content,
                             const std::string& mentioned) {
    SCOPED_TRACE(std::string(content));
    const std::string region = room_.write(name, content);
    expect_refused(
        viewcover_run({"solve", room_.scene(), "--region", region, "-o", room_.bundle()}),
        room_.bundle(), mentioned);
    EXPECT_FALSE(std::filesystem::exists(room_.bundle()));
  }
};

TEST_F(BadRegion, MalformedOrEmpty) {
  expect_region_refused("region.json", "", "region.json");
  expect_region_refused("region.json", "{", "region.json");
  expect_region_refused("region.json", R"({"polygons": []})", "region.json");
  expect_region_refused("region.json", R"({"polygons": [[[0,0,0],[1,0,0]]]})", "region.json");
  expect_region_refused("region.json", R"({"polygons": [[[0,0,1],[1,0,1e999],[0,1,1]]]})",
                        "region.json");
}

TEST_F(BadRegion, Missing) {
  expect_refused(viewcover_run({"solve", room_.scene(), "--region", room_.bundle("none.json"), "-o",
                                room_.bundle()}),
                 room_.bundle(), "none.json");
}

TEST_F(BadRegion, OutsideEverything) {
  expect_region_refused("region.json",
                        R"({"polygons": [[[100,100,1],[101,100,1],[101,101,1],[100,101,1]]]})",
                        "region.json");
}

TEST_F(BadRegion, CutByGeometry) {
  expect_region_refused("region.json", R"({"polygons": [[[-1,-1,1],[9,-1,1],[9,9,1],[-1,9,1]]]})",
                        "region.json");
}

/// The six faces of [low, high]^3 as OBJ, corners numbered from `first`, seen from outside or
/// inside.
std::string cube(double low, double high, int first, bool from_outside) {
  std::ostringstream out;
  for (int corner = 0; corner < 8; ++corner) {
    out << "v";
    for (int axis = 0; axis < 3; ++axis) out << ' ' << ((corner >> axis & 1) != 0 ? high : low);
    out << '\n';
  }
  constexpr std::array<std::array<int, 4>, 6> kFaces = {
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  for (const std::array<int, 4>& face : kFaces) {
    out << "f";
    for (std::size_t i = 0; i < 4; ++i) out << ' ' << first + face[from_outside ? i : 3 - i];
    out << '\n';
  }
  return out.str();
}

TEST_F(BadRegion, InsideAnObject) {
  const std::string scene = room_.write("cube.obj", cube(0, 8, 1, false) + cube(3, 5, 9, true));
  const auto solve = [&](const std::string& low, const std::string& high) {
    const std::string region = room_.write(
        "region.json", "{\"polygons\": [[[" + low + "," + low + ",4],[" + high + "," + low +
                           ",4],[" + high + "," + high + ",4],[" + low + "," + high + ",4]]]}");
    return viewcover_run({"solve", scene, "--region", region, "--viewpoints", "none", "--quiet",
                          "-o", room_.bundle()});
  };
  expect_refused(solve("3.5", "4.5"), room_.bundle(), "region.json");
  EXPECT_EQ(solve("1", "2").exit_code, 0);
}

TEST(BadOptions, AreRefusedInOneLine) {
  const RoomFolder room;
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{"--regions", "63"}, "63"},
      {{"--regions", "0"}, "--regions"},
      {{"--regions", "-4"}, "--regions"},
      {{"--regions", "64x"}, "--regions"},
      {{"--regions", "99999999999999999999999"}, "--regions"},
      {{"--rays", "0"}, "--rays"},
      {{"--rays", "-1"}, "--rays"},
      {{"--rays", "1.5"}, "--rays"},
      {{"--rays", "99999999999"}, "--rays"},
      {{"--element-area", "0"}, "--element-area"},
      {{"--element-area", "-1"}, "--element-area"},
      {{"--element-area", "nan"}, "--element-area"},
      {{"--element-area", "inf"}, "--element-area"},
      {{"--element-area", "1e999"}, "--element-area"},
      {{"--element-area", "much"}, "--element-area"},
      {{"--element-area", "1e-12"}, "--element-area"},
      {{"--clearance", "-1"}, "--clearance"},
      {{"--clearance", "nan"}, "--clearance"},
      {{"--time-limit", "0"}, "--time-limit"},
      {{"--time-limit", "nan"}, "--time-limit"},
      {{"--threads", "0"}, "--threads"},
      {{"--threads", "many"}, "--threads"},
      {{"--seed", "-1"}, "--seed"},
      {{"--seed", "18446744073709551616"}, "--seed"},
      {{"--lattice", "1000000"}, "--lattice"},
      {{"--sampling", "halton"}, "use plain or stratified"},
      {{"--backend", "cells"}, "--backend cells: not in this version; use exact or rays"},
      {{"--optimizer", "magic"},
       "--optimizer magic: not in this version; use exact, local, sa, tabu or greedy"},
      {{"--viewpoints", "tabu"}, "--viewpoints tabu: not in this version; use sa or none"},
      {{"--viewpoints", "sa", "--close-gap", "-1"}, "--close-gap"},
      {{"--viewpoints", "sa", "--close-gap", "nan"}, "--close-gap"},
      {{"--viewpoints", "sa", "--close-gap", "5"}, "random rays prove no lower bound"},
      {{"--backend", "exact", "--close-gap", "5"}, "use it with --viewpoints sa"},
      {{"--coverage", "all"}, "--coverage all: not in this version; use elements or full"},
      {{"--viewpoints", "sa", "--coverage", "full"}, "use full with --backend exact"},
      {{"--backend", "exact", "--coverage", "full"}, "use it with --viewpoints sa"},
      {{"--missed-share", "0.1"}, "use it with --coverage full"},
      {{"--missed-share", "-1"}, "--missed-share"},
      {{"--no-such-option"}, "--no-such-option"},
      {{"--rays"}, "--rays"},
      {{"surplus"}, "surplus"},
  };
  for (const auto& [options, mentioned] : cases) {
    SCOPED_TRACE(::testing::PrintToString(options));
    expect_refused(room.solve("bundle", options), room.bundle(), mentioned);
  }
}

TEST(BadOptions, MissingOnesAreNamed) {
  const RoomFolder room;
  expect_refused(viewcover_run({}), room.bundle(), "");
  expect_refused(viewcover_run({"solve"}), room.bundle(), "SCENE");
  expect_refused(viewcover_run({"solve", room.scene(), "-o", room.bundle()}), room.bundle(),
                 "--region");
  expect_refused(viewcover_run({"solve", room.scene(), "--region", room.region()}), room.bundle(),
                 "--output");
  expect_refused(viewcover_run({"guess"}), room.bundle(), "guess");
}

TEST(BadOutput, AFolderThatCannotBeMade) {
  // Permissions do not bind root; a path below a regular file binds everybody.
  const RoomFolder room;
  const Outcome outcome = room.solve("room.obj/bundle");
  expect_refused(outcome, room.bundle("room.obj/bundle"), "room.obj/bundle");
  expect_refused(viewcover_run({"solve", room.scene(), "--region", room.region(), "-o",
                                "/proc/viewcover-bundle"}),
                 "/proc/viewcover-bundle", "/proc/viewcover-bundle");
}

TEST(BadOutput, AFileInTheWayOfAFolder) {
  const RoomFolder room;
  const std::string file = room.write("bundle", "mine");
  expect_refused(room.solve("bundle"), "", file);
  EXPECT_EQ(read_file(file), "mine");
}

TEST(BadOutput, AFullDiskLeavesNoFinishedBundle) {
  const RoomFolder room;
  // Room for run.json and the smaller tables, then for less and less.
  for (const rlim_t bytes : {100'000, 10'000, 1000}) {
    SCOPED_TRACE(bytes);
    const Outcome outcome = room.solve("bundle", {"--quiet"}, {.file_bytes = bytes});
    expect_refused(outcome, room.bundle(), "File too large");
  }
}

TEST(BadOutput, AFullDiskMakesAnOldBundleIncompleteOrLeavesItWhole) {
  const RoomFolder room;
  ASSERT_EQ(room.solve("bundle", {"--quiet"}).exit_code, 0);
  const auto before = comparable_files(room.bundle());
  // No room for run.json: nothing may change.
  EXPECT_EQ(room.solve("bundle", {"--quiet", "--seed", "2"}, {.file_bytes = 1000}).exit_code, 2);
  EXPECT_EQ(comparable_files(room.bundle()), before);
  // Room for run.json, but not for all tables.
  EXPECT_EQ(room.solve("bundle", {"--quiet", "--seed", "2"}, {.file_bytes = 100'000}).exit_code, 2);
  EXPECT_FALSE(is_complete(room.bundle()));
}

}  // namespace
}  // namespace viewcover::testing
