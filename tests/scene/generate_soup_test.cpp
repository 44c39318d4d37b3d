#include <gmock/gmock.h>

#include "scene/error.h"
#include "scene/exact_faces.h"
#include "scene/generate/generated_scene.h"

namespace viewcover {
namespace {

// Mean crossings of the lines x, y = const through a grid of points over the middle of the square.
double mean_crossings(const GeneratedScene& soup) {
  constexpr int kGrid = 40;
  int crossings = 0;
  for (int i = 0; i < kGrid; ++i) {
    for (int k = 0; k < kGrid; ++k) {
      const double x = 0.3 + 0.4 * i / kGrid;
      const double y = 0.3 + 0.4 * k / kGrid;
      for (const GeneratedScene::Face& face : soup.faces) {
        int turns = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          const Point& p = soup.vertices[face.corners[c]];
          const Point& q = soup.vertices[face.corners[(c + 1) % 3]];
          turns += (p.x() - x) * (q.y() - y) - (p.y() - y) * (q.x() - x) > 0 ? 1 : -1;
        }
        crossings += std::abs(turns) == 3;
      }
    }
  }
  return crossings / double{kGrid * kGrid};
}

TEST(TriangleSoup, HasTheTrianglesAskedForInOneGroup) {
  for (const std::size_t n : {1u, 2u, 1000u}) {
    const GeneratedScene soup = triangle_soup(n, 1);
    EXPECT_EQ(soup.faces.size(), n);
    EXPECT_EQ(soup.groups.size(), 1u);
  }
}

TEST(TriangleSoup, TrianglesAreNearlyEquilateralOnTheLatticeAndClearOfTheRegion) {
  for (const std::size_t n : {1u, 50u, 4000u}) {
    const GeneratedScene soup = triangle_soup(n, 7);
    for (const WholeFace& face : whole_faces(soup)) {  // throws off the lattice
      EXPECT_TRUE(is_strictly_convex(face));
      for (const std::vector<Point>& part : soup.region) EXPECT_TRUE(is_clear_of(face, part));
    }
    for (const Point& p : soup.vertices) {
      EXPECT_TRUE(p.minCoeff() >= 0 && p.maxCoeff() <= 1) << p.transpose();
      EXPECT_GE(std::fabs(p.z() - 0.5), 0.05) << p.transpose();
    }
    for (const GeneratedScene::Face& face : soup.faces) {
      std::array<double, 3> edges{};
      for (std::size_t c = 0; c < 3; ++c) {
        edges[c] =
            (soup.vertices[face.corners[c]] - soup.vertices[face.corners[(c + 1) % 3]]).norm();
      }
      // Corners moved by at most half a step of 2^-20 in each coordinate.
      const auto [least, most] = std::minmax_element(edges.begin(), edges.end());
      EXPECT_LE(*most - *least, 4e-6);
    }
  }
}

// A triangle of area A in random direction has the mean shadow A/2; A = 3 sqrt(3) / 4 r^2 for the
// radius r = 0.68 n^(-1/3) of the circle round it, so n of them shade 0.3003 n^(1/3). They keep off
// the cube's faces, so it is more in the middle, by 1 / (1 - 2 r)^2: 4.02 for n = 1000 (r = 0.068)
// and 8.46 for n = 16000 (r = 0.027).
TEST(TriangleSoup, CrossingsOfALineGrowLikeTheCubeRoot) {
  EXPECT_NEAR(mean_crossings(triangle_soup(1000, 3)), 4.02, 0.4);
  EXPECT_NEAR(mean_crossings(triangle_soup(16000, 3)), 8.46, 0.5);
}

TEST(TriangleSoup, LiesAboveAndBelowTheRegionAlike) {
  const GeneratedScene soup = triangle_soup(10000, 2);
  std::size_t above = 0;
  for (const GeneratedScene::Face& face : soup.faces) {
    above += soup.vertices[face.corners[0]].z() > 0.5;
  }
  EXPECT_NEAR(static_cast<double>(above), 5000, 200);  // four standard deviations
}

TEST(TriangleSoup, NormalsHaveNoPreferredDirection) {
  const GeneratedScene soup = triangle_soup(20000, 11);
  Point mean = Point::Zero();
  Point squares = Point::Zero();
  for (const GeneratedScene::Face& face : soup.faces) {
    const Point& o = soup.vertices[face.corners[0]];
    const Point normal =
        (soup.vertices[face.corners[1]] - o).cross(soup.vertices[face.corners[2]] - o).normalized();
    mean += normal / 20000;
    squares += normal.cwiseAbs2() / 20000;
  }
  // Standard deviations: sqrt(1/3 / 20000) = 0.0041 and sqrt(4/45 / 20000) = 0.0021.
  EXPECT_LT(mean.cwiseAbs().maxCoeff(), 0.02);
  EXPECT_LT((squares - Point::Constant(1.0 / 3)).cwiseAbs().maxCoeff(), 0.01);
}

TEST(TriangleSoup, SameSeedSameTrianglesOtherSeedOthers) {
  const GeneratedScene soup = triangle_soup(100, 5);
  EXPECT_EQ(triangle_soup(100, 5).vertices, soup.vertices);
  EXPECT_NE(triangle_soup(100, 6).vertices, soup.vertices);
}

// Holds the numbers themselves fast, for other platforms and compilers.
TEST(TriangleSoup, NumbersAreTheSameEverywhere) {
  const GeneratedScene soup = triangle_soup(1000, 1);
  const std::array<double, 3> first = {654256, 739287, 971295};
  const std::array<double, 3> last = {590800, 132407, 158738};
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(std::ldexp(soup.vertices.front()[axis], 20), first[static_cast<std::size_t>(axis)]);
    EXPECT_EQ(std::ldexp(soup.vertices.back()[axis], 20), last[static_cast<std::size_t>(axis)]);
  }
}

TEST(TriangleSoup, RefusesNumbersOutOfRange) {
  EXPECT_THROW(triangle_soup(0, 1), InputError);
  EXPECT_THROW(triangle_soup(100'000'001, 1), InputError);
}

}  // namespace
}  // namespace viewcover
