#include <string>
#include <utility>
#include <vector>

#include "scene/generate/furniture.h"

namespace viewcover {

namespace {

constexpr double kWidth = 6;  // along x, from west to east
constexpr double kDepth = 5;  // along y, from south to north
constexpr double kHeight = 2.5;
constexpr double kEyeHeight = 1.6015625;  // 205/128: on the lattice
constexpr double kRug = 3.0 / 256;        // thickness of the rugs

// The way through the wall between two rooms: floor, height and thickness.
constexpr double kDoorSouth = 0.5, kDoorNorth = 1.4, kDoorHeight = 2, kDoorDepth = 0.125;

// Which ends of a room lead to another one.
struct Doorways {
  bool west = false, east = false;
};

// Shell with inward normals: a window set back in the south wall, a door in the east wall, closed
// where it leads nowhere.
void add_shell(SceneBuilder& scene, Doorways open) {
  const Placement room;
  // Rectangles of the planes x = c and y = c, as seen with the first coordinate to the right.
  const auto along_x = [&](double y, double x0, double x1, double z0, double z1) {
    scene.add_face({room(x0, y, z0), room(x1, y, z0), room(x1, y, z1), room(x0, y, z1)});
  };
  const auto along_y = [&](double x, double y0, double y1, double z0, double z1) {
    scene.add_face({room(x, y0, z0), room(x, y1, z0), room(x, y1, z1), room(x, y0, z1)});
  };
  const auto level = [&](double z, double x0, double x1, double y0, double y1) {
    scene.add_face({room(x0, y0, z), room(x1, y0, z), room(x1, y1, z), room(x0, y1, z)});
  };

  scene.begin_group("floor");
  level(0, 0, kWidth, 0, kDepth);
  scene.begin_group("ceiling");
  level(kHeight, 0, kWidth, kDepth, 0);
  scene.begin_group("wall-north");
  along_x(kDepth, 0, kWidth, 0, kHeight);
  scene.begin_group("wall-west");
  if (open.west) {
    along_y(0, 0, kDoorSouth, 0, kHeight);
    along_y(0, kDoorNorth, kDepth, 0, kHeight);
    along_y(0, kDoorSouth, kDoorNorth, kDoorHeight, kHeight);
  } else {
    along_y(0, 0, kDepth, 0, kHeight);
  }

  const double w0 = 2;
  const double w1 = 4;
  const double sill = 0.875;
  const double lintel = 2.125;
  const double pane = -0.25;
  scene.begin_group("wall-south");
  along_x(0, kWidth, 0, 0, sill);
  along_x(0, kWidth, 0, lintel, kHeight);
  along_x(0, w0, 0, sill, lintel);
  along_x(0, kWidth, w1, sill, lintel);
  scene.begin_group("window");
  along_x(pane, w1, w0, sill, lintel);
  level(sill, w0, w1, pane, 0);
  level(lintel, w0, w1, 0, pane);
  along_y(w0, pane, 0, sill, lintel);
  along_y(w1, 0, pane, sill, lintel);

  const double d0 = kDoorSouth;
  const double d1 = kDoorNorth;
  const double door = kWidth + kDoorDepth;
  scene.begin_group("wall-east");
  along_y(kWidth, d0, 0, 0, kHeight);
  along_y(kWidth, kDepth, d1, 0, kHeight);
  along_y(kWidth, d1, d0, kDoorHeight, kHeight);
  scene.begin_group("door");
  if (!open.east) along_y(door, d1, d0, 0, kDoorHeight);
  level(0, kWidth, door, d0, d1);
  level(kDoorHeight, kWidth, door, d1, d0);
  along_x(d0, door, kWidth, 0, kDoorHeight);
  along_x(d1, kWidth, door, 0, kDoorHeight);
}

void add_region(SceneBuilder& scene) {
  const double margin = 0.75;
  const double x1 = kWidth - margin;
  const double y1 = kDepth - margin;
  scene.add_region({{margin, margin, kEyeHeight},
                    {x1, margin, kEyeHeight},
                    {x1, y1, kEyeHeight},
                    {margin, y1, kEyeHeight}});
}

// So many books stand in compartment (column, row) of a bookshelf.
struct Shelf {
  int column, row, books;
};

void add_bookshelf(SceneBuilder& scene, const Placement& at, const Point& size,
                   const Compartments& compartments, const std::vector<Shelf>& shelves) {
  scene.begin_group("bookshelf");
  add_carcass(scene, at, size, compartments);
  scene.begin_group("books");
  int first = 0;
  for (const Shelf& shelf : shelves) {
    Point inner;
    const Placement place = compartment(at, size, compartments, shelf.column, shelf.row, inner);
    add_books(scene, place, inner, shelf.books, first);
    first += shelf.books;
  }
}

// Nothing stands or hangs in an open way to the west.
void furnish_simple(SceneBuilder& scene, Doorways open) {
  scene.begin_group("rug");
  add_box(scene, {}, {1.6, 2.2, 0}, {3.0, 3.65, kRug});
  scene.begin_group("sofa");
  add_sofa(scene, {2.3, 4.2, 0}, 2.0, 2, Finish::kPlain);
  scene.begin_group("armchair-west");
  add_sofa(scene, {1.0, 2.2, 0, {-64, 111}}, 0.9, 1, Finish::kPlain);
  scene.begin_group("armchair-east");
  add_sofa(scene, {3.65, 2.65, 0, {-33, -124}}, 0.9, 1, Finish::kPlain);
  scene.begin_group("coffee-table");
  add_table(scene, {2.3, 2.9, kRug}, {1.1, 0.6, 0.45});
  scene.begin_group("dining-table");
  add_table(scene, {4.5, 1.3, 0}, {1.2, 0.8, 0.75});
  scene.begin_group("chair-west");
  add_chair(scene, {3.75, 1.3, 0, {8, 128}}, Finish::kPlain);
  scene.begin_group("chair-north");
  add_chair(scene, {4.5, 1.9, 0, {111, 64}}, Finish::kPlain);
  add_bookshelf(scene, {0.36, 3.95, 0, kFacingEast}, {0.9, 0.34, 2.1}, {1, 4, 0.03, 0.3},
                {{0, 1, 3}, {0, 2, 1}});
  scene.begin_group("cupboard");
  add_carcass(scene, {5.5, 2.9, 0, kFacingWest}, {0.8, 0.45, 2.0}, {1, 1, 0.06, 0.02});
  scene.begin_group("lamp");
  add_floor_lamp(scene, {5.4, 4.6, 0}, Finish::kPlain);
  scene.begin_group("picture");
  add_picture(scene, {1.8, kDepth, 1.4}, 1.0, 0.6, Finish::kPlain);
  if (open.west) return;
  scene.begin_group("plant");
  add_plant(scene, {0.45, 0.45, 0}, 7, false);
}

void furnish_complex(SceneBuilder& scene, Doorways open) {
  scene.begin_group("rug");
  add_box(scene, {}, {1.6, 2.2, 0}, {3.0, 3.65, kRug});
  scene.begin_group("round-rug");
  add_frustum(scene, {4.5, 1.3, 0}, kOctagon, 14, 14, 0, kRug, Caps::kBoth);
  scene.begin_group("sofa");
  add_sofa(scene, {2.3, 4.2, 0}, 2.2, 3, Finish::kFine);
  scene.begin_group("armchair-west");
  add_sofa(scene, {1.0, 2.2, 0, {-64, 111}}, 0.9, 1, Finish::kFine);
  scene.begin_group("armchair-east");
  add_sofa(scene, {3.65, 2.75, 0, {-33, -124}}, 0.9, 1, Finish::kFine);
  scene.begin_group("coffee-table");
  add_table(scene, {2.3, 2.9, kRug}, {1.1, 0.6, 0.45});
  scene.begin_group("bowl");
  add_bowl(scene, {2.15, 2.95, kRug + 0.45});
  scene.begin_group("dining-table");
  add_table(scene, {4.5, 1.3, kRug}, {1.2, 0.8, 0.75});
  scene.begin_group("crockery");
  add_place_setting(scene, {4.2, 1.1, kRug + 0.75});
  add_place_setting(scene, {4.7, 1.5, kRug + 0.75, {-111, 64}});
  scene.begin_group("chair-west");
  add_chair(scene, {3.75, 1.3, kRug, {8, 128}}, Finish::kFine);
  scene.begin_group("chair-north");
  add_chair(scene, {4.5, 1.9, kRug, {124, 33}}, Finish::kFine);
  scene.begin_group("chair-east");
  add_chair(scene, {5.25, 1.35, kRug, {0, -128}}, Finish::kFine);
  scene.begin_group("chair-south");
  add_chair(scene, {4.45, 0.7, kRug, {-127, 16}}, Finish::kFine);
  add_bookshelf(scene, {0.36, 3.4, 0, kFacingEast}, {1.5, 0.34, 2.1}, {3, 5, 0.03, 0.3},
                {{0, 1, 7}, {1, 2, 8}, {2, 2, 5}, {0, 3, 6}, {2, 3, 6}, {1, 4, 4}});
  scene.begin_group("sideboard");
  add_carcass(scene, {5.55, 4.35, 0, kFacingWest}, {1.2, 0.4, 0.5}, {3, 1, 0.03, 0.36});
  scene.begin_group("television");
  add_television(scene, {5.75, 3.75, 0.5, kFacingWest}, 0.9);
  scene.begin_group("cupboard");
  add_carcass(scene, {5.5, 2.9, 0, kFacingWest}, {1.0, 0.45, 2.0}, {2, 2, 0.04, 0.02});
  scene.begin_group("floor-lamp");
  add_floor_lamp(scene, {5.5, 4.65, 0}, Finish::kFine);
  scene.begin_group("pendant-lamp");
  add_pendant_lamp(scene, {4.5, 1.3, 0}, kHeight);
  scene.begin_group("side-table");
  add_table(scene, {0.9, 4.4, 0}, {0.45, 0.45, 0.5});
  scene.begin_group("table-lamp");
  add_table_lamp(scene, {0.9, 4.4, 0.5});
  scene.begin_group("pictures");
  add_picture(scene, {1.4, kDepth, 1.4}, 0.7, 0.5, Finish::kFine);
  add_picture(scene, {2.4, kDepth, 1.3}, 0.5, 0.7, Finish::kFine);
  if (!open.west) {
    add_picture(scene, {0, 1.6, 1.3, kFacingEast}, 0.9, 0.6, Finish::kFine);
    scene.begin_group("plant-west");
    add_plant(scene, {0.45, 0.45, 0}, 8, true);
  }
  scene.begin_group("plant-north");
  add_plant(scene, {4.1, 4.5, 0}, 8, true);
  scene.begin_group("curtains");
  add_curtain(scene, {1.5, 0.15, 0}, 0.5, 0.05, 2.3, 6);
  add_curtain(scene, {4.0, 0.15, 0}, 0.5, 0.05, 2.3, 6);
  scene.begin_group("blinds");
  add_blinds(scene, {2.02, -0.2, 0}, 1.96, 1.5, 2.1, 10);
  scene.begin_group("radiator");
  add_radiator(scene, {2.2, 0.04, 0}, 1.6, 8);
}

void add_room(SceneBuilder& scene, RoomDetail detail, Doorways open) {
  add_shell(scene, open);
  add_region(scene);
  detail == RoomDetail::kSimple ? furnish_simple(scene, open) : furnish_complex(scene, open);
}

}  // namespace

GeneratedScene living_room(RoomDetail detail) {
  SceneBuilder scene(detail == RoomDetail::kSimple ? "viewcover living room, simple"
                                                   : "viewcover living room, complex");
  add_room(scene, detail, {});
  return std::move(scene).finish();
}

GeneratedScene row_of_rooms(std::size_t rooms, RoomDetail detail) {
  SceneBuilder scene("viewcover row of " + std::to_string(rooms) + " living rooms, " +
                     (detail == RoomDetail::kSimple ? "simple" : "complex"));
  for (std::size_t i = 0; i < rooms; ++i) {
    scene.move_to({static_cast<double>(i) * (kWidth + kDoorDepth), 0, 0},
                  "room-" + std::to_string(i + 1) + "/");
    add_room(scene, detail, {.west = i > 0, .east = i + 1 < rooms});
  }
  return std::move(scene).finish();
}

}  // namespace viewcover
