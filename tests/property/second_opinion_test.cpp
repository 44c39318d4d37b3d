#include "support/second_opinion.h"

#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "exact/sight_query.h"
#include "scene/random_numbers.h"
#include "support/scenes.h"

namespace viewcover::testing {
namespace {

/// Shafts on a small integer grid: contacts, common edges and exact umbra borders abound.
enum Family {
  kLoose,     ///< triangles between a low R and a high E
  kAnywhere,  ///< everything anywhere, planes cutting R, E and occluders
  kSlab,      ///< a closed slab of abutting pieces; at times a corner is one unit off
  kUmbra,     ///< E at the border of the umbra of a wall in pieces, or one unit to a side
  kPlug,      ///< a wall with a hole, and a plate that plugs it exactly or one unit short
  kSlats,     ///< two or three layers of strips with overlaps of one unit, none, or slits
  kCorner,    ///< R and E meet in an edge, a plate through that edge
  kCrossed,   ///< R's plane cuts E or the other way round, the pieces behind plates
  kShingles,  ///< triangles round an axis that overlap like blades, tilted: borders are conics
  kFamilyCount
};
constexpr std::array<const char*, kFamilyCount> kFamilyNames = {
    "loose", "anywhere", "slab", "umbra", "plug", "slats", "corner", "crossed", "shingles"};

struct Made {
  SightQuery query;
  Family family;
};

class ShaftMaker {
 public:
  ShaftMaker(std::uint64_t seed, std::uint64_t index)
      : random_(mixed(seed + mixed(index))), family_(static_cast<Family>(index % kFamilyCount)) {}

  Made make() {
    switch (family_) {
      case kLoose:
        loose();
        break;
      case kAnywhere:
        anywhere();
        break;
      case kSlab:
        slab();
        break;
      case kUmbra:
        umbra();
        break;
      case kPlug:
        plug();
        break;
      case kSlats:
        slats();
        break;
      case kCorner:
        corner();
        break;
      case kCrossed:
        crossed();
        break;
      default:
        shingles();
        break;
    }
    add_bystander();
    disguise();
    return {query_, family_};
  }

 private:
  int between(int low, int high) {  // both included
    return low + static_cast<int>(random_.below(static_cast<std::size_t>(high - low + 1)));
  }
  bool one_in(int n) { return between(1, n) == 1; }
  /// Mostly 0, else a unit up or down.
  int graze() { return one_in(2) ? 0 : between(-1, 1); }

  Point point(int low, int high, int low_z, int high_z) {
    const int x = between(low, high), y = between(low, high), z = between(low_z, high_z);
    return Point(x, y, z);
  }

  /// A convex polygon with 3 to 5 corners in the frame of three random points.
  ConvexPolygon polygon(int low, int high, int low_z, int high_z, bool only_triangle = false) {
    static const std::vector<std::vector<std::pair<int, int>>> kShapes = {
        {{0, 0}, {1, 0}, {0, 1}},
        {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
        {{0, 0}, {2, 0}, {1, 1}, {0, 1}},
        {{0, 0}, {1, 0}, {2, 1}, {1, 2}, {0, 1}}};
    while (true) {
      const Point a = point(low, high, low_z, high_z);
      const Point u = point(low, high, low_z, high_z) - a, v = point(low, high, low_z, high_z) - a;
      if (u.cross(v).isZero()) continue;
      const auto& shape = kShapes[only_triangle ? 0 : random_.below(kShapes.size())];
      ConvexPolygon result;
      for (const auto& [s, t] : shape) result.push_back(a + s * u + t * v);
      return result;
    }
  }

  void occlude(const ConvexPolygon& polygon) {
    if ((polygon[1] - polygon[0]).cross(polygon[2] - polygon[0]).isZero()) return;
    query_.occluders.push_back(polygon);
  }

  void loose() {
    query_.region = polygon(2, 8, 0, 2);
    query_.element = polygon(2, 8, 14, 16);
    const int count = between(2, 6);
    for (int i = 0; i < count; ++i) occlude(polygon(-14, 22, 4, 12, !one_in(4)));
  }

  void anywhere() {
    query_.region = polygon(0, 4, 0, 2);
    query_.element = polygon(0, 4, 2, 4);
    const int count = between(4, 6);
    for (int i = 0; i < count; ++i) occlude(polygon(-12, 16, -1, 5, one_in(4)));
  }

  /// A wall over [x0, x1] x [y0, y1] in 2 to 6 pieces that meet in edges; heights z + slope * x.
  void wall(int x0, int y0, int x1, int y1, int z, int slope, int most, bool may_fray) {
    const auto at = [&](int x, int y) { return Point(x, y, z + slope * x); };
    std::vector<ConvexPolygon> pieces;
    const int kind = between(0, most >= 4 ? 3 : most >= 2 ? 1 : 0);
    const int x = between(x0 + 1, x1 - 1), y = between(y0 + 1, y1 - 1);
    const std::array<Point, 4> corners = {at(x0, y0), at(x1, y0), at(x1, y1), at(x0, y1)};
    if (kind == 0) {
      pieces = {{corners[0], corners[1], corners[2], corners[3]}};
    } else if (kind == 1) {
      pieces = {{corners[0], corners[1], corners[2]}, {corners[0], corners[2], corners[3]}};
    } else if (kind == 2) {
      for (std::size_t i = 0; i < 4; ++i) {
        pieces.push_back({corners[i], corners[(i + 1) % 4], at(x, y)});
      }
    } else {
      pieces = {{at(x0, y0), at(x, y0), at(x, y), at(x0, y)},
                {at(x, y0), at(x1, y0), at(x1, y), at(x, y)},
                {at(x0, y), at(x, y), at(x, y1), at(x0, y1)},
                {at(x, y), at(x1, y), at(x1, y1), at(x, y1)}};
    }
    if (may_fray && one_in(2)) {
      const std::size_t which = random_.below(pieces.size());
      ConvexPolygon& piece = pieces[which];
      if (piece.size() == 3) {
        Point& moved = piece[random_.below(3)];
        moved[between(0, 2)] += one_in(2) ? 1 : -1;
      } else {  // slide an edge, the polygon stays planar
        const std::size_t i = random_.below(4);
        const int axis = one_in(2) ? 0 : 1;
        const double step = one_in(2) ? 1 : -1;
        for (const std::size_t k : {i, (i + 1) % 4}) {
          piece[k][axis] += step;
          if (axis == 0) piece[k].z() += step * slope;
        }
      }
    }
    for (const ConvexPolygon& piece : pieces) occlude(piece);
  }

  void slab() {
    query_.region = polygon(2, 6, 0, 2);
    query_.element = polygon(2, 6, 14, 16);
    // Everything between lies over the hull of both.
    Box box;
    for (const ConvexPolygon* p : {&query_.region, &query_.element}) {
      box.extend(bounding_box(*p));
    }
    const auto low = box.min(), high = box.max();
    const int m = (high - low).head<2>().minCoeff() < 2 ? 1 : between(0, 1);
    wall(static_cast<int>(low.x()) - m, static_cast<int>(low.y()) - m,
         static_cast<int>(high.x()) + m, static_cast<int>(high.y()) + m, between(6, 9),
         one_in(3) ? between(-1, 1) : 0, 4, true);
    if (one_in(2)) occlude(polygon(0, 8, 4, 12, true));
    if (one_in(2)) occlude(polygon(0, 8, 4, 12, true));
  }

  void umbra() {
    const int r = between(2, 5), h = between(1, 4), k = between(1, 3), o = r + between(0, 3);
    const int e = o + (o - r) * k;
    query_.region = horizontal(-r, -r, r, r, 0);
    wall(-o, -o, o, o, h, 0, 4, one_in(4));
    query_.element = horizontal(-e + graze(), -e + graze(), e + graze(), e + graze(), h + h * k);
    if (one_in(3)) query_.element.pop_back();
    if (one_in(3)) query_.region.pop_back();
    if (one_in(2)) occlude(polygon(-4, 4, 1, 4, true));
  }

  void plug() {
    const int r = between(1, 3), hole = between(1, 3), h = between(2, 3), up = between(1, 2) * h;
    const int gap = one_in(3) ? h : between(1, h);
    // The beam through the hole is this wide at height h + gap, up to rounding.
    const int beam = hole + ((hole + r) * gap + h - 1) / h;
    const int far = 12, off = one_in(3) ? between(-1, 1) : 0;
    query_.region = horizontal(-r, -r, r, r, 0);
    const int e = between(1, 6);
    query_.element = horizontal(-e, -e, e, e, h + up + gap);
    occlude(horizontal(-far, -far, -hole, far, h));
    occlude(horizontal(hole + off, -far, far, far, h));
    occlude(horizontal(-hole, -far, hole + off, -hole, h));
    occlude(horizontal(-hole, hole, hole + off, far, h));
    const int x = between(-1, 1);
    if (one_in(2)) {
      const int short_by = one_in(2) ? between(0, 2) : 0;
      occlude(horizontal(-beam + graze(), -beam, beam + graze(), beam - short_by, h + gap));
    } else {
      occlude(horizontal(-beam, -beam, x + graze(), beam + graze(), h + gap));
      occlude(horizontal(x, -beam, beam, beam, h + gap));
    }
  }

  void slats() {
    query_.region = polygon(1, 7, 0, 1);
    query_.element = polygon(1, 7, 9, 10);
    const int count = between(3, 6), tilt = between(0, 1);
    int x = -6;
    for (int i = 0; i < count; ++i) {
      const int end =
          i + 1 == count ? 16 : std::min(15, std::max(x + 1, between(0, 2) + 2 * i + 1));
      const int z = between(4, 5), z2 = z + tilt * between(-1, 1);
      occlude({Point(x, -9, z), Point(end, -9, z2), Point(end, 17, z2), Point(x, 17, z)});
      x = end + (one_in(4) ? between(-1, 1) : 0);
    }
  }

  void corner() {
    const int w = between(2, 6), a = between(1, 4), b = between(1, 4), n = between(1, 3);
    const auto at = [&](int x, int y, int z) { return Point(x, y, z); };
    query_.region = {at(0, 0, 0), at(a, 0, 0), at(a, w, 0), at(0, w, 0)};
    query_.element = {at(0, 0, 0), at(0, w + graze(), 0), at(0, w, b), at(0, 0, b)};
    if (one_in(2)) query_.element = {at(0, 0, 0), at(0, w, 0), at(0, between(0, w), b)};
    if (one_in(3)) query_.region = {at(0, 0, 0), at(a, between(0, w), 0), at(0, w, 0)};
    // A plate from the common edge out to the segment from (a, 0) to (0, b), or just short of it.
    const int u = n * a, v = n * b, over = between(0, 1);
    const int y0 = -over + (one_in(5) ? 1 : 0), y1 = w + over - (one_in(5) ? 1 : 0);
    const int split = between(1, w - 1), kind = between(0, 2);
    const Point low = at(0, y0, 0), high = at(0, y1, 0), step = at(u, 0, v);
    if (kind == 0) {
      occlude({low, high, high + step, low + step});
    } else if (kind == 1) {
      occlude({low, high, high + step});
      occlude({low, low + step + at(graze(), 0, graze()), high + step});
    } else {
      const Point middle = at(0, split, 0);
      occlude({low, middle, middle + step, low + step});
      const Point from = middle + at(0, graze(), 0);
      occlude({from, high, high + step, from + step});
    }
    if (one_in(2)) occlude(polygon(-1, 5, -1, 5, true));
  }

  void crossed() {
    // E stands across the plane of R, z = 0, which it meets within R at times.
    query_.region = horizontal(0, 0, between(2, 5), between(2, 5), 0);
    const int x = between(-2, 6), tilt = between(-1, 1), low = between(-4, -1),
              high = between(1, 4);
    query_.element = {Point(x + tilt * low, 0, low), Point(x + tilt * low, 4, low),
                      Point(x + tilt * high, 4, high), Point(x + tilt * high, 0, high)};
    if (one_in(2)) query_.element.pop_back();
    // Plates on both sides, close to E or to R.
    for (const int side : {-1, 1}) {
      if (one_in(8)) continue;
      const int reach = side < 0 ? low : high;
      if (one_in(2)) {  // over R
        const int z = side;
        occlude(horizontal(-8 + graze(), -8, 13, 12, one_in(3) ? z * 0.5 : z * 0.25));
      } else {  // along E, on each side of it
        for (const int d : {-1, 1}) {
          const double s = d * 0.25;
          occlude({Point(x + s + tilt * reach, -6, reach), Point(x + s, -6, 0),
                   Point(x + s, 10 + graze(), 0), Point(x + s + tilt * reach, 10, reach)});
        }
      }
    }
    if (one_in(2)) occlude(polygon(-2, 6, -3, 3, true));
  }

  void shingles() {
    static constexpr std::array<std::array<int, 2>, 12> kRing = {{{16, 0},
                                                                  {14, 8},
                                                                  {8, 14},
                                                                  {0, 16},
                                                                  {-8, 14},
                                                                  {-14, 8},
                                                                  {-16, 0},
                                                                  {-14, -8},
                                                                  {-8, -14},
                                                                  {0, -16},
                                                                  {8, -14},
                                                                  {14, -8}}};
    query_.region = polygon(-3, 3, -10, -8, true);
    query_.element = polygon(-3, 3, 8, 10, true);
    const std::size_t count = between(3, 6);
    const int height = between(0, 4), most = between(0, 6);
    for (std::size_t i = 0; i < count; ++i) {
      const auto &a = kRing[(i * 12 / count + (one_in(2) ? 11 : 0)) % 12],
                 &b = kRing[((i + 1) * 12 / count + (one_in(2) ? 1 : 0)) % 12];
      const int back = between(0, most);
      const auto z = [&] { return between(-height, height); };
      occlude({Point(-(a[0] + b[0]) * back / 24, -(a[1] + b[1]) * back / 24, z()),
               Point(a[0], a[1], z()), Point(b[0], b[1], z())});
    }
  }

  /// A polygon that hides nothing more: in the plane of R or E, or a copy of another.
  void add_bystander() {
    if (query_.occluders.size() >= 6 || !one_in(8)) return;
    const int kind = between(0, 2);
    if (kind == 2 && query_.occluders.empty()) return;
    ConvexPolygon copy = kind == 0   ? query_.region
                         : kind == 1 ? query_.element
                                     : query_.occluders[random_.below(query_.occluders.size())];
    if (kind < 2) {
      const Point step = (copy[1] - copy[0]) * between(0, 1);
      for (Point& corner : copy) corner += step;
    }
    occlude(copy);
  }

  /// Maps that keep every answer: swaps, permutations, mirrors, a shear, another first corner,
  /// a further corner within an edge.
  void disguise() {
    if (one_in(2)) std::swap(query_.region, query_.element);
    std::array<int, 3> axes = {0, 1, 2};
    for (std::size_t i = 3; i > 1; --i) std::swap(axes[i - 1], axes[random_.below(i)]);
    const int shear_from = between(0, 2), shear_to = (shear_from + between(1, 2)) % 3;
    const int shear = one_in(2) ? 0 : between(-2, 2), mirror = between(0, 7);
    const auto each = [&](ConvexPolygon& polygon) {
      for (Point& p : polygon) {
        Point moved(p[axes[0]], p[axes[1]], p[axes[2]]);
        moved[shear_to] += shear * moved[shear_from];
        for (int k = 0; k < 3; ++k) {
          if (mirror >> k & 1) moved[k] = -moved[k];
        }
        p = moved;
      }
      std::rotate(polygon.begin(), polygon.begin() + between(0, 2), polygon.end());
      if (one_in(2)) std::reverse(polygon.begin(), polygon.end());
      if (one_in(16)) polygon.push_back((polygon.front() + polygon.back()) / 2);
    };
    each(query_.region);
    each(query_.element);
    for (ConvexPolygon& occluder : query_.occluders) each(occluder);
    for (std::size_t i = query_.occluders.size(); i > 1; --i) {
      std::swap(query_.occluders[i - 1], query_.occluders[random_.below(i)]);
    }
  }

  RandomNumbers random_;
  Family family_;
  SightQuery query_;
};

std::string text(const ConvexPolygon& polygon) {
  std::ostringstream out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    out << (i == 0 ? "[[" : ", [") << polygon[i].x() << ", " << polygon[i].y() << ", "
        << polygon[i].z() << "]";
  }
  out << "]";
  return out.str();
}

/// As one line of a corpus.
std::string text(const SightQuery& query, bool visible) {
  std::ostringstream out;
  out << "{\"region\": " << text(query.region) << ", \"element\": " << text(query.element)
      << ", \"occluders\": [";
  for (std::size_t i = 0; i < query.occluders.size(); ++i) {
    out << (i == 0 ? "" : ", ") << text(query.occluders[i]);
  }
  out << "], \"visible\": " << (visible ? "true" : "false") << "}";
  return out.str();
}

bool kernel_sees(const SightQuery& query) { return is_visible(decide_from_region(query).verdict); }

constexpr std::uint64_t kSeed = 20240611;
constexpr std::uint64_t kShards = 8, kShaftsPerShard = 2'250;

class SecondOpinion : public ::testing::TestWithParam<std::uint64_t> {};

TEST_P(SecondOpinion, AgreesWithTheKernel) {
  std::cout << "seed " << kSeed << ", shard " << GetParam() << "\n";
  std::array<std::array<int, 2>, kFamilyCount> count{};
  int mismatches = 0;
  for (std::uint64_t i = 0; i < kShaftsPerShard && mismatches < 5; ++i) {
    const std::uint64_t index = GetParam() * kShaftsPerShard + i;
    const auto [query, family] = ShaftMaker(kSeed, index).make();
    const bool visible = sees_by_second_opinion(query);
    ++count[family][visible];
    if (kernel_sees(query) == visible) continue;
    ++mismatches;
    ADD_FAILURE() << "seed " << kSeed << ", index " << index << ", " << kFamilyNames[family]
                  << "; the second opinion is\n"
                  << text(query, visible);
  }
  if (mismatches > 0) return;
  std::array<int, 2> sum{};
  for (std::size_t family = 0; family < kFamilyCount; ++family) {
    std::cout << kFamilyNames[family] << ": " << count[family][0] << " hidden, " << count[family][1]
              << " visible\n";
    for (const int verdict : {0, 1}) {
      EXPECT_GE(count[family][verdict], 5) << kFamilyNames[family];
      sum[verdict] += count[family][verdict];
    }
  }
  EXPECT_GE(sum[0] * 10, (sum[0] + sum[1]) * 3) << "hidden";
  EXPECT_GE(sum[1] * 10, (sum[0] + sum[1]) * 3) << "visible";
}

INSTANTIATE_TEST_SUITE_P(Shards, SecondOpinion, ::testing::Range<std::uint64_t>(0, kShards));

/// A comparison that passes in double would prove nothing.
TEST(SecondOpinion, DoublesDisagree) {
  std::cout << "seed " << kSeed << "\n";
  int differs_from_opinion = 0, differs_from_kernel = 0, lost = 0;
  for (std::uint64_t index = 0; index < 600; ++index) {
    const SightQuery query = ShaftMaker(kSeed, index).make().query;
    try {
      const bool visible = sees_by_second_opinion_in_double(query);
      differs_from_opinion += visible != sees_by_second_opinion(query);
      differs_from_kernel += visible != kernel_sees(query);
    } catch (const second_opinion::Undecided&) {
      ++lost;
    }
  }
  std::cout << differs_from_opinion << " of 600 wrong in double, " << lost
            << " without an answer\n";
  EXPECT_GT(differs_from_opinion, 0);
  EXPECT_GT(differs_from_kernel, 0);
}

struct Known {
  std::string name;
  ConvexPolygon region, element;
  std::vector<ConvexPolygon> occluders;
  bool visible;
};

std::vector<Known> known_cases() {
  const auto square = [](double half, double z) { return horizontal(-half, -half, half, half, z); };
  /// A wall at height z but for the slit low < y < high.
  const auto slit_y = [](double low, double high, double z) {
    return std::vector<ConvexPolygon>{horizontal(-99, -99, 99, low, z),
                                      horizontal(-99, high, 99, 99, z)};
  };
  const auto slit_x = [](double low, double high, double z) {
    return std::vector<ConvexPolygon>{horizontal(-99, -99, low, 99, z),
                                      horizontal(high, -99, 99, 99, z)};
  };
  const auto both = [](std::vector<ConvexPolygon> a, const std::vector<ConvexPolygon>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  };
  /// A wall at height 2 with the hole |x|, |y| < 1.
  const std::vector<ConvexPolygon> hole = {
      horizontal(-99, -99, -1, 99, 2), horizontal(1, -99, 99, 99, 2), horizontal(-1, -99, 1, -1, 2),
      horizontal(-1, 1, 1, 99, 2)};
  const auto upright = [](double x, double y0, double y1, double z0, double z1) {
    return ConvexPolygon{{x, y0, z0}, {x, y1, z0}, {x, y1, z1}, {x, y0, z1}};
  };
  const ConvexPolygon floor = horizontal(0, 0, 2, 2, 0), wall = upright(0, 0, 2, 0, 2);
  const ConvexPolygon plate = {{0, 0, 0}, {0, 2, 0}, {2, 2, 2}, {2, 0, 2}};
  const ConvexPolygon narrow_plate = {{0, 0, 0}, {0, 1, 0}, {2, 1, 2}, {2, 0, 2}};
  const ConvexPolygon flat = square(2, 0), crossing = upright(0, -1, 1, -2, 2);
  return {
      {"nothing between", square(1, 0), square(1, 2), {}, true},
      {"one plane", square(1, 0), horizontal(3, 0, 4, 1, 0), {}, false},
      // The umbra of the wall |x|, |y| < 2 at height 1 is |x|, |y| < 3 at height 2.
      {"fills the umbra", square(1, 0), square(3, 2), {square(2, 1)}, false},
      {"within the umbra", square(1, 0), square(2, 2), {square(2, 1)}, false},
      {"out of the umbra", square(1, 0), horizontal(-2, -3, 4, 3, 2), {square(2, 1)}, true},
      {"slats that abut",
       square(1, 0),
       square(1, 2),
       {horizontal(-1, -1, 0, 1, 1), horizontal(0, -1, 1, 1, 1)},
       false},
      {"slats with a slit",
       square(16, 0),
       square(16, 2),
       {horizontal(-16, -16, 0, 16, 1), horizontal(1, -16, 16, 16, 1)},
       true},
      {"triangles round a corner that abut",
       square(1, 0),
       square(1, 2),
       {{{-1, -1, 1}, {1, -1, 1}, {0.5, 0.25, 1}},
        {{1, -1, 1}, {1, 1, 1}, {0.5, 0.25, 1}},
        {{1, 1, 1}, {-1, 1, 1}, {0.5, 0.25, 1}},
        {{-1, 1, 1}, {-1, -1, 1}, {0.5, 0.25, 1}}},
       false},
      {"crossed slits", square(2, 0), square(2, 3), both(slit_y(0, 1, 1), slit_x(0, 1, 2)), true},
      {"crossed slits, one closed", square(2, 0), square(2, 3),
       both(slit_y(0, 1, 1), slit_x(1, 1, 2)), false},
      // From 0 < y < 1 at height 1 to 2 < y < 3 at height 2 lines start at y < 0.
      {"slits out of line by two", horizontal(0, 0, 1, 1, 0), square(9, 3),
       both(slit_y(0, 1, 1), slit_y(2, 3, 2)), false},
      {"slits out of line by two, from further out", horizontal(0, -1, 1, 1, 0), square(9, 3),
       both(slit_y(0, 1, 1), slit_y(2, 3, 2)), true},
      // From |y| < 2 at height 0 through the hole lines are within |y| < 4 at height 4.
      {"hole with a plug", square(2, 0), square(9, 6), both(hole, {square(4, 4)}), false},
      {"hole with a plug one unit short", square(2, 0), square(9, 6),
       both(hole, {horizontal(-4, -4, 4, 3, 4)}), true},
      {"plate through the common edge", floor, wall, {plate}, false},
      {"plate through half of the common edge", floor, wall, {narrow_plate}, true},
      {"in the plane of the element", square(1, 0), square(1, 2), {square(2, 2)}, true},
      {"behind both", square(1, 0), square(1, 2), {square(9, 3), square(9, -1)}, true},
      {"standing on the region", floor, square(2, 2), {upright(1, 0, 2, 0, 9)}, true},
      {"element across, one side blocked", flat, crossing, {horizontal(-9, -9, 9, 9, 0.5)}, true},
      // Each wall stands between the element and one half of the region.
      {"element across, walls along it",
       flat,
       crossing,
       {upright(0.25, -9, 9, -9, 9), upright(-0.25, -9, 9, -9, 9)},
       true},
      {"element across and off the region, plates on both sides",
       flat,
       upright(3, -1, 1, -2, 2),
       {horizontal(-9, -9, 2, 9, 0.5), horizontal(-9, -9, 2, 9, -0.5), upright(2, -9, 9, -1, 1)},
       false},
  };
}

TEST(SecondOpinion, KnownAnswers) {
  for (const Known& known : known_cases()) {
    SightQuery query;
    query.region = known.region;
    query.element = known.element;
    query.occluders = known.occluders;
    EXPECT_EQ(sees_by_second_opinion(query), known.visible) << known.name;
    std::swap(query.region, query.element);
    EXPECT_EQ(sees_by_second_opinion(query), known.visible) << known.name << ", swapped";
  }
}

}  // namespace
}  // namespace viewcover::testing
