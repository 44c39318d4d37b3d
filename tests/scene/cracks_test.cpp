#include "scene/cracks.h"

#include <gmock/gmock.h>

#include <set>

#include "scene/convex_parts.h"
#include "scene/random_numbers.h"
#include "scene/scene.h"
#include "scene/scratch_folder.h"
#include "scene/surface_mesh.h"

namespace viewcover::testing {
namespace {

/// Faces with corners of their own, as files have them that were not welded.
PolygonSoup soup_of(const std::vector<std::vector<Point>>& faces) {
  PolygonSoup soup;
  soup.file = "made";
  soup.groups = {""};
  for (const std::vector<Point>& corners : faces) {
    PolygonSoup::Face face;
    for (const Point& corner : corners) {
      face.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.push_back(corner);
    }
    soup.faces.push_back(face);
    soup.face_groups.emplace_back(0);
  }
  return soup;
}

/// A square [0, 2] x [0, 2] and to its right two squares of half the size, whose common corner lies
/// `gap` beside the middle of the large one's edge.
PolygonSoup t_junction(double gap) {
  return soup_of({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                  {{2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2 + gap, 1, 0}},
                  {{2 + gap, 1, 0}, {3, 1, 0}, {3, 2, 0}, {2, 2, 0}}});
}

TEST(Cracks, AreFoundWithPlaceAndWidth) {
  const Cracks cracks = find_cracks(t_junction(0.01), 0.02);
  ASSERT_EQ(cracks.beside_edges.size(), 1u);
  const Crack& crack = cracks.beside_edges[0];
  EXPECT_EQ(crack.face, 0u);
  EXPECT_EQ(crack.edge, 1u);
  EXPECT_DOUBLE_EQ(crack.along, 0.5);
  EXPECT_NEAR(crack.width, 0.01, 1e-15);
  EXPECT_TRUE(cracks.apart.empty());
  EXPECT_EQ(cracks.junctions, 0u);

  EXPECT_TRUE(find_cracks(t_junction(0.03), 0.02).beside_edges.empty());
  const Cracks closed = find_cracks(t_junction(0), 0.02);
  EXPECT_TRUE(closed.beside_edges.empty());
  EXPECT_EQ(closed.junctions, 1u);
}

TEST(Cracks, NearVerticesAreNoneBesideEdges) {
  const PolygonSoup soup =
      soup_of({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{1.005, 0, 0}, {2, 0, 0}, {2, 1, 0}}});
  const Cracks cracks = find_cracks(soup, 0.01);
  ASSERT_EQ(cracks.apart.size(), 1u);
  EXPECT_EQ(cracks.apart[0].first, 1u);
  EXPECT_EQ(cracks.apart[0].second, 3u);
  EXPECT_NEAR(cracks.apart[0].distance, 0.005, 1e-15);
  EXPECT_TRUE(cracks.beside_edges.empty());
}

TEST(Cracks, AgreeWithAllPairs) {
  std::size_t found = 0, near = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    RandomNumbers random(mixed(seed));
    std::vector<std::vector<Point>> faces;
    for (int i = 0; i < 40; ++i) {
      faces.emplace_back();
      for (int k = 0; k < 3; ++k)
        faces.back().emplace_back(random.unit(), random.unit(), random.unit() / 4);
    }
    const PolygonSoup soup = soup_of(faces);
    constexpr double kWidth = 0.02;
    std::set<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>> expected, got;
    for (std::uint32_t v = 0; v < soup.vertices.size(); ++v) {
      for (std::uint32_t f = 0; f < soup.faces.size(); ++f) {
        for (std::uint32_t k = 0; k < 3; ++k) {
          const Point &a = soup.vertices[3 * f + k], &b = soup.vertices[3 * f + (k + 1) % 3],
                      &x = soup.vertices[v];
          const double length = (b - a).norm(), from_a = (b - a).dot(x - a) / length;
          const double distance = (b - a).cross(x - a).norm() / length;
          if (v / 3 != f && length > 2 * kWidth && from_a > kWidth && from_a < length - kWidth &&
              distance <= kWidth) {
            expected.insert({v, f, k});
          }
        }
      }
      for (std::uint32_t w = 0; w < v; ++w)
        near += (soup.vertices[v] - soup.vertices[w]).norm() <= kWidth;
    }
    const Cracks cracks = find_cracks(soup, kWidth);
    for (const Crack& crack : cracks.beside_edges)
      got.insert({crack.vertex, crack.face, crack.edge});
    EXPECT_EQ(got, expected);
    found += got.size();
    near -= cracks.apart.size();
  }
  EXPECT_GT(found, 100u);
  EXPECT_EQ(near, 0u);
}

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

TEST(Heal, ABridgeToAHoleStaysWalkedTwice) {
  PolygonSoup soup = soup_of({{{0, 0, 0},
                               {4, 0, 0},
                               {4, 4, 0},
                               {0, 4, 0},
                               {0, 0, 0},
                               {1, 1, 0},
                               {1, 3, 0},
                               {3, 3, 0},
                               {3, 1, 0},
                               {1, 1, 0}},
                              {{0.5, 0.52, 0}, {0.4, 0.5, 1}, {0.6, 0.5, 1}}});
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

}  // namespace
}  // namespace viewcover::testing
