#include "exact/point_cases.h"

#include <utility>

namespace viewcover::testing {
namespace {

/// Viewpoints are the origin unless moved.
class PointCaseList {
 public:
  PointCase& add(std::string name, ConvexPolygon element, Polygons occluders, double seen,
                 double of, std::string argument) {
    PointCase added;
    added.name = std::move(name);
    added.query.viewpoint.setZero();
    added.query.element = std::move(element);
    added.query.occluders = std::move(occluders);
    added.seen = seen;
    added.of = of;
    added.fully = false;
    added.argument = std::move(argument);
    return cases_.emplace_back(std::move(added));
  }
  std::vector<PointCase> take() { return std::move(cases_); }

 private:
  std::vector<PointCase> cases_;
};

void add_covers(PointCaseList& list) {
  // Plates at z = 1 have shadows of twice their size.
  const ConvexPolygon element = square(2 * kS, 2);
  list.add("nothing between", element, {}, 1, 1, "Nothing is between.").fully = true;
  list.add("plate over half", element, {horizontal(-kS, -kS, 0, kS, 1)}, 1, 2,
           "The shadow is x < 0.");
  list.add("three copies of a plate over half", element,
           repeated({horizontal(-kS, -kS, 0, kS, 1)}, 3), 1, 2, "The shadow is x < 0.");
  list.add("umbra, exact", element, {square(kS, 1)}, 0, 1, "The shadow is the element.");
  list.add("umbra, one unit wider", element, {square(kS + 1, 1)}, 0, 1,
           "The shadow contains the element.");
  list.add("umbra, one unit short", element, {horizontal(-kS, -kS, kS - 1, kS, 1)}, 1, 2 * kS,
           "The shadow leaves a strip of width 2 out of 4 S.");
  list.add("umbra one unit before the element", square(kS, kS), {square(kS - 1, kS - 1)}, 0, 1,
           "The shadow is S/(S-1) times the plate: the element.");
  list.add("umbra one unit before the element, one unit short", square(kS, kS),
           {square(kS - 2, kS - 1)}, 2 * kS - 3, (kS - 1) * (kS - 1),
           "The shadow has half side S (S-2)/(S-1): 1 - ((S-2)/(S-1))^2 is left.");

  const std::vector<double> cuts{-kS / 2, -1, 0, 1000};
  list.add("five abutting slats", element, cut_square(kS, 1, cuts), 0, 1,
           "Together the slats cast the shadow of the whole plate.");
  list.add("five slats, one missing", element, without(cut_square(kS, 1, cuts), 2), 1, 2 * kS,
           "A strip of width 2 out of 4 S is left.");
  Polygons tiles, chess;
  for (int i = 0; i < 64; ++i) {
    const double x = (i % 8 - 4) * kS / 4, y = (i / 8 - 4) * kS / 4;
    tiles.push_back(horizontal(x, y, x + kS / 4, y + kS / 4, 1));
    if ((i % 8 + i / 8) % 2 == 0) chess.push_back(tiles.back());
  }
  list.add("64 tiles", element, tiles, 0, 1, "The tiles abut and cast the element as shadow.");
  list.add("63 tiles", element, without(tiles, 27), 1, 64, "One of 64 equal shadows is missing.");
  list.add("chessboard", element, chess, 1, 2, "The shadows of half the fields.");

  const ConvexPolygon rim{{kS, -kS, 1}, {kS, 0, 1},  {kS, kS, 1},   {0, kS, 1},
                          {-kS, kS, 1}, {-kS, 0, 1}, {-kS, -kS, 1}, {0, -kS, 1}};
  list.add("fan of eight", element, fan({3, 5, 1}, rim), 0, 1,
           "The fan casts the element as shadow.");
  list.add("fan of eight, one missing", element, without(fan({3, 5, 1}, rim), 1), kS - 3, 8 * kS,
           "The blade has area S (S-3)/2 of the fan's (2 S)^2.");
  list.add("overlapping shadows at two depths", square(4, 4),
           {horizontal(0, -1, 1, 1, 1), horizontal(-1, -2, 1, 0, 2)}, 3, 8,
           "The shadows [0, 4] x [-4, 4] and [-2, 2] x [-4, 0] cover 40 of 64.");
  list.add("corners within edges", {{-4, -4, 2}, {0, -4, 2}, {4, -4, 2}, {4, 4, 2}, {-4, 4, 2}},
           {{{-2, -2, 1}, {-1, -2, 1}, {0, -2, 1}, {0, 0, 1}, {0, 2, 1}, {-2, 2, 1}}}, 1, 2,
           "The shadow is x < 0.");
}

void add_slits(PointCaseList& list) {
  list.add("slit of one unit", square(2 * kS, 2), slit_x(kS, 1, 0, 1), 1, 2 * kS,
           "A strip of width 2 out of 4 S is seen.");
  list.add("crossed slits of one unit", square(2 * kS, 6),
           joined({slit_x(kS, 2, 0, 1), slit_y(kS, 3, 0, 1)}), 3, 8 * kS * kS,
           "A rectangle 3 x 2 out of (4 S)^2 is seen.");
  const ConvexPolygon half = horizontal(-kS, -kS, 0, kS, 1);
  list.add("half walls that meet in projection", square(2 * kS, 4),
           {half, horizontal(0, -2 * kS, 2 * kS, 2 * kS, 3)}, 0, 1,
           "The shadows x <= 0 and x >= 0 abut.");
  list.add("half walls one unit apart", square(2 * kS, 4),
           {half, horizontal(1, -2 * kS, 2 * kS, 2 * kS, 2)}, 1, 2 * kS,
           "The shadows x <= 0 and x >= 2 leave a strip of width 2 out of 4 S.");
  list.add("half walls overlapping by one unit", square(2 * kS, 4),
           {horizontal(-kS, -kS, 1, kS, 1), horizontal(1, -2 * kS, 2 * kS, 2 * kS, 2)}, 0, 1,
           "The shadows x <= 4 and x >= 2 overlap.");
  const Polygons wall = frame(kS, 2, 1);
  list.add("window", square(2 * kS, 2), wall, 4, kS * kS,
           "A square of side 8 out of (4 S)^2 is seen.");
  list.add("window with its plug", square(2 * kS, 2), joined({wall, {square(2, 1)}}), 0, 1,
           "Wall and plug cast the element as shadow.");
  list.add("window with a plug one unit short", square(2 * kS, 2),
           joined({wall, {horizontal(-2, -2, 2, 1, 1)}}), 1, kS * kS,
           "A rectangle 8 x 2 out of (4 S)^2 is seen.");
}

void add_polygons(PointCaseList& list) {
  list.add("triangle over triangle", level(2, {{0, 0}, {8, 0}, {0, 8}}),
           {level(1, {{0, 0}, {2, 0}, {0, 2}})}, 3, 4,
           "The shadow is the element at half its size.");
  list.add("octagon over square", square(4, 2), {octagon(2, 1, 1)}, 1, 8,
           "The octagon has area 14, its shadow 56 of 64.");
  list.add("half of a pentagon", pentagon(1, 2), {horizontal(-9, -9, 0, 9, 1)}, 1, 2,
           "The pentagon is symmetric in x.");
  const ConvexPolygon skew{{6, 0, 0}, {0, 6, 0}, {0, 0, 6}};
  list.add("skew triangle, tilted cover", skew, {{{3, 0, 0}, {0, 1, 0}, {0, 0, 3}}}, 0, 1,
           "The cover's corners are on the lines of sight to the element's.");
  list.add("skew triangle, a third covered", skew, {{{1, 0, 0}, {0, 1, 0}, {1, 1, 1}}}, 2, 3,
           "The shadow is the triangle of two corners and the centre of mass.");
}

void add_planes(PointCaseList& list) {
  const ConvexPolygon element = square(4, 4);
  list.add("occluders behind and on the element", element, {square(16, 5), square(16, 4)}, 1, 1,
           "They are beyond all segments, or in the element's plane.")
      .fully = true;
  list.add("occluder behind the viewpoint", element, {square(16, -1)}, 1, 1,
           "It is on the other side of the viewpoint.")
      .fully = true;
  list.add("occluder crossing the element's plane", element, {slat({0, 2}, {2, 6}, -8, 8)}, 7, 8,
           "Before the element it spans x = 0 at z = 2 to x = 1 at z = 4: the shadow is (0, 1).");
  list.add("wall standing on the element", element, {upright_x(1, -8, 2, 8, 4)}, 7, 8,
           "Segments pass x = 1 at z = 4/x, in [2, 4] for x in [1, 2].");
  list.add("wall through the element's plane and past the viewpoint", element,
           {upright_x(1, -8, -8, 8, 8)}, 5, 8, "All of x > 1 is behind the wall.");
  list.add("wall past the viewpoint", element, {upright_x(1, -8, -8, 8, 2)}, 3, 4,
           "Segments pass x = 1 at z = 4/x, below 2 for x > 2.");
  list.add("tilted plate past the viewpoint", element, {slat({-4, 3}, {8, -3}, -8, 8)}, 0, 1,
           "Its plane x + 2 z = 2 parts viewpoint and element, and it covers all segments.");
  list.add("occluder in a plane through the viewpoint", element, {upright_x(0, -8, 1, 8, 3)}, 1, 1,
           "It is seen edge-on.")
      .fully.reset();
  list.add("occluder with the viewpoint as a corner", element, {{{0, 0, 0}, {1, 1, 2}, {1, -1, 2}}},
           1, 1, "It is seen edge-on.")
      .fully.reset();
  list.add("viewpoint on an occluder", element, {square(1, 0)}, 1, 1,
           "All segments leave its plane at once.")
      .fully = true;
  list.add("edge-on occluder and plate over half", element,
           {upright_x(1, -8, -1, 8, 1), upright_x(0, -8, 1, 8, 3), horizontal(-4, -4, 0, 4, 2)}, 1,
           2, "The plate's shadow is x < 0; x = 0 is edge-on and x = 1 passed at z >= 1.");
  list.add("viewpoint in the element's plane", horizontal(2, 2, 4, 4, 0), {}, 0, 1,
           "The element is seen edge-on.");
  list.add("viewpoint on the element", square(4, 0), {}, 0, 1, "The element is seen edge-on.");

  const auto one_sided = [](PointCase& c) -> PointCase& {
    c.query.one_sided = true;
    return c;
  };
  one_sided(list.add("one-sided, back", element, {}, 0, 1, "The element faces away."));
  one_sided(list.add("one-sided, front", flipped(element), {}, 1, 1, "Nothing is between.")).fully =
      true;
  one_sided(list.add("one-sided, front, plate over half", flipped(element),
                     {horizontal(-4, -4, 0, 4, 2)}, 1, 2, "The shadow is x < 0."));

  list.add("viewpoint off the axis", element, {horizontal(0, 0, 4, 2, 2)}, 1, 2,
           "The shadow of (x, y) is (2 x - 4, 2 y - 4): y < 0.")
      .query.viewpoint = Point(4, 4, 0);

  const Polygons closed = box({-1, -1, -1}, {1, 1, 1});
  list.add("in a closed box", element, closed, 0, 1,
           "The viewpoint is inside, the element outside.");
  list.add("in a box without ceiling", element, without(closed, 5), 1, 1,
           "The element is the ceiling's shadow; the sides only touch the shaft.")
      .fully = true;
  list.add("in a box with half a ceiling", element,
           joined({without(closed, 5), {horizontal(-1, -1, 0, 1, 1)}}), 1, 2,
           "The half ceiling's shadow is x < 0.");
}

}  // namespace

std::vector<PointCase> point_cases() {
  PointCaseList list;
  add_covers(list);
  add_slits(list);
  add_polygons(list);
  add_planes(list);
  return list.take();
}

}  // namespace viewcover::testing
