#include "scene/repair/heal.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "scene/convex_polygon.h"
#include "scene/made_soup.h"
#include "scene/repair/convex_parts.h"
#include "scene/repair/cracks.h"
#include "scene/repair/surface_mesh.h"
#include "scene/scene.h"
#include "scene/scratch_folder.h"

namespace viewcover::testing {
namespace {

TEST(Heal, ClosesTJunctionsAndMovesNothingTooFar) {
  PolygonSoup soup = t_junction(0.01);
  const Healing healing = heal(soup, 0.02);
  EXPECT_EQ(healing.inserted, 1u);
  EXPECT_EQ(healing.moved, 0u);
  EXPECT_EQ(healing.largest_move, 0);
  EXPECT_EQ(soup.faces[0].size(), 5u);
  EXPECT_EQ(soup.vertices[soup.faces[0][2]], Point(2.01, 1, 0));
  EXPECT_TRUE(find_cracks(soup, 0.02).beside_edges.empty());
  const PolygonSoup before = soup;
  heal(soup, 0.02);
  EXPECT_EQ(soup.faces, before.faces);  // once is enough

  PolygonSoup apart = soup_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                               {{1.005, 0, 0}, {2, 0, 0}, {2, 1, 0}},
                               {{1.012, 0, 0}, {1.5, 1, 0}, {1.2, 1, 0}}});
  const Healing merged = heal(apart, 0.01);
  // The third is near the second only, which has moved: it stays, since it may move no farther.
  EXPECT_EQ(merged.moved, 1u);
  EXPECT_NEAR(merged.largest_move, 0.005, 1e-15);
  EXPECT_EQ(apart.vertices[3], apart.vertices[1]);
  EXPECT_EQ(apart.vertices[6], Point(1.012, 0, 0));
}

FaceKind kind_of(const PolygonSoup& soup, std::size_t face) {
  std::vector<Point> loop;
  for (const std::uint32_t corner : soup.faces[face]) loop.push_back(soup.vertices[corner]);
  return convex_parts(without_straight_corners(loop)).kind;
}

/// [0, width] x [0, 4] without [1, 3] x [1, 3], in one loop with a bridge.
std::vector<Point> floor_with_hole(double width) {
  return {{0, 0, 0}, {width, 0, 0}, {width, 4, 0}, {0, 4, 0}, {0, 0, 0},
          {1, 1, 0}, {1, 3, 0},     {3, 3, 0},     {3, 1, 0}, {1, 1, 0}};
}

TEST(Heal, ABridgeToAHoleStaysWalkedTwice) {
  PolygonSoup soup = soup_of({floor_with_hole(4), {{0.5, 0.52, 0}, {0.4, 0.5, 1}, {0.6, 0.5, 1}}});
  EXPECT_EQ(heal(soup, 0.05).inserted, 2u);
  EXPECT_EQ(soup.faces[0].size(), 12u);
  EXPECT_NE(kind_of(soup, 0), FaceKind::kCrossing);
}

TEST(Heal, AFaceThatWouldCrossItselfStaysAsItIs) {
  // Each vertex is beside both long edges of the strip.
  PolygonSoup soup = soup_of({{{0, 0, 0}, {1, 0, 0}, {1, 0.004, 0}, {0, 0.004, 0}},
                              {{0.5, -0.003, 0}, {0.5, -1, 1}, {0.6, -1, 1}},
                              {{0.5, 0.007, 0}, {0.5, 1, 1}, {0.6, 1, 1}}});
  const PolygonSoup before = soup;
  const Healing healing = heal(soup, 0.008);
  EXPECT_EQ(healing.inserted, 0u);
  EXPECT_EQ(soup.faces[0], before.faces[0]);
  EXPECT_NE(kind_of(soup, 0), FaceKind::kCrossing);
}

/// A cube whose top is cut into two rectangles with corners of their own, `gap` too low at one of
/// the places where the cut meets the rim.
std::string cube_with_a_crack(double gap) {
  const std::string z = std::to_string(1 - gap);
  return "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
         "v 0.5 0 " +
         z +
         "\nv 0.5 1 1\n"
         "f 1 4 3 2\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\nf 5 9 10 8\nf 9 6 7 10\n";
}

TEST(Heal, MakesASceneClosed) {
  const ScratchFolder folder;
  const auto file = folder.write("cube.obj", cube_with_a_crack(0.001));
  const SurfaceMesh open(load_scene(file).surfaces);
  EXPECT_GT(open.boundary_edges(), 0u);
  SceneOptions options;
  options.heal = 0.002;
  const Scene scene = load_scene(file, options);
  EXPECT_EQ(scene.repairs.healing.inserted, 1u);
  EXPECT_THAT(scene.repairs.summary(), ::testing::HasSubstr("1 corner inserted in an edge"));
  const SurfaceMesh closed(scene.surfaces);
  EXPECT_EQ(closed.boundary_edges(), 0u);
  EXPECT_EQ(closed.components(), 1u);
  options.heal = 0.0005;
  EXPECT_GT(SurfaceMesh(load_scene(file, options).surfaces).boundary_edges(), 0u);
}

/// A floor of 4 x 4 and on it the four sides of a leg, whose lower corners are at these heights.
PolygonSoup leg_on_floor(std::array<double, 4> heights) {
  const std::array<Point, 4> below = {Point(1, 1, heights[0]), Point(2, 1, heights[1]),
                                      Point(2, 2, heights[2]), Point(1, 2, heights[3])};
  std::vector<std::vector<Point>> faces = {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}};
  for (std::size_t k = 0; k < 4; ++k) {
    const Point &a = below[k], &b = below[(k + 1) % 4];
    faces.push_back({a, b, {b.x(), b.y(), 3}, {a.x(), a.y(), 3}});
  }
  return soup_of(faces);
}

double area_of_floor(const PolygonSoup& soup) {
  double sum = 0;
  for (std::size_t face = 0; face < soup.faces.size(); ++face) {
    if (soup.number_in_file(face) != 0) continue;
    std::vector<Point> loop;
    for (const std::uint32_t corner : soup.faces[face]) loop.push_back(soup.vertices[corner]);
    EXPECT_GT(area_vector(loop).z(), 0);
    sum += area_vector(loop).z() / 2;
  }
  return sum;
}

/// Is the lower edge k of the leg an edge of the floor, both ways round?
bool stands_on_edge(const PolygonSoup& soup, std::size_t k) {
  const Point &a = soup.vertices[4 + 4 * k], &b = soup.vertices[5 + 4 * k];
  std::size_t found = 0;
  for (std::size_t face = 0; face < soup.faces.size(); ++face) {
    if (soup.number_in_file(face) != 0) continue;
    const PolygonSoup::Face& corners = soup.faces[face];
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Point &c = soup.vertices[corners[i]],
                  &d = soup.vertices[corners[(i + 1) % corners.size()]];
      found += (c == a && d == b) || (c == b && d == a) ? 1 : 0;
    }
  }
  return found == 2;
}

TEST(Heal, ALegThatEndsAboveTheFloorStandsOnIt) {
  PolygonSoup soup = leg_on_floor({0.01, 0.01, 0.01, 0.01});
  const std::vector<Point> before = soup.vertices;
  EXPECT_EQ(find_cracks(soup, 0.02).beside_faces.size(), 4u);
  const Healing healing = heal(soup, 0.02);
  EXPECT_EQ(healing.bent, 4u);
  EXPECT_NEAR(healing.largest_move, 0.01, 1e-15);
  EXPECT_EQ(soup.vertices, before);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_TRUE(stands_on_edge(soup, k)) << k;
  EXPECT_NEAR(area_of_floor(soup), 16, 1e-12);
  EXPECT_EQ(soup.number_in_file(soup.faces.size() - 1), 4u);
  EXPECT_EQ(soup.face_groups.size(), soup.faces.size());
  const PolygonSoup healed = soup;
  EXPECT_EQ(heal(soup, 0.02).bent, 0u);  // once is enough
  EXPECT_EQ(soup.faces, healed.faces);
}

TEST(Heal, ALegThatLeansStandsOnAllItsCorners) {
  PolygonSoup soup = leg_on_floor({0, 0, 0.01, 0.01});
  EXPECT_EQ(heal(soup, 0.02).bent, 2u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_TRUE(stands_on_edge(soup, k)) << k;
  EXPECT_NEAR(area_of_floor(soup), 16, 1e-12);
}

// A board that leans: its long edge lies on the floor, which bends beside it.
TEST(Heal, AnEdgeOnABentFloorIsOneOfItsEdges) {
  PolygonSoup soup = soup_of({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                              {{0.5, 1, 0}, {3.5, 1, 0}, {3.5, 1.5, 0.01}, {0.5, 1.5, 0.01}},
                              {{2, 0.9, 0.01}, {2, 0.5, 1}, {2.5, 0.5, 1}}});
  EXPECT_EQ(heal(soup, 0.02).bent, 3u);
  std::size_t found = 0;
  for (std::size_t face = 0; face < soup.faces.size(); ++face) {
    if (soup.number_in_file(face) != 0) continue;
    std::set<Point, decltype([](const Point& a, const Point& b) {
               return std::ranges::lexicographical_compare(a, b);
             })>
        corners;
    for (const std::uint32_t corner : soup.faces[face]) corners.insert(soup.vertices[corner]);
    found += corners.contains({0.5, 1, 0}) && corners.contains({3.5, 1, 0}) ? 1 : 0;
  }
  EXPECT_EQ(found, 2u);
}

TEST(Heal, ALegThatStandsOrFloatsStaysAsItIs) {
  for (const double height : {0.0, 0.03}) {
    PolygonSoup soup = leg_on_floor({height, height, height, height});
    EXPECT_TRUE(find_cracks(soup, 0.02).beside_faces.empty());
    EXPECT_EQ(heal(soup, 0.02).bent, 0u);
    EXPECT_EQ(soup.faces.size(), 5u);
  }
}

// Two corners of a face that became one by an earlier step make no edge.
TEST(Heal, AFaceThatCollapsedBesideAnotherDoesNoHarm) {
  PolygonSoup soup = soup_of({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                              {{1, 1, 0.01}, {1.01, 1, 0.01}, {1, 3, 2}, {0.5, 3, 2}}});
  const Healing healing = heal(soup, 0.02);
  EXPECT_EQ(healing.moved, 1u);
  EXPECT_EQ(healing.bent, 1u);
  EXPECT_NEAR(area_of_floor(soup), 16, 1e-12);
}

TEST(Heal, OfVerticesOnBothSidesOfAFaceTheNearerCounts) {
  PolygonSoup soup = soup_of({{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
                              {{1, 1, 0.019}, {2, 1, 3}, {2, 2, 3}},
                              {{1, 1, -0.01}, {3, 1, -3}, {3, 2, -3}}});
  EXPECT_EQ(heal(soup, 0.02).bent, 1u);
  std::set<double> heights;
  for (std::size_t face = 0; face < soup.faces.size(); ++face) {
    if (soup.number_in_file(face) != 0) continue;
    for (const std::uint32_t corner : soup.faces[face]) heights.insert(soup.vertices[corner].z());
  }
  EXPECT_EQ(heights, (std::set<double>{0, -0.01}));
  EXPECT_NEAR(area_of_floor(soup), 16, 1e-12);
}

TEST(Heal, AFaceWithAHoleKeepsIt) {
  PolygonSoup soup = soup_of({floor_with_hole(8),
                              {{6, 2, 0.01}, {6, 2.5, 1}, {6.5, 2, 1}},
                              {{2, 2, 0.01}, {2, 2.5, 1}, {2.5, 2, 1}}});
  EXPECT_EQ(heal(soup, 0.02).bent, 1u);  // the other is over the hole
  EXPECT_NEAR(area_of_floor(soup), 32 - 4, 1e-12);
}

}  // namespace
}  // namespace viewcover::testing
