#include "free_space/free_region.h"

#include <gmock/gmock.h>

#include <cmath>

#include "scene/error.h"
#include "scene/polygon_contact.h"
#include "scene/predicates.h"
#include "scene/random_numbers.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

/// Boxes as scenes; `up` says which axis the third number is.
class Boxes {
 public:
  explicit Boxes(int up = 2) : up_(up) { scene_.lattice = {16}; }

  void add(const Point& least, const Point& most) {
    for (int axis = 0; axis < 3; ++axis) {
      for (const double at : {least[axis], most[axis]}) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        ConvexPolygon face;
        for (const auto& [a, b] :
             {std::pair(0, 0), std::pair(1, 0), std::pair(1, 1), std::pair(0, 1)}) {
          Point corner;
          corner[axis] = at;
          corner[u] = a == 0 ? least[u] : most[u];
          corner[v] = b == 0 ? least[v] : most[v];
          face.push_back(turned(corner));
        }
        scene_.bounds.extend(bounding_box(face));
        scene_.surfaces.push_back({face, GroupId(0), 0});
      }
    }
  }
  const Scene& scene() const { return scene_; }
  Point turned(const Point& p) const {
    Point q;
    q[up_] = p[2];
    q[(up_ + 1) % 3] = p[0];
    q[(up_ + 2) % 3] = p[1];
    return q;
  }

 private:
  int up_;
  Scene scene_;
};

/// A room 4 x 3, 2.5 high.
Boxes empty_room(int up = 2) {
  Boxes boxes(up);
  boxes.add({0, 0, 0}, {4, 3, 2.5});
  return boxes;
}

FreeRegionOptions at(double height, double clearance, int up = 2) {
  FreeRegionOptions options;
  options.up_axis = up;
  options.height = height;
  options.clearance = clearance;
  return options;
}

bool holds(const FreeRegion& region, const Point& place, int up) {
  return std::ranges::any_of(region.parts, [&](const ConvexPolygon& part) {
    bool left = false, right = false;
    for (std::size_t k = 0; k < part.size(); ++k) {
      const int side = turn(part[k], part[(k + 1) % part.size()], place, up);
      left |= side > 0;
      right |= side < 0;
    }
    return !(left && right);
  });
}

/// Is a place nearer than a distance to a surface? By a triangle round it that is a millionth wide.
bool is_near(const Scene& scene, const Point& place, double distance) {
  const ConvexPolygon speck = {place, place + Point(1e-6, 0, 0), place + Point(0, 1e-6, 1e-6)};
  return std::ranges::any_of(scene.surfaces, [&](const Surface& surface) {
    return is_nearer_than(speck, surface.polygon, distance);
  });
}

TEST(FreeRegion, OfAnEmptyRoomIsARectangleWhicheverWayIsUp) {
  for (int up = 0; up < 3; ++up) {
    SCOPED_TRACE(up);
    const Boxes room = empty_room(up);
    const FreeRegion region = find_free_region(room.scene(), at(1.5, 0.25, up));
    ASSERT_EQ(region.parts.size(), 1u);
    EXPECT_EQ(region.parts[0].size(), 4u);
    EXPECT_EQ(region.holes, 0u);
    EXPECT_EQ(region.others, 0u);
    EXPECT_NEAR(region.area, 3.5 * 2.5, 0.02);
    EXPECT_LT(region.area, 3.5 * 2.5);
    for (const Point& corner : region.parts[0]) EXPECT_EQ(corner[up], 1.5);
  }
}

TEST(FreeRegion, GoesRoundAPillarAndOverATable) {
  Boxes room = empty_room();
  room.add({0.5, 0.5, 0}, {1.5, 1.5, 0.7});  // a table, far below
  const double without = find_free_region(room.scene(), at(1.5, 0.25)).area;
  EXPECT_NEAR(without, 3.5 * 2.5, 0.02);
  room.add({2, 1, 0}, {2.5, 1.5, 2.5});
  const FreeRegion region = find_free_region(room.scene(), at(1.5, 0.25));
  EXPECT_EQ(region.holes, 1u);
  EXPECT_GE(region.parts.size(), 4u);
  // Between the square with round corners and that with octagons' corners round the same discs.
  const double round = 0.5 * 0.5 + 4 * 0.5 * 0.25 + M_PI * 0.25 * 0.25;
  const double octagon = 0.5 * 0.5 + 4 * 0.5 * 0.25 + 8 * std::tan(M_PI / 8) * 0.25 * 0.25;
  EXPECT_LT(region.area, without - round);
  EXPECT_GT(region.area, without - octagon - 0.02);

  // A table that is nearly as high as the camera is in the way, though it is below.
  EXPECT_LT(find_free_region(room.scene(), at(0.8, 0.25)).area, region.area - 1);
}

TEST(FreeRegion, KeepsTheClearanceAndLeavesOutNoMoreThanTheOctagons) {
  std::size_t tried = 0, inside = 0, outside = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    RandomNumbers random(mixed(seed));
    const int up = static_cast<int>(seed % 3);
    Boxes room = empty_room(up);
    const Lattice& lattice = room.scene().lattice;
    for (int i = 0; i < 6; ++i) {
      const Point least = lattice.round(
          Point(random.between(0.2, 3.2), random.between(0.2, 2.2), random.between(0, 2)));
      const Point size = lattice.round(
          Point(random.between(0.1, 0.6), random.between(0.1, 0.6), random.between(0.1, 0.5)));
      room.add(least, least + size);
    }
    const double clearance = random.between(0.02, 0.15);
    const FreeRegion region = find_free_region(room.scene(), at(1.25, clearance, up));
    EXPECT_NO_THROW(check_region_is_free(
        "region", room.scene(), {.parts = region.parts, .level = 0}, {.clearance = clearance}));
    double area_of_parts = 0;
    for (const ConvexPolygon& part : region.parts) {
      EXPECT_TRUE(is_strictly_convex(part));
      area_of_parts += area(part);
    }
    EXPECT_DOUBLE_EQ(area_of_parts, region.area);
    if (region.others > 0) continue;
    ++tried;
    std::size_t held = 0;
    constexpr int kPlaces = 300;
    for (int i = 0; i < kPlaces; ++i) {
      const Point place = room.turned({random.between(0, 4), random.between(0, 3), 1.25});
      const bool is_held = holds(region, place, up);
      held += is_held;
      // A surface above or below does not count all its distance: projected it is in the way.
      EXPECT_FALSE(is_held && is_near(room.scene(), place, clearance - 1e-5));
      inside += is_held;
      outside += !is_held;
    }
    // The area by counting: what parts cover twice or not at all would show.
    EXPECT_NEAR(region.area, 12.0 * static_cast<double>(held) / kPlaces,
                4 * 12 * 0.5 / std::sqrt(kPlaces));
  }
  EXPECT_GE(tried, 6u);
  EXPECT_GT(inside, 500u);
  EXPECT_GT(outside, 200u);
}

TEST(FreeRegion, LeavesOutNothingThatIsFarFromWalls) {
  // Pillars only: distances in space are those in the plane.
  constexpr double kClearance = 0.0625, kWidth = 0.25;
  std::size_t far = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    RandomNumbers random(mixed(seed));
    Boxes room = empty_room();
    std::vector<Point> pillars;
    for (int i = 0; i < 5; ++i) {
      const Point least =
          room.scene().lattice.round(Point(random.between(0.5, 3), random.between(0.5, 2), 0));
      pillars.push_back(least);
      room.add(least, least + Point(kWidth, kWidth, 2.5));
    }
    const FreeRegion region = find_free_region(room.scene(), at(1.25, kClearance));
    if (region.others > pillars.size()) continue;  // the insides of pillars are free, too
    for (int i = 0; i < 200; ++i) {
      const Point place(random.between(0, 4), random.between(0, 3), 1.25);
      const bool in_a_pillar = std::ranges::any_of(pillars, [&](const Point& least) {
        return place.x() > least.x() && place.x() < least.x() + kWidth && place.y() > least.y() &&
               place.y() < least.y() + kWidth;
      });
      if (in_a_pillar || is_near(room.scene(), place, kClearance * 1.09 + 0.002)) continue;
      ++far;
      EXPECT_TRUE(holds(region, place, 2)) << place.transpose();
    }
  }
  EXPECT_GT(far, 300u);
}

TEST(FreeRegion, SeedChoosesTheRoom) {
  Boxes rooms;
  rooms.add({0, 0, 0}, {4, 3, 2.5});
  rooms.add({4, 0, 0}, {6, 3, 2.5});
  FreeRegionOptions options = at(1.5, 0.25);
  const FreeRegion largest = find_free_region(rooms.scene(), options);
  EXPECT_NEAR(largest.area, 3.5 * 2.5, 0.02);
  EXPECT_EQ(largest.others, 1u);
  EXPECT_NEAR(largest.area_of_others, 1.5 * 2.5, 0.02);
  options.seed = Point(5, 1, 99);
  EXPECT_NEAR(find_free_region(rooms.scene(), options).area, 1.5 * 2.5, 0.02);
  for (const Point& bad : {Point(4.1, 1, 1.5), Point(-1, 1, 1.5)}) {
    options.seed = bad;
    EXPECT_THAT(
        [&] { find_free_region(rooms.scene(), options); },
        ThrowsMessage<InputError>(HasSubstr("--seed-point: is outside the scene, or nearer")));
  }
}

TEST(FreeRegion, RefusesWhatLeavesNoSpace) {
  const Boxes room = empty_room();
  EXPECT_THAT([&] { find_free_region(room.scene(), at(1.5, 1.6)); },
              ThrowsMessage<InputError>(HasSubstr("--height: no free space is left")));
  EXPECT_THAT([&] { find_free_region(room.scene(), at(0, 0)); },
              ThrowsMessage<InputError>(HasSubstr("--height: no free space is left")));
  EXPECT_THAT([&] { find_free_region(room.scene(), at(3, 0.1)); },
              ThrowsMessage<InputError>(
                  HasSubstr("--height: 3 is outside the scene, which goes from 0 to 2.5")));
  EXPECT_THAT([&] { find_free_region(room.scene(), at(1, -1)); },
              ThrowsMessage<InputError>(HasSubstr("--clearance: is negative")));
}

FreeBoxOptions between(double low, double high, double clearance, int up = 2) {
  FreeBoxOptions options;
  options.up_axis = up;
  options.low = low;
  options.high = high;
  options.clearance = clearance;
  return options;
}

TEST(FreeBoxes, FillAnEmptyRoomWhicheverWayIsUp) {
  constexpr double kClearance = 0.25;
  for (int up = 0; up < 3; ++up) {
    SCOPED_TRACE(up);
    const Boxes room = empty_room(up);
    FreeBoxOptions options = between(1, 2, kClearance, up);
    // 4 along the room's first axis, 3 along its second, 2 layers.
    const auto along = [&](int axis) -> std::size_t& {
      return options.cells[static_cast<std::size_t>((up + 1 + axis) % 3)];
    };
    along(0) = 4;
    along(1) = 3;
    along(2) = 2;
    const FreeBoxes free = find_free_boxes(room.scene(), options);
    ASSERT_EQ(free.boxes.size(), 24u);
    EXPECT_NEAR(free.area, 3.5 * 2.5, 0.2);
    EXPECT_NEAR(free.area + free.left_out, 3.5 * 2.5, 0.02);
    double volume = 0;
    for (std::size_t i = 0; i < free.boxes.size(); ++i) {
      volume += free.boxes[i].volume();
      EXPECT_GE(free.boxes[i].min()[up], 1);
      EXPECT_LE(free.boxes[i].max()[up], 2);
      for (std::size_t j = 0; j < i; ++j) {
        EXPECT_LE(free.boxes[i].intersection(free.boxes[j]).sizes().minCoeff(), 0);
      }
    }
    EXPECT_NEAR(volume, 3.5 * 2.5, 0.4);
    EXPECT_NO_THROW(check_region_is_free(
        "region", room.scene(), make_viewing_region({}, free.boxes, 0), {.clearance = kClearance}));
  }
}

TEST(FreeBoxes, LeaveOutWhatIsNotWhollyFree) {
  Boxes room = empty_room();
  room.add({0.5, 0.5, 0}, {1.5, 1.5, 0.7});  // a table below
  room.add({2, 1, 1.9}, {2.2, 1.2, 2.5});    // a lamp that hangs into the upper layer only
  FreeBoxOptions options = between(1, 2, 0.05);
  options.cells = {8, 6, 2};
  const FreeBoxes free = find_free_boxes(room.scene(), options);
  EXPECT_LT(free.boxes.size(), 96u);
  EXPECT_GE(free.boxes.size(), 96u - 2 * 4) << "it reaches into four columns at most";
  EXPECT_NEAR(free.left_out, 3.9 * 2.9 - free.area, 0.2);
  for (const Box& box : free.boxes) {
    EXPECT_FALSE(box.contains(Point(2.1, 1.1, 1.95)));
    EXPECT_FALSE(box.contains(Point(2.1, 1.1, 1.05))) << "layers have the same plan";
  }
  EXPECT_NO_THROW(check_region_is_free(
      "region", room.scene(), make_viewing_region({}, free.boxes, 0), {.clearance = 0.05}));
  // The grid is all or nothing: a single box does not go round the lamp.
  options.cells = {1, 1, 1};
  EXPECT_THAT([&] { find_free_boxes(room.scene(), options); },
              ThrowsMessage<InputError>(HasSubstr("--cells: none of 1 x 1 x 1 is wholly free")));
}

}  // namespace
}  // namespace viewcover::testing
