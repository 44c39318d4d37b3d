#include "exact/query_cases.h"

namespace viewcover::testing {
namespace {

void add_coplanar_covers(QueryCaseList& list) {
  const Ends upright{square(kS, 0), square(kS, 4)};
  list.fully("the element as its own occluder", upright, {upright.element},
             "An occluder in the element's plane blocks nothing.");
  list.fully("sheets in the planes of both", upright, {square(2 * kS, 0), square(2 * kS, 4)},
             "Occluders in these planes block nothing.");
  list.visible("sheets in the planes of both, and half a plate", upright,
               {square(2 * kS, 0), square(2 * kS, 4), horizontal(-kS, -kS, 0, kS, 2)},
               "Upright segments with x > 0 are free.");
  list.hidden("sheets in the planes of both, and two half plates", upright,
              joined({{square(2 * kS, 0), square(2 * kS, 4)}, cut_square(kS, 2, {0})}),
              "The half plates abut and fill the section.");
  list.hidden("sheet one unit above the region", upright, {square(kS, 1)},
              "The sheet fills the section.");

  const Ends crossing{square(kS, 0), upright_x(3 * kS, -kS, -kS, kS, kS)};
  list.fully("sheet in the region's plane, which cuts the element", crossing, {square(4 * kS, 0)},
             "An occluder in the region's plane blocks nothing.");
  list.fully("sheet between, in the region's plane", crossing,
             {horizontal(kS + 1, -kS, 2 * kS, kS, 0)},
             "An occluder in the region's plane blocks nothing.");
  list.visible("sheet one unit above the region's plane", crossing, {square(4 * kS, 1)},
               "Segments that go down are free.");
  list.visible("sheets one unit above and below the region's plane", crossing,
               {square(4 * kS, 1), square(4 * kS, -1)},
               "Segments to element points with |z| < 1 are free.");
  list.hidden("sheet that carries the element", {square(kS, 0), upright_x(3 * kS, -kS, 1, kS, kS)},
              {square(4 * kS, 1)}, "All segments pass z = 1 within the sheet.");
  list.hidden("sheets one unit above and below the region's plane, and a stop between", crossing,
              {square(4 * kS, 1), square(4 * kS, -1), upright_x(2 * kS, -kS, -1, kS, 1)},
              "In profile the sheets and the stop enclose the region from the right.");
}

void add_shared_edges(QueryCaseList& list) {
  const Ends corner{horizontal(0, 0, kS, kS, 0), upright_x(0, 0, 0, kS, kS)};
  const double h = kS / 2;
  list.fully("shared edge", corner, {}, "Nothing is between.");
  const std::string cut = "The bisector x = z parts the two; segments pass it at x <= S/2";
  list.hidden("shared edge, plate on the bisector", corner, {slat({0, 0}, {h, h}, 0, kS)},
              cut + ", within the plate.");
  list.visible("shared edge, plate one unit short far from the edge", corner,
               {slat({0, 0}, {h - 1, h - 1}, 0, kS)}, cut + "; the plate ends at S/2 - 1.");
  list.visible("shared edge, plate one unit off the edge", corner, {slat({1, 1}, {h, h}, 0, kS)},
               "Segments near the shared edge pass the bisector at x < 1.");
  list.hidden("shared edge, bent plate", corner, chain({{0, 0}, {kS / 4, kS / 8}, {h, h}}, 0, kS),
              "The profile of the plate connects the shared edge to the hull's far side.");
  list.visible("shared edge, bent plate with a joint of one unit", corner,
               {slat({0, 0}, {kS / 4, kS / 8}, 0, kS), slat({kS / 4 + 1, kS / 8}, {h, h}, 0, kS)},
               "Segments that lean to -x pass the joint at z = S/8.");
  list.hidden(
      "shared edge, region and element as occluders too, plate in two", corner,
      {corner.region, corner.element, slat({0, 0}, {h, h}, 0, 9), slat({0, 0}, {h, h}, 9, kS)},
      "The halves abut in the plate on the bisector.");

  const Ends partly{horizontal(0, 0, kS, kS, 0), upright_x(0, h, 0, 3 * h, kS)};
  list.fully("edges that overlap by half", partly, {}, "Nothing is between.");
  list.hidden("edges that overlap by half, plate on the bisector", partly,
              {slat({0, 0}, {h, h}, 0, 3 * h)}, cut + ", 0 <= y <= 3S/2.");
  list.visible("edges that overlap by half, plate one unit short along them", partly,
               {slat({0, 0}, {h, h}, 0, 3 * h - 1)},
               "Segments that end near the element's lower far corner pass the bisector near it.");

  const Ends vertex{horizontal(0, 0, kS, kS, 0), {{0, 0, 0}, {-kS, 0, kS}, {0, -kS, kS}}};
  const auto diagonal = [](double z) {
    return Polygons{{{-kS, kS, z}, {kS, -kS, z}, {kS, -kS, kS}, {-kS, kS, kS}}};
  };
  list.fully("shared vertex", vertex, {}, "Nothing is between.");
  list.hidden("shared vertex, plate between", vertex, diagonal(0),
              "The plane x + y = 0 parts the two; the hull meets it within the plate.");
  list.visible("shared vertex, plate one unit above it", vertex, diagonal(1),
               "Segments near the vertex pass x + y = 0 at z < 1.");

  const Ends on_edge{horizontal(0, 0, kS, kS, 0),
                     {{0, h, 0}, {-kS, h / 2, kS}, {-kS, 3 * h / 2, kS}}};
  const std::string over = "Segments pass x = 0 at z = p q / (p + q) <= S/2 for ends x = p, z = q";
  list.fully("vertex on an edge", on_edge, {}, "Nothing is between.");
  list.hidden("vertex on an edge, wall between", on_edge, {upright_x(0, 0, 0, kS, h)},
              over + ", within the wall.");
  list.visible("vertex on an edge, wall one unit short above", on_edge,
               {upright_x(0, 0, 0, kS, h - 1)}, over + "; the wall ends at S/2 - 1.");
  list.visible("vertex on an edge, wall one unit short below", on_edge, {upright_x(0, 0, 1, kS, h)},
               over + ", near 0 by the vertex.");

  const Ends standing{square(2 * kS, 0), upright_x(0, -kS, 0, kS, 2 * kS)};
  const ConvexPolygon right = slat({0, 0}, {kS, kS}, -2 * kS, 2 * kS);
  const ConvexPolygon left = slat({0, 0}, {-kS, kS}, -2 * kS, 2 * kS);
  const std::string tent = "On each side segments pass |x| = z at |x| <= 2S 2S / 4S = S";
  list.fully("wall standing on the region", standing, {}, "Nothing is between.");
  list.hidden("wall standing on the region, plates on both bisectors", standing, {left, right},
              tent + ", within the plates.");
  list.visible("wall standing on the region, one side covered", standing, {right},
               "The other side is seen.");
  list.visible("wall standing on the region, one plate one unit short", standing,
               {left, slat({0, 0}, {kS - 1, kS - 1}, -2 * kS, 2 * kS)},
               tent + "; one plate ends at S - 1.");
  list.hidden("wall standing on the region, one-sided, its front covered", standing, {right},
              tent + "; the back does not count.")
      .query.one_sided = true;

  list.fully("region's edge in the element's plane, apart",
             {corner.region, upright_x(0, 2 * kS, 0, 3 * kS, kS)}, {}, "Nothing is between.");
  list.fully("region's edge in the element's plane, above",
             {corner.region, upright_x(0, 0, kS, kS, 2 * kS)}, {}, "Nothing is between.");
  list.hidden("region's edge in the element's plane, shelf between",
              {corner.region, upright_x(0, 0, kS, kS, 2 * kS)}, {horizontal(0, 0, h, kS, kS)},
              "Segments pass z = S at x = p (1 - S/q) <= S/2, within the shelf.");
}

void add_cut_planes(QueryCaseList& list) {
  const Ends below{horizontal(0, 0, kS, kS, 0), upright_x(2 * kS, 0, -kS, kS, kS)};
  const double x = 3 * kS / 2;
  const ConvexPolygon upper = upright_x(x, 0, 0, kS, kS), lower = upright_x(x, 0, -kS, kS, 0);
  list.hidden("region's plane cuts the element, one wall through it", below,
              {upright_x(x, 0, -kS, kS, kS)}, "The wall contains the hull's section.");
  list.hidden("region's plane cuts the element, walls that abut in it", below, {upper, lower},
              "The walls contain the hull's section.");
  list.visible("region's plane cuts the element, upper wall only", below, {upper},
               "Segments that go down are free.");
  list.visible("region's plane cuts the element, slit of one unit below", below,
               {upper, upright_x(x, 0, -kS, kS, -1)}, "Segments that go down slightly are free.");
  list.visible("region's plane cuts the element, slit of one unit above", below,
               {lower, upright_x(x, 0, 1, kS, kS)}, "Segments that go up slightly are free.");
  list.hidden("region's plane cuts the element, overlapping walls", below,
              {upright_x(x, 0, -1, kS, kS), upright_x(x - 1, 0, -kS, kS, 1)},
              "Segments up hit the first wall at z > 0, segments down the second at z < 0.");

  const Ends both{square(kS, 0), upright_x(0, 2 * kS, -kS, 3 * kS, kS)};
  const double y = 3 * kS / 2;
  const Polygons quadrants{upright_y(y, -kS, -kS, 0, 0), upright_y(y, 0, -kS, kS, 0),
                           upright_y(y, -kS, 0, 0, kS), upright_y(y, 0, 0, kS, kS)};
  list.fully("both planes cut", both, {}, "Nothing is between.");
  list.hidden("both planes cut, one wall", both, {upright_y(y, -kS, -kS, kS, kS)},
              "The wall contains the hull's section.");
  list.hidden("both planes cut, walls in four quadrants", both, quadrants,
              "The walls abut and contain the hull's section.");
  list.visible("both planes cut, one quadrant free", both, without(quadrants, 1),
               "Segments from x > 0 to z < 0 are free.");
  Polygons narrow = quadrants;
  narrow[3] = upright_y(y, 1, 0, kS, kS);
  list.visible("both planes cut, one quadrant one unit short", both, narrow,
               "Segments from small x > 0 to z > 0 pass the wall's plane at x in (0, 1).");

  // A Z in profile.
  const Ends upright{square(kS, 0), square(kS, 4 * kS)};
  const ConvexPolygon left = horizontal(-kS, -kS, 0, kS, kS);
  const ConvexPolygon right = horizontal(0, -kS, kS, kS, 3 * kS);
  const ConvexPolygon wall = upright_x(0, -kS, kS, kS, 3 * kS);
  list.hidden("two half plates and the wall between them", upright, {left, wall, right},
              "In profile the three connect the hull's sides; any two leave a gap.");
  list.visible("two half plates, the wall one unit short", upright,
               {left, upright_x(0, -kS, kS + 1, kS, 3 * kS), right},
               "Segments pass from right to left of x = 0 at z in (S, S + 1).");
  list.visible("half plate and wall", upright, {left, wall},
               "Upright segments with x > 0 are free.");
  list.hidden("two half plates and a wall that pierces both ends", upright,
              {left, upright_x(0, -kS, -1, kS, 4 * kS + 1), right},
              "The wall contains the one that connects the plates.");
  list.visible("wall that pierces both ends", upright, {upright_x(0, -kS, -kS, kS, 5 * kS)},
               "Upright segments are free.");

  // Its plane is crossed one way and the other.
  const ConvexPolygon cross_x = upright_x(0, -kS, 0, kS, 4 * kS);
  const ConvexPolygon cross_y = upright_y(0, -kS, 0, kS, 4 * kS);
  Polygons quarters{horizontal(-kS, -kS, 0, 0, kS), horizontal(0, -kS, kS, 0, 2 * kS),
                    horizontal(-kS, 0, 0, kS, 2 * kS), horizontal(0, 0, kS, kS, 3 * kS)};
  list.hidden("two crossing walls and a plate in each quarter", upright,
              joined({{cross_x, cross_y}, quarters}),
              "Segments stay in a quarter and hit its plate, or cross a wall.");
  quarters[3] = horizontal(0, 1, kS, kS, 3 * kS);
  list.visible("two crossing walls, one plate one unit short", upright,
               joined({{cross_x, cross_y}, quarters}),
               "Upright segments with x > 0, y in (0, 1) are free.");
}

void add_piercing(QueryCaseList& list) {
  const Ends upright{square(kS, 0), square(kS, 4 * kS)};
  const auto arms = [](Flat tip, double out, double z) {
    return Polygons{slat(tip, {-out, z}, -kS, kS), slat(tip, {out, z}, -kS, kS)};
  };
  const std::string connects = "In profile the arms connect the hull's sides";
  list.hidden("V standing on the region", upright, arms({0, 0}, kS, kS), connects + ".");
  list.hidden("V one unit above the region", upright, arms({0, 1}, kS, kS + 1), connects + ".");
  list.visible("V through the region, one unit deep", upright, arms({0, -1}, kS + 1, kS),
               "The region's strip |x| < 1 is above the arms.");
  list.hidden("roof touching the element along a line", upright, arms({0, 4 * kS}, kS, 3 * kS),
              connects + "; only the line itself is seen.");
  list.hidden("roof one unit below the element", upright, arms({0, 4 * kS - 1}, kS, 3 * kS - 1),
              connects + ".");
  list.visible("roof through the element by one unit", upright,
               arms({0, 4 * kS + 1}, kS + 1, 3 * kS),
               "The element's strip |x| < 1 is under the roof.");
  const auto crossed = [](double z) {
    return Polygons{slat({-kS, z - kS}, {kS, z + kS}, -kS, kS),
                    slat({kS, z - kS}, {-kS, z + kS}, -kS, kS)};
  };
  list.hidden("crossing plates that meet on the element", upright, crossed(4 * kS),
              "Their lower halves are a roof that touches the element along a line.");
  list.visible("crossing plates that meet one unit behind the element", upright,
               crossed(4 * kS + 1), "The element's strip |x| < 1 is under the roof.");
  list.hidden("crossing plates that meet on the region", upright, crossed(0),
              "Their upper halves are a V standing on the region.");
  list.hidden("crossing plates half way", upright, crossed(2 * kS),
              "In profile each connects the hull's sides.");

  const Ends low{horizontal(0, -kS, kS, kS, 0), horizontal(0, -kS, kS, kS, 4)};
  list.hidden("tilted plate that crosses the region's plane beside it", low,
              {slat({-2 * kS, -1}, {2 * kS, 3}, -kS, kS)},
              "It passes the hull from (0, 1) to (S, 2) in profile.");
  list.visible("tilted plate through region and element", low,
               {slat({-1, -4}, {kS + 1, 8}, -kS, kS)},
               "Segments from and to small x > 0 stay above the plate, or below it near x = S.");
  list.fully("plate hinged on the region's edge, below it", upright,
             {slat({-kS, 0}, {2 * kS, -kS}, -kS, kS)}, "It is behind the region.");
  list.fully("plates behind region and element", upright,
             {square(4 * kS, -1), square(4 * kS, 4 * kS + 1), slat({-9, -9}, {9, -1}, -9, 9)},
             "All are beyond the hull.");
  list.fully(
      "plates in the planes of the hull's sides", upright,
      {upright_x(kS, -4 * kS, -kS, 4 * kS, 4 * kS), upright_y(-kS, -4 * kS, -kS, 4 * kS, 4 * kS)},
      "They touch the hull in its sides.");
  list.visible("triangle with a tip one unit above the region", upright,
               {{{0, 0, 1}, {0, 0, -kS}, {0, kS, -kS}}},
               "The tip is inside the hull; upright segments with x > 0 are free.");
  list.fully("triangle with its tip on the region", upright,
             {{{0, 0, 0}, {0, 0, -kS}, {0, kS, -kS}}}, "It only touches the hull.");
  list.visible("hexagon through the element", upright,
               {{{0, 2, 4 * kS},
                 {0, 1, 4 * kS + 2},
                 {0, -1, 4 * kS + 2},
                 {0, -2, 4 * kS},
                 {0, -1, 4 * kS - 2},
                 {0, 1, 4 * kS - 2}}},
               "Its lower half is inside the hull; upright segments with x > 0 are free.");
}

}  // namespace

std::vector<QueryCase> plane_cases() {
  QueryCaseList list;
  add_coplanar_covers(list);
  add_shared_edges(list);
  add_cut_planes(list);
  add_piercing(list);
  return list.take();
}

}  // namespace viewcover::testing
