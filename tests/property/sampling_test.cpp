// Random soups between two parallel triangles: no ray may be free where the kernel says hidden, and
// every sight line that it names must be one.
//
// VIEWCOVER_TEST_RAYS: rays a soup, 10^6 if not set.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "support/random_queries.h"
#include "support/witness_check.h"

namespace viewcover {
namespace {

using testing::text;

constexpr std::uint64_t kSeed = 2310;
constexpr std::uint64_t kShards = 10, kSoupsPerShard = 50;
constexpr std::uint64_t kDefaultRays = 1'000'000;
constexpr double kLow = 0, kHigh = 1;  // heights of region and element

std::uint64_t rays_per_soup() {
  const char* value = std::getenv("VIEWCOVER_TEST_RAYS");
  return value != nullptr ? std::stoull(value) : kDefaultRays;
}

/// A segment from height 0 to height 1, as a line: direction and moment.
struct Ray {
  Point direction, moment;
  Ray(const Point& p, const Point& q) : direction(q - p), moment(p.cross(q)) {}
};

/// A triangle strictly between the heights of all rays' ends: a ray meets it iff its line does.
class RayTriangle {
 public:
  explicit RayTriangle(const ConvexPolygon& triangle) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point &a = triangle[k], &b = triangle[(k + 1) % 3];
      const Point direction = b - a, moment = a.cross(b);
      edges_[k] = {moment.x(), moment.y(), moment.z(), direction.x(), direction.y(), direction.z()};
    }
    const Point u = triangle[1] - triangle[0], v = triangle[2] - triangle[0];
    shadow_ = std::abs(u.x() * v.y() - u.y() * v.x());
  }

  /// True only if the ray misses the triangle, and so do those whose ends are off by 2^-50: its
  /// line passes two edges on different sides.
  bool is_missed_by(const Ray& ray) const {
    double least = INFINITY, most = -INFINITY;
    for (const auto& e : edges_) {
      const double side = ray.direction.x() * e[0] + ray.direction.y() * e[1] +
                          ray.direction.z() * e[2] + ray.moment.x() * e[3] + ray.moment.y() * e[4] +
                          ray.moment.z() * e[5];
      least = std::min(least, side);
      most = std::max(most, side);
    }
    return least < -kMargin && most > kMargin;
  }

  double shadow() const { return shadow_; }  ///< area seen from above, doubled

 private:
  // All coordinates are below 1.2, so the six products below 4, their factors off by 8 units of
  // roundoff 2^-53 at most; ends that are off by 2^-50 move them by 2^-46. All in all below 2^-42.
  static constexpr double kMargin = 0x1p-40;

  std::array<std::array<double, 6>, 3> edges_;
  double shadow_ = 0;
};

/// Finds blockers of rays, likely ones first.
class RayBlockers {
 public:
  explicit RayBlockers(std::span<const ConvexPolygon> occluders)
      : triangles_(occluders.begin(), occluders.end()) {
    std::ranges::sort(triangles_, std::ranges::greater{}, &RayTriangle::shadow);
  }

  bool block(const Ray& ray) {
    const auto hit = std::ranges::find_if(
        triangles_, [&](const RayTriangle& triangle) { return !triangle.is_missed_by(ray); });
    return hit != triangles_.end();
  }

  /// Puts first what blocks most of the rays, then what blocks most of the others, and so on.
  void learn(std::span<const Ray> rays) {
    std::vector<bool> open(rays.size(), true);
    for (auto next = triangles_.begin(); next != triangles_.end(); ++next) {
      const auto blocked = [&](const RayTriangle& triangle) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
          count += open[i] && !triangle.is_missed_by(rays[i]);
        }
        return count;
      };
      std::size_t most = 0;
      auto best = next;
      for (auto t = next; t != triangles_.end(); ++t) {
        if (const std::size_t count = blocked(*t); count > most) {
          most = count;
          best = t;
        }
      }
      if (most == 0) return;
      std::iter_swap(next, best);
      for (std::size_t i = 0; i < rays.size(); ++i) {
        open[i] = open[i] && next->is_missed_by(rays[i]);
      }
    }
  }

 private:
  std::vector<RayTriangle> triangles_;
};

/// Rays from region to element: half of them anywhere, the others where sight is likely to be left.
class RayMaker {
 public:
  RayMaker(const SightQuery& soup, RandomNumbers& random) : soup_(soup), random_(random) {}

  Ray anywhere() { return {inner_point(soup_.region), inner_point(soup_.element)}; }

  /// Passes close by two edges of occluders, or one and a corner of the region or the element. None
  /// if such a line does not join region and element.
  std::optional<Ray> grazing() {
    const Point a = beside_an_edge();
    const std::size_t kind = random_.below(4);
    const Point b = kind == 0   ? near_a_corner(soup_.region)
                    : kind == 1 ? near_a_corner(soup_.element)
                                : beside_an_edge();
    if (std::abs(a.z() - b.z()) < 0.01) return std::nullopt;
    const auto at = [&](double z) {
      Point p = a + (b - a) * ((z - a.z()) / (b.z() - a.z()));
      p.z() = z;
      return p;
    };
    const Point p = at(kLow), q = at(kHigh);
    if (!is_inner(soup_.region, p) || !is_inner(soup_.element, q)) return std::nullopt;
    return Ray(p, q);
  }

 private:
  /// Uniform; off by rounding.
  Point inner_point(const ConvexPolygon& triangle) {
    double u = random_.open_unit(), v = random_.open_unit();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    return triangle[0] + u * (triangle[1] - triangle[0]) + v * (triangle[2] - triangle[0]);
  }

  /// 2^-2 to 2^-33.
  double small() {
    return std::ldexp(1 + random_.unit(), -static_cast<int>(3 + random_.below(31)));
  }

  /// A point just outside an edge of an occluder.
  Point beside_an_edge() {
    const ConvexPolygon& triangle = soup_.occluders[random_.below(soup_.occluders.size())];
    const std::size_t k = random_.below(3);
    const Point &a = triangle[k], &b = triangle[(k + 1) % 3], &c = triangle[(k + 2) % 3];
    const Point on_edge = a + random_.unit() * (b - a);
    return on_edge + small() * (0.5 * (a + b) - c);
  }

  Point near_a_corner(const ConvexPolygon& triangle) {
    const std::size_t k = random_.below(3);
    const double u = small() / 2, v = small() / 2;
    return triangle[k] + u * (triangle[(k + 1) % 3] - triangle[k]) +
           v * (triangle[(k + 2) % 3] - triangle[k]);
  }

  /// By more than rounding; level triangles that run counter-clockwise.
  static bool is_inner(const ConvexPolygon& triangle, const Point& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point edge = triangle[(k + 1) % 3] - triangle[k], to = p - triangle[k];
      if (edge.x() * to.y() - edge.y() * to.x() < 1e-12) return false;
    }
    return true;
  }

  const SightQuery& soup_;
  RandomNumbers& random_;
};

/// How many rays are blocked before the first free one, if there is one.
std::optional<std::uint64_t> first_free_ray(const SightQuery& soup, std::uint64_t count,
                                            RandomNumbers& random) {
  RayMaker rays(soup, random);
  RayBlockers blockers(soup.occluders);
  std::vector<Ray> sample;
  for (int i = 0; i < 512; ++i) sample.push_back(rays.anywhere());
  blockers.learn(sample);
  for (std::uint64_t i = 0; i < count; ++i) {
    std::optional<Ray> ray;
    if (i % 2 == 1) ray = rays.grazing();
    if (!ray) ray = rays.anywhere();
    if (!blockers.block(*ray)) return i;
  }
  return std::nullopt;
}

class RandomSoups : public ::testing::TestWithParam<std::uint64_t> {};

INSTANTIATE_TEST_SUITE_P(Shards, RandomSoups, ::testing::Range<std::uint64_t>(0, kShards));

TEST_P(RandomSoups, NoRayIsFreeWhereHiddenAndWitnessesAreSightLines) {
  const std::uint64_t rays = rays_per_soup();
  int hidden = 0, visible = 0, found = 0;
  std::uint64_t most_before = 0;
  for (std::uint64_t i = 0; i < kSoupsPerShard; ++i) {
    const std::uint64_t index = GetParam() * kSoupsPerShard + i;
    RandomNumbers random(mixed(kSeed + mixed(index)));
    const SightQuery soup = testing::random_soup(random, {});
    const SightAnswer answer = decide_from_region(soup);
    SCOPED_TRACE("index " + std::to_string(index));
    const auto free_ray = first_free_ray(soup, rays, random);
    if (!is_visible(answer.verdict)) {
      ++hidden;
      EXPECT_FALSE(free_ray) << "a ray is free\n" << text(soup);
      continue;
    }
    ++visible;
    ASSERT_TRUE(answer.witness) << text(soup);
    EXPECT_TRUE(testing::is_sight_line(soup, *answer.witness)) << text(soup);
    if (free_ray) {
      ++found;
      most_before = std::max(most_before, *free_ray);
    }
  }
  std::cout << "seed " << kSeed << ", shard " << GetParam() << ", " << rays << " rays: " << hidden
            << " hidden, " << visible << " visible, rays found " << found << " of these, after "
            << most_before << " blocked rays at most\n";
  EXPECT_GE(hidden, 5);
  EXPECT_GE(visible, 5);
  // The rays are no blind judges.
  EXPECT_GE(found * 10, visible * 7);
}

/// The soups above are hidden many times over; here every occluder is needed.
TEST_P(RandomSoups, NoRayIsFreeWhereTheLastGapWasClosed) {
  const std::uint64_t rays = rays_per_soup();
  int tried = 0, gaps_found = 0;
  std::size_t left = 0;
  for (std::uint64_t i = 0; i < kSoupsPerShard && tried < 6; ++i) {
    const std::uint64_t index = GetParam() * kSoupsPerShard + i;
    RandomNumbers random(mixed(kSeed + mixed(index)));
    SightQuery soup = testing::random_soup(random, {});
    const auto is_hidden = [&] { return !is_visible(decide_from_region(soup).verdict); };
    if (!is_hidden()) continue;
    ++tried;
    ConvexPolygon last;  // the one that closed the gap
    for (std::size_t k = soup.occluders.size(); k-- > 0;) {
      const ConvexPolygon dropped = soup.occluders[k];
      soup.occluders.erase(soup.occluders.begin() + static_cast<std::ptrdiff_t>(k));
      if (is_hidden()) continue;
      soup.occluders.push_back(dropped);
      last = dropped;
    }
    left += soup.occluders.size();
    EXPECT_FALSE(first_free_ray(soup, rays, random)) << "index " << index << "\n" << text(soup);
    std::erase(soup.occluders, last);
    gaps_found += first_free_ray(soup, rays, random).has_value();
  }
  std::cout << "seed " << kSeed << ", shard " << GetParam() << ", " << rays << " rays: " << tried
            << " minimal soups of " << left << " triangles in all; with one less, rays found "
            << gaps_found << " gaps\n";
  EXPECT_EQ(tried, 6);
  EXPECT_GT(gaps_found, 0);
}

}  // namespace
}  // namespace viewcover
