#include "exact/query_cases.h"

namespace viewcover::testing {
namespace {

const Ends kBay{square(kS, 0), square(kS, 4)};

void add_single_slits(QueryCaseList& list) {
  list.visible("slit of one unit", kBay, slit_x(kS, 2, 0, 1),
               "Upright segments with x in (0, 1) are free.");
  list.visible("slit of one unit at the edge of the hull", kBay,
               {horizontal(1 - kS, -kS, kS, kS, 2)}, "Upright segments with x < 1 - S are free.");
  list.visible("wedge from nothing to one unit", kBay,
               {horizontal(-kS, -kS, 0, kS, 2), level(2, {{0, -kS}, {kS, -kS}, {kS, kS}, {1, kS}})},
               "Upright segments through the open wedge are free.");
  list.visible("slit of one unit between copies", kBay, repeated(slit_x(kS, 2, 0, 1), 3),
               "Upright segments with x in (0, 1) are free.");
  list.visible("slit of one unit in a tilted wall", kBay,
               {slat({-kS, 1}, {0, 2}, -kS, kS), slat({1, 2}, {kS, 3}, -kS, kS)},
               "Upright segments with x in (0, 1) are free.");
  list.hidden("tilted wall in two pieces that meet in a ridge", kBay,
              chain({{-kS, 1}, {0, 3}, {kS, 2}}, -kS, kS),
              "The profile of the wall connects the hull's sides.");
  list.hidden("zigzag of ten slats", kBay,
              chain({{-kS, 1},
                     {-9, 3},
                     {-7, 2},
                     {-4, 3},
                     {-3, 1},
                     {0, 2},
                     {0, 3},
                     {5, 1},
                     {6, 2},
                     {9, 1},
                     {kS, 3}},
                    -kS, kS),
              "The profile of the zigzag connects the hull's sides.");
  list.visible("zigzag, one joint one unit open", kBay,
               joined({chain({{-kS, 1}, {-9, 3}, {-7, 2}, {-4, 3}, {-3, 1}, {0, 2}}, -kS, kS),
                       chain({{1, 2}, {5, 1}, {6, 2}, {9, 1}, {kS, 3}}, -kS, kS)}),
               "Upright segments with x in (0, 1) are free.");
}

void add_parallel_slits(QueryCaseList& list) {
  // Segments through x1 at z = 1 and x3 at z = 3 end in x4 = (3 x3 - x1) / 2, which must be < S.
  const std::string reach = "x4 = (3 x3 - x1)/2 > (3 c - 1)/2 for slits (0, 1) at z = 1 and (c, ";
  const double c = 174763;  // (2 S + 1) / 3
  list.hidden("two slits, reaching the element's edge only", kBay,
              joined({slit_x(kS, 1, 0, 1), slit_x(kS, 3, c, c + 1)}),
              reach + "c + 1) at z = 3; here (3 c - 1)/2 = S.");
  list.visible("two slits, one unit nearer", kBay,
               joined({slit_x(kS, 1, 0, 1), slit_x(kS, 3, c - 1, c)}),
               reach + "c + 1) at z = 3; here (3 c - 1)/2 = S - 3/2.");
  list.hidden("two slits, one unit farther", kBay,
              joined({slit_x(kS, 1, 0, 1), slit_x(kS, 3, c + 1, c + 2)}),
              reach + "c + 1) at z = 3; here (3 c - 1)/2 = S + 3/2.");

  const auto three = [](double middle_from, double middle_to, double last_to) {
    return joined(
        {slit_x(kS, 1, 0, 1), slit_x(kS, 2, middle_from, middle_to), slit_x(kS, 3, 1000, last_to)});
  };
  const std::string mean =
      "x2 = (x1 + x3)/2 with x1 in (0, 1), x3 in (1000, 1001) fills (500, 501)";
  list.visible("three slits in line", kBay, three(500, 501, 1001), mean + ", the middle slit.");
  list.hidden("three slits, one plane of lines, above", kBay, three(501, 502, 1001),
              mean + ", which only touches [501, 502].");
  list.hidden("three slits, one plane of lines, below", kBay, three(499, 500, 1001),
              mean + ", which only touches [499, 500].");
  list.visible("three slits, the last one unit wider", kBay, three(501, 502, 1002),
               "x2 = (x1 + x3)/2 with x1 in (0, 1), x3 in (1000, 1002) fills (500, 501.5).");
  list.visible("three slits, the middle one unit wider", kBay, three(500, 502, 1001),
               mean + ", within the middle slit.");

  const auto run = [](const std::vector<double>& starts, double pitch) {
    Polygons plates;
    double z = 1;
    for (const double start : starts) {
      const double from = start + pitch * z;
      plates = joined({plates, slit_x(kS, z, from, from + 1)});
      z += 1;
    }
    return plates;
  };
  const Ends deep{square(kS, 0), square(kS, 6)};
  list.visible("five slits in line", deep, run({0, 0, 0, 0, 0}, 100),
               "The segments x = 100 z + e with e in (0, 1) are free.");
  list.hidden("five slits, the middle one a unit off", deep, run({0, 0, 1, 0, 0}, 100),
              "Less 100 z, the mean of x2 and x4 is below 1, x3 above 1.");
  list.visible("five slits along a steeper line", deep, run({0, 1, 1, 2, 2}, 100),
               "The segment x = 100 z + (1 + 2 z)/4 passes inside all five slits.");
  list.hidden("four slits on one plane of lines", deep, run({0, 2, 2, 4}, 0),
              "x2 - x1 > 1 and x3 - x2 < 1 exclude each other; only x = z touches all edges.");
  list.visible("four slits, the second one unit wider", deep,
               joined({run({0}, 0), slit_x(kS, 2, 1, 3), slit_x(kS, 3, 2, 3), slit_x(kS, 4, 4, 5)}),
               "The segment x = 1.04 z - 0.14 passes inside all four slits.");
}

/// The plate 3 y - 4 x <= bound for side = 1, >= bound for side = -1, at z = 4, beyond the hull;
/// (x, y) is on its edge.
ConvexPolygon oblique(double x, double y, double side) {
  return level(4, {{x - 96, y - 128},
                   {x + 96, y + 128},
                   {x + 96 + 128 * side, y + 128 - 96 * side},
                   {x - 96 + 128 * side, y - 128 - 96 * side}});
}

void add_crossed_slits(QueryCaseList& list) {
  list.visible("crossed slits of one unit", kBay,
               joined({slit_x(kS, 1, 0, 1), slit_y(kS, 3, 0, 1)}),
               "Upright segments with x and y in (0, 1) are free.");
  list.hidden("crossed slits, one closed", kBay, joined({slit_x(kS, 1, 0, 0), slit_y(kS, 3, 0, 1)}),
              "The plates at z = 1 abut and fill the section.");
  const double c = 174763;
  list.hidden("slits along y, x, y, reaching the element's edge only", kBay,
              joined({slit_x(kS, 1, 0, 1), slit_y(kS, 2, 0, 1), slit_x(kS, 3, c, c + 1)}),
              "x4 = (3 x3 - x1)/2 > (3 c - 1)/2 = S.");
  list.visible("slits along y, x, y, one unit nearer", kBay,
               joined({slit_x(kS, 1, 0, 1), slit_y(kS, 2, 0, 1), slit_x(kS, 3, c - 1, c)}),
               "x4 = (3 x3 - x1)/2 may be any value above S - 3/2; y is free to be in (0, 1).");

  const double m = 64;
  const Ends ends{square(m, 0), square(m, 5)};
  const Polygons three = joined(
      {slit_x(m, 1, 0, 1),
       slit_y(m, 2, 0, 1),
       {level(3, {{-m, -m}, {m, m}, {-m, m}}), level(3, {{1 - m, -m}, {m, -m}, {m, m - 1}})}});
  list.visible("three slits in three directions", ends, three,
               "The upright segment at x = 3/4, y = 1/4 passes inside all slits.");
  const std::string regulus =
      "With x1, y2 and s = x3 - y3 in (0, 1), 3 y4 - 4 x4 = 2 x1 - 3 y2 - 6 s fills (-9, 2); the "
      "fourth slit is 3 y - 4 x in ";
  list.hidden("four slits in four directions, above the regulus", ends,
              joined({three, {oblique(1, 2, 1), oblique(-2, 2, -1)}}), regulus + "(2, 14).");
  list.visible("four slits in four directions, one unit lower", ends,
               joined({three, {oblique(-1, -1, 1), oblique(-1, 3, -1)}}), regulus + "(1, 13).");
  list.hidden("four slits in four directions, below the regulus", ends,
              joined({three, {oblique(6, 1, 1), oblique(3, 1, -1)}}), regulus + "(-21, -9).");
  list.visible("four slits in four directions, one unit higher", ends,
               joined({three, {oblique(5, 0, 1), oblique(2, 0, -1)}}), regulus + "(-20, -8).");
}

void add_half_walls(QueryCaseList& list) {
  // Walls x <= a at z = 1, x >= b at z = 3. x0 = (3 x1 - x3)/2 <= S and x4 = (3 x3 - x1)/2 >= -S.
  const auto walls = [](double a, double b) {
    return Polygons{horizontal(-kS, -kS, a, kS, 1), horizontal(b, -kS, kS, kS, 3)};
  };
  const double h = kS / 2;
  list.visible("half walls that meet in projection", kBay, walls(0, 0),
               "Segments from x > 0 to x < 0 pass both edges.");
  const std::string extreme =
      "Free segments have x1 > a, x3 < b, x3 > 3 x1 - 2 S, 3 x3 > x1 - 2 S; ";
  list.hidden("half walls at the extreme line", kBay, walls(h, -h),
              extreme + "a = S/2, b = -S/2 leave only the line from edge to edge.");
  list.visible("half walls, the upper one unit back", kBay, walls(h, -h + 1),
               extreme + "a = S/2, b = 1 - S/2 leave room near the extreme line.");
  list.visible("half walls, the lower one unit back", kBay, walls(h - 1, -h),
               extreme + "x1 = S/2 - 3/4, x3 = -S/2 - 1/8 solve all.");
  list.hidden("half walls, overlapping by one unit at the bottom", kBay, walls(h + 1, -h + 3),
              extreme + "a = S/2 + 1 needs x3 > 3 - S/2 = b.");
  list.visible("half walls, one unit off the overlap", kBay, walls(h + 1, -h + 4),
               extreme + "a = S/2 + 1 needs x3 > 3 - S/2 = b - 1.");
  list.hidden("half walls overlapping by one unit each", kBay, walls(h + 1, -h - 1),
              extreme + "they cover more than the walls at the extreme line.");
}

void add_louvres(QueryCaseList& list) {
  // Slats from (1 + k d, 1) to (1 + (k + 1) d, 2): segments that lean to -x hit one.
  const double d = kS / 4;
  Polygons louvre;
  for (int k = -5; k < 5; ++k) louvre.push_back(slat({1 + k * d, 1}, {1 + (k + 1) * d, 2}, 0, kS));
  const auto ends = [](double to) {
    return Ends{horizontal(0, 0, kS, kS, 0), horizontal(-kS, 0, to, kS, 3)};
  };
  const std::string passing = "Passing slats k - 1 and k needs x1 < 1 + k d < x2; ";
  list.hidden("louvre of ten, leaning segments only", ends(0), louvre,
              passing + "all segments have x2 < x1.");
  list.hidden("louvre of ten, element up to the joint", ends(1), louvre,
              passing + "segments with x2 > x1 have 0 < x1 < x2 < 1.");
  list.visible("louvre of ten, element one unit beyond the joint", ends(2), louvre,
               passing + "x1 slightly below 1 and x2 slightly above reach the element.");
  list.visible("louvre of ten, one missing", ends(0), without(louvre, 4),
               "Upright segments just right of x = 0 pass the missing slat.");

  list.visible("upright fins", kBay,
               {upright_x(-kS / 2, -kS, 1, kS, 3), upright_x(0, -kS, 1, kS, 3),
                upright_x(1, -kS, 1, kS, 3), upright_x(kS / 2, -kS, 1, kS, 3)},
               "Upright segments between the fins are free.");
  list.visible("egg crate", kBay,
               {upright_x(0, -kS, 1, kS, 3), upright_x(1, -kS, 1, kS, 3),
                upright_y(0, -kS, 1, kS, 3), upright_y(1, -kS, 1, kS, 3)},
               "Upright segments between the fins are free.");
}

void add_windows(QueryCaseList& list) {
  const Polygons wall = frame(kS, 2, 2);
  list.visible("window", kBay, wall, "Upright segments through the window are free.");
  list.hidden("window plugged exactly", kBay, joined({wall, {square(2, 2)}}),
              "Wall and plug fill the section.");
  list.visible("window plugged but for one unit", kBay,
               joined({wall, {horizontal(-2, -2, 2, 1, 2)}}),
               "Upright segments with x in (-2, 2), y in (1, 2) are free.");
  const std::string before = "x1 = (x0 + x2)/2 with |x0| < S, |x2| < 2 fills |x1| < S/2 + 1";
  list.hidden("window covered from one unit before it", kBay,
              joined({wall, {square(kS / 2 + 1, 1)}}), before + ", the cover; and so for y.");
  list.visible("window covered but for one unit", kBay, joined({wall, {square(kS / 2, 1)}}),
               before + ", one unit more than the cover.");
  list.visible("window covered but for one unit on one side", kBay,
               joined({wall, {horizontal(-kS / 2 - 1, -kS / 2 - 1, kS / 2 + 1, kS / 2, 1)}}),
               before + ", and so for y, where the cover ends at S/2.");

  const double b = kS / 2, c = kS / 4;
  const Ends octagons{octagon(2 * b, b, 0), octagon(2 * b, b, 4)};
  const ConvexPolygon outer = octagon(2 * b, b, 2), inner = octagon(2 * c, c, 2);
  Polygons ring;
  for (std::size_t i = 0; i < 8; ++i) {
    ring.push_back({outer[i], outer[(i + 1) % 8], inner[(i + 1) % 8], inner[i]});
  }
  list.hidden("octagonal ring with its plug", octagons, joined({ring, {inner}}),
              "Ring and plug fill the section; each of the nine is needed.");
  ConvexPolygon dented = inner;
  dented[1].x() -= 1;
  list.visible("octagonal ring, the plug one unit short at a corner", octagons,
               joined({ring, {dented}}),
               "Upright segments through the uncovered part of the section are free.");
  list.visible("octagonal ring, one piece missing", octagons, joined({without(ring, 3), {inner}}),
               "Upright segments through the missing piece are free.");
}

}  // namespace

std::vector<QueryCase> slit_cases() {
  QueryCaseList list;
  add_single_slits(list);
  add_parallel_slits(list);
  add_crossed_slits(list);
  add_half_walls(list);
  add_louvres(list);
  add_windows(list);
  return list.take();
}

}  // namespace viewcover::testing
