#include "links/shaft.h"

#include <gtest/gtest.h>

#include <random>

#include "support/exact_judge.h"
#include "support/scenes.h"
#include "support/shaft_case.h"

namespace viewcover {
namespace {

using testing::combination;
using testing::ExactPoint;
using testing::horizontal;
using testing::segment_meets;
using testing::ShaftCase;

const ConvexPolygon kRegion = horizontal(0, 0, 1, 1, 0);
const ConvexPolygon kElement = horizontal(0, 0, 1, 1, 2);

/// Turned by the rotation of integers over 3, times 3: nothing stays parallel to an axis.
ConvexPolygon turned(const ConvexPolygon& polygon) {
  Eigen::Matrix3d rotation;
  rotation << 2, -1, 2, 2, 2, -1, -1, 2, 2;
  ConvexPolygon result;
  for (const Point& corner : polygon) result.emplace_back(rotation * corner);
  return result;
}

std::vector<ConvexPolygon> turned(std::vector<ConvexPolygon> polygons) {
  for (ConvexPolygon& polygon : polygons) polygon = turned(polygon);
  return polygons;
}

TEST(Shaft, DropsWhatOnlyTouchesIt) {
  const std::vector<ConvexPolygon> touching{
      horizontal(1, 0, 2, 1, 1),                      // beside, sharing an edge
      {{1, 0, 0}, {1, 0, 2}, {1, 1, 2}, {1, 1, 0}},   // the shaft's own side
      horizontal(0.25, 0.25, 0.75, 0.75, 2),          // in the element's plane
      horizontal(-1, -1, 3, 3, 0),                    // in the region's plane
      {{0, 0, 2}, {1, 0, 2}, {0.5, 0, 3}},            // a wall on the element
      horizontal(0, 0, 1, 1, 3),                      // behind the element
      {{1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {1, 2, 1}}};  // at a corner line
  const ShaftCase upright(kRegion, kElement, touching);
  const ShaftCase tilted(turned(kRegion), turned(kElement), turned(touching));
  for (std::size_t i = 0; i < touching.size(); ++i) {
    EXPECT_EQ(upright.meets(SurfaceId(i)), Shaft::Meets::kNo) << i;
    EXPECT_EQ(tilted.meets(SurfaceId(i)), Shaft::Meets::kNo) << i;
  }
}

TEST(Shaft, DropsOccludersInThePlaneOfAnElementThatCutsTheRegion) {
  const ConvexPolygon region{{0, 0, -1}, {0, 1, -1}, {0, 1, 1}, {0, 0, 1}};
  const ConvexPolygon element = horizontal(3, 0, 4, 1, 0);
  const std::vector<ConvexPolygon> between{horizontal(1, 0, 2, 1, 0),
                                           horizontal(1, 0, 2, 1, 0x1p-10)};
  const ShaftCase upright(region, element, between);
  const ShaftCase tilted(turned(region), turned(element), turned(between));
  for (const ShaftCase* c : {&upright, &tilted}) {
    EXPECT_EQ(c->meets(SurfaceId(0)), Shaft::Meets::kNo);
    EXPECT_EQ(c->meets(SurfaceId(1)), Shaft::Meets::kMaybe);
  }
}

TEST(Shaft, KeepsWhatEntersItByOneLatticeStep) {
  const double step = 0x1p-20;
  const ShaftCase c(kRegion, kElement,
                    {horizontal(1 - step, 0, 2, 1, 1),
                     {{0, 0, 2 - step}, {1, 0, 2}, {1, 1, 2}},
                     {{0.5, 0.5, step}, {0.5, 0.5, -1}, {0.5, 1, -1}}});
  for (std::size_t i = 0; i < c.scene.surfaces.size(); ++i) {
    EXPECT_EQ(c.meets(SurfaceId(i)), Shaft::Meets::kMaybe) << i;
  }
}

TEST(Shaft, OneOccluderBlocksOnlyIfItCoversTheWholeSection) {
  const double step = 0x1p-20;
  const ShaftCase c(kRegion, kElement,
                    {horizontal(0, 0, 1, 1, 1),
                     horizontal(-1, -1, 2, 2, 0.5),
                     horizontal(0, 0, 1, 1 - step, 1),
                     {{0, 0, 0.5}, {1, 0, 0.5}, {1, 1, 1.5}, {0, 1, 1.5}},
                     {{0, 0, 0}, {1, 0, 0}, {1, 1, 2}, {0, 1, 2}},      // hinged on both
                     {{0, 0, -1}, {1, 0, -1}, {1, 1, 3}, {0, 1, 3}}});  // cuts both
  EXPECT_EQ(c.meets(SurfaceId(0)), Shaft::Meets::kBlocksAll);
  EXPECT_EQ(c.meets(SurfaceId(1)), Shaft::Meets::kBlocksAll);
  EXPECT_EQ(c.meets(SurfaceId(2)), Shaft::Meets::kMaybe);
  EXPECT_EQ(c.meets(SurfaceId(3)), Shaft::Meets::kBlocksAll);
  EXPECT_EQ(c.meets(SurfaceId(4)), Shaft::Meets::kBlocksAll);
  EXPECT_EQ(c.meets(SurfaceId(5)), Shaft::Meets::kMaybe);
}

TEST(Shaft, FacesUnlessCoplanarOrBehindAOneSidedElement) {
  const ShaftCase facing(kRegion, kElement, {kElement});
  EXPECT_TRUE(facing.shaft().is_facing());
  EXPECT_FALSE(facing.shaft(true).is_facing());  // the element's front is up, away from the region
  ConvexPolygon turned(kElement.rbegin(), kElement.rend());
  EXPECT_TRUE(ShaftCase(kRegion, turned, {kElement}).shaft(true).is_facing());
  const ShaftCase coplanar(kRegion, horizontal(2, 0, 3, 1, 0), {kElement});
  EXPECT_FALSE(coplanar.shaft().is_facing());
  // A region on both sides of the element's plane has a part in front.
  const ConvexPolygon wall{{0.5, 0, 1}, {0.5, 1, 1}, {0.5, 1, 2}, {0.5, 0, 2}};
  EXPECT_TRUE(ShaftCase(kRegion, wall, {kElement}).shaft(true).is_facing());
}

ConvexPolygon random_polygon(double low, double high, std::mt19937_64& random) {
  std::uniform_int_distribution<int> coordinate(0, 8);
  std::uniform_real_distribution<double> height(low, high);
  for (;;) {
    ConvexPolygon polygon;
    if (random() % 2 == 0) {
      for (int i = 0; i < 3; ++i) {
        polygon.emplace_back(coordinate(random), coordinate(random), std::round(height(random)));
      }
    } else {
      const Point a(coordinate(random), coordinate(random), std::round(height(random)));
      const Point u(coordinate(random) - 4, coordinate(random) - 4, coordinate(random) % 2);
      const Point v(coordinate(random) - 4, coordinate(random) - 4, 0);
      polygon = {a, a + u, a + u + v, a + v};
    }
    if (area(polygon) > 0 && is_strictly_convex(polygon)) return polygon;
  }
}

/// Small integers make contact of every kind frequent; the judge is rational and shares no code.
TEST(Shaft, VerdictsHoldOnExactSegmentsOfRandomGrazingShafts) {
  std::mt19937_64 random(3);
  int dropped = 0, kept = 0, blocking = 0, hits = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    SCOPED_TRACE(trial);
    // In a third of the trials the planes of region and element cut the other one.
    const bool cutting = trial % 3 == 0;
    const ConvexPolygon from = random_polygon(0, cutting ? 6 : 1, random);
    const ConvexPolygon to = random_polygon(cutting ? 0 : 5, 6, random);
    std::vector<ConvexPolygon> between{random_polygon(0, 6, random), horizontal(-8, -8, 20, 20, 3)};
    if (trial % 2 == 0) between[1] = random_polygon(2, 4, random);
    const ShaftCase c(from, to, between);
    if (!c.shaft().is_facing()) continue;
    const auto weights = [&](std::size_t n) {
      std::vector<int> list(n);
      for (int& w : list) w = 1 + static_cast<int>(random() % 16 == 0 ? 1000 : random() % 5);
      return list;
    };
    for (std::size_t i = 0; i < between.size(); ++i) {
      const Shaft::Meets meets = c.meets(SurfaceId(i));
      (meets == Shaft::Meets::kNo ? dropped : meets == Shaft::Meets::kMaybe ? kept : blocking)++;
      for (int ray = 0; ray < 8; ++ray) {
        const ExactPoint p = combination(from, weights(from.size()));
        const ExactPoint q = combination(to, weights(to.size()));
        const bool hit = segment_meets(p, q, between[i]);
        hits += hit;
        ASSERT_NE(meets, hit ? Shaft::Meets::kNo : Shaft::Meets::kBlocksAll);
      }
    }
  }
  EXPECT_GT(dropped, 500);
  EXPECT_GT(kept, 500);
  EXPECT_GT(blocking, 100);
  EXPECT_GT(hits, 1000);
}

TEST(Cull, OpensClustersUpToTheLimitAndDropsNothingThatMeetsTheShaft) {
  std::mt19937_64 random(9);
  std::size_t unopened = 0;
  for (int trial = 0; trial < 30; ++trial) {
    SCOPED_TRACE(trial);
    const auto triangles = testing::random_triangles(300, 0.05, 0.1, 1.9, random);
    const ShaftCase c(horizontal(0.25, 0.25, 0.5, 0.5, 0), horizontal(0.5, 0.5, 0.75, 0.625, 2),
                      triangles);
    const Shaft shaft = c.shaft();
    std::vector<bool> brute(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      brute[i] = c.meets(SurfaceId(i)) != Shaft::Meets::kNo;
    }
    const ShaftOccluder everything{.node = 0};
    for (const std::size_t limit : {std::size_t{2}, std::size_t{8}, kOpenAll}) {
      ShaftOccluders kept;
      ASSERT_FALSE(cull(shaft, {&everything, 1}, limit, kept));
      std::vector<bool> covered(triangles.size());
      for (const ShaftOccluder& occluder : kept) {
        const auto& node = c.clusters.nodes()[occluder.node];
        if (!node.is_leaf()) {
          EXPECT_NE(limit, kOpenAll);
          ++unopened;
        }
        for (std::uint32_t i = 0; i < node.count; ++i) {
          const SurfaceId surface = c.clusters.surface(OccluderId(node.first + i));
          EXPECT_FALSE(covered[surface.value]) << "listed twice";
          covered[surface.value] = true;
        }
      }
      for (std::size_t i = 0; i < triangles.size(); ++i) {
        EXPECT_TRUE(covered[i] || !brute[i]) << i;
        EXPECT_TRUE(limit != kOpenAll || covered[i] == brute[i]) << i;
      }
    }
  }
  EXPECT_GT(unopened, 30u);
}

}  // namespace
}  // namespace viewcover
