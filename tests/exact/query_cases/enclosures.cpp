#include "exact/query_cases.h"

namespace viewcover::testing {
namespace {

void add_tubes(QueryCaseList& list) {
  const Ends wide{square(kS, 0), square(4 * kS, 8)};
  const Polygons sides = tube({-kS, -kS, 0}, {kS, kS, 4});
  const ConvexPolygon lid = square(kS, 4);
  list.hidden("tube on the region's edges with a lid", wide, joined({sides, {lid}}),
              "The region is the floor of a closed box.");
  list.visible("tube on the region's edges, lid one unit short", wide,
               joined({sides, {horizontal(-kS, -kS, kS - 1, kS, 4)}}),
               "Upright segments with x > S - 1 are free.");
  list.visible("tube on the region's edges, one unit below its lid", wide,
               joined({tube({-kS, -kS, 0}, {kS, kS, 3}), {lid}}),
               "Segments pass x = S at z in (3, 4), between tube and lid.");
  list.visible("tube one unit above the region's edges, with a lid", wide,
               joined({tube({-kS, -kS, 1}, {kS, kS, 4}), {lid}}),
               "Segments from near the edge x = S pass it at z < 1.");
  list.visible("tube on the region's edges without a lid", wide, sides,
               "Upright segments are free.");
  list.hidden("tube one unit round the region, with a lid", wide,
              joined({tube({-kS - 1, -kS - 1, 0}, {kS + 1, kS + 1, 4}), {square(kS + 1, 4)}}),
              "All segments go up, where the box is closed.");
  list.hidden("tube of twelve plates with a lid of five", wide,
              joined({tube({-kS, -kS, 0}, {kS, kS, 1}), tube({-kS, -kS, 1}, {kS, kS, 3}),
                      tube({-kS, -kS, 3}, {kS, kS, 4}), cut_square(kS, 4, {-3, -2, 0, 1000})}),
              "The pieces are the tube and its lid.");

  const Ends beside{square(kS, 0), upright_x(3 * kS, -kS, -kS, kS, kS)};
  const Polygons closed = box({-kS - 1, -kS - 1, -1}, {kS + 1, kS + 1, 1});
  list.hidden("closed box round the region, its plane cuts the element", beside, closed,
              "The region is inside, the element outside.");
  list.visible("box without floor round the region, its plane cuts the element", beside,
               without(closed, 4), "Segments that leave through the floor reach the element.");
  list.hidden("box without floor, and a skirt under it", beside,
              joined({without(closed, 4), {upright_x(kS + 1, -kS, -kS, kS, -1)}}),
              "Segments to x = 3S pass x = S + 1 at |y| <= S, |z| < S, on the box or the skirt.");

  // From x >= 3 S at z = 0 to x <= S at z = 4 S: x = S is passed at half way or later.
  const Polygons skirt = tube({-kS, -kS, 2 * kS}, {kS, kS, 4 * kS});
  const Polygons shorter = tube({-kS, -kS, 2 * kS + 1}, {kS, kS, 4 * kS});
  const ConvexPolygon ceiling = square(kS, 4 * kS);
  const std::string low =
      "Segments pass x = S at z >= 2 S, near 2 S from edge x = 3 S to edge x = -S";
  list.hidden("skirt round the element, seen from beside",
              {horizontal(3 * kS, -kS, 4 * kS, kS, 0), ceiling}, skirt,
              low + "; the skirt ends at 2 S.");
  list.visible("skirt one unit shorter, seen from beside",
               {horizontal(3 * kS, -kS, 4 * kS, kS, 0), ceiling}, shorter,
               low + "; the skirt ends at 2 S + 1.");
  list.hidden("skirt round the element, seen from beyond its corner",
              {horizontal(3 * kS, 3 * kS, 4 * kS, 4 * kS, 0), ceiling}, skirt,
              low + ", and so for y: they enter the skirt's column at z >= 2 S.");
  list.visible("skirt one unit shorter, seen from beyond its corner",
               {horizontal(3 * kS, 3 * kS, 4 * kS, 4 * kS, 0), ceiling}, shorter,
               low + ", and so for y; the skirt ends at 2 S + 1.");
}

void add_domes(QueryCaseList& list) {
  const Polygons closed = box({-kS - 1, -kS - 1, 2 * kS - 1}, {kS + 1, kS + 1, 2 * kS + 1});
  const Ends boxed{square(4 * kS, 0), square(kS, 2 * kS)};
  list.hidden("closed box round the element", boxed, closed,
              "The element is inside, the region outside.");
  list.visible("box round the element, floor missing", boxed, without(closed, 4),
               "Upright segments are free.");
  list.visible("box round the element, floor one unit short of a side", boxed,
               joined({without(closed, 4), {horizontal(-kS - 1, -kS - 1, kS, kS + 1, 2 * kS - 1)}}),
               "Segments pass the floor's plane at x in (S, S + 1), then lean in.");

  const double a = kS / 8;
  const Point c(0, 0, 4 * a);
  const ConvexPolygon rim{c + Point(3 * a, 0, 0), c + Point(0, 3 * a, 0), c - Point(3 * a, 0, 0),
                          c - Point(0, 3 * a, 0)};
  const Polygons octahedron =
      joined({fan(c - Point(0, 0, 3 * a), rim), fan(c + Point(0, 0, 3 * a), rim)});
  const Ends inside{square(8 * a, 0), square(a, 4 * a)};
  list.hidden("octahedron round the element", inside, octahedron,
              "The element is inside, the region outside.");
  list.visible("octahedron round the element, one lower side missing", inside,
               without(octahedron, 2), "Segments pass the missing side and meet no other.");
  Polygons loose = octahedron;
  loose[2][1].x() += 1;
  list.visible("octahedron round the element, one lower side one unit short", inside, loose,
               "Between the side and its neighbour is a sliver, open from below to the element.");

  const ConvexPolygon base = octagon(2 * a, a, 0);
  const Ends covered{base, square(16 * a, 4 * a)};
  const Polygons spire = fan({0, 0, 2 * a}, base);
  list.hidden("octagonal pyramid on the region", covered, spire,
              "The region is the base of the pyramid.");
  list.visible("octagonal pyramid, one side missing", covered, without(spire, 5),
               "Segments leave through the missing side.");
  Polygons notched = spire;
  notched[0][2].y() -= 1;
  list.visible("octagonal pyramid, one side one unit short at the base", covered, notched,
               "The sliver between two sides is an opening above the region.");
  list.hidden("pyramid of four on the region", {square(a, 0), square(16 * a, 4 * a)},
              fan({1, 2, a}, square(a, 0)), "The region is the base of the pyramid.");
  const Point apex(0, 0, 2 * a);
  Polygons blunt;  // sides up to half height
  for (std::size_t i = 0; i < base.size(); ++i) {
    const Point &p = base[i], &q = base[(i + 1) % base.size()];
    blunt.push_back({p, q, (q + apex) / 2, (p + apex) / 2});
  }
  list.hidden("octagonal frustum with a lid", covered, joined({blunt, {octagon(a, a / 2, a)}}),
              "The region is the base of a closed frustum of ten sides.");
  list.visible("octagonal frustum, lid one unit too high", covered,
               joined({blunt, {octagon(a, a / 2, a + 1)}}),
               "Segments pass between the frustum's edge and the lid.");
}

void add_rooms(QueryCaseList& list) {
  const Polygons room = box({-kS, -kS, 0}, {kS, kS, 2 * kS});
  list.fully("floor and ceiling of a box", {square(kS, 0), square(kS, 2 * kS)}, room,
             "The hull is the box.");
  list.fully("floor and wall of a box", {square(kS, 0), upright_x(kS, -kS, 0, kS, 2 * kS)}, room,
             "The box is convex and its sides only touch the hull.");
  list.fully("patches in a box", {square(9, 1), upright_x(kS, -5, 1, 5, 7)}, room,
             "The box is convex and its sides only touch the hull.");

  // Rooms x in [-2 S, 0] and [0, S], a wall between them with a door |y| < k, z < k.
  const double k = kS / 4;
  const Ends rooms{horizontal(-2 * kS, -kS, -kS, kS, 0), upright_x(kS, -kS, 0, kS, kS)};
  const Polygons shell = box({-2 * kS, -kS, 0}, {kS, kS, kS});
  const Polygons open = joined(
      {shell,
       {upright_x(0, -kS, 0, -k, kS), upright_x(0, k, 0, kS, kS), upright_x(0, -k, k, k, kS)}});
  const auto with = [&open](ConvexPolygon door) { return joined({open, {std::move(door)}}); };
  list.visible("two rooms, door open", rooms, open, "Segments with |y| < k rise slowly enough.");
  list.hidden("two rooms, door closed", rooms, with(upright_x(0, -k, 0, k, k)),
              "The wall and its door contain the hull's section at x = 0.");
  list.visible("two rooms, door one unit short above", rooms, with(upright_x(0, -k, 0, k, k - 1)),
               "Segments pass x = 0 with |y| < k at z in (k - 1, k).");
  list.visible("two rooms, door one unit short below", rooms, with(upright_x(0, -k, 1, k, k)),
               "Segments pass x = 0 with |y| < k at z in (0, 1).");
  list.visible("two rooms, door one unit ajar", rooms,
               with({{0, -k, 0}, {1, k, 0}, {1, k, k}, {0, -k, k}}),
               "Segments with y slowly rising through k pass between latch and wall.");
  list.hidden("two rooms, door one unit ajar against a stop", rooms,
              joined({open,
                      {{{0, -k, 0}, {1, k, 0}, {1, k, k}, {0, -k, k}},
                       upright_y(k, 0, 0, 1, k),
                       horizontal(0, -k, 1, k, k)}}),
              "Door, stop and lintel close the opening without a gap.");
  list.hidden("two rooms, double door", rooms,
              joined({open, {upright_x(0, -k, 0, 3, k), upright_x(0, 3, 0, k, k)}}),
              "The wings abut: the wall contains the hull's section at x = 0.");
  list.visible("two rooms, double door one unit open", rooms,
               joined({open, {upright_x(0, -k, 0, 3, k), upright_x(0, 4, 0, k, k)}}),
               "Segments with y in (3, 4) rise slowly enough.");
  list.hidden("two rooms, screen behind the door", rooms,
              joined({open, {upright_x(-1, -kS, 0, kS, kS)}}),
              "The screen contains the hull's section at x = -1.");

  // Round a corner: the inner corner is the point (0, S) of the profile.
  const auto legs = [](double top) {
    return Ends{horizontal(-kS, 0, 0, kS, 0), horizontal(kS, 0, 2 * kS, kS, top)};
  };
  const Polygons wall = chain({{0, 0}, {0, kS}, {2 * kS, kS}}, 0, kS);
  const std::string corner = "A segment from x = -p, height 0, passes x = 0 at height h p/(p + q)";
  list.hidden("round a corner, along the extreme line", legs(2 * kS), wall,
              corner + " <= 2S S / 2S = S, the top of the wall.");
  list.visible("round a corner, element one unit higher", legs(2 * kS + 1), wall,
               corner + ", up to S + 1/2.");
  list.visible("round a corner, wall one unit lower", legs(2 * kS),
               chain({{0, 0}, {0, kS - 1}, {2 * kS, kS - 1}}, 0, kS), corner + ", up to S.");
}

}  // namespace

std::vector<QueryCase> enclosure_cases() {
  QueryCaseList list;
  add_tubes(list);
  add_domes(list);
  add_rooms(list);
  return list.take();
}

}  // namespace viewcover::testing
