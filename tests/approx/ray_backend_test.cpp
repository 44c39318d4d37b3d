#include "approx/ray_backend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "links/sampling.h"
#include "support/shaft_case.h"

namespace viewcover {
namespace {

using testing::horizontal;
using testing::ShaftCase;

/// The backend's verdict on a shaft after culling; hidden too if one occluder blocks it.
Verdict decide(const ShaftCase& c, const RayOptions& options, std::size_t number = 0) {
  Shaft shaft = c.shaft(false, number);
  const ShaftOccluder everything{.node = 0};
  ShaftOccluders kept;
  if (cull(shaft, {&everything, 1}, kOpenAll, kept)) return Verdict::kHiddenByOne;
  if (kept.empty()) return Verdict::kFullyVisible;
  shaft.set_occluders(kept);
  return RayBackend(options).decide(shaft, Effort::kFull);
}

const ConvexPolygon kSource = horizontal(-0.5, -0.5, 0.5, 0.5, 0);
const ConvexPolygon kTarget = horizontal(-0.5, -0.5, 0.5, 0.5, 1);

/// Walls at height z that leave the open rectangle (x0, x1) x (y0, y1) free.
std::vector<ConvexPolygon> wall_with_window(double x0, double y0, double x1, double y1, double z) {
  std::vector<ConvexPolygon> walls;
  if (x0 > -2) walls.push_back(horizontal(-2, -2, x0, 2, z));
  if (x1 < 2) walls.push_back(horizontal(x1, -2, 2, 2, z));
  if (y0 > -2) walls.push_back(horizontal(x0, -2, x1, y0, z));
  if (y1 < 2) walls.push_back(horizontal(x0, y1, x1, 2, z));
  return walls;
}

std::vector<ConvexPolygon> joined(std::vector<ConvexPolygon> a,
                                  const std::vector<ConvexPolygon>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Shares of unblocked random pairs known in closed form, t = z / H.
struct ClosedForm {
  const char* name;
  std::vector<ConvexPolygon> occluders;
  double visible_share;
};

std::vector<ClosedForm> closed_forms() {
  const double w = 0.25, s = 0.5;
  return {
      // x of the crossing is the mean of two uniform numbers; P(|x| < w/2) = 2w - w^2.
      {"long slit of width 1/4", wall_with_window(-w / 2, -2, w / 2, 2, 0.5), 2 * w - w * w},
      // Both coordinates are independent.
      {"plate of side 1/2",
       {horizontal(-s / 2, -s / 2, s / 2, s / 2, 0.5)},
       1 - std::pow(2 * s - s * s, 2)},
      // |3a + b| / 4 < w/2 for uniform a, b in x, and the same in y with a, b exchanged.
      {"crossed slits of width 1/4",
       joined(wall_with_window(-2, -w / 2, 2, w / 2, 0.25),
              wall_with_window(-w / 2, -2, w / 2, 2, 0.75)),
       std::pow(4 * w / 3, 2)},
      // x > 0 at t = 1/4 and x < 0 at t = 3/4: the corner of the unit square cut by two lines.
      {"half walls", {horizontal(-2, -2, 0, 2, 0.25), horizontal(0, -2, 2, 2, 0.75)}, 1.0 / 6},
  };
}

TEST(RayBackend, OneRayIsFreeAsOftenAsTheClosedFormSays) {
  constexpr int kTrials = 40000;
  for (const ClosedForm& form : closed_forms()) {
    const ShaftCase c(kSource, kTarget, form.occluders);
    int visible = 0;
    for (int seed = 0; seed < kTrials; ++seed) {
      visible += is_visible(decide(c, {.rays = 1, .seed = static_cast<std::uint64_t>(seed)}));
    }
    const double share = form.visible_share;
    const double deviation = std::sqrt(share * (1 - share) / kTrials);
    EXPECT_NEAR(visible / double(kTrials), share, 4.5 * deviation) << form.name;
  }
}

TEST(RayBackend, StratifiedSamplesHitEveryStratumOnce) {
  for (const int count : {1, 2, 7, 16, 100, 1000}) {
    Samples4 samples(99, count, true);
    std::vector<std::array<bool, 4>> hit(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
      const auto sample = samples.next();
      for (std::size_t axis = 0; axis < 4; ++axis) {
        ASSERT_GT(sample[axis], 0);
        ASSERT_LE(sample[axis], 1);
        const auto stratum = std::min(static_cast<std::size_t>(sample[axis] * count),
                                      static_cast<std::size_t>(count - 1));
        EXPECT_FALSE(hit[stratum][axis]);
        hit[stratum][axis] = true;
      }
    }
  }
}

TEST(RayBackend, PolygonSamplesAreUniform) {
  // Trapezium with parallel sides 4 and 2 at distance 3; share of area below y = 1: 11 / 27.
  const ConvexPolygon trapezium{{0, 0, 1}, {4, 0, 1}, {3, 3, 1}, {1, 3, 1}};
  const PolygonSampler sampler(trapezium);
  RandomNumbers random(4);
  int low = 0, left = 0;
  constexpr int kTrials = 100000;
  for (int i = 0; i < kTrials; ++i) {
    const double u = random.open_unit(), v = random.open_unit();
    const Point p = sampler.point(u, v);
    low += p.y() < 1;
    left += p.x() < 2;
  }
  EXPECT_NEAR(low / double(kTrials), 11.0 / 27, 0.007);
  EXPECT_NEAR(left / double(kTrials), 0.5, 0.007);
}

/// Occluders that close a shaft by mere contact: no ray may slip through.
TEST(RayBackend, NothingIsSeenThroughContact) {
  const double third = std::nearbyint(0x1p20 / 3) * 0x1p-20;
  const Point hub(third, 0.125, 0.5);
  std::vector<ConvexPolygon> fan;
  const std::vector<Point> rim{{-2, -2, 0.5}, {2, -2, 0.5}, {2, 2, 0.5}, {-2, 2, 0.5}};
  for (std::size_t i = 0; i < 4; ++i) fan.push_back({hub, rim[i], rim[(i + 1) % 4]});
  const std::vector<std::pair<const char*, std::vector<ConvexPolygon>>> cases{
      {"abutting slats", {horizontal(-2, -2, third, 2, 0.5), horizontal(third, -2, 2, 2, 0.5)}},
      {"fan of triangles", fan},
      {"walls that meet in a T",
       {horizontal(-2, -2, 2, 0, 0.5), horizontal(-2, 0, third, 2, 0.5),
        horizontal(third, 0, 2, 2, 0.5)}},
      {"ridge",
       {{{-2, -2, 0.25}, {0, -2, 0.75}, {0, 2, 0.75}, {-2, 2, 0.25}},
        {{0, -2, 0.75}, {2, -2, 0.25}, {2, 2, 0.25}, {0, 2, 0.75}}}}};
  for (const auto& [name, occluders] : cases) {
    const ShaftCase c(kSource, kTarget, occluders);
    EXPECT_FALSE(is_visible(decide(c, {.rays = 20000}))) << name;
  }
}

TEST(RayBackend, SeesThroughTheSlitOnceItIsWideEnoughForItsRays) {
  for (const double width : {0x1p-6, 0x1p-8}) {
    const ShaftCase c(kSource, kTarget,
                      {horizontal(-2, -2, 0, 2, 0.5), horizontal(width, -2, 2, 2, 0.5)});
    // P(free) is about 2 * width a ray.
    EXPECT_TRUE(is_visible(decide(c, {.rays = 20000})));
    EXPECT_TRUE(is_visible(decide(c, {.rays = 20000, .stratified = true})));
  }
}

TEST(RayBackend, IsARepeatableFunctionOfSeedAndAddresses) {
  const ShaftCase c(kSource, kTarget, wall_with_window(-0.125, -2, 0.125, 2, 0.5));
  const RayOptions options{.rays = 1};
  int differ_by_seed = 0, differ_by_address = 0;
  for (std::size_t i = 0; i < 200; ++i) {
    const Verdict verdict = decide(c, {.rays = 1, .seed = i});
    EXPECT_EQ(verdict, decide(c, {.rays = 1, .seed = i}));
    differ_by_seed += verdict != decide(c, options);
    differ_by_address += decide(c, options, i) != decide(c, options);
  }
  EXPECT_GT(differ_by_seed, 20);
  EXPECT_GT(differ_by_address, 20);
}

TEST(RayBackend, LooksOnlyFromTheFrontOfAOneSidedElement) {
  // The region crosses the element's plane; its front part is behind a wall.
  const ConvexPolygon region = horizontal(-1, -1, 1, 1, 0);
  const ConvexPolygon element{{0, -1, 1}, {0, 1, 1}, {0, 1, 2}, {0, -1, 2}};  // front: x > 0
  const ConvexPolygon wall{
      {0.0078125, -9, -9}, {0.0078125, 9, -9}, {0.0078125, 9, 9}, {0.0078125, -9, 9}};
  const ConvexPolygon plate = horizontal(0, -2, 2, 2, 0.5);
  const ShaftCase c(region, element, {wall, plate});
  const ShaftOccluders all{{.node = c.leaf(SurfaceId(0))}, {.node = c.leaf(SurfaceId(1))}};
  for (const bool one_sided : {false, true}) {
    Shaft shaft = c.shaft(one_sided);
    shaft.set_occluders(all);
    EXPECT_EQ(is_visible(RayBackend({.rays = 1000}).decide(shaft, Effort::kFull)), !one_sided);
  }
}

TEST(RayBackend, LooksIntoClustersThatWereNotOpened) {
  std::mt19937_64 random(21);
  int visible = 0, hidden = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const ConvexPolygon from = horizontal(0.25, 0.25, 0.5, 0.5, 0);
    const ConvexPolygon to = horizontal(0.5, 0.5, 0.75, 0.625, 1);
    // A cluster may hold the element itself, and what lies in its plane or in the region's.
    auto between = testing::random_triangles(150, 0.25, 0.1, 0.9, random);
    between.insert(between.end(), {to, horizontal(0.25, 0.25, 0.625, 0.75, 1),
                                   horizontal(0.375, 0.375, 0.75, 0.75, 0)});
    const ShaftCase c(from, to, between);
    Shaft shaft = c.shaft();
    const ShaftOccluder everything{.node = 0};
    ShaftOccluders kept;
    if (cull(shaft, {&everything, 1}, kOpenAll, kept) || kept.empty()) continue;
    const RayBackend backend({.rays = 16});
    shaft.set_occluders(kept);
    const Verdict opened = backend.decide(shaft, Effort::kFull);
    shaft.set_occluders({&everything, 1});
    EXPECT_EQ(backend.decide(shaft, Effort::kFull), opened);
    (is_visible(opened) ? visible : hidden)++;
  }
  EXPECT_GT(visible, 20);
  EXPECT_GT(hidden, 20);
}

}  // namespace
}  // namespace viewcover
