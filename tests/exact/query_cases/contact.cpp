#include "exact/query_cases.h"

namespace viewcover::testing {
namespace {

/// The section at any height is square(kS, z).
const Ends kUpright{square(kS, 0), square(kS, 8)};

const std::string kFillsSection = "The pieces abut and fill the hull's section at z = 4.";

void add_covers(QueryCaseList& list) {
  list.hidden("plate of the hull's section", kUpright, {square(kS, 4)},
              "All segments pass z = 4 within the section, which is the plate.");
  list.hidden("plate one unit wider", kUpright, {square(kS + 1, 4)},
              "All segments pass z = 4 within the plate.");
  list.visible("plate one unit short", kUpright, {horizontal(-kS, -kS, kS - 1, kS, 4)},
               "Upright segments with x > S - 1 are free.");
  list.hidden("copy of the element one unit below it", kUpright, {square(kS, 7)},
              "All segments pass z = 7 within the section, which is the plate.");

  list.hidden("two abutting slats", kUpright, cut_square(kS, 4, {7}), kFillsSection);
  list.hidden("three abutting slats", kUpright, cut_square(kS, 4, {-kS + 1, 0}), kFillsSection);
  list.hidden("four abutting slats", kUpright, cut_square(kS, 4, {-5, -4, 3}), kFillsSection);
  const Polygons five = cut_square(kS, 4, {-kS / 2, -1, 0, 1000});
  list.hidden("five abutting slats", kUpright, five, kFillsSection);
  list.visible("five slats, one missing", kUpright, without(five, 2),
               "Upright segments with x in (-1, 0) are free.");
  Polygons gap = five;
  gap[3] = horizontal(1, -kS, gap[3][1].x(), kS, 4);
  list.visible("five slats, one gap of one unit", kUpright, gap,
               "Upright segments with x in (0, 1) are free.");
  list.hidden("abutting slats of the element's corners within edges",
              {kUpright.region,
               {{-kS, -kS, 8}, {-5, -kS, 8}, {kS, -kS, 8}, {kS, 3, 8}, {kS, kS, 8}, {-kS, kS, 8}}},
              {{{-kS, -kS, 4}, {-7, -kS, 4}, {5, -kS, 4}, {5, 0, 4}, {5, kS, 4}, {-kS, kS, 4}},
               {{5, kS, 4}, {5, 9, 4}, {5, -kS, 4}, {kS, -kS, 4}, {kS, kS, 4}}},
              kFillsSection);

  Polygons junction{horizontal(-kS, -kS, kS, 0, 4), horizontal(-kS, 0, 5, kS, 4),
                    horizontal(5, 0, kS, kS, 4)};
  list.hidden("T-junction", kUpright, junction, kFillsSection);
  junction[0] = horizontal(-kS, -kS, kS, -1, 4);
  list.visible("T-junction, one unit apart", kUpright, junction,
               "Upright segments with y in (-1, 0) are free.");

  const Polygons wheel{horizontal(-kS, -kS, 2, -3, 4), horizontal(2, -kS, kS, 3, 4),
                       horizontal(-2, 3, kS, kS, 4), horizontal(-kS, -3, -2, kS, 4),
                       horizontal(-2, -3, 2, 3, 4)};
  list.hidden("pinwheel of five", kUpright, wheel, kFillsSection);
  Polygons loose = wheel;
  loose[4] = horizontal(-2, -3, 1, 3, 4);
  list.visible("pinwheel, hub one unit short", kUpright, loose,
               "Upright segments with x in (1, 2), y in (-3, 3) are free.");

  Polygons tiles;
  const double cuts[] = {-kS, -kS / 2, 3, kS};
  for (int i = 0; i < 9; ++i) {
    tiles.push_back(horizontal(cuts[i % 3], cuts[i / 3], cuts[i % 3 + 1], cuts[i / 3 + 1], 4));
  }
  list.hidden("nine tiles", kUpright, tiles, kFillsSection);
  list.visible("eight of nine tiles", kUpright, without(tiles, 4),
               "Upright segments through the missing tile are free.");
  list.visible("chessboard of five tiles that touch at corners", kUpright,
               {tiles[0], tiles[2], tiles[4], tiles[6], tiles[8]},
               "Upright segments through the other four fields are free.");

  list.hidden("three copies of a cover", kUpright, repeated({square(kS, 4)}, 3),
              "The plate hides, however often it is there.");
  list.visible("three copies of half a cover", kUpright,
               repeated({horizontal(-kS, -kS, 0, kS, 4)}, 3),
               "Upright segments with x > 0 are free.");
  list.hidden("copies of abutting slats, overlapping", kUpright,
              joined({cut_square(kS, 4, {7}), cut_square(kS, 4, {-9}), cut_square(kS, 4, {7})}),
              kFillsSection);
}

void add_fans(QueryCaseList& list) {
  const ConvexPolygon rim{{kS, -kS, 4}, {kS, 0, 4},  {kS, kS, 4},   {0, kS, 4},
                          {-kS, kS, 4}, {-kS, 0, 4}, {-kS, -kS, 4}, {0, -kS, 4}};
  const Polygons blades = fan({3, 5, 4}, rim);
  list.hidden("fan of eight round a hub", kUpright, blades, kFillsSection);
  list.visible("fan of eight, one missing", kUpright, without(blades, 6),
               "Upright segments through the missing blade are free.");
  Polygons loose = blades;
  loose[1][0] = Point(4, 5, 4);
  list.visible("fan of eight, one blade one unit off the hub", kUpright, loose,
               "The blade shrinks, so a part of the section of positive area is uncovered.");

  list.hidden("plate on the diagonal of the hull", kUpright, {slat({-kS, 0}, {kS, 8}, -kS, kS)},
              "Its plane parts region and element and meets the hull in the plate.");
  list.hidden(
      "plate on the diagonal of the hull, as two triangles", kUpright,
      {{{-kS, -kS, 0}, {kS, -kS, 8}, {kS, kS, 8}}, {{-kS, -kS, 0}, {kS, kS, 8}, {-kS, kS, 0}}},
      "Together they are the plate on the diagonal.");
  list.visible("plate on the diagonal, one unit short at the element", kUpright,
               {slat({-kS, 0}, {kS - 1, 8}, -kS, kS)}, "Upright segments with x > S - 1 are free.");

  const double a = 0x1p16;
  const Ends turned{level(0, {{-2 * a, -2 * a}, {4 * a, -2 * a}, {-2 * a, 4 * a}}),
                    level(8, {{2 * a, 2 * a}, {-4 * a, 2 * a}, {2 * a, -4 * a}})};
  const ConvexPolygon hexagon = level(
      4, {{3 * a, 0}, {0, 3 * a}, {-3 * a, 3 * a}, {-3 * a, 0}, {0, -3 * a}, {3 * a, -3 * a}});
  list.hidden("hexagon between opposed triangles", turned, {hexagon},
              "Half the Minkowski sum of the triangles is the hexagon.");
  list.hidden("hexagon between opposed triangles, as a fan", turned, fan({1, 1, 4}, hexagon),
              "The fan is the hexagon, half the Minkowski sum of the triangles.");
  ConvexPolygon dented = hexagon;
  dented[0].x() -= 1;
  list.visible(
      "hexagon with one corner one unit short", turned, {dented},
      "The corner is the midpoint of a corner of each triangle: segments near it are free.");

  const double b = kS / 2;
  const Ends mixed{octagon(2 * b, b, 0), square(2 * b, 8)};
  const ConvexPolygon middle = octagon(2 * b, 1.5 * b, 4);
  list.hidden("octagon between octagon and square", mixed, {middle},
              "Half the Minkowski sum of octagon and square is the plate.");
  list.hidden("octagon between octagon and square, as a fan", mixed, fan({-1, 2, 4}, middle),
              "The fan is half the Minkowski sum of octagon and square.");
  Polygons blunt = fan({-1, 2, 4}, middle);
  blunt[0][2].y() -= 1;
  list.visible("octagon between octagon and square, as a fan with one corner one unit short", mixed,
               blunt, "The blade shrinks, so a part of the section of positive area is uncovered.");
}

void add_boxes(QueryCaseList& list) {
  list.hidden("box of the hull's section", kUpright, box({-kS, -kS, 2}, {kS, kS, 4}),
              "Its floor fills the section; its sides graze the hull.");
  list.visible("box one unit smaller", kUpright, box({-kS, -kS, 2}, {kS - 1, kS, 4}),
               "Upright segments with x > S - 1 are free.");
  list.hidden("two boxes sharing a side", kUpright,
              joined({box({-kS, -kS, 2}, {3, kS, 4}), box({3, -kS, 2}, {kS, kS, 4})}),
              "Their floors abut and fill the section.");
  list.visible("two boxes one unit apart", kUpright,
               joined({box({-kS, -kS, 2}, {3, kS, 4}), box({4, -kS, 2}, {kS, kS, 4})}),
               "Upright segments with x in (3, 4) are free.");
  list.hidden(
      "two boxes sharing an edge only", kUpright,
      joined({box({-kS, -kS, 1}, {3, kS, 4}), box({3, -kS, 4}, {kS, kS, 7})}),
      "In profile the boxes meet in the point (3, 4): their union connects the hull's sides.");
  list.fully("box beside the hull, touching", kUpright, box({kS, -kS, 2}, {2 * kS, kS, 4}),
             "It touches the hull in a side.");
  list.visible("box entering the hull by one unit", kUpright,
               box({kS - 1, -kS, 2}, {2 * kS, kS, 4}), "Upright segments with x < S - 1 are free.");
  list.fully("four boxes round the hull, touching", kUpright,
             joined({box({kS, -kS, 0}, {2 * kS, kS, 8}), box({-2 * kS, -kS, 0}, {-kS, kS, 8}),
                     box({-kS, kS, 0}, {kS, 2 * kS, 8}), box({-kS, -2 * kS, 0}, {kS, -kS, 8})}),
             "They touch the hull in its sides.");
  list.fully("box touching an edge of the hull", kUpright, box({kS, kS, 2}, {2 * kS, 2 * kS, 4}),
             "It touches the hull in the edge x = y = S.");
  list.fully("tube of the hull's sides", kUpright, tube({-kS, -kS, 0}, {kS, kS, 8}),
             "Its sides are sides of the hull.");
  list.visible("tube one unit within the hull", kUpright,
               tube({1 - kS, 1 - kS, 1}, {kS - 1, kS - 1, 7}),
               "Upright segments within the tube are free.");
  list.fully("triangle touching the hull's side with a corner", kUpright,
             {{{kS, 0, 4}, {kS + 3, 5, 2}, {kS + 2, -4, 9}}}, "Only its corner is on the hull.");
  list.visible("triangle with a corner one unit within", kUpright,
               {{{kS - 1, 0, 4}, {kS + 3, 5, 2}, {kS + 2, -4, 9}}},
               "Upright segments with x < S - 1 are free.");
}

void add_umbras(QueryCaseList& list) {
  // Homothetic about the axis: hidden iff q <= s H/h - l (H - h)/h for half sides l, s, q.
  const std::string bound = "Umbra of coaxial plates: hidden iff q <= s H/h - l (H-h)/h; here ";
  const auto twice = [](double d) { return Ends{square(kS, 0), square(kS / 2 + d, 8)}; };
  const Polygons smaller{square(3 * kS / 4, 4)};
  list.hidden("umbra of squares, on the boundary", twice(0), smaller, bound + "q = S/2 = bound.");
  list.hidden("umbra of squares, one unit within", twice(-1), smaller, bound + "q = bound - 1.");
  list.visible("umbra of squares, one unit beyond", twice(1), smaller, bound + "q = bound + 1.");
  list.visible("umbra of squares, plate one unit smaller", twice(0), {square(3 * kS / 4 - 1, 4)},
               bound + "q = bound + 2.");

  const auto thrice = [](double d) { return Ends{square(kS / 2, 0), square(2 * kS + d, 9)}; };
  list.hidden("umbra at three heights, on the boundary", thrice(0), {square(kS, 3)},
              bound + "q = 2 S = bound.");
  list.hidden("umbra at three heights, one unit within", thrice(-1), {square(kS, 3)},
              bound + "q = bound - 1.");
  list.visible("umbra at three heights, one unit beyond", thrice(1), {square(kS, 3)},
               bound + "q = bound + 1.");
  list.hidden("umbra at three heights, plate in four quarters", thrice(0),
              {horizontal(-kS, -kS, 0, 0, 3), horizontal(0, -kS, kS, 0, 3),
               horizontal(-kS, 0, 0, kS, 3), horizontal(0, 0, kS, kS, 3)},
              bound + "q = 2 S = bound, and the quarters abut.");

  list.hidden("umbra of a tiny source, on the boundary", {square(1, 0), square(kS + 1, kS)},
              {square(2, 1)}, bound + "H = S, h = l = 1, s = 2, q = S + 1 = bound.");
  list.visible("umbra of a tiny source, one unit beyond", {square(1, 0), square(kS + 2, kS)},
               {square(2, 1)}, bound + "H = S, h = l = 1, s = 2, q = S + 2.");

  const double a = kS / 16;
  list.hidden("umbra of pentagons, on the boundary", {pentagon(a, 0), pentagon(4 * a, 3)},
              {pentagon(2 * a, 1)}, bound + "in multiples of a pentagon: l = a, s = 2a, q = 4a.");
  list.visible("umbra of pentagons, one unit beyond", {pentagon(a, 0), pentagon(4 * a + 1, 3)},
               {pentagon(2 * a, 1)},
               bound + "in multiples of a pentagon: l = a, s = 2a, q = 4a + 1.");
  list.hidden("umbra of pentagons, as a fan", {pentagon(a, 0), pentagon(4 * a, 3)},
              fan({5, -3, 1}, pentagon(2 * a, 1)), "The fan is the plate on the boundary.");
}

}  // namespace

std::vector<QueryCase> contact_cases() {
  QueryCaseList list;
  add_covers(list);
  add_fans(list);
  add_boxes(list);
  add_umbras(list);
  return list.take();
}

}  // namespace viewcover::testing
