#include "scene/repair/cracks.h"

#include <gmock/gmock.h>

#include <set>

#include "scene/made_soup.h"
#include "scene/random_numbers.h"

namespace viewcover::testing {
namespace {

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

}  // namespace
}  // namespace viewcover::testing
