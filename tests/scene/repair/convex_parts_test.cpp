#include "scene/repair/convex_parts.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "scene/predicates.h"
#include "scene/repair/convex_merge.h"

namespace viewcover {

void PrintTo(FaceKind kind, std::ostream* out) {
  constexpr const char* kNames[] = {"whole", "split", "triangulated", "degenerate", "crossing"};
  *out << kNames[static_cast<int>(kind)];
}

namespace {

using Loop = std::vector<Point>;
using Plane2 = std::vector<std::pair<int, int>>;

Loop flat(const Plane2& corners) {
  Loop loop;
  for (const auto& [x, y] : corners) loop.emplace_back(x, y, 0);
  return loop;
}

// Into a slanted plane, by an integer map: z = 3x - 2y + 1.
Loop slanted(Loop loop) {
  for (Point& p : loop) p.z() = 3 * p.x() - 2 * p.y() + 1;
  return loop;
}

// Twice the area of the projection to z = 0 in whole numbers: another computation than the one
// tested. All coordinates here are whole and below 2^24.
std::int64_t twice_area(std::span<const Point> loop) {
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Point &a = loop[i], &b = loop[(i + 1) % loop.size()];
    sum += static_cast<std::int64_t>(a.x()) * static_cast<std::int64_t>(b.y()) -
           static_cast<std::int64_t>(a.y()) * static_cast<std::int64_t>(b.x());
  }
  return sum;
}

std::int64_t twice_area(const ConvexParts& parts) {
  std::int64_t sum = 0;
  for (const ConvexPolygon& part : parts.polygons) sum += twice_area(part);
  return sum;
}

// True iff an edge of one of the two has the other polygon on its outer side: for convex polygons
// in the plane, iff their interiors are disjoint. Both counter-clockwise.
bool are_disjoint(const ConvexPolygon& a, const ConvexPolygon& b) {
  const auto separates = [](const ConvexPolygon& p, const ConvexPolygon& q) {
    for (std::size_t i = 0; i < p.size(); ++i) {
      const bool is_outside = std::all_of(q.begin(), q.end(), [&](const Point& corner) {
        return turn(p[i], p[(i + 1) % p.size()], corner, 2) <= 0;
      });
      if (is_outside) return true;
    }
    return false;
  };
  return separates(a, b) || separates(b, a);
}

// Everything that convex_parts promises of a loop that runs counter-clockwise seen from +z.
void expect_parts(const Loop& loop, FaceKind kind) {
  const ConvexParts parts = convex_parts(loop);
  EXPECT_EQ(parts.kind, kind);
  EXPECT_EQ(twice_area(parts), twice_area(loop));
  for (const ConvexPolygon& part : parts.polygons) {
    EXPECT_TRUE(is_strictly_convex(part));
    EXPECT_TRUE(is_planar(part));
    EXPECT_GT(twice_area(part), 0);
    for (const Point& corner : part) {
      EXPECT_NE(std::find(loop.begin(), loop.end(), corner), loop.end());
    }
  }
  for (std::size_t i = 0; i < parts.polygons.size(); ++i) {
    for (std::size_t j = i + 1; j < parts.polygons.size(); ++j) {
      EXPECT_TRUE(are_disjoint(parts.polygons[i], parts.polygons[j])) << i << " and " << j;
    }
  }
  // The reversed loop gives parts that face the other way.
  const ConvexParts back = convex_parts(Loop(loop.rbegin(), loop.rend()));
  EXPECT_EQ(back.kind, kind);
  EXPECT_EQ(twice_area(back), -twice_area(loop));
  for (const ConvexPolygon& part : back.polygons) EXPECT_LT(twice_area(part), 0);
}

TEST(ConvexParts, ConvexStaysWhole) {
  const Loop square = flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  expect_parts(square, FaceKind::kWhole);
  expect_parts(slanted(square), FaceKind::kWhole);
  EXPECT_EQ(convex_parts(square).polygons[0], ConvexPolygon(square.begin(), square.end()));
}

TEST(ConvexParts, DropsStraightAndRepeatedCorners) {
  const auto parts = convex_parts(
      flat({{0, 0}, {2, 0}, {2, 0}, {4, 0}, {4, 4}, {4, 4}, {3, 4}, {0, 4}, {0, 3}, {0, 0}}));
  EXPECT_EQ(parts.kind, FaceKind::kWhole);
  ASSERT_EQ(parts.polygons.size(), 1u);
  const Loop expected = flat({{4, 0}, {4, 4}, {0, 4}, {0, 0}});
  EXPECT_TRUE(std::is_permutation(parts.polygons[0].begin(), parts.polygons[0].end(),
                                  expected.begin(), expected.end()));
  EXPECT_TRUE(is_strictly_convex(parts.polygons[0]));
}

TEST(ConvexParts, DropsSpikes) {
  // Out along a line and back: (6,0) goes first, then (4,0) is repeated.
  expect_parts(flat({{0, 0}, {4, 0}, {6, 0}, {4, 0}, {4, 4}, {0, 4}}), FaceKind::kWhole);
  // A spike inwards, whose tip is not straight with the corners beside its foot.
  expect_parts(flat({{0, 0}, {4, 0}, {2, 2}, {4, 0}, {4, 4}, {0, 4}}), FaceKind::kWhole);
}

TEST(ConvexParts, ConcaveIsSplitInFewParts) {
  const Loop corner = flat({{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}});
  expect_parts(corner, FaceKind::kSplit);
  expect_parts(slanted(corner), FaceKind::kSplit);
  EXPECT_EQ(convex_parts(corner).polygons.size(), 2u);
  // Hertel and Mehlhorn: at most 2 r + 1 parts for r notches (the optimum is r / 2 + 1 at least).
  const Loop comb = flat(
      {{0, 0}, {9, 0}, {9, 5}, {8, 1}, {7, 5}, {6, 1}, {5, 5}, {4, 1}, {3, 5}, {2, 1}, {1, 5}});
  expect_parts(comb, FaceKind::kSplit);
  EXPECT_LE(convex_parts(comb).polygons.size(), 2 * 4 + 1u);
}

TEST(ConvexParts, LoopsAreHoles) {
  const Loop outline = flat({{0, 0}, {8, 0}, {8, 8}, {0, 8}}),
             left = flat({{1, 1}, {1, 7}, {3, 7}, {3, 1}}),
             right = flat({{5, 2}, {5, 6}, {7, 6}, {7, 2}});
  const std::vector<Loop> one = {outline, left}, both = {outline, left, right};
  EXPECT_EQ(twice_area(convex_parts(one)), 2 * (64 - 12));
  EXPECT_EQ(convex_parts(one).polygons.size(), 4u);
  EXPECT_EQ(twice_area(convex_parts(both)), 2 * (64 - 12 - 8));
  EXPECT_EQ(convex_parts(both).kind, FaceKind::kSplit);
  EXPECT_EQ(convex_parts(std::vector<Loop>{outline}).kind, FaceKind::kWhole);

  // A hole that crosses the outline, one that winds as it does, and one in another plane.
  const std::vector<Loop> crossing = {outline, flat({{7, 1}, {7, 2}, {9, 2}, {9, 1}})},
                          same_way = {outline, Loop(left.rbegin(), left.rend())};
  std::vector<Loop> beside = one;
  beside[1][0].z() += 1;
  for (const std::vector<Loop>& wrong : {crossing, same_way, beside}) {
    EXPECT_EQ(convex_parts(wrong).kind, FaceKind::kCrossing);
  }
}

TEST(ConvexParts, KeyholesAreCutOut) {
  const Loop one =
      flat({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {2, 2}, {2, 6}, {6, 6}, {6, 2}, {2, 2}});
  expect_parts(one, FaceKind::kSplit);
  expect_parts(slanted(one), FaceKind::kSplit);
  EXPECT_EQ(twice_area(convex_parts(one)), 2 * (64 - 16));
  EXPECT_EQ(convex_parts(one).polygons.size(), 4u);
  // Two holes, each at a bridge of its own.
  const Loop two = flat({{0, 0},
                         {9, 0},
                         {9, 5},
                         {0, 5},
                         {0, 0},
                         {1, 1},
                         {1, 4},
                         {4, 4},
                         {4, 1},
                         {1, 1},
                         {0, 0},
                         {9, 0},
                         {8, 1},
                         {5, 1},
                         {5, 4},
                         {8, 4},
                         {8, 1},
                         {9, 0}});
  EXPECT_EQ(twice_area(two), 2 * (45 - 18));
  expect_parts(two, FaceKind::kSplit);
  // The second hole hangs on the first.
  const Loop chain = flat({{0, 0},
                           {9, 0},
                           {9, 5},
                           {0, 5},
                           {0, 0},
                           {1, 1},
                           {1, 4},
                           {4, 4},
                           {5, 4},
                           {8, 4},
                           {8, 1},
                           {5, 1},
                           {5, 4},
                           {4, 4},
                           {4, 1},
                           {1, 1}});
  EXPECT_EQ(twice_area(chain), 2 * (45 - 18));
  expect_parts(chain, FaceKind::kSplit);
  // The bridge runs on from an edge of the outline and overlaps part of it.
  expect_parts(
      flat({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 2}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {0, 2}}),
      FaceKind::kSplit);
}

TEST(ConvexParts, MayTouchThemselves) {
  // A notch whose tip touches the opposite edge.
  expect_parts(flat({{0, 0}, {8, 0}, {8, 4}, {5, 4}, {4, 0}, {3, 4}, {0, 4}}), FaceKind::kSplit);
}

TEST(ConvexParts, LoopsThatAreNotPlanarAreTriangulated) {
  Loop quad = flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}});
  quad[2].z() = 0x1p-20;
  expect_parts(quad, FaceKind::kTriangulated);
  EXPECT_EQ(convex_parts(quad).polygons.size(), 2u);
  // One corner out of the plane of four others, which stay together.
  Loop house = flat({{0, 0}, {4, 0}, {4, 4}, {2, 6}, {0, 4}});
  house[3].z() = 1;
  expect_parts(house, FaceKind::kTriangulated);
  EXPECT_LE(convex_parts(house).polygons.size(), 3u);
  // A saddle that shows a crossing from one side only.
  const Loop saddle = {{0, 0, 0}, {4, 0, 1}, {0, 0, 4}, {4, 1, 3}};
  EXPECT_NE(convex_parts(saddle).kind, FaceKind::kWhole);
}

TEST(ConvexParts, CrossingLoopsAreRefused) {
  const auto kind = [](const Plane2& corners) { return convex_parts(flat(corners)).kind; };
  EXPECT_EQ(kind({{0, 0}, {4, 4}, {4, 0}, {0, 4}}), FaceKind::kCrossing);  // bow-tie, no area
  EXPECT_EQ(kind({{0, 0}, {6, 6}, {6, 0}, {0, 4}}), FaceKind::kCrossing);  // bow-tie, some area
  EXPECT_EQ(kind({{0, 0}, {4, 0}, {0, 4}, {0, 0}, {-4, 0}, {0, -3}}), FaceKind::kSplit);
  // Two loops joined at a corner that run opposite ways: one of them faces backwards.
  EXPECT_EQ(kind({{0, 0}, {4, 0}, {0, 4}, {0, 0}, {0, -3}, {-4, 0}}), FaceKind::kCrossing);
  // A pentagram winds twice round its middle.
  EXPECT_EQ(kind({{0, 10}, {-6, -8}, {9, 3}, {-9, 3}, {6, -8}}), FaceKind::kCrossing);
  // A square inside a square, both counter-clockwise: the inner one would be covered twice.
  EXPECT_EQ(kind({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {2, 2}, {6, 2}, {6, 6}, {2, 6}, {2, 2}}),
            FaceKind::kCrossing);
  for (const ConvexPolygon& part : convex_parts(flat({{0, 0}, {4, 4}, {4, 0}, {0, 4}})).polygons) {
    ADD_FAILURE() << "a part with " << part.size() << " corners";
  }
}

TEST(ConvexParts, NoAreaIsDegenerate) {
  const auto kind = [](const Plane2& corners) { return convex_parts(slanted(flat(corners))).kind; };
  EXPECT_EQ(kind({{0, 0}, {1, 1}, {3, 3}}), FaceKind::kDegenerate);
  EXPECT_EQ(kind({{0, 0}, {1, 1}, {0, 0}}), FaceKind::kDegenerate);
  EXPECT_EQ(kind({{2, 2}, {2, 2}, {2, 2}, {2, 2}}), FaceKind::kDegenerate);
  EXPECT_EQ(kind({{0, 0}, {4, 0}, {4, 4}, {4, 0}}), FaceKind::kDegenerate);  // there and back
  EXPECT_EQ(kind({{0, 0}, {4, 0}, {0, 4}, {0, 0}, {0, 4}, {4, 0}}), FaceKind::kDegenerate);
  // One lattice step wide is not degenerate.
  EXPECT_EQ(kind({{0, 0}, {8000000, 1}, {4000000, 1}}), FaceKind::kWhole);
}

TEST(ConvexParts, RandomStarsKeepTheirArea) {
  int split = 0;
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::size_t n = 3 + random() % 40;
    std::uniform_real_distribution<double> radius(seed % 3 == 0 ? 10 : 1000,
                                                  seed % 3 == 0 ? 12 : 8e6);
    // Star-shaped about the origin: corners in order of angle, less than half a turn apart.
    Loop loop;
    for (std::size_t i = 0; i < n; ++i) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
      const double r = radius(random);
      loop.emplace_back(std::round(r * std::cos(angle)), std::round(r * std::sin(angle)), 0);
    }
    // Rounding may have spoilt the order of angles of small stars: leave those out.
    bool is_star = true;
    for (std::size_t i = 0; i < n; ++i) {
      is_star = is_star && turn(Point(0, 0, 0), loop[i], loop[(i + 1) % n], 2) > 0;
    }
    if (!is_star) continue;
    const FaceKind kind = convex_parts(loop).kind;
    ASSERT_TRUE(kind == FaceKind::kSplit || kind == FaceKind::kWhole);
    split += kind == FaceKind::kSplit;
    expect_parts(loop, kind);
    // One corner lifted: the triangulation of the same projection.
    Loop lifted = loop;
    lifted[0].z() = 1;
    if (n > 3 && kind == FaceKind::kSplit) expect_parts(lifted, FaceKind::kTriangulated);
  }
  EXPECT_GT(split, 150);
}

std::vector<ConvexCell> grid(int n, std::vector<Point>& points) {
  for (int y = 0; y <= n; ++y) {
    for (int x = 0; x <= n; ++x) points.emplace_back(x, 2 * y, x + y);
  }
  std::vector<ConvexCell> cells;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const auto at = static_cast<std::uint32_t>(y * (n + 1) + x),
                 up = static_cast<std::uint32_t>(n);
      cells.push_back({{at, at + 1, at + up + 2, at + up + 1}, 0, 0});
    }
  }
  return cells;
}

TEST(ConvexMerge, GridBecomesOneCellWhateverTheOrder) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    std::vector<Point> points;
    auto cells = grid(7, points);
    std::mt19937 random(seed);
    std::shuffle(cells.begin(), cells.end(), random);
    for (std::uint32_t i = 0; i < cells.size(); ++i) cells[i].source = i;
    const auto merged = merge_convex(points, cells);
    ASSERT_EQ(merged.size(), 1u) << "seed " << seed;
    EXPECT_EQ(merged[0].corners.size(), 4u);
    EXPECT_EQ(merged[0].source, 0u);
  }
}

TEST(ConvexMerge, KeepsApartWhatIsNotOnePolygon) {
  std::vector<Point> points;
  auto cells = grid(2, points);
  cells[3].group = 1;  // three of one group make an L
  EXPECT_EQ(merge_convex(points, cells).size(), 3u);
  cells[3].group = 0;
  std::reverse(cells[3].corners.begin(), cells[3].corners.end());  // faces the other way
  EXPECT_EQ(merge_convex(points, cells).size(), 3u);
  cells = grid(2, points);
  points.assign(points.begin(), points.begin() + 9);
  points[8].z() += 0x1p-40;  // a quadrilateral in two planes no more in that of the others
  cells.pop_back();
  cells.push_back({{4, 5, 8}, 0, 0});
  cells.push_back({{4, 8, 7}, 0, 0});
  EXPECT_EQ(merge_convex(points, cells).size(), 4u);
  // Folded back over one another: they share an edge but lie on the same side of it.
  const std::vector<Point> fold = {{0, 0, 0}, {4, 0, 0}, {1, 3, 0}, {3, 3, 0}};
  EXPECT_EQ(merge_convex(fold, {{{0, 1, 2}, 0, 0}, {{0, 1, 3}, 0, 0}}).size(), 2u);
  EXPECT_EQ(merge_convex(fold, {{{0, 1, 2}, 0, 0}, {{1, 0, 3}, 0, 0}}).size(), 2u);
  const std::vector<Point> nested = {{0, 0, 0}, {4, 0, 0}, {2, 5, 0}, {2, 1, 0}};
  EXPECT_EQ(merge_convex(nested, {{{0, 1, 2}, 0, 0}, {{1, 0, 3}, 0, 0}}).size(), 2u);
}

}  // namespace
}  // namespace viewcover
