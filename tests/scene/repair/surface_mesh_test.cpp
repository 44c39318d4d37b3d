#include "scene/repair/surface_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/made_scene.h"

namespace viewcover {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::vector<Surface> surfaces_of(const std::vector<ConvexPolygon>& polygons) {
  return made_scene({{"", polygons}}).surfaces;
}

TEST(SurfaceMesh, Cube) {
  const auto cube = surfaces_of(box_outward(Point(0, 0, 0), Point(1, 1, 1)));
  const SurfaceMesh mesh(cube);
  EXPECT_EQ(mesh.faces(), 6u);
  EXPECT_EQ(mesh.edges(), 12u);
  EXPECT_EQ(mesh.boundary_edges(), 0u);
  EXPECT_EQ(mesh.non_manifold_edges(), 0u);
  EXPECT_EQ(mesh.components(), 1u);
  EXPECT_TRUE(mesh.is_closed(0));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(mesh.neighbours(SurfaceId(i)).size(), 4u);
    EXPECT_THAT(mesh.coplanar_neighbours(SurfaceId(i)), IsEmpty());
    EXPECT_FALSE(mesh.is_reversed(SurfaceId(i)) != mesh.is_reversed(SurfaceId(0)));
  }
  // Faces 0 and 1 are opposite.
  EXPECT_THAT(mesh.neighbours(SurfaceId(0)),
              ElementsAre(SurfaceId(2), SurfaceId(3), SurfaceId(4), SurfaceId(5)));
}

TEST(SurfaceMesh, OneFaceTheWrongWayRound) {
  auto box = box_outward(Point(0, 0, 0), Point(1, 1, 1));
  std::reverse(box[3].begin(), box[3].end());
  const SurfaceMesh mesh(surfaces_of(box));
  EXPECT_TRUE(mesh.is_closed(0));
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(mesh.neighbours(SurfaceId(i)).size(), 4u);
    EXPECT_EQ(mesh.is_reversed(SurfaceId(i)) == mesh.is_reversed(SurfaceId(3)), i == 3) << i;
  }
}

TEST(SurfaceMesh, OpenBox) {
  auto box = box_outward(Point(0, 0, 0), Point(1, 1, 1));
  box.pop_back();
  const SurfaceMesh mesh(surfaces_of(box));
  EXPECT_EQ(mesh.edges(), 12u);
  EXPECT_EQ(mesh.boundary_edges(), 4u);
  EXPECT_FALSE(mesh.is_closed(0));
}

TEST(SurfaceMesh, ThreeFacesAtOneEdge) {
  const ConvexPolygon a = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
  const ConvexPolygon b = {{0, 0, 0}, {0, 0, 1}, {-1, 1, 0}};
  const ConvexPolygon c = {{0, 0, 1}, {0, 0, 0}, {-1, -1, 0}};
  const SurfaceMesh mesh(surfaces_of({a, b, c}));
  EXPECT_EQ(mesh.faces(), 3u);
  EXPECT_EQ(mesh.edges(), 7u);
  EXPECT_EQ(mesh.non_manifold_edges(), 1u);
  EXPECT_EQ(mesh.boundary_edges(), 6u);
  EXPECT_EQ(mesh.components(), 1u);
  EXPECT_FALSE(mesh.is_closed(0));
  EXPECT_THAT(mesh.neighbours(SurfaceId(0)), ElementsAre(SurfaceId(1), SurfaceId(2)));
  EXPECT_THAT(mesh.neighbours(SurfaceId(1)), ElementsAre(SurfaceId(0), SurfaceId(2)));
  EXPECT_THAT(mesh.neighbours(SurfaceId(2)), ElementsAre(SurfaceId(0), SurfaceId(1)));
}

TEST(SurfaceMesh, TwoCubesAtOneEdgeAreClosed) {
  auto boxes = box_outward(Point(0, 0, 0), Point(1, 1, 1));
  for (const auto& face : box_outward(Point(1, 1, 0), Point(2, 2, 1))) boxes.push_back(face);
  for (const auto& face : box_outward(Point(5, 5, 5), Point(6, 6, 6))) boxes.push_back(face);
  boxes.pop_back();
  const SurfaceMesh mesh(surfaces_of(boxes));
  EXPECT_EQ(mesh.faces(), 17u);
  EXPECT_EQ(mesh.non_manifold_edges(), 1u);
  EXPECT_EQ(mesh.boundary_edges(), 4u);
  ASSERT_EQ(mesh.components(), 2u);
  EXPECT_EQ(mesh.component_of(SurfaceId(11)), 0u);
  EXPECT_EQ(mesh.component_of(SurfaceId(12)), 1u);
  EXPECT_TRUE(mesh.is_closed(0));
  EXPECT_FALSE(mesh.is_closed(1));
}

TEST(SurfaceMesh, ABoxWithAWallInsideIsNotClosedByParity) {
  auto boxes = box_outward(Point(0, 0, 0), Point(1, 1, 1));
  const auto second = box_outward(Point(1, 0, 0), Point(2, 1, 1));
  boxes.insert(boxes.end(), second.begin() + 1, second.end());  // all but the wall between them
  const SurfaceMesh mesh(surfaces_of(boxes));
  EXPECT_EQ(mesh.faces(), 11u);
  EXPECT_EQ(mesh.boundary_edges(), 0u);
  EXPECT_EQ(mesh.non_manifold_edges(), 4u);
  EXPECT_EQ(mesh.components(), 1u);
  EXPECT_FALSE(mesh.is_closed(0));
  EXPECT_EQ(mesh.neighbours(SurfaceId(1)).size(), 8u);
}

TEST(SurfaceMesh, CornersOnAnEdgeDoNotTearIt) {
  // The top of a cube in two halves: its neighbours have edges that are cut in the middle.
  auto box = box_outward(Point(0, 0, 0), Point(2, 2, 2));
  box.pop_back();
  box.push_back({{0, 0, 2}, {1, 0, 2}, {1, 2, 2}, {0, 2, 2}});
  box.push_back({{1, 0, 2}, {2, 0, 2}, {2, 2, 2}, {1, 2, 2}});
  const SurfaceMesh mesh(surfaces_of(box));
  EXPECT_EQ(mesh.edges(), 15u);
  EXPECT_EQ(mesh.boundary_edges(), 0u);
  EXPECT_TRUE(mesh.is_closed(0));
  EXPECT_THAT(mesh.coplanar_neighbours(SurfaceId(5)), ElementsAre(SurfaceId(6)));
  EXPECT_THAT(mesh.coplanar_neighbours(SurfaceId(0)), IsEmpty());
  EXPECT_EQ(mesh.neighbours(SurfaceId(5)).size(), 4u);
  // Several vertices on one slanted edge, given out of order.
  const SurfaceMesh fan(surfaces_of({{{0, 0, 0}, {6, 3, 9}, {0, 9, 0}},
                                     {{6, 3, 9}, {4, 2, 6}, {9, 0, 0}},
                                     {{2, 1, 3}, {0, 0, 0}, {9, 0, 0}},
                                     {{4, 2, 6}, {2, 1, 3}, {9, 0, 0}}}));
  EXPECT_THAT(fan.neighbours(SurfaceId(0)), ElementsAre(SurfaceId(1), SurfaceId(2), SurfaceId(3)));
  EXPECT_EQ(fan.boundary_edges(), 4u);
}

TEST(SurfaceMesh, MoebiusStripKeepsItsNeighbours) {
  // Five quads round a strip whose last edge is joined the other way; planar enough as triangles.
  const std::vector<Point> up = {{4, 0, 1}, {1, 4, 1}, {-3, 2, 1}, {-3, -2, 1}, {1, -4, 1}};
  std::vector<Point> down = up;
  for (Point& p : down) p.z() = -1;
  std::vector<ConvexPolygon> strip;
  for (std::size_t i = 0; i < 5; ++i) {
    const bool is_last = i == 4;
    const Point &next_up = is_last ? down[0] : up[i + 1],
                &next_down = is_last ? up[0] : down[i + 1];
    strip.push_back({up[i], down[i], next_up});
    strip.push_back({down[i], next_down, next_up});
  }
  const SurfaceMesh mesh(surfaces_of(strip));
  EXPECT_EQ(mesh.faces(), 10u);
  EXPECT_EQ(mesh.boundary_edges(), 10u);
  EXPECT_EQ(mesh.non_manifold_edges(), 0u);
  for (std::size_t i = 0; i < 10; ++i) {
    EXPECT_THAT(mesh.neighbours(SurfaceId(i)),
                UnorderedElementsAre(SurfaceId((i + 1) % 10), SurfaceId((i + 9) % 10)));
  }
}

TEST(SurfaceMesh, BothSidesOfOnePolygon) {
  const ConvexPolygon front = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const ConvexPolygon back = {{0, 0, 0}, {0, 1, 0}, {1, 0, 0}};
  const SurfaceMesh mesh(surfaces_of({front, back}));
  EXPECT_EQ(mesh.faces(), 2u);
  EXPECT_EQ(mesh.boundary_edges(), 0u);
  EXPECT_THAT(mesh.neighbours(SurfaceId(0)), ElementsAre(SurfaceId(1)));
  EXPECT_THAT(mesh.coplanar_neighbours(SurfaceId(0)), ElementsAre(SurfaceId(1)));
}

TEST(MergeCoplanar, JoinsWithinOneGroupOnly) {
  const ConvexPolygon a = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const ConvexPolygon b = {{1, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}};
  const ConvexPolygon wall = {{0, 0, 0}, {0, 1, 0}, {0, 1, 5}};
  auto together = made_scene({{"a", {wall, b, a}}}).surfaces;
  EXPECT_EQ(merge_coplanar(together), 1u);
  ASSERT_EQ(together.size(), 2u);
  EXPECT_EQ(together[0].polygon, wall);
  EXPECT_EQ(area(together[1].polygon), 3);
  EXPECT_EQ(together[1].polygon.size(), 4u);
  EXPECT_EQ(together[1].source_face, 1u);
  auto apart = made_scene({{"a", {a}}, {"b", {b}}}).surfaces;
  EXPECT_EQ(merge_coplanar(apart), 0u);
  EXPECT_EQ(apart.size(), 2u);
}

}  // namespace
}  // namespace viewcover
