// Changes that keep a verdict, or may change it one way only.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "support/random_queries.h"
#include "support/witness_check.h"

namespace viewcover {
namespace {

using testing::ExactPoint;
using testing::flipped;
using testing::kQueryFamilies;
using testing::kQueryFamilyNames;
using testing::Polygons;
using testing::QueryFamily;
using testing::RandomQuery;

constexpr std::uint64_t kSeed = 417;
constexpr std::uint64_t kShards = 8;

/// In ascending order.
enum class Sight { kNotFacing, kHidden, kPartly, kFully };

void PrintTo(Sight sight, std::ostream* out) {
  constexpr std::array kNames = {"not facing", "hidden", "partly visible", "fully visible"};
  *out << kNames[static_cast<std::size_t>(sight)];
}

Sight sight_of(Verdict verdict) {
  if (verdict == Verdict::kHiddenNotFacing) return Sight::kNotFacing;
  if (!is_visible(verdict)) return Sight::kHidden;
  return verdict == Verdict::kFullyVisible ? Sight::kFully : Sight::kPartly;
}

/// Whatever is decided is also checked: visible iff a sight line is named.
Sight sight(const SightQuery& query) {
  const SightAnswer answer = decide_from_region(query);
  EXPECT_EQ(answer.witness.has_value(), is_visible(answer.verdict)) << testing::text(query);
  if (answer.witness) {
    EXPECT_TRUE(testing::is_sight_line(query, *answer.witness)) << testing::text(query);
  }
  return sight_of(answer.verdict);
}

bool is_visible(Sight sight) { return sight >= Sight::kPartly; }

// ------------------------------------------------------------------ changes that keep the verdict

template <class Map>
void map_points(SightQuery& query, const Map& map) {
  const auto map_all = [&](ConvexPolygon& polygon) {
    for (Point& p : polygon) p = map(p);
  };
  map_all(query.region);
  map_all(query.element);
  for (ConvexPolygon& occluder : query.occluders) map_all(occluder);
  query.viewpoint = map(query.viewpoint);
}

/// Swaps the element's sides: a map that mirrors has swapped them too.
void turn_back(SightQuery& query) { query.element = flipped(query.element); }

void permute_axes(SightQuery& query, RandomNumbers& random) {
  const int first = static_cast<int>(random.below(3)), turn = random.below(2) == 0 ? 1 : 2;
  const bool odd = random.below(2) == 0;
  std::array<int, 3> axes = {first, (first + turn) % 3, (first + 2 * turn) % 3};
  if (odd) std::swap(axes[0], axes[1]);
  map_points(query, [&](const Point& p) { return Point(p[axes[0]], p[axes[1]], p[axes[2]]); });
  if (odd != (turn == 2)) turn_back(query);
}

void mirror(SightQuery& query, RandomNumbers& random) {
  const auto axis = static_cast<Eigen::Index>(random.below(3));
  map_points(query, [&](Point p) {
    p[axis] = -p[axis];
    return p;
  });
  turn_back(query);
}

void scale(SightQuery& query, RandomNumbers& random) {
  const int exponent = static_cast<int>(random.below(601)) - 300;
  map_points(query, [&](const Point& p) { return Point(std::ldexp(1.0, exponent) * p); });
}

void stretch(SightQuery& query, RandomNumbers& random) {
  Point factors;
  for (double& f : factors) f = std::ldexp(1.0, static_cast<int>(random.below(25)) - 12);
  map_points(query, [&](const Point& p) { return Point(p.cwiseProduct(factors)); });
}

void shear(SightQuery& query, RandomNumbers& random) {
  const auto to = static_cast<Eigen::Index>(random.below(3));
  const Eigen::Index from = (to + 1) % 3, other = (to + 2) % 3;
  const double a = static_cast<double>(random.below(7)) - 3;
  const double b = static_cast<double>(random.below(7)) - 3;
  map_points(query, [&](Point p) {
    p[to] += a * p[from] + b * p[other];
    return p;
  });
}

void translate(SightQuery& query, RandomNumbers& random) {
  const int exponent = random.below(2) == 0 ? 0 : 20;  // sums stay exact: 22 + 20 + 6 bits
  Point step;
  for (double& s : step) {
    s = std::ldexp(static_cast<double>(random.below(63)) - 31, exponent);
  }
  map_points(query, [&](const Point& p) { return Point(p + step); });
}

void swap_ends(SightQuery& query, RandomNumbers&) { std::swap(query.region, query.element); }

void shuffle_occluders(SightQuery& query, RandomNumbers& random) {
  for (std::size_t i = query.occluders.size(); i > 1; --i) {
    std::swap(query.occluders[i - 1], query.occluders[random.below(i)]);
  }
}

/// Replaces an occluder, if there is any, by what `pieces` makes of it.
template <class Pieces>
void replace_one(SightQuery& query, RandomNumbers& random, const Pieces& pieces) {
  if (query.occluders.empty()) return;
  const std::size_t which = random.below(query.occluders.size());
  const ConvexPolygon whole = query.occluders[which];
  query.occluders.erase(query.occluders.begin() + static_cast<std::ptrdiff_t>(which));
  for (const ConvexPolygon& piece : pieces(whole)) query.occluders.push_back(piece);
}

Polygons in_two(const ConvexPolygon& whole, RandomNumbers& random) {
  const std::size_t n = whole.size();
  ConvexPolygon corners = whole;
  std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(random.below(n)),
              corners.end());
  if (n == 3) {
    const Point middle = (corners[0] + corners[1]) / 2;
    return {{corners[0], middle, corners[2]}, {middle, corners[1], corners[2]}};
  }
  return {{corners[0], corners[1], corners[2]}, [&] {
            ConvexPolygon rest(corners.begin() + 2, corners.end());
            rest.push_back(corners[0]);
            return rest;
          }()};
}

void split_one(SightQuery& query, RandomNumbers& random) {
  replace_one(query, random, [&](const ConvexPolygon& whole) { return in_two(whole, random); });
}

void quarter_one(SightQuery& query, RandomNumbers& random) {
  replace_one(query, random, [](const ConvexPolygon& whole) { return quarters(whole); });
}

void triangulate(SightQuery& query, RandomNumbers& random) {
  Polygons triangles;
  for (const ConvexPolygon& occluder : query.occluders) {
    const std::size_t n = occluder.size(), hub = random.below(n);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      triangles.push_back({occluder[hub], occluder[(hub + i) % n], occluder[(hub + i + 1) % n]});
    }
  }
  query.occluders = std::move(triangles);
}

void duplicate(SightQuery& query, RandomNumbers& random) {
  replace_one(query, random, [](const ConvexPolygon& whole) {
    return Polygons{whole, flipped(whole)};
  });
}

void turn_corners(SightQuery& query, RandomNumbers& random) {
  const auto turn = [&](ConvexPolygon& polygon, bool keep_front) {
    const auto by = static_cast<std::ptrdiff_t>(random.below(polygon.size()));
    std::rotate(polygon.begin(), polygon.begin() + by, polygon.end());
    if (!keep_front && random.below(2) == 0) std::reverse(polygon.begin(), polygon.end());
  };
  turn(query.region, false);
  turn(query.element, query.one_sided);
  for (ConvexPolygon& occluder : query.occluders) turn(occluder, false);
}

void add_corners_within_edges(SightQuery& query, RandomNumbers& random) {
  const auto add = [&](ConvexPolygon& polygon) {
    const std::size_t k = random.below(polygon.size());
    const Point middle = (polygon[k] + polygon[(k + 1) % polygon.size()]) / 2;
    polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(k + 1), middle);
  };
  add(query.region);
  add(query.element);
  for (ConvexPolygon& occluder : query.occluders) add(occluder);
}

/// Occluders that block nothing: in the plane of region or element.
void add_coplanar(SightQuery& query, RandomNumbers& random) {
  for (const ConvexPolygon* end : {&query.region, &query.element}) {
    ConvexPolygon copy = *end;
    const Point step = random.below(2) == 0 ? Point((copy[1] - copy[0]) / 2) : Point::Zero();
    for (Point& corner : copy) corner = 2 * corner - (*end)[0] + step;
    query.occluders.push_back(copy);
  }
}

struct Change {
  const char* name;
  void (*apply)(SightQuery&, RandomNumbers&);
  bool keeps_one_sided = true;
};

constexpr std::array kChanges = {
    Change{"axes permuted", permute_axes},
    Change{"mirrored", mirror},
    Change{"scaled by a power of two", scale},
    Change{"axes scaled by powers of two", stretch},
    Change{"sheared", shear},
    Change{"translated", translate},
    Change{"region and element swapped", swap_ends, false},
    Change{"occluders shuffled", shuffle_occluders},
    Change{"an occluder split by a diagonal", split_one},
    Change{"an occluder quartered", quarter_one},
    Change{"occluders triangulated", triangulate},
    Change{"an occluder duplicated", duplicate},
    Change{"corners in other order", turn_corners},
    Change{"corners added within edges", add_corners_within_edges},
    Change{"coplanar occluders added", add_coplanar},
};

// ------------------------------------------------------------------------------------ queries

/// How many queries of each family were hidden and visible.
class Tally {
 public:
  void add(QueryFamily family, bool visible) {
    ++counts_[static_cast<std::size_t>(family)][visible ? 1 : 0];
  }
  void expect_both_verdicts() const {
    for (std::size_t f = 0; f < kQueryFamilies; ++f) {
      std::cout << "  " << kQueryFamilyNames[f] << ": " << counts_[f][0] << " hidden, "
                << counts_[f][1] << " visible\n";
      const int all = counts_[f][0] + counts_[f][1];
      EXPECT_GE(counts_[f][0] * 12, all) << kQueryFamilyNames[f];
      EXPECT_GE(counts_[f][1] * 12, all) << kQueryFamilyNames[f];
    }
  }

 private:
  std::array<std::array<int, 2>, kQueryFamilies> counts_{};
};

bool is_well_formed(const SightQuery& query) {
  const auto is_convex = [](const ConvexPolygon& polygon) {
    return is_planar(polygon) && is_strictly_convex(polygon);
  };
  return is_convex(query.region) && is_convex(query.element) &&
         std::ranges::all_of(query.occluders, is_convex);
}

class Metamorphic : public ::testing::TestWithParam<std::uint64_t> {
 protected:
  /// Calls check(query) for `count` random queries, until something fails.
  template <class Check>
  void for_queries(std::uint64_t count, const Check& check) const {
    std::cout << "seed " << kSeed << ", shard " << GetParam() << ", " << count << " queries\n";
    for (std::uint64_t i = 0; i < count && !HasFailure(); ++i) {
      const std::uint64_t index = GetParam() * count + i;
      RandomQuery made(kSeed, index);
      SCOPED_TRACE("seed " + std::to_string(kSeed) + ", index " + std::to_string(index) + ", " +
                   kQueryFamilyNames[static_cast<std::size_t>(made.family())] + "\n" +
                   testing::text(made.query()));
      ASSERT_TRUE(is_well_formed(made.query()));
      check(made);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(Shards, Metamorphic, ::testing::Range<std::uint64_t>(0, kShards));

TEST_P(Metamorphic, VerdictsSurviveChangesThatMeanNothing) {
  Tally tally;
  int fully = 0;
  for_queries(400, [&](RandomQuery& made) {
    const Sight expected = sight(made.query());
    tally.add(made.family(), is_visible(expected));
    fully += expected == Sight::kFully;
    SightQuery all_changes = made.query();
    for (const Change& change : kChanges) {
      if (made.query().one_sided && !change.keeps_one_sided) continue;
      SightQuery changed = made.query();
      change.apply(changed, made.random());
      EXPECT_EQ(sight(changed), expected) << change.name << "\n" << testing::text(changed);
      // Magnitudes far apart cost many bits when combined.
      if (change.apply != scale && change.apply != stretch) {
        change.apply(all_changes, made.random());
      }
    }
    EXPECT_EQ(sight(all_changes), expected) << "all changes\n" << testing::text(all_changes);
  });
  if (HasFailure()) return;
  tally.expect_both_verdicts();
  EXPECT_GE(fully, 5);
}

TEST_P(Metamorphic, MoreOccludersNeverReveal) {
  Tally tally;
  int lowered = 0;
  for_queries(700, [&](RandomQuery& made) {
    SightQuery query = made.query();
    Sight before = sight(query);
    tally.add(made.family(), is_visible(before));
    for (int i = 0; i < 3 && before >= Sight::kPartly; ++i) {
      query.occluders.push_back(made.further_occluder());
      const Sight after = sight(query);
      EXPECT_LE(after, before) << "with one more\n" << testing::text(query);
      EXPECT_NE(after, Sight::kNotFacing);
      lowered += after < before;
      before = after;
    }
  });
  if (HasFailure()) return;
  tally.expect_both_verdicts();
  EXPECT_GE(lowered, 20);
}

/// What some quarter of the region, or of the element, sees, the whole sees, and the other way
/// round: the quarters tile it.
TEST_P(Metamorphic, AWholeSeesWhatItsQuartersSee) {
  Tally tally;
  int some_but_not_all = 0;
  for_queries(400, [&](RandomQuery& made) {
    const Sight whole = sight(made.query());
    tally.add(made.family(), is_visible(whole));
    for (const bool of_region : {true, false}) {
      SightQuery query = made.query();
      ConvexPolygon& end = of_region ? query.region : query.element;
      int seeing = 0;
      for (const ConvexPolygon& quarter : quarters(end)) {
        end = quarter;
        const Sight part = sight(query);
        seeing += is_visible(part);
        if (whole == Sight::kFully && !query.one_sided) {
          EXPECT_EQ(part, Sight::kFully) << testing::text(query);
        }
        if (!is_visible(whole)) {
          EXPECT_FALSE(is_visible(part)) << testing::text(query);
        }
      }
      EXPECT_EQ(seeing > 0, is_visible(whole)) << (of_region ? "region" : "element");
      some_but_not_all += seeing > 0 && seeing < 4;
    }
  });
  if (HasFailure()) return;
  tally.expect_both_verdicts();
  EXPECT_GE(some_but_not_all, 50);
}

// -------------------------------------------------------------------------------- viewpoints

/// A point inside the polygon, of few more bits.
Point inner_point(const ConvexPolygon& polygon, RandomNumbers& random) {
  Point sum = Point::Zero();
  std::size_t left = 256;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t others = polygon.size() - 1 - i;
    const std::size_t weight = others == 0 ? left : 1 + random.below(left - 8 * others);
    sum += static_cast<double>(weight) * polygon[i];
    left -= weight;
  }
  return sum / 256;
}

bool is_coplanar(const ConvexPolygon& a, const ConvexPolygon& b) {
  return std::ranges::all_of(
      a, [&](const Point& corner) { return testing::exact_side(b, ExactPoint(corner)) == 0; });
}

/// On one of the occluders that count for the region: what passes by it on both sides may be seen
/// from this point alone.
bool is_on_an_occluder(const SightQuery& query) {
  const ExactPoint p(query.viewpoint);
  return std::ranges::any_of(query.occluders, [&](const ConvexPolygon& occluder) {
    if (testing::exact_side(occluder, p) != 0 || is_coplanar(occluder, query.region)) return false;
    const ExactPoint normal = testing::exact_area_vector(occluder);
    for (std::size_t k = 0; k < occluder.size(); ++k) {
      const ExactPoint a(occluder[k]), b(occluder[(k + 1) % occluder.size()]);
      if (testing::dot(normal, testing::cross(b - a, p - a)) < 0) return false;
    }
    return true;
  });
}

TEST_P(Metamorphic, ARegionSeesWhatOneOfItsPointsSees) {
  Tally tally;
  int seen_by_region_only = 0;
  for_queries(1500, [&](RandomQuery& made) {
    SightQuery query = made.query();
    query.viewpoint = inner_point(query.region, made.random());
    if (is_on_an_occluder(query)) return;
    const PointAnswer answer = decide_from_point(query);
    const bool seen = is_visible(answer.verdict);
    tally.add(made.family(), seen);
    EXPECT_EQ(seen, answer.visible_fraction > 0);
    const bool by_region = is_visible(decide_from_region(query).verdict);
    EXPECT_LE(seen, by_region) << "viewpoint " << query.viewpoint.transpose();
    seen_by_region_only += by_region && !seen;
  });
  if (HasFailure()) return;
  tally.expect_both_verdicts();
  EXPECT_GE(seen_by_region_only, 30);
}

TEST_P(Metamorphic, MoreOccludersLeaveNoMoreToAViewpoint) {
  int lowered = 0;
  for_queries(700, [&](RandomQuery& made) {
    SightQuery query = made.query();
    query.viewpoint = inner_point(query.region, made.random());
    double before = 1;
    Polygons occluders;
    std::swap(occluders, query.occluders);
    for (const ConvexPolygon& occluder : occluders) {
      query.occluders.push_back(occluder);
      const double after = decide_from_point(query).visible_fraction;
      EXPECT_GE(after, 0);
      EXPECT_LE(after, before) << testing::text(query) << "\nviewpoint "
                               << query.viewpoint.transpose();
      lowered += 0 < after && after < before;
      before = after;
    }
  });
  if (HasFailure()) return;
  EXPECT_GE(lowered, 50);
}

TEST_P(Metamorphic, QuartersOfAnElementShareWhatAViewpointSees) {
  int partly = 0;
  for_queries(700, [&](RandomQuery& made) {
    SightQuery query = made.query();
    query.viewpoint = inner_point(query.region, made.random());
    const double whole = decide_from_point(query).visible_fraction;
    const double whole_area = area(query.element);
    double sum = 0;
    for (const ConvexPolygon& quarter : quarters(made.query().element)) {
      query.element = quarter;
      sum += decide_from_point(query).visible_fraction * (area(quarter) / whole_area);
    }
    EXPECT_NEAR(sum, whole, 1e-14);
    partly += 0 < whole && whole < 1;
  });
  if (HasFailure()) return;
  EXPECT_GE(partly, 50);
}

// ----------------------------------------------------------------------------- random segments

/// Does the segment pq meet the polygon? In doubles; few random segments come near enough an edge.
bool meets(const Point& p, const Point& q, const ConvexPolygon& polygon) {
  const auto side = [](const Point& a, const Point& b, const Point& c, const Point& d) {
    return (b - a).cross(c - a).dot(d - a);
  };
  if (side(polygon[0], polygon[1], polygon[2], p) * side(polygon[0], polygon[1], polygon[2], q) >=
      0) {
    return false;
  }
  bool positive = false, negative = false;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const double s = side(p, q, polygon[k], polygon[(k + 1) % polygon.size()]);
    positive |= s > 0;
    negative |= s < 0;
  }
  return !(positive && negative);
}

/// Uniform on the polygon.
Point random_point(const ConvexPolygon& polygon, RandomNumbers& random) {
  const auto doubled_area = [&](std::size_t i) {
    return (polygon[i] - polygon[0]).cross(polygon[i + 1] - polygon[0]).norm();
  };
  double total = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) total += doubled_area(i);
  double at = random.unit() * total;
  std::size_t i = 1;
  for (; i + 2 < polygon.size() && at >= doubled_area(i); ++i) at -= doubled_area(i);
  double u = random.open_unit(), v = random.open_unit();
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  return polygon[0] + u * (polygon[i] - polygon[0]) + v * (polygon[i + 1] - polygon[0]);
}

TEST_P(Metamorphic, VisibleFractionsAreThoseOfRandomSegments) {
  constexpr int kSegments = 4000;
  int partly = 0;
  for_queries(300, [&](RandomQuery& made) {
    SightQuery query = made.query();
    query.viewpoint = inner_point(query.region, made.random());
    const PointAnswer answer = decide_from_point(query);
    if (answer.verdict == Verdict::kHiddenNotFacing) return;
    // Those seen edge-on, or in the element's plane, block nothing.
    std::erase_if(query.occluders, [&](const ConvexPolygon& occluder) {
      return testing::exact_side(occluder, ExactPoint(query.viewpoint)) == 0 ||
             is_coplanar(occluder, query.element);
    });
    int free = 0;
    for (int i = 0; i < kSegments; ++i) {
      const Point q = random_point(query.element, made.random());
      free += std::ranges::none_of(query.occluders, [&](const ConvexPolygon& occluder) {
        return meets(query.viewpoint, q, occluder);
      });
    }
    const double share = answer.visible_fraction;
    const double deviation = std::sqrt(share * (1 - share) / kSegments);
    // Rare events are not normal: a few more are allowed, unless there are none.
    const double few = 0 < share && share < 1 ? 6.0 / kSegments : 0;
    EXPECT_NEAR(free / double(kSegments), share, 4.5 * deviation + few)
        << "viewpoint " << query.viewpoint.transpose();
    partly += 0 < share && share < 1;
  });
  if (HasFailure()) return;
  EXPECT_GE(partly, 50);
}

}  // namespace
}  // namespace viewcover
