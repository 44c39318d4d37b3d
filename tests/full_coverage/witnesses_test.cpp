#include "full_coverage/witnesses.h"

#include <gtest/gtest.h>

#include "viewpoints/solved_scene.h"

namespace viewcover::testing {
namespace {

/// An L-shaped room 2 high over [0, 4]^2 without [2, 4]^2.
Scene ell_room() {
  const std::vector<std::pair<double, double>> plan = {{0, 0}, {4, 0}, {4, 2},
                                                       {2, 2}, {2, 4}, {0, 4}};
  std::vector<ConvexPolygon> polygons = {horizontal(0, 0, 2, 4, 0), horizontal(2, 0, 4, 2, 0)};
  for (std::size_t i = 0; i < plan.size(); ++i) {
    const auto [x0, y0] = plan[i];
    const auto [x1, y1] = plan[(i + 1) % plan.size()];
    polygons.push_back({{x1, y1, 0}, {x0, y0, 0}, {x0, y0, 2}, {x1, y1, 2}});
  }
  return scene_of(polygons);
}

/// It seen from its plan at half the height, in triangles round its reflex corner (2, 2): most of
/// them are behind one of its walls for what the corner sees along the other.
std::unique_ptr<SolvedScene> ell(bool one_sided = false) {
  const auto triangle = [](double x1, double y1, double x2, double y2) {
    return ConvexPolygon{{2, 2, 1}, {x1, y1, 1}, {x2, y2, 1}};
  };
  ViewingRegion region = region_of(triangle(2, 4, 0, 4), 2);
  for (const ConvexPolygon& part :
       {triangle(0, 4, 0, 0), triangle(0, 0, 4, 0), triangle(4, 0, 4, 2)}) {
    region.parts.push_back(part);
  }
  return std::make_unique<SolvedScene>(ell_room(), region, 1, std::make_unique<ExactBackend>(1),
                                       one_sided);
}

/// It seen from two boxes that fill its middle heights, up to the walls.
std::unique_ptr<SolvedScene> ell_of_boxes() {
  const std::vector<Box> boxes = {Box(Point(0, 0, 0.5), Point(2, 4, 1.5)),
                                  Box(Point(2, 0, 0.5), Point(4, 2, 1.5))};
  return std::make_unique<SolvedScene>(ell_room(), make_viewing_region({}, boxes, 1), 1);
}

/// One in the middle of each element.
Witnesses one_in_each_element(const SolvedScene& solved) {
  Witnesses witnesses(solved.views);
  std::vector<ElementTarget> places;
  for (std::size_t column = 0; column < solved.matrix.elements.size(); ++column) {
    const ElementAddress element = solved.matrix.elements[column];
    const auto place =
        witnesses.place_in(column, subdivided(solved.scene[element.owner()].polygon, element));
    EXPECT_TRUE(place) << column;
    if (place) places.push_back(*place);
  }
  witnesses.add(places);
  return witnesses;
}

std::vector<RegionCell> quarters_of_regions(const SolvedScene& solved) {
  std::vector<RegionCell> cells;
  for (std::size_t i = 0; i < solved.views.region_count(); ++i) {
    const auto quarter = solved.views.positions(i).region().quarters();
    for (int digit = 0; digit < 4; ++digit) {
      cells.push_back(
          {solved.region.address(i).child(digit), i, quarter[static_cast<std::size_t>(digit)]});
    }
  }
  return cells;
}

/// Else the lower bound would be none.
void expect_seen_by_what_holds_their_viewers(const SolvedScene& solved) {
  const Witnesses witnesses = one_in_each_element(solved);
  RandomNumbers random(5);
  std::size_t seen = 0, unseen_by_cells = 0;
  for (const RegionCell& cell : quarters_of_regions(solved)) {
    const RegionPositions positions(cell.shape, solved.scene.bounds, solved.scene.lattice.exponent);
    const Point position = positions.random(random);
    if (!solved.views.is_free(cell.region, position)) continue;
    for (std::size_t w = 0; w < witnesses.size(); ++w) {
      const bool cell_sees = witnesses.region_sees(cell.region, w) && witnesses.cell_sees(cell, w);
      unseen_by_cells += !cell_sees;
      if (!witnesses.is_seen(position, witnesses[w])) continue;
      ++seen;
      EXPECT_TRUE(witnesses.region_sees(cell.region, w)) << w;
      EXPECT_TRUE(cell_sees) << w;
    }
  }
  EXPECT_GT(seen, 100u);
  EXPECT_GT(unseen_by_cells, 100u);
}

TEST(Witnesses, AreSeenByTheRegionsAndCellsOfPositionsThatSeeThem) {
  expect_seen_by_what_holds_their_viewers(*ell());
}

TEST(Witnesses, AreSeenByTheBoxesAndPartsOfBoxesOfPositionsThatSeeThem) {
  expect_seen_by_what_holds_their_viewers(*ell_of_boxes());
}

// A wall between two boxes, in their faces; past its edge each box sees a part of the plate on the
// other side, but not the place behind the wall.
TEST(Witnesses, AreNotSeenThroughASurfaceThatAFaceLiesOn) {
  const auto upright = [](double x, double low, double high) {
    return ConvexPolygon{{x, low, low}, {x, high, low}, {x, high, high}, {x, low, high}};
  };
  const std::vector<ConvexPolygon> polygons = {upright(0, -4, 4), upright(-3, 0, 60),
                                               upright(3, 0, 60)};
  const std::vector<Box> boxes = {Box(Point(-2, 0, 0), Point(0, 1, 1)),
                                  Box(Point(0, 0, 0), Point(2, 1, 1))};
  const SolvedScene solved(scene_of(polygons), make_viewing_region({}, boxes, 0), 1e4);
  const Witnesses witnesses(solved.views);
  for (std::size_t column = 1; column < 3; ++column) {
    const auto behind = witnesses.place_in(column, upright(polygons[column][0].x(), 0, 1)),
               past = witnesses.place_in(column, upright(polygons[column][0].x(), 40, 60));
    ASSERT_TRUE(behind && past);
    for (std::size_t i = 0; i < 2; ++i) {
      const RegionCell cell{solved.region.address(i), i, solved.views.positions(i).region()};
      ASSERT_TRUE(solved.views.region_sees(i, column));
      EXPECT_TRUE(solved.views.cell_sees_place(cell, *past));
      EXPECT_EQ(solved.views.cell_sees_place(cell, *behind), column == i + 1);
    }
  }
}

/// Every cell that a guard stands in sees, or is lent, all witnesses that the guard sees.
void expect_lent_what_guard_sees(const SolvedScene& solved, const Point& guard) {
  const Witnesses witnesses = one_in_each_element(solved);
  const std::vector<RegionCell> cells = quarters_of_regions(solved);
  const auto lends = witnesses.lends(cells);
  const auto sees = [&](std::size_t cell, std::size_t w) {
    return witnesses.region_sees(cells[cell].region, w) && witnesses.cell_sees(cells[cell], w);
  };
  std::size_t by_itself = 0, lent = 0;
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (!cells[cell].shape.contains(guard)) continue;
    for (std::size_t w = 0; w < witnesses.size(); ++w) {
      if (!witnesses.is_seen(guard, witnesses[w])) continue;
      if (sees(cell, w)) {
        ++by_itself;
        continue;
      }
      ++lent;
      EXPECT_TRUE(std::ranges::any_of(
          lends, [&](const auto& pair) { return pair.first == cell && sees(pair.second, w); }))
          << "cell " << cell << " witness " << w;
    }
  }
  EXPECT_GT(by_itself, 0u);
  EXPECT_GT(lent, 0u) << "else nothing was tested";
}

// A guard on the reflex corner is in cells on both sides of it, and sees past each of its walls.
TEST(Witnesses, CellsAreLentWhatAGuardOnAReflexCornerSees) {
  expect_lent_what_guard_sees(*ell(), {2, 2, 1});
}

// A guard on top of a screen that reaches the region sees the floor on both sides.
TEST(Witnesses, CellsAreLentWhatAGuardOnAScreenSees) {
  const std::vector<ConvexPolygon> polygons = {horizontal(0, 0, 4, 4, 0),
                                               {{2, 0, 0}, {2, 4, 0}, {2, 4, 1}, {2, 0, 1}}};
  ViewingRegion region = region_of(horizontal(0, 0, 2, 4, 1), 1);
  region.parts.push_back(horizontal(2, 0, 4, 4, 1));
  expect_lent_what_guard_sees(SolvedScene(scene_of(polygons), region, 0.25), {2, 2, 1});
}

// The same between boxes on both sides of a screen, as high as it.
TEST(Witnesses, PartsOfBoxesAreLentWhatAGuardOnAScreenSees) {
  const std::vector<ConvexPolygon> polygons = {horizontal(0, 0, 4, 4, 0),
                                               {{2, 0, 0}, {2, 4, 0}, {2, 4, 1}, {2, 0, 1}}};
  const std::vector<Box> boxes = {Box(Point(0, 0, 0.5), Point(2, 4, 1)),
                                  Box(Point(2, 0, 0.5), Point(4, 4, 1))};
  expect_lent_what_guard_sees(
      SolvedScene(scene_of(polygons), make_viewing_region({}, boxes, 1), 0.25), {2, 2, 1});
}

TEST(Witnesses, AreNotSeenFromThePlaneOfTheirSurfaceNorFromBehind) {
  const auto solved = ell();
  const Witnesses witnesses = one_in_each_element(*solved);
  const OpenSegments segments(solved->views.occluders());
  // In line with the wall at x = 0, on it.
  const Point in_line(0, 1, 1);
  std::size_t on_wall = 0;
  for (std::size_t w = 0; w < witnesses.size(); ++w) {
    const Point& place = witnesses[w].place;
    if (place.x() != 0) continue;
    ++on_wall;
    EXPECT_TRUE(segments.is_free(in_line, place));
    EXPECT_FALSE(witnesses.is_seen(in_line, witnesses[w]));
  }
  EXPECT_GT(on_wall, 0u);
  // All fronts look inward.
  const auto fronts = ell(true);
  const Witnesses one_sided = one_in_each_element(*fronts);
  ASSERT_GT(one_sided.size(), 0u);
  const Point outside(20, 1, 1);
  for (std::size_t w = 0; w < one_sided.size(); ++w) {
    if (one_sided[w].place.x() != 4) continue;
    EXPECT_FALSE(one_sided.is_seen(outside, one_sided[w]));
    EXPECT_TRUE(one_sided.is_seen({3, 1, 1}, one_sided[w]));
  }
}

// The middle of the floor is the foot of a screen, that of the screen is in the region's plane.
TEST(Witnesses, LieOnOneSurfaceAndInThePlaneOfNoRegion) {
  const std::vector<ConvexPolygon> polygons = {horizontal(0, 0, 4, 4, 0),
                                               {{2, 1, 0}, {2, 3, 0}, {2, 3, 2}, {2, 1, 2}}};
  const SolvedScene solved(scene_of(polygons), region_of(horizontal(0, 0, 1, 4, 1), 1), 100);
  const Witnesses witnesses(solved.views);
  for (std::size_t column = 0; column < 2; ++column) {
    const auto place = witnesses.place_in(column, polygons[column]);
    ASSERT_TRUE(place);
    EXPECT_TRUE(lies_in(place->place, polygons[column]));
    EXPECT_FALSE(lies_in(place->place, polygons[1 - column]));
    EXPECT_NE(place->place.z(), 1);
  }
}

}  // namespace
}  // namespace viewcover::testing
