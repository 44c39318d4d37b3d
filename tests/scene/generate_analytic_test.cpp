#include <gmock/gmock.h>

#include <bit>
#include <set>

#include "scene/exact_faces.h"
#include "scene/generate/generated_scene.h"
#include "support/generated.h"

namespace viewcover {
namespace {

// What the derivations say about the geometry, as far as it takes no visibility to check.

AnalyticScene named(const std::string& name) {
  for (AnalyticScene& scene : analytic_scenes()) {
    if (scene.name == name) return scene;
  }
  throw std::invalid_argument("no analytic scene " + name);
}

std::vector<std::vector<Point>> faces_of(const GeneratedScene& scene, const std::string& group) {
  std::vector<std::vector<Point>> faces;
  for (const GeneratedScene::Face& face : scene.faces) {
    if (scene.groups[face.group] != group) continue;
    faces.emplace_back();
    for (const std::uint32_t corner : face.corners) {
      faces.back().push_back(scene.vertices[corner]);
    }
  }
  if (faces.empty()) throw std::invalid_argument("no group " + group);
  return faces;
}

// Whether all corners of the part lie strictly before the face, or none does.
bool is_before(const std::vector<Point>& part, const std::vector<Point>& face) {
  return std::all_of(part.begin(), part.end(), [&](const Point& p) {
    return side(whole(face[0]), whole(face[1]), whole(face[2]), whole(p)) > 0;
  });
}
bool is_behind(const std::vector<Point>& part, const std::vector<Point>& face) {
  return std::none_of(part.begin(), part.end(), [&](const Point& p) {
    return side(whole(face[0]), whole(face[1]), whole(face[2]), whole(p)) > 0;
  });
}

TEST(AnalyticScenes, AreWellFormed) {
  std::set<std::string> names;
  for (const AnalyticScene& answer : analytic_scenes()) {
    SCOPED_TRACE(answer.name);
    EXPECT_TRUE(names.insert(answer.name).second);
    EXPECT_THAT(faults(answer.scene), ::testing::IsEmpty());
    EXPECT_FALSE(answer.derivation.empty());
    std::size_t power = 1;
    while (power < answer.regions) power *= 4;
    EXPECT_EQ(power, answer.regions);
    ASSERT_TRUE(answer.optimal_regions.has_value());
    EXPECT_LE(*answer.optimal_regions, answer.regions * answer.scene.region.size());

    const std::set<std::string> groups(answer.scene.groups.begin(), answer.scene.groups.end());
    const std::set<std::string> hidden(answer.hidden_groups.begin(), answer.hidden_groups.end());
    for (const std::string& group : hidden) EXPECT_EQ(groups.count(group), 1u) << group;
    for (const std::string& group : answer.visible_groups) {
      EXPECT_EQ(groups.count(group), 1u) << group;
      EXPECT_EQ(hidden.count(group), 0u) << group;
    }
    for (const WholeFace& face : whole_faces(answer.scene)) {
      for (const std::vector<Point>& part : answer.scene.region) {
        EXPECT_TRUE(is_clear_of(face, part));
      }
    }
  }
  EXPECT_THAT(names, ::testing::IsSupersetOf({"empty-room", "cube-in-room", "two-rooms", "comb-2",
                                              "comb-4", "comb-8", "parallel-plates", "slit"}));
}

TEST(AnalyticScenes, LoadWithoutRepairAndTheirRegionsAreFree) {
  for (const AnalyticScene& answer : analytic_scenes()) {
    SCOPED_TRACE(answer.name);
    const testing::LoadedScene loaded = testing::load_generated(answer.scene, answer.regions);
    EXPECT_EQ(loaded.scene.surfaces.size(), answer.scene.faces.size());
    EXPECT_FALSE(loaded.scene.repairs.any()) << loaded.scene.repairs.summary();
  }
}

// A convex room: every corner of every wall lies before or on every wall.
TEST(AnalyticScenes, EmptyRoomIsConvex) {
  const GeneratedScene room = named("empty-room").scene;
  for (const WholeFace& face : whole_faces(room)) {
    for (const Point& p : room.vertices) EXPECT_GE(side(face[0], face[1], face[2], whole(p)), 0);
  }
}

TEST(AnalyticScenes, EachSideOfTheCubeHasOnePartBeforeIt) {
  const GeneratedScene room = named("cube-in-room").scene;
  for (const char* name : {"cube-south", "cube-north", "cube-west", "cube-east"}) {
    const std::vector<Point> face = faces_of(room, name)[0];
    int before = 0, behind = 0;
    for (const auto& part : room.region) {
      before += is_before(part, face);
      behind += is_behind(part, face);
    }
    EXPECT_EQ(before, 1) << name;
    EXPECT_EQ(behind, 3) << name;
  }
  for (const auto& part : room.region) {
    EXPECT_TRUE(is_before(part, faces_of(room, "cube-top")[0]));
    EXPECT_TRUE(is_behind(part, faces_of(room, "cube-bottom")[0]));
  }
}

TEST(AnalyticScenes, FacesOfTheHangingBoxThatAreHiddenHaveNoPartBeforeThem) {
  const GeneratedScene room = named("nested-boxes").scene;
  for (const auto& part : room.region) {
    for (const char* name : {"box-bottom", "box-west", "box-east"}) {
      EXPECT_TRUE(is_behind(part, faces_of(room, name)[0])) << name;
    }
    EXPECT_TRUE(is_before(part, faces_of(room, "box-top")[0]));
    const bool is_south = is_before(part, faces_of(room, "box-south")[0]);
    EXPECT_TRUE(is_behind(part, faces_of(room, is_south ? "box-north" : "box-south")[0]));
    EXPECT_TRUE(is_south || is_before(part, faces_of(room, "box-north")[0]));
  }
  // The inner box lies strictly within the outer one: behind all of its faces.
  for (const char* outer : {"top", "bottom", "south", "north", "west", "east"}) {
    const std::vector<Point> face = faces_of(room, std::string("box-") + outer)[0];
    for (const char* inner : {"top", "bottom"}) {
      const std::vector<Point> corners = faces_of(room, std::string("inner-") + inner)[0];
      for (const Point& p : corners) {
        EXPECT_LT(side(whole(face[0]), whole(face[1]), whole(face[2]), whole(p)), 0);
      }
    }
  }
}

TEST(AnalyticScenes, APartitionIsBeforeItsOwnRoomOnly) {
  const GeneratedScene rooms = named("two-rooms").scene;
  ASSERT_EQ(rooms.region.size(), 2u);
  for (const auto& face : faces_of(rooms, "partition-a")) {
    EXPECT_TRUE(is_before(rooms.region[0], face));
    EXPECT_TRUE(is_behind(rooms.region[1], face));
  }
  for (const auto& face : faces_of(rooms, "partition-b")) {
    EXPECT_TRUE(is_behind(rooms.region[0], face));
    EXPECT_TRUE(is_before(rooms.region[1], face));
  }
  for (const auto& face : faces_of(rooms, "door")) {
    for (const auto& part : rooms.region) EXPECT_TRUE(is_before(part, face));
  }
}

// Where lines from a part to a back cross y = 4 is monotone in each coordinate of their ends, so
// the corners tell.
TEST(AnalyticScenes, LinesToAToothOfTheCombMissItsMouthButFromBeforeIt) {
  for (const int teeth : {2, 4, 8}) {
    const AnalyticScene comb = named("comb-" + std::to_string(teeth));
    ASSERT_EQ(comb.scene.region.size(), static_cast<std::size_t>(teeth));
    EXPECT_EQ(comb.optimal_regions, static_cast<std::size_t>(teeth));
    for (int tooth = 0; tooth < teeth; ++tooth) {
      const auto back = faces_of(comb.scene, "back-" + std::to_string(tooth + 1));
      ASSERT_EQ(back.size(), 1u);
      for (int part = 0; part < teeth; ++part) {
        double nearest = 0, farthest = 0;  // distance from the mouth's middle, both signs
        bool is_first = true;
        for (const Point& p : comb.scene.region[static_cast<std::size_t>(part)]) {
          for (const Point& q : back[0]) {
            ASSERT_EQ(q.y(), 0);
            const double crossing = p.x() + (q.x() - p.x()) * (p.y() - 4) / p.y();
            const double offset = (crossing - (2.0 * tooth + 0.5)) * (part > tooth ? 1 : -1);
            nearest = is_first ? offset : std::min(nearest, offset);
            farthest = is_first ? offset : std::max(farthest, offset);
            is_first = false;
          }
        }
        if (part == tooth) {
          EXPECT_TRUE(-0.5 < nearest && farthest < 0.5);
        } else {
          EXPECT_GT(nearest, 0.5 + 0.89);  // 17/19 short of the mouth
        }
      }
    }
  }
}

TEST(AnalyticScenes, LinesBetweenTheArmsOfTheLCutTheCorner) {
  const GeneratedScene room = named("l-shaped-room-arms").scene;
  ASSERT_EQ(room.region.size(), 2u);
  const auto end = faces_of(room, "end-east");
  for (const Point& p : room.region[1]) {
    for (const Point& q : end[0]) {
      ASSERT_GT(p.y(), 2);
      ASSERT_LE(q.y(), 2);
      const double x = p.x() + (q.x() - p.x()) * (p.y() - 2) / (p.y() - q.y());
      EXPECT_GT(x, 3.5);
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {  // the northern part is the eastern one mirrored
    const Point mirrored(room.region[0][i].y(), room.region[0][i].x(), room.region[0][i].z());
    EXPECT_THAT(room.region[1], ::testing::Contains(mirrored));
  }
}

TEST(AnalyticScenes, LinesToTheTargetCrossThePlate) {
  for (const auto& [name, margin] :
       {std::pair("parallel-plates", 0.25), std::pair("parallel-plates-exact", 0.0)}) {
    const GeneratedScene plates = named(name).scene;
    const std::vector<Point> plate = faces_of(plates, "plate")[0];
    const std::vector<Point> target = faces_of(plates, "target")[0];
    const double half = plate[0].cwiseAbs().x();
    for (const Point& p : plates.region[0]) {
      for (const Point& q : target) {
        const Point crossing = (p + q) / 2;
        EXPECT_EQ(crossing.z(), plate[0].z());
        EXPECT_LE(crossing.head<2>().cwiseAbs().maxCoeff(), half - margin);
      }
    }
  }
  const GeneratedScene plates = named("parallel-plates").scene;
  for (const auto& face : faces_of(plates, "beyond")) {
    for (const Point& p : plates.region[0]) {
      for (const Point& q : face) {
        EXPECT_GE(((p + q) / 2).head<2>().cwiseAbs().maxCoeff(), 1.25);
      }
    }
  }
}

// The plane problem behind the slit: which columns of regions see which columns of the target.
TEST(AnalyticScenes, TwoColumnsOfRegionsSeeTheTargetThroughTheSlit) {
  const AnalyticScene slit = named("slit");
  double left = -1, right = 1;
  for (const auto& wall : faces_of(slit.scene, "walls")) {
    for (const Point& p : wall) {
      ASSERT_EQ(p.z(), 1);
      (p.x() < 0 ? left : right) = p.x() < 0 ? std::max(left, p.x()) : std::min(right, p.x());
    }
  }
  ASSERT_EQ(slit.regions, 16u);
  ASSERT_EQ(slit.element_area, 1.0 / 16);
  std::array<unsigned, 4> seen{};
  for (unsigned c = 0; c < 4; ++c) {
    for (unsigned e = 0; e < 4; ++e) {
      const double low = (c + e) / 4.0 - 1;  // of the sum of the ends; the crossing is its half
      if (low / 2 < right && (low + 0.5) / 2 > left) seen[c] |= 1u << e;
    }
  }
  std::size_t fewest = 4;
  for (unsigned chosen = 1; chosen < 16; ++chosen) {
    unsigned all = 0;
    for (unsigned c = 0; c < 4; ++c) all |= chosen >> c & 1 ? seen[c] : 0;
    if (all == 15) fewest = std::min<std::size_t>(fewest, std::popcount(chosen));
  }
  EXPECT_EQ(fewest, 2u);
  EXPECT_EQ(slit.optimal_regions, fewest);
  EXPECT_EQ(seen, (std::array<unsigned, 4>{0b1100, 0b1110, 0b0111, 0b0011}));
}

TEST(AnalyticScenes, WallsOfTheClosedSlitAbut) {
  const auto walls = faces_of(named("slit-closed").scene, "walls");
  ASSERT_EQ(walls.size(), 2u);
  for (const auto& wall : walls) {
    EXPECT_EQ(std::count_if(wall.begin(), wall.end(), [](const Point& p) { return p.x() == 0; }),
              2);
  }
}

}  // namespace
}  // namespace viewcover
