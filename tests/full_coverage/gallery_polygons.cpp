#include "full_coverage/gallery_polygons.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <fstream>

namespace viewcover::testing {
namespace {

Loop2 rectangle(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
}
Loop2 rectangular_hole(double x0, double y0, double x1, double y1) {
  return {{x0, y0}, {x0, y1}, {x1, y1}, {x1, y0}};
}

/// Any point sees all of a convex polygon.
void add_convex(std::vector<GalleryCase>& cases) {
  cases.push_back({"triangle", {{0, 0}, {4, 0}, {1, 3}}, {}, 1, {{1.5, 1}}, {{1, 1}}});
  cases.push_back({"square", rectangle(0, 0, 4, 4), {}, 1, {{1, 3}}, {{2, 1.5}}});
  cases.push_back({"needle", {{0, 0}, {32, 0}, {31, 1}}, {}, 1, {{1, 0.015625}}, {{30, 0.5}}});
  cases.push_back({"octagon",
                   {{2, 0}, {5, 0}, {7, 2}, {7, 5}, {5, 7}, {2, 7}, {0, 5}, {0, 2}},
                   {},
                   1,
                   {{6, 1.5}},
                   {{3, 4}}});
}

/// Three rooms off a square, of which each halves the kernel: it is
/// 2 <= x <= 4, 2 <= y <= 4, x + y >= 8 - slack, whose three sides are lines of walls.
GalleryCase crossing_star(const std::string& name, double slack) {
  return {name,
          {{0, 0},
           {8 - slack, 0},
           {9 - slack, -1},
           {9.5, -1},
           {9.5, 0},
           {10, 0},
           {10, 2},
           {12, 2},
           {12, 4},
           {10, 4},
           {10, 10},
           {4, 10},
           {4, 12},
           {2, 12},
           {2, 10},
           {0, 10}},
          {},
          1,
          {{4 - slack / 4, 4 - slack / 4}},
          {{5, 6}},
          slack > 0};
}

/// A polygon is star-shaped if some point is on the inner side of the lines of all walls.
void add_stars(std::vector<GalleryCase>& cases) {
  // Kernel: the square where the bars meet.
  cases.push_back({"cross",
                   {{1, 0},
                    {2, 0},
                    {2, 1},
                    {3, 1},
                    {3, 2},
                    {2, 2},
                    {2, 3},
                    {1, 3},
                    {1, 2},
                    {0, 2},
                    {0, 1},
                    {1, 1}},
                   {},
                   1,
                   {{1.5, 1.5}},
                   {{1.5, 1.25}}});
  // Walls lead 8/7 past the middle.
  cases.push_back({"four spikes",
                   {{8, 0}, {1, 1}, {0, 8}, {-1, 1}, {-8, 0}, {-1, -1}, {0, -8}, {1, -1}},
                   {},
                   1,
                   {{0.25, 0.125}},
                   {{7, 0.0625}}});
  // Two rooms that overlap in a square of side 1/64, the kernel: 4 <= x <= 4 + 1/64 is needed for
  // the upper and lower walls at the opening, 2 - 1/64 <= y <= 2 for the others.
  const double e = 1.0 / 64;
  cases.push_back({"two rooms, a tiny kernel",
                   {{0, 0}, {4 + e, 0}, {4 + e, 2 - e}, {8, 2 - e}, {8, 4}, {4, 4}, {4, 2}, {0, 2}},
                   {},
                   1,
                   {{4 + e / 2, 2 - e / 2}},
                   {{7, 3}}});
  // The walls at (4, 4) ask for x <= 4 and y <= 4, that from (7, 1) to (8, 0) for x + y >= 8: the
  // reflex corner (4, 4) is all of the kernel.
  cases.push_back({"a reflex corner sees all",
                   {{0, 0}, {7, 1}, {8, 0}, {9, 0}, {9, 4}, {4, 4}, {4, 8}, {0, 8}},
                   {},
                   1,
                   {{4, 4}},
                   {{1, 2}},
                   false});
  cases.push_back(crossing_star("a crossing of wall lines sees all", 0));
  cases.push_back(crossing_star("a triangle between wall lines sees all", 1.0 / 256));
}

/// k teeth of width 1 and height 8 on a corridor of height 1, 4 apart; upright, or leaning by 1/2.
/// A guard in the corridor below a tooth, in the strip between the lines of its walls, sees the
/// tooth and the corridor: k guards. What sees the witness, 1/8 below the middle of the tip, lies
/// in its tooth or, through an opening of width 1 at a distance of 7 7/8, in a stretch of the
/// corridor no wider than 1 + 1/7: the stretches of different teeth are disjoint.
GalleryCase comb(std::size_t teeth, double lean) {
  GalleryCase comb;
  comb.name = fmt::format("comb, {} {} teeth", teeth, lean == 0 ? "upright" : "leaning");
  comb.optimum = teeth;
  const auto count = static_cast<double>(teeth);
  comb.outer = {{0, 0}, {4 * count, 0}, {4 * count, 1}};
  for (double x = 4 * (count - 1) + 1; x > 0; x -= 4) {
    comb.outer.insert(comb.outer.end(),
                      {{x + 1, 1}, {x + 1 + 8 * lean, 9}, {x + 8 * lean, 9}, {x, 1}});
    comb.guards.emplace_back(x + 0.5 - lean / 2, 0.5);
    comb.witnesses.emplace_back(x + 0.5 + 7.875 * lean + 1.0 / 64, 8.875);
  }
  comb.outer.emplace_back(0, 1);
  return comb;
}

/// Under n steps down to the right: with a point it contains all that lies below and to the left,
/// so that all of [0, 1]^2, which lies between the lines of the lowest and the leftmost step, sees
/// all of it.
GalleryCase staircase(int steps) {
  GalleryCase stairs;
  stairs.name = fmt::format("staircase, {} steps", steps);
  stairs.optimum = 1;
  stairs.outer = {{0, 0}, {steps, 0}};
  for (int i = 1; i <= steps; ++i) {
    stairs.outer.emplace_back(steps + 1 - i, i);
    stairs.outer.emplace_back(steps - i, i);
  }
  stairs.guards = {{0.5, 0.5}};
  stairs.witnesses = {{1.28125, 0.765625}};
  return stairs;
}

/// A corridor of width 1 along a path of axis-parallel pieces at right angles, all at least 4 long.
/// A guard in the middle of a bend sees both its pieces, as they are rectangles: with s pieces, the
/// guards of bends 1, 3, 5, ... (and, for odd s, one in the last piece) are ceil(s / 2). Of what
/// sees a witness in the middle of a piece, all lies in the piece or, past a corner that is at
/// least 3/2 away, less than 1 from its middle line, and so within 1 of the ends of its neighbours,
/// which are at least 4 long: for pieces 1, 3, 5, ... these are disjoint.
GalleryCase corridor(const std::string& name, const std::vector<Place>& path) {
  const std::size_t pieces = path.size() - 1;
  const auto along = [&](std::size_t piece) {
    return Place((path[piece + 1] - path[piece]).normalized());
  };
  const auto left = [](const Place& d) { return Place(-d.y(), d.x()); };
  GalleryCase corridor;
  corridor.name = name;
  corridor.optimum = (pieces + 1) / 2;
  Loop2 far_side;
  for (std::size_t i = 0; i <= pieces; ++i) {
    const Place in = along(i == 0 ? 0 : i - 1), out = along(i == pieces ? pieces - 1 : i);
    const Place end = i == 0 ? Place(-in / 2) : i == pieces ? Place(in / 2) : Place(0, 0);
    const Place aside = i == 0 || i == pieces ? Place(left(in) / 2) : Place(left(in + out) / 2);
    corridor.outer.push_back(path[i] + end - aside);
    far_side.push_back(path[i] + end + aside);
  }
  corridor.outer.insert(corridor.outer.end(), far_side.rbegin(), far_side.rend());
  for (std::size_t piece = 0; piece < pieces; piece += 2) {
    corridor.guards.push_back(path[piece + 1]);
    corridor.witnesses.push_back((path[piece] + path[piece + 1]) / 2 + Place(3.0 / 64, 1.0 / 32));
  }
  return corridor;
}

GalleryCase stairs_corridor(int pieces) {
  std::vector<Place> path = {{0, 0}};
  for (int i = 0; i < pieces; ++i) {
    path.push_back(path.back() + (i % 2 == 0 ? Place(4, 0) : Place(0, 4)));
  }
  return corridor(fmt::format("corridor in steps, {} pieces", pieces), path);
}

/// Outward to the left, four pieces a turn, walls of thickness 1 between.
GalleryCase spiral(int turns) {
  std::vector<Place> path = {{0, 0}};
  Place direction(1, 0);
  for (int i = 0; i < 4 * turns; ++i) {
    path.push_back(path.back() + (4 + i / 2 * 2) * direction);
    direction = Place(-direction.y(), direction.x());
  }
  return corridor(fmt::format("spiral, {} turns", turns), path);
}

/// Crossing corridors of width 1 round m x n square holes of side 10. One guard at a crossing of
/// each row with a column of its own (the last for those that are over) sees all: max(m, n) + 1. Of
/// the longer kind, m + 1 or n + 1 of them, each has a witness in it that no one sees from outside
/// its neighbourhood: it is 5 from the nearest crossings.
GalleryCase grid(int m, int n) {
  GalleryCase grid;
  grid.name = fmt::format("grid of {} x {} holes", m, n);
  grid.optimum = static_cast<std::size_t>(std::max(m, n)) + 1;
  grid.outer = rectangle(0, 0, 11 * m + 1, 11 * n + 1);
  for (int i = 0; i < m; ++i) {
    for (int k = 0; k < n; ++k) {
      grid.holes.push_back(rectangular_hole(11 * i + 1, 11 * k + 1, 11 * i + 11, 11 * k + 11));
    }
  }
  for (int i = 0; i <= std::max(m, n); ++i) {
    grid.guards.emplace_back(11 * std::min(i, m) + 0.5, 11 * std::min(i, n) + 0.5);
    // In columns if there are more of them, else in rows.
    const Place witness(11 * i + 0.5 + 1.0 / 64, 6 + 1.0 / 16);
    grid.witnesses.push_back(m >= n ? witness : Place(witness.y(), witness.x()));
  }
  return grid;
}

void add_holes(std::vector<GalleryCase>& cases) {
  // No point sees both sides of a pillar: what sees a witness 1/8 before the middle of a side of
  // length 2 keeps to its side but for a flare of at most 1/2 at the walls 4 away. The two guards
  // have their shadows behind the pillar on different sides of it.
  const auto pillar = rectangular_hole(4, 4, 6, 6);
  cases.push_back({"a pillar",
                   rectangle(0, 0, 10, 10),
                   {pillar},
                   2,
                   {{1, 1}, {9, 9}},
                   {{3.875, 5.015625}, {6.125, 5.015625}}});
  // As before. The guards look through between the pillars: the shadows of pillars next to them run
  // within parallel lines of slope 7/8 that miss each other, and the farther pillars' lie behind
  // these, where the other guard stands.
  cases.push_back({"two pillars",
                   rectangle(0, 0, 20, 10),
                   {pillar, rectangular_hole(14, 4, 16, 6)},
                   2,
                   {{2, 0.5}, {18, 9.5}},
                   {{3.875, 5.015625}, {6.125, 5.015625}}});
  // A slanted pillar in a slanted room.
  cases.push_back({"a triangular pillar",
                   {{0, 0}, {12, -2}, {16, 6}, {8, 14}, {-2, 8}},
                   {{{6, 4}, {5, 7}, {8, 6}}},
                   2,
                   {{1, 3}, {14, 7}},
                   {{5.375, 5.5}, {7.125, 4.875}, {6.53125, 6.625}}});
  // Three corridors: a guard at a corner sees two of them, none sees a part of each witness's.
  cases.push_back({"a ring of three corridors",
                   {{0, 0}, {32, 0}, {16, 24}},
                   {{{4, 2}, {16, 20}, {28, 2}}},
                   2,
                   {{2, 1}, {30, 1}},
                   {{16.0625, 1}, {9, 11.53125}, {23, 11.46875}}});
  cases.push_back(grid(1, 1));
  cases.push_back(grid(2, 1));
  cases.push_back(grid(1, 3));
  cases.push_back(grid(2, 2));
}

std::vector<const Loop2*> loops_of(const GalleryCase& gallery) {
  std::vector<const Loop2*> loops = {&gallery.outer};
  for (const Loop2& hole : gallery.holes) loops.push_back(&hole);
  return loops;
}

}  // namespace

std::vector<GalleryCase> gallery_cases() {
  std::vector<GalleryCase> cases;
  add_convex(cases);
  add_stars(cases);
  for (std::size_t teeth = 2; teeth <= 6; ++teeth) cases.push_back(comb(teeth, 0));
  cases.push_back(comb(3, 0.5));
  for (const int steps : {2, 6}) cases.push_back(staircase(steps));
  for (const int pieces : {2, 3, 5, 8}) cases.push_back(stairs_corridor(pieces));
  for (int turns = 1; turns <= 3; ++turns) cases.push_back(spiral(turns));
  add_holes(cases);
  return cases;
}

void write_floor_plan(const GalleryCase& gallery, const std::filesystem::path& file) {
  std::ofstream stream(file);
  fmt::print(stream, "# {}, art gallery number {}\n", gallery.name, gallery.optimum);
  for (const Loop2* loop : loops_of(gallery)) {
    if (loop != &gallery.outer) fmt::print(stream, "hole\n");
    for (const Place& corner : *loop) fmt::print(stream, "{} {}\n", corner.x(), corner.y());
  }
}

FloorPlan floor_plan_of(const GalleryCase& gallery) {
  FloorPlan plan;
  std::size_t line = 1;
  for (const Loop2* loop : loops_of(gallery)) {
    if (!plan.empty()) ++line;
    plan.emplace_back();
    for (const Place& corner : *loop) {
      plan.back().push_back({Point(corner.x(), corner.y(), 0), ++line});
    }
  }
  return plan;
}

}  // namespace viewcover::testing
