#include <fmt/format.h>

#include <utility>

#include "scene/generate/analytic_parts.h"

namespace viewcover {

namespace {

constexpr double kEye = 1.5;  // height of the viewing regions, metres

struct NamedWall {
  std::string group;
  std::array<double, 2> from, to;  ///< the room lies to the left of the way
};

void add_walls(SceneBuilder& scene, const std::vector<NamedWall>& walls, double height) {
  for (const NamedWall& wall : walls) {
    scene.begin_group(wall.group);
    add_upright(scene, wall.from, wall.to, 0, height);
  }
}

void add_rectangular_walls(SceneBuilder& scene, const Rectangle& r, double height) {
  add_walls(scene,
            {{"wall-south", {r.x0, r.y0}, {r.x1, r.y0}},
             {"wall-east", {r.x1, r.y0}, {r.x1, r.y1}},
             {"wall-north", {r.x1, r.y1}, {r.x0, r.y1}},
             {"wall-west", {r.x0, r.y1}, {r.x0, r.y0}}},
            height);
}

void add_floor(SceneBuilder& scene, const Rectangle& r) {
  scene.begin_group("floor");
  add_facing_up(scene, r, 0);
}

void add_ceiling(SceneBuilder& scene, const Rectangle& r, double height) {
  scene.begin_group("ceiling");
  add_facing_down(scene, r, height);
}

// The six faces of a box, each its own group PREFIX-top and so on, facing outward.
void add_named_box(SceneBuilder& scene, const std::string& prefix, const Rectangle& r, double low,
                   double high) {
  scene.begin_group(prefix + "-top");
  add_facing_up(scene, r, high);
  scene.begin_group(prefix + "-bottom");
  add_facing_down(scene, r, low);
  scene.begin_group(prefix + "-south");
  add_upright(scene, {r.x1, r.y0}, {r.x0, r.y0}, low, high);
  scene.begin_group(prefix + "-north");
  add_upright(scene, {r.x0, r.y1}, {r.x1, r.y1}, low, high);
  scene.begin_group(prefix + "-west");
  add_upright(scene, {r.x0, r.y0}, {r.x0, r.y1}, low, high);
  scene.begin_group(prefix + "-east");
  add_upright(scene, {r.x1, r.y1}, {r.x1, r.y0}, low, high);
}

AnalyticScene empty_room() {
  const Rectangle room{0, 4, 0, 4};
  const double height = 2.5;
  SceneBuilder scene("viewcover analytic empty-room");
  add_floor(scene, room);
  add_ceiling(scene, room, height);
  add_rectangular_walls(scene, room, height);
  add_region_part(scene, {1, 3, 1, 3}, kEye);

  AnalyticScene answer;
  answer.name = "empty-room";
  answer.derivation =
      "The room is convex: a line from inside to a wall meets no other wall on its way. Every "
      "region sees everything, one suffices.";
  answer.regions = 16;
  answer.optimal_regions = 1;
  answer.scene = std::move(scene).finish();
  answer.visible_groups = answer.scene.groups;
  return answer;
}

// The middle of the room of 6 x 6, where boxes stand.
constexpr Rectangle kMiddle{2.5, 3.5, 2.5, 3.5};
constexpr Rectangle kLargeRoom{0, 6, 0, 6};
constexpr double kLargeHeight = 3;

AnalyticScene cube_in_room() {
  SceneBuilder scene("viewcover analytic cube-in-room");
  add_floor(scene, {0, 6, 0, 2.5});  // round the cube
  add_floor(scene, {0, 6, 3.5, 6});
  add_floor(scene, {0, 2.5, 2.5, 3.5});
  add_floor(scene, {3.5, 6, 2.5, 3.5});
  add_ceiling(scene, kLargeRoom, kLargeHeight);
  add_rectangular_walls(scene, kLargeRoom, kLargeHeight);
  add_named_box(scene, "cube", kMiddle, 0, 1);
  add_region_part(scene, {2.75, 3.25, 0.75, 1.25}, kEye);
  add_region_part(scene, {2.75, 3.25, 4.75, 5.25}, kEye);
  add_region_part(scene, {0.75, 1.25, 2.75, 3.25}, kEye);
  add_region_part(scene, {4.75, 5.25, 2.75, 3.25}, kEye);

  AnalyticScene answer;
  answer.name = "cube-in-room";
  answer.derivation =
      "The cube [5/2, 7/2]^2 x [0, 1] stands in the middle of a room, one region part at z = 3/2 "
      "before each side face, within the slab of the two neighbouring side faces. A side face is "
      "seen only from beyond its plane, and only its own part lies there: four regions are needed. "
      "One region of each part, any one, suffices: y <= 5/2 is a convex part of the room without "
      "the cube, seen whole by the southern regions; so are y >= 7/2, x <= 5/2 and x >= 7/2 by "
      "theirs and z >= 1 by all, and these five make up the room without the cube. The bottom is "
      "reached from above only through the cube: hidden.";
  answer.regions = 4;
  answer.optimal_regions = 4;
  answer.hidden_groups = {"cube-bottom"};
  answer.scene = std::move(scene).finish();
  for (const std::string& group : answer.scene.groups) {
    if (group != "cube-bottom") answer.visible_groups.push_back(group);
  }
  return answer;
}

AnalyticScene nested_boxes() {
  SceneBuilder scene("viewcover analytic nested-boxes");
  add_floor(scene, kLargeRoom);
  add_ceiling(scene, kLargeRoom, kLargeHeight);
  add_rectangular_walls(scene, kLargeRoom, kLargeHeight);
  add_named_box(scene, "box", kMiddle, 0.25, 1.25);
  add_named_box(scene, "inner", {2.75, 3.25, 2.75, 3.25}, 0.5, 1);
  add_region_part(scene, {2.75, 3.25, 0.75, 1.25}, kEye);
  add_region_part(scene, {2.75, 3.25, 4.75, 5.25}, kEye);

  AnalyticScene answer;
  answer.name = "nested-boxes";
  answer.derivation =
      "A closed box [5/2, 7/2]^2 x [1/4, 5/4] hangs in the room and holds a smaller one, which is "
      "hidden on all sides. Two region parts of one region each at z = 3/2, south and north of the "
      "box, both within 11/4 <= x <= 13/4. They lie behind the planes of the box's west, east and "
      "bottom faces, whose fronts are thus hidden, and their backs are inside the box. The south "
      "face is seen from the southern part only, the north face from the northern one only: both "
      "are needed, and there are no more. The southern region sees all of y <= 5/2, the northern "
      "all of y >= 7/2, both all of z >= 5/4, as these parts of the room are convex and empty.";
  answer.regions = 1;
  answer.optimal_regions = 2;
  answer.hidden_groups = {"box-bottom",  "box-west",    "box-east",   "inner-top", "inner-bottom",
                          "inner-south", "inner-north", "inner-west", "inner-east"};
  answer.visible_groups = {"ceiling", "wall-south", "wall-north",
                           "box-top", "box-south",  "box-north"};
  answer.scene = std::move(scene).finish();
  return answer;
}

AnalyticScene two_rooms() {
  const double height = 2.5;
  const double a = 4;  // the wall between the rooms, from a to b
  const double b = 4.25;
  const double depth = 4;
  const double d0 = 1.5;  // the door
  const double d1 = 2.5;
  const double lintel = 2;
  const double end = 8.25;
  SceneBuilder scene("viewcover analytic two-rooms");
  scene.begin_group("room-a");
  add_facing_up(scene, {0, a, 0, depth}, 0);
  add_facing_down(scene, {0, a, 0, depth}, height);
  add_walls(scene,
            {{"room-a", {0, 0}, {a, 0}},
             {"room-a", {a, depth}, {0, depth}},
             {"room-a", {0, depth}, {0, 0}},
             {"partition-a", {a, 0}, {a, d0}},
             {"partition-a", {a, d1}, {a, depth}}},
            height);
  add_upright(scene, {a, d0}, {a, d1}, lintel, height);
  scene.begin_group("room-b");
  add_facing_up(scene, {b, end, 0, depth}, 0);
  add_facing_down(scene, {b, end, 0, depth}, height);
  add_walls(scene,
            {{"room-b", {b, 0}, {end, 0}},
             {"room-b", {end, 0}, {end, depth}},
             {"room-b", {end, depth}, {b, depth}},
             {"partition-b", {b, depth}, {b, d1}},
             {"partition-b", {b, d0}, {b, 0}}},
            height);
  add_upright(scene, {b, d1}, {b, d0}, lintel, height);
  scene.begin_group("door");
  add_facing_up(scene, {a, b, d0, d1}, 0);
  add_facing_down(scene, {a, b, d0, d1}, lintel);
  add_upright(scene, {a, d0}, {b, d0}, 0, lintel);
  add_upright(scene, {b, d1}, {a, d1}, 0, lintel);
  add_region_part(scene, {1, 3, 1.75, 2.25}, kEye);
  add_region_part(scene, {5.25, 7.25, 1.75, 2.25}, kEye);

  AnalyticScene answer;
  answer.name = "two-rooms";
  answer.derivation =
      "Rooms x <= 4 and x >= 17/4 are joined by a door 3/2 <= y <= 5/2, z <= 2 through the wall "
      "between them; one region part in each. partition-a lies in the plane x = 4 and faces room "
      "a; the part in room b is behind that plane, and the back is inside the closed wall. So "
      "partition-a is seen from room a only, and partition-b from room b only: two regions are "
      "needed. One of each part, any one, suffices: the rooms are convex, and all regions lie "
      "before the door opening (7/4 <= y <= 9/4, z = 3/2), from where all of its four faces is "
      "seen.";
  answer.regions = 4;
  answer.optimal_regions = 2;
  answer.scene = std::move(scene).finish();
  answer.visible_groups = answer.scene.groups;
  return answer;
}

AnalyticScene comb(int teeth) {
  const double height = 2.5;
  const double mouth = 4;  // teeth are 0 <= y <= 4, the corridor 4 <= y <= 5
  const double back = 5;
  const double left = -1;
  const double right = 2.0 * teeth;
  SceneBuilder scene(fmt::format("viewcover analytic comb-{}", teeth));
  scene.begin_group("corridor");
  add_facing_up(scene, {left, right, mouth, back}, 0);
  add_facing_down(scene, {left, right, mouth, back}, height);
  add_upright(scene, {right, mouth}, {right, back}, 0, height);
  add_upright(scene, {right, back}, {left, back}, 0, height);
  add_upright(scene, {left, back}, {left, mouth}, 0, height);
  for (int tooth = 0; tooth < teeth; ++tooth) {
    const double x0 = 2.0 * tooth;
    const double x1 = x0 + 1;
    scene.begin_group("corridor");
    add_upright(scene, {x0 - 1, mouth}, {x0, mouth}, 0, height);
    if (tooth == teeth - 1) add_upright(scene, {x1, mouth}, {right, mouth}, 0, height);
    scene.begin_group(fmt::format("tooth-{}", tooth + 1));
    add_facing_up(scene, {x0, x1, 0, mouth}, 0);
    add_facing_down(scene, {x0, x1, 0, mouth}, height);
    add_upright(scene, {x0, mouth}, {x0, 0}, 0, height);
    add_upright(scene, {x1, 0}, {x1, mouth}, 0, height);
    scene.begin_group(fmt::format("back-{}", tooth + 1));
    add_upright(scene, {x0, 0}, {x1, 0}, 0, height);
    add_region_part(scene, {x0 + 0.25, x0 + 0.75, 4.25, 4.75}, kEye);
  }

  AnalyticScene answer;
  answer.name = fmt::format("comb-{}", teeth);
  answer.derivation = fmt::format(
      "{0} teeth 2j <= x <= 2j + 1, 0 <= y <= 4 open at y = 4 to a corridor; a region part before "
      "each mouth, 2j + 1/4 <= x <= 2j + 3/4, 17/4 <= y <= 19/4. A line from part i to the back of "
      "tooth j = i + d goes at most 3/19 of its way before it crosses y = 4, there at x - 2i <= "
      "(16 (3/4) + 3 (2d + 1)) / 19 = (15 + 6d) / 19, short of mouth j by (32 d - 15) / 19 >= "
      "17/19; so it meets the wall between the mouths, or the side of another tooth (d < 0 is the "
      "mirror image). The back of a tooth is thus seen from its own part only: {0} regions are "
      "needed. One of each part, any one, suffices: the corridor is convex, and a line from before "
      "a mouth into its tooth stays within 2j <= x <= 2j + 1.",
      teeth);
  answer.regions = 4;
  answer.optimal_regions = static_cast<std::size_t>(teeth);
  answer.scene = std::move(scene).finish();
  answer.visible_groups = answer.scene.groups;
  return answer;
}

// Arms 0 <= y <= 2 to the east and 0 <= x <= 2 to the north, both 6 long.
SceneBuilder l_shape(const std::string& name) {
  const double height = 2.5;
  SceneBuilder scene("viewcover analytic " + name);
  add_floor(scene, {0, 6, 0, 2});
  add_floor(scene, {0, 2, 2, 6});
  add_ceiling(scene, {0, 6, 0, 2}, height);
  add_ceiling(scene, {0, 2, 2, 6}, height);
  add_walls(scene,
            {{"wall-south", {0, 0}, {6, 0}},
             {"end-east", {6, 0}, {6, 2}},
             {"corner-north", {6, 2}, {2, 2}},
             {"corner-east", {2, 2}, {2, 6}},
             {"end-north", {2, 6}, {0, 6}},
             {"wall-west", {0, 6}, {0, 0}}},
            height);
  return scene;
}

AnalyticScene l_shaped_room() {
  AnalyticScene answer;
  answer.name = "l-shaped-room";
  SceneBuilder scene = l_shape(answer.name);
  add_region_part(scene, {0.5, 1.5, 0.5, 1.5}, kEye);
  answer.derivation =
      "The room is the union of the arms 0 <= y <= 2 and 0 <= x <= 2, both convex, and the region "
      "1/2 <= x, y <= 3/2 lies in both: every region sees everything, one suffices.";
  answer.regions = 16;
  answer.optimal_regions = 1;
  answer.scene = std::move(scene).finish();
  answer.visible_groups = answer.scene.groups;
  return answer;
}

AnalyticScene l_shaped_room_arms() {
  AnalyticScene answer;
  answer.name = "l-shaped-room-arms";
  SceneBuilder scene = l_shape(answer.name);
  add_region_part(scene, {4.5, 5.5, 0.5, 1.5}, kEye);
  add_region_part(scene, {0.5, 1.5, 4.5, 5.5}, kEye);
  answer.derivation =
      "As `l-shaped-room`, with a region part near the end of each arm. A line from the northern "
      "part (x >= 1/2, y >= 9/2) to the eastern end (x = 6, y >= 0) has gone at least 5/9 of its "
      "way when it comes down to y = 2, and is there at x >= (4/9) (1/2) + (5/9) 6 = 32/9 > 2: it "
      "has left the northern arm through its wall x = 2. So the eastern end is seen from the "
      "eastern part only, the northern end from the northern one only: two regions are needed. One "
      "of each part, any one, suffices, since the arms are convex.";
  answer.regions = 4;
  answer.optimal_regions = 2;
  answer.scene = std::move(scene).finish();
  answer.visible_groups = answer.scene.groups;
  return answer;
}

}  // namespace

std::vector<AnalyticScene> analytic_rooms() {
  return {empty_room(), cube_in_room(),  two_rooms(),          comb(2),       comb(4),
          comb(8),      l_shaped_room(), l_shaped_room_arms(), nested_boxes()};
}

}  // namespace viewcover
