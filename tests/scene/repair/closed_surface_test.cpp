#include "scene/repair/closed_surface.h"

#include <gtest/gtest.h>

#include <vector>

#include "scene/made_scene.h"

namespace viewcover {
namespace {

// Every lattice point of a box, on its faces, edges and corners and round it, so that most ways out
// along an axis graze something.
void expect_box(const std::vector<ConvexPolygon>& faces, int inside_winding) {
  const Scene scene = made_scene({{"box", faces}});
  const std::vector<ClosedSurface> closed = closed_surfaces(scene);
  ASSERT_EQ(closed.size(), 1u);
  ASSERT_EQ(closed[0].surfaces.size(), faces.size());
  EXPECT_TRUE(closed[0].is_oriented);
  EXPECT_EQ(closed[0].bounds.min(), Point(0, 0, 0));
  EXPECT_EQ(closed[0].bounds.max(), Point(4, 4, 4));
  std::size_t inside = 0, on = 0;
  for (int x = -1; x <= 5; ++x) {
    for (int y = -1; y <= 5; ++y) {
      for (int z = -1; z <= 5; ++z) {
        const Point point(x, y, z);
        const Point from_middle = (point - Point(2, 2, 2)).cwiseAbs();
        const double reach = from_middle.maxCoeff();
        const auto place = enclosure(scene, closed[0], point);
        ASSERT_EQ(place.has_value(), reach != 2) << point.transpose();
        on += !place;
        if (!place) continue;
        ASSERT_EQ(place->is_inside, reach < 2) << point.transpose();
        ASSERT_EQ(place->winding, reach < 2 ? inside_winding : 0) << point.transpose();
        inside += place->is_inside;
      }
    }
  }
  EXPECT_EQ(inside, 27u);
  EXPECT_EQ(on, 125u - 27u);
}

TEST(ClosedSurface, EnclosesItsInside) {
  const auto box = box_outward({0, 0, 0}, {4, 4, 4});
  expect_box(box, 1);
  expect_box(reversed(box), -1);
}

TEST(ClosedSurface, FacesMayBeCutAsTheyLike) {
  auto box = box_outward({0, 0, 0}, {4, 4, 4});
  for (std::size_t i = 0; i < 6; ++i) {  // cut in three, no edge as long as the neighbour's
    const ConvexPolygon face = box[i];
    const double at = static_cast<double>(i % 3 + 1) / 4;
    const Point low = face[0] + at * (face[1] - face[0]), high = low + (face[3] - face[0]);
    box[i] = {face[0], low, high, face[3]};
    box.push_back({low, face[1], face[2]});
    box.push_back({low, face[2], high});
  }
  expect_box(box, 1);
  expect_box(reversed(box), -1);
}

// A prism over the letter U: ways out cross it up to three times.
TEST(ClosedSurface, NotConvex) {
  const ConvexPolygon u[] = {{{0, 0, 0}, {6, 0, 0}, {6, 2, 0}, {0, 2, 0}},
                             {{0, 2, 0}, {2, 2, 0}, {2, 6, 0}, {0, 6, 0}},
                             {{4, 2, 0}, {6, 2, 0}, {6, 6, 0}, {4, 6, 0}}};
  const Point outline[] = {{0, 0, 0}, {6, 0, 0}, {6, 6, 0}, {4, 6, 0},
                           {4, 2, 0}, {2, 2, 0}, {2, 6, 0}, {0, 6, 0}};
  const Point up(0, 0, 4);
  std::vector<ConvexPolygon> faces;
  for (ConvexPolygon part : u) {
    faces.push_back(ConvexPolygon(part.rbegin(), part.rend()));
    for (Point& corner : part) corner += up;
    faces.push_back(part);
  }
  for (std::size_t i = 0; i < 8; ++i) {
    const Point &a = outline[i], &b = outline[(i + 1) % 8];
    faces.push_back({a, b, b + up, a + up});
  }
  const Scene scene = made_scene({{"u", faces}});
  const auto closed = closed_surfaces(scene);
  ASSERT_EQ(closed.size(), 1u);
  EXPECT_TRUE(closed[0].is_oriented);
  for (int x = -1; x <= 7; ++x) {
    for (int y = -1; y <= 7; ++y) {
      const bool in_plan = x > 0 && x < 6 && y > 0 && y < 6 && !(x >= 2 && x <= 4 && y >= 2);
      const bool on_plan =
          !in_plan && x >= 0 && x <= 6 && y >= 0 && y <= 6 && !(x > 2 && x < 4 && y > 2);
      for (const double z : {1.0, 2.0}) {
        const auto place = enclosure(scene, closed[0], {double(x), double(y), z});
        ASSERT_EQ(place.has_value(), !on_plan) << x << " " << y;
        if (!place) continue;
        ASSERT_EQ(place->is_inside, in_plan) << x << " " << y;
        ASSERT_EQ(place->winding, in_plan ? 1 : 0) << x << " " << y;
      }
    }
  }
}

TEST(ClosedSurface, PiecesAreToldApart) {
  const auto box = box_outward({0, 0, 0}, {4, 4, 4});
  auto open = box_outward({10, 0, 0}, {14, 4, 4});
  open.pop_back();
  auto mixed = box_outward({20, 0, 0}, {24, 4, 4});
  mixed[3] = reversed({mixed[3]})[0];
  const auto on_edge = box_outward({4, 4, 1}, {6, 6, 3});  // along an edge of the first
  const auto closed =
      closed_surfaces(made_scene({{"", open}, {"", mixed}, {"", box}, {"", on_edge}}));
  ASSERT_EQ(closed.size(), 3u);
  EXPECT_FALSE(closed[0].is_oriented);
  EXPECT_TRUE(closed[1].is_oriented);
  EXPECT_TRUE(closed[2].is_oriented);
  for (std::size_t piece = 0; piece < 3; ++piece) {
    ASSERT_EQ(closed[piece].surfaces.size(), 6u);
    EXPECT_EQ(closed[piece].surfaces.front(), SurfaceId(5 + 6 * piece));
    EXPECT_EQ(closed[piece].surfaces.back(), SurfaceId(10 + 6 * piece));
  }
}

}  // namespace
}  // namespace viewcover
