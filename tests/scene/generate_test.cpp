#include <gmock/gmock.h>

#include <map>
#include <set>
#include <string>

#include "scene/exact_faces.h"
#include "scene/generate/generated_scene.h"
#include "support/generated.h"

namespace viewcover {
namespace {

class LivingRoom : public ::testing::TestWithParam<RoomDetail> {};

INSTANTIATE_TEST_SUITE_P(Details, LivingRoom,
                         ::testing::Values(RoomDetail::kSimple, RoomDetail::kComplex),
                         [](const auto& detail) {
                           return detail.param == RoomDetail::kSimple ? "Simple" : "Complex";
                         });

TEST_P(LivingRoom, HasThePolygonsOfThePaper) {
  const GeneratedScene room = living_room(GetParam());
  EXPECT_EQ(room.faces.size(), GetParam() == RoomDetail::kSimple ? 316u : 1228u);
}

TEST_P(LivingRoom, FacesArePlanarConvexDistinctAndDoNotCross) {
  EXPECT_THAT(faults(living_room(GetParam())), ::testing::IsEmpty());
}

TEST_P(LivingRoom, LoadsWithoutRepairAndItsRegionIsFree) {
  const GeneratedScene room = living_room(GetParam());
  const testing::LoadedScene loaded = testing::load_generated(room, 64);
  EXPECT_EQ(loaded.scene.surfaces.size(), room.faces.size());
  EXPECT_EQ(loaded.scene.groups, room.groups);
  EXPECT_FALSE(loaded.scene.repairs.any()) << loaded.scene.repairs.summary();
  EXPECT_EQ(loaded.scene.repairs.largest_move, 0);
}

TEST_P(LivingRoom, RegionAtEyeHeightIsCutByNoFace) {
  const GeneratedScene room = living_room(GetParam());
  ASSERT_EQ(room.region.size(), 1u);
  ASSERT_EQ(room.region[0].size(), 4u);
  for (const Point& corner : room.region[0]) EXPECT_NEAR(corner.z(), 1.6, 0.002);
  const std::vector<WholeFace> faces = whole_faces(room);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    EXPECT_TRUE(is_clear_of(faces[i], room.region[0])) << room.groups[room.faces[i].group];
  }
}

// The window bay and the door niche are the only places beyond 6 x 5 x 2.5 m.
TEST_P(LivingRoom, FurnitureStaysInTheRoom) {
  const GeneratedScene room = living_room(GetParam());
  for (const GeneratedScene::Face& face : room.faces) {
    const std::string& group = room.groups[face.group];
    if (group == "window" || group == "door" || group == "blinds") continue;
    for (const std::uint32_t corner : face.corners) {
      const Point& p = room.vertices[corner];
      EXPECT_TRUE(p.minCoeff() >= 0 && p.x() <= 6 && p.y() <= 5 && p.z() <= 2.5) << group;
    }
  }
}

// Faces that close a volume: area vectors that add up to 0, exactly, and the sign of the volume.
TEST_P(LivingRoom, ShellFacesInwardAndSolidsOutward) {
  const GeneratedScene room = living_room(GetParam());
  const std::vector<WholeFace> faces = whole_faces(room);
  std::map<std::string, WholePoint> area;
  std::map<std::string, double> volume;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    std::string group = room.groups[room.faces[i].group];
    for (const char* shell : {"floor", "ceiling", "wall-", "window", "door"}) {
      if (group.rfind(shell, 0) == 0 && group != "floor-lamp") group = "shell";
    }
    for (std::size_t k = 2; k < faces[i].size(); ++k) {
      const WholePoint part = cross(faces[i][0], faces[i][k - 1], faces[i][k]);
      for (std::size_t axis = 0; axis < 3; ++axis) area[group][axis] += part[axis];
      volume[group] += static_cast<double>(dot(part, faces[i][0])) * 0x1p-60 / 6;
    }
  }
  // 6 x 5 x 2.5, the window bay 2 x 1.25 x 0.25 and the door niche 0.9 x 2 x 0.125 m, to the
  // 4 mm that lengths are rounded to.
  EXPECT_NEAR(volume.at("shell"), -(75 + 0.625 + 0.225), 0.01);
  const std::set<std::string> with_open_sheets = {
      "lamp", "floor-lamp", "pendant-lamp", "table-lamp",  "plant",
      "bowl", "crockery",   "plant-west",   "plant-north", "curtains"};
  for (const auto& [group, sum] : area) {
    if (with_open_sheets.count(group) > 0) continue;
    EXPECT_TRUE(sum == WholePoint{}) << group;
    EXPECT_TRUE(group == "shell" || volume.at(group) > 0) << group;
  }
  // The carcass is 0.9 (simple) or 1.5 m wide, 0.34 deep and 2.1 high; compartments take most.
  const double carcass = (GetParam() == RoomDetail::kSimple ? 0.9 : 1.5) * 0.34 * 2.1;
  EXPECT_GT(volume.at("bookshelf"), 0.1 * carcass);
  EXPECT_LT(volume.at("bookshelf"), 0.4 * carcass);
}

class RowOfRooms : public ::testing::TestWithParam<RoomDetail> {};

INSTANTIATE_TEST_SUITE_P(Details, RowOfRooms,
                         ::testing::Values(RoomDetail::kSimple, RoomDetail::kComplex),
                         [](const auto& detail) {
                           return detail.param == RoomDetail::kSimple ? "Simple" : "Complex";
                         });

TEST_P(RowOfRooms, FacesArePlanarConvexDistinctAndDoNotCross) {
  EXPECT_THAT(faults(row_of_rooms(3, GetParam())), ::testing::IsEmpty());
}

TEST_P(RowOfRooms, LoadsWithoutRepairAndHasAFreeRegionInEachRoom) {
  const GeneratedScene rooms = row_of_rooms(40, GetParam());
  const testing::LoadedScene loaded = testing::load_generated(rooms, 4);
  EXPECT_EQ(loaded.scene.surfaces.size(), rooms.faces.size());
  EXPECT_FALSE(loaded.scene.repairs.any()) << loaded.scene.repairs.summary();
  EXPECT_EQ(loaded.scene.repairs.largest_move, 0);
  EXPECT_EQ(loaded.region.parts.size(), 40u);
  EXPECT_EQ(loaded.region.parts[39][0].x() - loaded.region.parts[0][0].x(), 39 * 6.125);
  for (std::size_t i = 0; i < loaded.scene.surfaces.size(); ++i) {
    const Surface& surface = loaded.scene.surfaces[i];
    const std::string& group = loaded.scene.groups[surface.group.value];
    if (group == "room-40/door") continue;  // its leaf is where another room would begin
    const double room = std::floor(bounding_box(surface.polygon).min().x() / 6.125);
    EXPECT_TRUE(group.starts_with("room-" + std::to_string(static_cast<int>(room) + 1) + "/"))
        << group;
  }
}

// The shell is closed, doorways and all: area vectors that add up to 0 and the volume of the rooms
// with their windows and doors. At either side of a doorway nothing is in the way.
TEST_P(RowOfRooms, ShellIsOneThroughTheDoorways) {
  const GeneratedScene rooms = row_of_rooms(3, GetParam());
  const testing::LoadedScene loaded = testing::load_generated(rooms, 4);
  Point area = Point::Zero();
  double volume = 0;
  for (const Surface& surface : loaded.scene.surfaces) {
    const std::string name = loaded.scene.groups[surface.group.value].substr(7);
    const bool is_shell = name == "floor" || name == "ceiling" || name == "window" ||
                          name == "door" || name.starts_with("wall-");
    if (is_shell) {
      area += area_vector(surface.polygon);
      volume -= surface.polygon[0].dot(area_vector(surface.polygon)) / 6;
    } else {
      for (const double doorway : {6.125, 12.25}) {
        const Box way(Point(doorway - 0.5, 0.5, 0), Point(doorway + 0.375, 1.4, 2));
        EXPECT_TRUE(way.intersection(bounding_box(surface.polygon)).isEmpty()) << name;
      }
    }
  }
  EXPECT_EQ(area, Point(0, 0, 0));
  EXPECT_NEAR(volume, 3 * (6 * 5 * 2.5 + 2 * 0.25 * 1.25 + 0.125 * 0.9 * 2), 0.01);
}

}  // namespace
}  // namespace viewcover
