#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "scene/error.h"
#include "scene/made_scene.h"
#include "scene/scene.h"
#include "scene/viewing_region.h"

namespace viewcover {
namespace {

using testing::HasSubstr;

// The message for a region of these parts; empty if it is free.
std::string refusal(const Scene& scene, std::vector<ConvexPolygon> parts,
                    const RegionCheck& check = {}) {
  ViewingRegion region;
  region.parts = std::move(parts);
  try {
    check_region_is_free("region.json", scene, region, check);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

ConvexPolygon rectangle(double x0, double y0, double x1, double y1, double z) {
  return {{x0, y0, z}, {x1, y0, z}, {x1, y1, z}, {x0, y1, z}};
}

const std::vector<ConvexPolygon> kRoom = reversed(box_outward({0, 0, 0}, {100, 100, 50}));
const std::vector<ConvexPolygon> kTable = box_outward({20, 20, 0}, {40, 60, 10});

// One face of six turned round.
std::vector<ConvexPolygon> mixed(std::vector<ConvexPolygon> faces) {
  faces[2] = reversed({faces[2]})[0];
  return faces;
}

TEST(RegionCheck, FreeRegionIsAccepted) {
  const Scene scene = made_scene({{"room", kRoom}, {"table", kTable}});
  EXPECT_EQ(refusal(scene, {rectangle(10, 10, 90, 90, 30)}), "");
  EXPECT_EQ(refusal(scene, {rectangle(50, 10, 90, 90, 5), rectangle(1, 1, 19, 99, 5)}), "");
}

TEST(RegionCheck, TouchingIsAllowed) {
  const Scene scene = made_scene({{"room", kRoom}, {"table", kTable}});
  EXPECT_EQ(refusal(scene, {rectangle(0, 0, 100, 100, 30)}), "") << "edges on the walls";
  EXPECT_EQ(refusal(scene, {rectangle(25, 25, 35, 35, 10)}), "") << "within the table top";
  EXPECT_EQ(refusal(scene, {rectangle(20, 20, 40, 60, 10)}), "") << "the table top itself";
  EXPECT_EQ(refusal(scene, {rectangle(0, 0, 100, 100, 10)}), "") << "round the table top";
  EXPECT_EQ(refusal(scene, {rectangle(40, 20, 60, 60, 5)}), "") << "edge within the table's side";
  EXPECT_EQ(refusal(scene, {rectangle(40, 60, 60, 80, 5)}), "") << "corner on the table's edge";
  EXPECT_EQ(refusal(scene, {rectangle(40, 60, 60, 80, 10)}), "") << "corner on its corner";
  EXPECT_EQ(refusal(scene, {{{40, 0, 5}, {60, 0, 5}, {60, 0, 45}}}), "") << "on a wall";
}

TEST(RegionCheck, OneUnitFartherIsRefused) {
  const Scene scene = made_scene({{"room", kRoom}, {"table", kTable}});
  EXPECT_EQ(refusal(scene, {rectangle(-1, 1, 99, 99, 30)}),
            "region.json: region part 1 is cut by 1 face: 1 ('room'); "
            "move it into free space; touching is allowed");
  EXPECT_THAT(refusal(scene, {rectangle(39, 20, 60, 60, 5)}), HasSubstr("('table')"));
  EXPECT_EQ(refusal(scene, {rectangle(50, 1, 99, 99, 30), rectangle(39, 59, 60, 80, 5)}),
            "region.json: region part 2 is cut by 2 faces: 8, 10 ('table'); "
            "move it into free space; touching is allowed");
  EXPECT_EQ(refusal(scene, {rectangle(-1, -1, 101, 101, 5)}),
            "region.json: region part 1 is cut by 8 faces: 1-4, 7-10 ('room', 'table'); "
            "move it into free space; touching is allowed");
}

TEST(RegionCheck, CornerOfATriangleCuts) {
  const auto scene = [](double tip) {
    return made_scene({{"room", kRoom}, {"", {{{60, 60, tip}, {50, 70, 45}, {70, 75, 45}}}}});
  };
  EXPECT_EQ(refusal(scene(20), {rectangle(10, 10, 90, 90, 20)}), "");
  EXPECT_THAT(refusal(scene(19), {rectangle(10, 10, 90, 90, 20)}),
              HasSubstr("region part 1 is cut by 1 face: 7;"));
}

TEST(RegionCheck, ManyCuttingFacesAreCounted) {
  std::vector<ConvexPolygon> slats;
  for (int i = 0; i < 9; ++i) {
    slats.push_back({{10., 10. * i + 5, 10}, {90., 10. * i + 5, 10}, {50., 10. * i + 5, 40}});
    slats.push_back({{10., 10. * i + 6, 45}, {90., 10. * i + 6, 45}, {50., 10. * i + 6, 40}});
  }
  EXPECT_THAT(
      refusal(made_scene({{"room", kRoom}, {"slats", slats}}), {rectangle(1, 1, 99, 99, 20)}),
      HasSubstr("is cut by 9 faces: 7, 9, 11, 13 and 5 more ('slats');"));
}

TEST(RegionCheck, Clearance) {
  const Scene scene = made_scene({{"room", kRoom}, {"table", kTable}});
  const ConvexPolygon part = rectangle(50, 30, 90, 50, 10);  // 10 from the table and a wall
  EXPECT_EQ(refusal(scene, {part}, {10, false}), "");
  EXPECT_EQ(
      refusal(scene, {part}, {std::nextafter(10.0, 11.0), false}),
      "region.json: region part 1 is nearer than the clearance 10.000000000000002 to 4 faces: "
      "2, 5, 8, 12 ('room', 'table'); move it away from them, or ask for less --clearance");
  EXPECT_THAT(refusal(scene, {rectangle(25, 25, 35, 35, 10)}, {0x1p-60, false}),
              HasSubstr("is nearer than the clearance"))
      << "touching is 0 apart";
  for (const double bad :
       {-1.0, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THAT(refusal(scene, {part}, {bad, false}), testing::StartsWith("--clearance: "));
  }
}

TEST(RegionCheck, InsideAClosedObjectIsRefused) {
  const std::vector<ConvexPolygon> inside = {rectangle(50, 10, 90, 90, 30),
                                             rectangle(25, 25, 35, 55, 5)};
  EXPECT_EQ(refusal(made_scene({{"room", kRoom}, {"table", kTable}}), inside),
            "region.json: region part 2 lies inside the closed object 'table' (faces 7-12); "
            "move it into free space");
  EXPECT_THAT(refusal(made_scene({{"room", kRoom}, {"table", mixed(kTable)}}), inside),
              HasSubstr("inside the closed object 'table' (faces 7-12)"))
      << "faces that point either way";
  EXPECT_THAT(refusal(made_scene({{"", kTable}, {"", kRoom}}), inside),
              HasSubstr("inside the closed object (faces 1-6)"));
  EXPECT_THAT(
      refusal(made_scene({{"room", box_outward({0, 0, 0}, {100, 100, 50})}, {"table", kTable}}),
              inside),
      HasSubstr("region part 2 lies inside the closed object 'table' (faces 7-12)"))
      << "all faces outward";
}

TEST(RegionCheck, FacesInwardMakeARoomButMixedFacesAnObject) {
  const ConvexPolygon part = rectangle(25, 25, 35, 55, 5);
  const auto inward = reversed(kTable);
  EXPECT_EQ(refusal(made_scene({{"room", kRoom}, {"cabin", inward}}), {part}), "");
  for (std::size_t face = 0; face < 6; ++face) {
    auto one_turned = inward;
    one_turned[face] = kTable[face];
    EXPECT_THAT(refusal(made_scene({{"room", kRoom}, {"cabin", one_turned}}), {part}),
                HasSubstr("closed object 'cabin' (faces 7-12)"))
        << face;
  }
}

TEST(RegionCheck, RegionOnAnyFaceOfAnObjectIsAccepted) {
  const auto block = box_outward({20, 20, 10}, {40, 60, 20});
  const Scene scene = made_scene({{"room", kRoom}, {"block", block}});
  for (const ConvexPolygon& face : block) {
    EXPECT_EQ(refusal(scene, {face}), "") << corner_mean(face).transpose();
  }
}

TEST(RegionCheck, FlatSceneHasItsPlaneWithin) {
  const Scene floor = made_scene({{"floor", {rectangle(0, 0, 10, 10, 0)}}});
  EXPECT_EQ(refusal(floor, {rectangle(2, 2, 8, 8, 0)}), "");
  EXPECT_THAT(refusal(floor, {rectangle(2, 2, 8, 8, 1)}), HasSubstr("outside"));
}

TEST(RegionCheck, RegionThatFillsTheObjectToItsWallsIsRefused) {
  const Scene scene = made_scene({{"room", kRoom}, {"table", kTable}});
  EXPECT_THAT(refusal(scene, {rectangle(20, 20, 40, 60, 5)}), HasSubstr("closed object 'table'"));
}

// The part runs along the lower step, on its surface, and then into the body of the upper one
// through the edge where they meet, without being cut by any face.
TEST(RegionCheck, RegionThatLiesOnAndInAnObjectIsRefused) {
  const std::vector<ConvexPolygon> steps = {
      {{20, 20, 0}, {20, 60, 0}, {60, 60, 0}, {60, 20, 0}},      // bottom
      {{20, 20, 10}, {40, 20, 10}, {40, 60, 10}, {20, 60, 10}},  // lower tread
      {{40, 20, 20}, {60, 20, 20}, {60, 60, 20}, {40, 60, 20}},  // upper tread
      {{20, 20, 0}, {20, 20, 10}, {20, 60, 10}, {20, 60, 0}},    // lower riser
      {{40, 20, 10}, {40, 20, 20}, {40, 60, 20}, {40, 60, 10}},  // upper riser
      {{60, 20, 0}, {60, 60, 0}, {60, 60, 20}, {60, 20, 20}},    // back
      {{20, 20, 0}, {40, 20, 0}, {40, 20, 10}, {20, 20, 10}},    // sides, with a T-junction
      {{40, 20, 0}, {60, 20, 0}, {60, 20, 20}, {40, 20, 20}},
      {{20, 60, 0}, {20, 60, 10}, {40, 60, 10}, {40, 60, 0}},
      {{40, 60, 0}, {40, 60, 20}, {60, 60, 20}, {60, 60, 0}}};
  const Scene scene = made_scene({{"room", kRoom}, {"steps", steps}});
  EXPECT_EQ(refusal(scene, {rectangle(20, 30, 40, 50, 10)}), "");
  EXPECT_THAT(refusal(scene, {rectangle(20, 30, 50, 50, 10)}),
              HasSubstr("inside the closed object 'steps' (faces 7-16)"));
}

TEST(RegionCheck, RoomIsNoObject) {
  const ConvexPolygon part = rectangle(10, 10, 90, 90, 30);
  const auto outward = box_outward({0, 0, 0}, {100, 100, 50});
  EXPECT_EQ(refusal(made_scene({{"room", outward}}), {part}), "");
  EXPECT_EQ(refusal(made_scene({{"room", mixed(outward)}}), {part}), "");
  EXPECT_EQ(refusal(made_scene({{"room", mixed(outward)}, {"table", kTable}}), {part}), "");
  // A lamp pokes through the wall.
  EXPECT_EQ(
      refusal(made_scene({{"room", outward}, {"lamp", box_outward({95, 8, 40}, {105, 9, 41})}}),
              {part}),
      "");
  // A larger shell round the room: faces inward make it a room, faces outward an object.
  const auto shell = box_outward({-10, -10, -10}, {200, 200, 90});
  EXPECT_EQ(refusal(made_scene({{"room", kRoom}, {"shell", shell}}), {part}), "");
  EXPECT_THAT(refusal(made_scene({{"room", outward}, {"shell", shell}}), {part}),
              HasSubstr("closed object 'room' (faces 1-6)"));
}

TEST(RegionCheck, OpenBoxIsNoObject) {
  for (std::size_t missing = 0; missing < 6; ++missing) {
    auto open = kTable;
    open.erase(open.begin() + static_cast<std::ptrdiff_t>(missing));
    EXPECT_EQ(
        refusal(made_scene({{"room", kRoom}, {"open", open}}), {rectangle(25, 25, 35, 55, 5)}), "")
        << missing;
  }
}

// The block has no bottom of its own: the floor's face below it closes it.
TEST(RegionCheck, ObjectMayBeClosedByAFaceOfAnotherGroup) {
  auto block = kTable;
  const ConvexPolygon bottom = block[4];
  block.erase(block.begin() + 4);
  EXPECT_THAT(refusal(made_scene({{"floor", {bottom}}, {"room", kRoom}, {"block", block}}),
                      {rectangle(25, 25, 35, 55, 5)}),
              HasSubstr("closed object 'floor', 'block' (faces 1, 8-12)"));
}

TEST(RegionCheck, ObjectMayHaveTJunctions) {
  auto cut = kTable;  // its top in three, so that edges of the sides meet two or three shorter ones
  cut.pop_back();
  cut.push_back({{20, 20, 10}, {33, 20, 10}, {33, 60, 10}, {20, 60, 10}});
  cut.push_back({{33, 20, 10}, {40, 20, 10}, {40, 37, 10}, {33, 37, 10}});
  cut.push_back({{33, 37, 10}, {40, 37, 10}, {40, 60, 10}, {33, 60, 10}});
  EXPECT_THAT(
      refusal(made_scene({{"room", kRoom}, {"table", cut}}), {rectangle(25, 25, 35, 55, 5)}),
      HasSubstr("closed object 'table' (faces 7-14)"));
}

TEST(RegionCheck, ObjectMayShareAnEdgeWithTheRoom) {
  // A cupboard in the corner: edges on the room's, which are not split there.
  const auto cupboard = box_outward({0, 0, 0}, {10, 10, 50});
  EXPECT_THAT(
      refusal(made_scene({{"room", kRoom}, {"cupboard", cupboard}}), {rectangle(2, 2, 8, 8, 20)}),
      HasSubstr("closed object 'cupboard' (faces 7-12)"));
  // A fin on an edge of the table makes no hole in it.
  const ConvexPolygon fin = {{40, 20, 10}, {40, 60, 10}, {50, 60, 15}};
  EXPECT_THAT(refusal(made_scene({{"room", kRoom}, {"fin", {fin}}, {"table", kTable}}),
                      {rectangle(25, 25, 35, 55, 5)}),
              HasSubstr("closed object 'table' (faces 8-13)"));
}

TEST(RegionCheck, InnermostObjectDecides) {
  // A hollow cupboard, outward outside and towards its own room inside: cameras may be in it.
  const auto outside = box_outward({20, 20, 0}, {60, 60, 40});
  const auto hollow = reversed(box_outward({21, 21, 1}, {59, 59, 39}));
  const ConvexPolygon part = rectangle(30, 30, 50, 50, 20);
  EXPECT_EQ(
      refusal(made_scene({{"room", kRoom}, {"outside", outside}, {"hollow", hollow}}), {part}), "");
  const auto safe = box_outward({25, 25, 5}, {55, 55, 35});
  EXPECT_THAT(
      refusal(
          made_scene({{"room", kRoom}, {"safe", safe}, {"outside", outside}, {"hollow", hollow}}),
          {part}),
      HasSubstr("closed object 'safe' (faces 7-12)"));
}

TEST(RegionCheck, OutsideNeedsPermission) {
  const Scene scene = made_scene({{"room", kRoom}});
  const std::string message =
      "region.json: region part 1 lies outside the scene's bounding box; "
      "move it into the scene, or pass --allow-outside";
  const ConvexPolygon above = rectangle(10, 10, 90, 90, 51);
  EXPECT_EQ(refusal(scene, {above}), message);
  EXPECT_EQ(refusal(scene, {above}, {0, true}), "");
  EXPECT_EQ(refusal(scene, {rectangle(10, 10, 90, 90, 50)}), "") << "touching from outside";
  // Slanted past an edge of the box: their boxes overlap.
  const ConvexPolygon slanted = {{90, 10, 61}, {90, 90, 61}, {111, 90, 40}, {111, 10, 40}};
  EXPECT_EQ(refusal(scene, {slanted}), message);
  EXPECT_EQ(refusal(scene, {slanted}, {0, true}), "");
}

TEST(RegionCheck, RealScenesAreAccepted) {
  const std::filesystem::path folder = VIEWCOVER_SHARED_SCENES;
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no folder " << folder;
  std::size_t scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".obj") continue;
    std::filesystem::path region_file = entry.path();
    region_file.replace_extension(".region.json");
    EXPECT_NO_THROW({
      const Scene scene = load_scene(entry.path());
      const ViewingRegion region = load_viewing_region(region_file, scene.lattice, 64);
      check_region_is_free(region_file, scene, region);
    }) << region_file;
    ++scenes;
  }
  EXPECT_GE(scenes, 6u);
}

TEST(RegionCheck, CornellBlockIsAnObject) {
  const std::filesystem::path file =
      std::filesystem::path(VIEWCOVER_SHARED_SCENES) / "cornell_box.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "no file " << file;
  const Scene scene = load_scene(file);
  // Well within the tall block, which is 330 high and stands round (368, 351).
  ConvexPolygon part = {{360, 100, 345}, {375, 100, 345}, {375, 100, 355}, {360, 100, 355}};
  EXPECT_THAT(refusal(scene, {part}), HasSubstr("'tall_block'"));
}

// Six parts, 16,000 small triangles: the whole check is meant to take well under a second.
TEST(RegionCheck, LargeSceneIsCheckedQuickly) {
  std::mt19937_64 random(7);
  std::vector<ConvexPolygon> soup;
  while (soup.size() < 16000) {
    const auto coordinate = [&] { return static_cast<double>(random() % 1000000); };
    const auto offset = [&] { return static_cast<double>(random() % 20000); };
    const Point p(coordinate(), coordinate(), coordinate() / 4);
    soup.push_back(
        {p, p + Point(offset() + 1, offset(), offset()), p - Point(offset(), offset(), 9)});
  }
  const Scene scene = made_scene({{"soup", soup}});
  std::vector<ConvexPolygon> parts;
  for (int i = 0; i < 6; ++i) parts.push_back(rectangle(0, 0, 1e6, 1e6, 3e5 + i * 1e5));
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(refusal(scene, parts, {1000, true}), "");
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 5)
      << "a sanitizer build may take ten times as long";
}

std::string box_refusal(const Scene& scene, const Box& box, const RegionCheck& check = {}) {
  try {
    check_region_is_free("region.json", scene, make_viewing_region({}, {box}, 1), check);
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
    return error.what();
  }
  return "";
}

TEST(RegionCheckOfBoxes, FreeAndTouchingBoxesAreAccepted) {
  const Scene scene = made_scene({{"room", kRoom}, {"table", kTable}});
  EXPECT_EQ(box_refusal(scene, {Point(5, 5, 20), Point(95, 95, 40)}), "");
  EXPECT_EQ(box_refusal(scene, {Point(0, 0, 10), Point(100, 100, 50)}), "") << "on all sides";
  EXPECT_EQ(box_refusal(scene, {Point(40, 0, 0), Point(100, 100, 50)}), "") << "beside the table";
}

TEST(RegionCheckOfBoxes, ASurfaceInsideIsRefusedThoughItTouchesNoFace) {
  const Scene scene = made_scene(
      {{"room", kRoom}, {"lamp", {{{50, 50, 30}, {52, 50, 30}, {50, 52, 31}}}}, {"table", kTable}});
  const std::string refused = box_refusal(scene, {Point(40, 40, 20), Point(60, 60, 40)});
  EXPECT_THAT(refused, HasSubstr("region box 1 has inside 1 face: 7 ('lamp')"));
  // No polygon of its own is cut by it.
  std::vector<ConvexPolygon> faces;
  for (const ConvexPolygon& face : box_faces({Point(40, 40, 20), Point(60, 60, 40)})) {
    faces.push_back(face);
  }
  EXPECT_EQ(refusal(scene, faces), "");
  EXPECT_THAT(box_refusal(scene, {Point(10, 10, 5), Point(60, 60, 40)}), HasSubstr("'table'"));
  EXPECT_THAT(box_refusal(scene, {Point(60, 5, 20), Point(130, 95, 40)}), HasSubstr("'room'"));
}

TEST(RegionCheckOfBoxes, ClearanceAndPlace) {
  const Scene scene = made_scene({{"room", kRoom}, {"table", kTable}});
  EXPECT_EQ(box_refusal(scene, {Point(25, 25, 15), Point(35, 35, 40)}, {.clearance = 5}), "");
  EXPECT_THAT(box_refusal(scene, {Point(25, 25, 14), Point(35, 35, 40)}, {.clearance = 5}),
              HasSubstr("region box 1 is nearer than the clearance 5 to 1 face"));
  EXPECT_THAT(box_refusal(scene, {Point(25, 25, 2), Point(35, 35, 8)}),
              HasSubstr("region box 1 lies inside the closed object 'table'"));
  EXPECT_THAT(box_refusal(scene, {Point(101, 0, 0), Point(110, 9, 9)}),
              HasSubstr("region box 1 lies outside the scene's bounding box"));
}

}  // namespace
}  // namespace viewcover
