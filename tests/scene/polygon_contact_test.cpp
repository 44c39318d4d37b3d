#include "scene/polygon_contact.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <random>
#include <utility>

#include "scene/convex_polygon.h"

namespace viewcover {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using ExactVector = std::array<Rational, 3>;

ExactVector exact(const Point& p) { return {Rational(p.x()), Rational(p.y()), Rational(p.z())}; }
ExactVector minus(const ExactVector& a, const ExactVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
ExactVector cross(const ExactVector& a, const ExactVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const ExactVector& a, const ExactVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Second opinion, by construction: the segment in which a polygon meets a plane, as an interval of
// places along `direction`; none unless the polygon has corners strictly on both sides.
std::optional<std::pair<Rational, Rational>> interval(const ConvexPolygon& polygon,
                                                      const ConvexPolygon& plane,
                                                      const ExactVector& direction) {
  const ExactVector origin = exact(plane[0]);
  const ExactVector normal = cross(minus(exact(plane[1]), origin), minus(exact(plane[2]), origin));
  bool above = false, below = false;
  std::optional<std::pair<Rational, Rational>> result;
  const auto extend = [&](const Rational& place) {
    if (!result) result.emplace(place, place);
    result->first = std::min(result->first, place);
    result->second = std::max(result->second, place);
  };
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ExactVector a = exact(polygon[i]), b = exact(polygon[(i + 1) % polygon.size()]);
    const Rational height_a = dot(minus(a, origin), normal);
    const Rational height_b = dot(minus(b, origin), normal);
    above = above || height_a > 0;
    below = below || height_a < 0;
    if (height_a == 0) extend(dot(a, direction));
    if ((height_a > 0 && height_b < 0) || (height_a < 0 && height_b > 0)) {
      const Rational t = height_a / (height_a - height_b);
      extend(dot(a, direction) * (1 - t) + dot(b, direction) * t);
    }
  }
  if (!above || !below) return std::nullopt;
  return result;
}

bool cut_by_construction(const ConvexPolygon& p, const ConvexPolygon& q) {
  const auto normal = [](const ConvexPolygon& x) {
    return cross(minus(exact(x[1]), exact(x[0])), minus(exact(x[2]), exact(x[0])));
  };
  const ExactVector direction = cross(normal(p), normal(q));
  const auto on_p = interval(p, q, direction), on_q = interval(q, p, direction);
  return on_p && on_q && on_p->first < on_q->second && on_q->first < on_p->second;
}

TEST(CutEachOther, CrossingPolygonsCut) {
  const ConvexPolygon floor = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  EXPECT_TRUE(cut_each_other(floor, ConvexPolygon{{1, 2, -1}, {3, 2, -1}, {3, 2, 1}}));
  EXPECT_TRUE(cut_each_other(floor, ConvexPolygon{{-9, 2, -1}, {9, 2, -1}, {9, 2, 9}, {-9, 2, 9}}));
  // Only its corner reaches in, past an edge and past a corner of the floor.
  EXPECT_TRUE(cut_each_other(floor, ConvexPolygon{{9, 2, -5}, {9, 2, 5}, {3, 2, 0}}));
  EXPECT_TRUE(cut_each_other(floor, ConvexPolygon{{9, 9, -5}, {9, 9, 5}, {3, 3, 0}}));
}

TEST(CutEachOther, TouchingIsNoCut) {
  const ConvexPolygon floor = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const std::vector<ConvexPolygon> touching = {
      {{1, 1, 0}, {2, 1, 0}, {1, 2, 0}},                 // coplanar, within
      {{-1, -1, 0}, {9, -1, 0}, {9, 9, 0}, {-1, 9, 0}},  // coplanar, round it
      {{1, 2, 0}, {3, 2, 0}, {3, 2, 1}, {1, 2, 1}},      // standing on it
      {{4, 1, -1}, {4, 3, -1}, {4, 3, 1}, {4, 1, 1}},    // a wall along an edge of the floor
      {{2, 2, 0}, {3, 2, 1}, {2, 3, 1}},                 // a corner on it
      {{4, 2, 0}, {9, 2, 1}, {9, 2, -1}},                // a corner on its edge
      {{4, 4, 0}, {9, 9, 1}, {9, 9, -1}},                // a corner on its corner
      {{3, 5, -1}, {5, 3, -1}, {5, 3, 1}, {3, 5, 1}},    // a wall past its corner
      {{9, 9, -1}, {8, 9, 1}, {9, 8, 1}},                // far off
  };
  for (const ConvexPolygon& polygon : touching) {
    EXPECT_FALSE(cut_each_other(floor, polygon)) << polygon[0].transpose();
    EXPECT_FALSE(cut_each_other(polygon, floor)) << polygon[0].transpose();
  }
}

TEST(CutEachOther, OneLatticeUnitDecides) {
  const double unit = 0x1p-20;
  const ConvexPolygon floor = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  const auto spike = [](double tip) { return ConvexPolygon{{8, 2, -3}, {8, 2, 3}, {tip, 2, 0}}; };
  EXPECT_TRUE(cut_each_other(floor, spike(4 - unit)));
  EXPECT_FALSE(cut_each_other(floor, spike(4)));
  EXPECT_FALSE(cut_each_other(floor, spike(4 + unit)));
  const auto board = [](double bottom) {
    return ConvexPolygon{{1, 2, bottom}, {3, 2, bottom}, {3, 2, 1}, {1, 2, 1}};
  };
  EXPECT_TRUE(cut_each_other(floor, board(-unit)));
  EXPECT_FALSE(cut_each_other(floor, board(0)));
  EXPECT_FALSE(cut_each_other(floor, board(unit)));
}

// Parallelograms and triangles on small integers, where half of all pairs graze.
ConvexPolygon random_polygon(std::mt19937_64& random, int reach) {
  std::uniform_int_distribution<int> coordinate(-reach, reach);
  for (;;) {
    Point p[3];
    for (Point& corner : p)
      corner = Point(coordinate(random), coordinate(random), coordinate(random));
    if ((p[1] - p[0]).cross(p[2] - p[0]).isZero(0)) continue;
    ConvexPolygon polygon = {p[0], p[1], p[2]};
    if (random() % 2 != 0) polygon.push_back(p[0] + (p[2] - p[1]));
    return polygon;
  }
}

TEST(CutEachOther, AgreesWithRationalConstruction) {
  std::size_t cuts = 0, touches = 0, cases = 0;
  for (std::uint64_t seed = 1; seed <= 6000; ++seed) {
    std::mt19937_64 random(seed);
    const int reach = seed % 3 == 0 ? (1 << 23) : seed % 3 == 1 ? 2 : 5;
    const ConvexPolygon p = random_polygon(random, reach), q = random_polygon(random, reach);
    const bool expected = cut_by_construction(p, q);
    ASSERT_EQ(cut_each_other(p, q), expected) << "seed " << seed;
    ASSERT_EQ(cut_each_other(q, p), expected) << "seed " << seed;
    ASSERT_EQ(cut_each_other(ConvexPolygon(p.rbegin(), p.rend()), q), expected) << "seed " << seed;
    cuts += expected;
    touches += !expected && is_nearer_than(p, q, 0x1p-100);
    ++cases;
  }
  EXPECT_GT(cuts, cases / 10);
  EXPECT_GT(touches, cases / 20);
}

TEST(IsNearerThan, KnownDistances) {
  const ConvexPolygon floor = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}};
  struct Case {
    ConvexPolygon polygon;
    double distance;
    const char* what;
  };
  const std::vector<Case> cases = {
      {{{1, 1, 3}, {2, 1, 3}, {1, 2, 3}}, 3, "parallel above the middle"},
      {{{-9, -9, 3}, {9, -9, 3}, {9, 9, 3}, {-9, 9, 3}}, 3, "parallel, larger"},
      {{{-1, 1, 3}, {5, 1, 3}, {5, 3, 3}, {-1, 3, 3}}, 3, "parallel, no corner over the other"},
      {{{2, 2, 1}, {3, 2, 5}, {2, 3, 5}}, 1, "a corner above the middle"},
      {{{7, 1, 4}, {7, 3, 4}, {9, 2, 9}}, 5, "edge to edge"},
      {{{6, 6, 1}, {9, 9, 1}, {9, 9, 2}}, 3, "corner to corner"},
      {{{6, 1, 0}, {8, 1, 0}, {8, 3, 0}}, 2, "coplanar"},
  };
  for (const Case& c : cases) {
    EXPECT_FALSE(is_nearer_than(floor, c.polygon, c.distance)) << c.what;
    EXPECT_FALSE(is_nearer_than(c.polygon, floor, c.distance)) << c.what;
    EXPECT_TRUE(is_nearer_than(floor, c.polygon, std::nextafter(c.distance, 9))) << c.what;
    EXPECT_TRUE(is_nearer_than(c.polygon, floor, std::nextafter(c.distance, 9))) << c.what;
  }
  EXPECT_TRUE(is_nearer_than(floor, ConvexPolygon{{1, 2, -1}, {3, 2, -1}, {2, 2, 1}}, 0x1p-900))
      << "cutting";
  EXPECT_TRUE(is_nearer_than(floor, ConvexPolygon{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, 0x1p-900))
      << "coplanar and overlapping";
  EXPECT_FALSE(is_nearer_than(floor, floor, 0));
}

// Second opinion: alternating projections converge to the distance of convex sets from above.
double projected_distance(const ConvexPolygon& p, const ConvexPolygon& q) {
  const auto nearest = [](const ConvexPolygon& polygon, const Point& x) {
    const Point normal = area_vector(polygon).normalized();
    const Point foot = x - normal * normal.dot(x - polygon[0]);
    bool is_inside = true;
    Point best = polygon[0];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      is_inside = is_inside && normal.dot((b - a).cross(foot - a)) >= 0;
      const double t = std::clamp((x - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
      const Point candidate = a + t * (b - a);
      if ((candidate - x).norm() < (best - x).norm()) best = candidate;
    }
    return is_inside ? foot : best;
  };
  Point x = corner_mean(p), y = nearest(q, x);
  for (int i = 0; i < 3000; ++i) {
    const Point next = nearest(p, y);
    y = nearest(q, next);
    if ((next - x).norm() < 1e-13) break;
    x = next;
  }
  return (nearest(p, y) - y).norm();
}

TEST(IsNearerThan, AgreesWithAlternatingProjections) {
  std::size_t apart = 0;
  for (std::uint64_t seed = 1; seed <= 1500; ++seed) {
    std::mt19937_64 random(seed);
    const ConvexPolygon p = random_polygon(random, 5), q = random_polygon(random, 5);
    const double distance = projected_distance(p, q);
    if (distance < 0.02) continue;  // projections converge too slowly to tell
    ++apart;
    ASSERT_TRUE(is_nearer_than(p, q, distance + 1e-3)) << "seed " << seed;
    ASSERT_FALSE(is_nearer_than(p, q, distance - 1e-2)) << "seed " << seed;
  }
  EXPECT_GT(apart, 300u);
}

// Second opinion: the polygon cut to the closed box, in rational numbers. The mean of what is left
// is inside iff any of it is.
bool enters_by_cutting(const ConvexPolygon& polygon, const Box& box) {
  std::vector<ExactVector> left;
  for (const Point& corner : polygon) left.push_back(exact(corner));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const bool low : {true, false}) {
      const Rational limit((low ? box.min() : box.max())[static_cast<Eigen::Index>(axis)]);
      const auto height = [&](const ExactVector& x) -> Rational {
        return low ? x[axis] - limit : limit - x[axis];
      };
      std::vector<ExactVector> kept;
      for (std::size_t i = 0; i < left.size(); ++i) {
        const ExactVector &a = left[i], &b = left[(i + 1) % left.size()];
        const Rational s = height(a), t = height(b);
        if (s >= 0) kept.push_back(a);
        if ((s > 0 && t < 0) || (s < 0 && t > 0)) {
          const Rational share = s / (s - t);
          ExactVector x;
          for (std::size_t k = 0; k < 3; ++k) x[k] = a[k] + share * (b[k] - a[k]);
          kept.push_back(x);
        }
      }
      left = std::move(kept);
    }
  }
  if (left.empty()) return false;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Rational sum = 0;
    for (const ExactVector& x : left) sum += x[axis];
    const Rational mean = sum / static_cast<int>(left.size());
    const auto k = static_cast<Eigen::Index>(axis);
    if (mean <= Rational(box.min()[k]) || mean >= Rational(box.max()[k])) return false;
  }
  return true;
}

// Small whole numbers: corners, edges and planes meet all the time.
TEST(EntersBox, AgreesWithCutting) {
  std::mt19937_64 random(5);
  std::uniform_int_distribution<int> number(-4, 4), side(1, 4);
  int inside = 0, outside = 0, grazing = 0;
  for (int i = 0; i < 20000; ++i) {
    ConvexPolygon triangle;
    for (int k = 0; k < 3; ++k)
      triangle.push_back(Point(number(random), number(random), number(random)));
    if (i % 3 == 0) {  // a parallelogram
      triangle.push_back(triangle[0] + triangle[2] - triangle[1]);
    }
    if (!is_strictly_convex(triangle)) continue;
    const Point least(number(random), number(random), number(random));
    const Box box(least, least + Point(side(random), side(random), side(random)));
    const bool truth = enters_by_cutting(triangle, box);
    ASSERT_EQ(enters_box(triangle, box), truth) << "number " << i;
    (truth ? inside : outside)++;
    // A unit to either side: whatever touches from outside enters the grown box.
    const Box grown(box.min() - Point::Constant(0x1p-10), box.max() + Point::Constant(0x1p-10));
    grazing += !truth && enters_box(triangle, grown);
    EXPECT_EQ(enters_box(triangle, grown), enters_by_cutting(triangle, grown));
  }
  EXPECT_GT(inside, 2000);
  EXPECT_GT(outside, 2000);
  EXPECT_GT(grazing, 200);
}

}  // namespace
}  // namespace viewcover
