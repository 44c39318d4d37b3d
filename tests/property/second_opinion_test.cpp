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

}  // namespace
}  // namespace viewcover::testing
