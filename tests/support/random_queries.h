#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "exact/query_shapes.h"
#include "exact/sight_query.h"
#include "scene/random_numbers.h"

namespace viewcover::testing {

/// All on a small integer grid, where contacts, common edges and exact umbra borders abound, but
/// for the last.
enum class QueryFamily : std::size_t {
  kGrid,     ///< polygons of 3 to 5 corners between a low R and a high E, or anywhere
  kTiles,    ///< a wall over the shaft in pieces that abut; at times one is a unit off
  kUmbra,    ///< E is the umbra of a wall in pieces, or a unit larger or smaller
  kCorner,   ///< R and E meet in an edge, plates through that edge
  kBoxes,    ///< boxes between a floor and a wall
  kCrossed,  ///< R's plane cuts E, plates on both sides
  kSoup,     ///< large random triangles, coordinates multiples of 2^-22
};
inline constexpr std::array kQueryFamilyNames = {"grid",  "tiles",   "umbra", "corner",
                                                 "boxes", "crossed", "soup"};
inline constexpr std::size_t kQueryFamilies = kQueryFamilyNames.size();

inline std::string text(const ConvexPolygon& polygon) {
  std::ostringstream out;
  out.precision(17);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    out << (i == 0 ? "[[" : ", [") << polygon[i].x() << ", " << polygon[i].y() << ", "
        << polygon[i].z() << "]";
  }
  out << "]";
  return out.str();
}

inline std::string text(const SightQuery& query) {
  std::ostringstream out;
  out << "{\"region\": " << text(query.region) << ", \"element\": " << text(query.element)
      << ", \"occluders\": [";
  for (std::size_t i = 0; i < query.occluders.size(); ++i) {
    out << (i == 0 ? "" : ", ") << text(query.occluders[i]);
  }
  out << "]" << (query.one_sided ? ", \"one_sided\": true}" : "}");
  return out.str();
}

/// An equilateral triangle of random orientation, corners multiples of 2^-22.
inline ConvexPolygon random_equilateral(RandomNumbers& random, const Point& centre, double radius) {
  const auto direction = [&] {
    while (true) {
      const Point d(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
      if (d.squaredNorm() > 0.01 && d.squaredNorm() < 1) return Point(d.normalized());
    }
  };
  const Point u = direction();
  Point v = u.cross(direction());
  while (v.norm() < 0.1) v = u.cross(direction());
  v.normalize();
  const Lattice lattice{22};
  const double half = radius / 2, height = radius * 0.8660254037844386;
  return {lattice.round(centre + radius * u), lattice.round(centre - half * u + height * v),
          lattice.round(centre - half * u - height * v)};
}

struct SoupOptions {
  std::size_t least = 20, most = 80;             ///< triangles
  double least_radius = 0.2, most_radius = 0.6;  ///< of their circumcircles
};

/// One of a soup's triangles, strictly between the heights 0 and 1.
inline ConvexPolygon soup_triangle(RandomNumbers& random, const SoupOptions& options) {
  while (true) {
    const Point centre(random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.unit());
    ConvexPolygon triangle = random_equilateral(
        random, centre, random.between(options.least_radius, options.most_radius));
    const Box box = bounding_box(triangle);
    if (box.min().z() > 0 && box.max().z() < 1) return triangle;
  }
}

/// Random triangles between two level ones of circumradius 1/2, at the heights 0 and 1.
inline SightQuery random_soup(RandomNumbers& random, const SoupOptions& options) {
  const auto end = [](double z) {
    const double height = Lattice{22}.round(0.5 * 0.8660254037844386);
    return ConvexPolygon{{0.5, 0, z}, {-0.25, height, z}, {-0.25, -height, z}};
  };
  SightQuery soup;
  soup.region = end(0);
  soup.viewpoint.setZero();
  soup.element = end(1);
  const std::size_t count = options.least + random.below(options.most - options.least + 1);
  while (soup.occluders.size() < count) soup.occluders.push_back(soup_triangle(random, options));
  return soup;
}

/// Query number `index` of a seed. R, E and occluders are strictly convex.
class RandomQuery {
 public:
  RandomQuery(std::uint64_t seed, std::uint64_t index)
      : family_(static_cast<QueryFamily>(index % kQueryFamilies)),
        random_(mixed(seed + mixed(index))) {
    query_.viewpoint.setZero();
    switch (family_) {
      case QueryFamily::kGrid:
        make_grid();
        break;
      case QueryFamily::kTiles:
        make_tiles();
        break;
      case QueryFamily::kUmbra:
        make_umbra();
        break;
      case QueryFamily::kCorner:
        make_corner();
        break;
      case QueryFamily::kBoxes:
        make_boxes();
        break;
      case QueryFamily::kCrossed:
        make_crossed();
        break;
      case QueryFamily::kSoup:
        query_ = random_soup(random_, kSoup);
        break;
    }
    query_.one_sided = one_in(6);
    if (query_.one_sided && one_in(2)) query_.element = flipped(query_.element);
  }

  QueryFamily family() const { return family_; }
  const SightQuery& query() const { return query_; }
  /// For what is done with the query.
  RandomNumbers& random() { return random_; }

  /// A polygon that may block something, of the family's kind.
  ConvexPolygon further_occluder() {
    if (family_ == QueryFamily::kSoup) return soup_triangle(random_, kSoup);
    return family_ == QueryFamily::kBoxes ? polygon(0, 12, 0, 7) : polygon(-3, 7, -1, 6);
  }

 private:
  int between(int low, int high) {  // both included
    return low + static_cast<int>(random_.below(static_cast<std::size_t>(high - low + 1)));
  }
  bool one_in(int n) { return random_.below(static_cast<std::size_t>(n)) == 0; }
  /// Mostly 0, else a unit up or down.
  int graze() { return one_in(2) ? 0 : between(-1, 1); }

  Point point(int low, int high, int low_z, int high_z) {
    const int x = between(low, high), y = between(low, high), z = between(low_z, high_z);
    return Point(x, y, z);
  }

  /// In the frame of three random points.
  ConvexPolygon polygon(int low, int high, int low_z, int high_z) {
    static const std::array<Flats, 4> kShapes = {
        Flats{{0, 0}, {1, 0}, {0, 1}}, Flats{{0, 0}, {1, 0}, {1, 1}, {0, 1}},
        Flats{{0, 0}, {2, 0}, {1, 1}, {0, 1}}, Flats{{0, 0}, {1, 0}, {2, 1}, {1, 2}, {0, 1}}};
    while (true) {
      const Point a = point(low, high, low_z, high_z);
      const Point u = point(low, high, low_z, high_z) - a, v = point(low, high, low_z, high_z) - a;
      if (u.cross(v).isZero()) continue;
      ConvexPolygon result;
      for (const auto& [s, t] : kShapes[random_.below(kShapes.size())]) {
        result.emplace_back(a + s * u + t * v);
      }
      return result;
    }
  }

  void occlude(ConvexPolygon polygon) { query_.occluders.push_back(std::move(polygon)); }

  void make_grid() {
    const bool anywhere = one_in(3);
    query_.region = polygon(0, 4, 0, 1);
    query_.element = anywhere ? polygon(0, 4, 0, 3) : polygon(0, 4, 6, 7);
    const int count = one_in(4) ? 1 : between(2, 7);
    for (int i = 0; i < count; ++i) {
      occlude(anywhere ? polygon(-2, 6, -1, 4) : polygon(-7, 11, 1, 5));
    }
  }

  /// Rectangles that tile [x0, x1] x [y0, y1], some cut into triangles, in the plane
  /// z = height + slope x.
  Polygons tiled_wall(int x0, int y0, int x1, int y1, int height, int slope) {
    struct Tile {
      int x0, y0, x1, y1;
    };
    std::vector<Tile> tiles = {{x0, y0, x1, y1}};
    const int cuts = between(0, 4);
    for (int i = 0; i < cuts; ++i) {
      Tile& tile = tiles[random_.below(tiles.size())];
      Tile rest = tile;
      if (one_in(2) && tile.x1 - tile.x0 > 1) {
        tile.x1 = rest.x0 = between(tile.x0 + 1, tile.x1 - 1);
      } else if (tile.y1 - tile.y0 > 1) {
        tile.y1 = rest.y0 = between(tile.y0 + 1, tile.y1 - 1);
      } else {
        continue;
      }
      tiles.push_back(rest);
    }
    Polygons pieces;
    for (const Tile& tile : tiles) {
      const auto at = [&](int x, int y) { return Point(x, y, height + slope * x); };
      const ConvexPolygon whole = {at(tile.x0, tile.y0), at(tile.x1, tile.y0), at(tile.x1, tile.y1),
                                   at(tile.x0, tile.y1)};
      if (one_in(3)) {
        pieces.push_back({whole[0], whole[1], whole[2]});
        pieces.push_back({whole[0], whole[2], whole[3]});
      } else {
        pieces.push_back(whole);
      }
    }
    return pieces;
  }

  /// Moves one piece by a unit, or drops it.
  void fray(Polygons& pieces) {
    const std::size_t which = random_.below(pieces.size());
    if (one_in(4)) {
      pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(which));
      return;
    }
    const int axis = between(0, 2), step = one_in(2) ? 1 : -1;
    for (Point& corner : pieces[which]) corner[axis] += step;
  }

  void make_tiles() {
    query_.region = polygon(2, 6, 0, 1);
    query_.element = polygon(2, 6, 10, 11);
    Box box = bounding_box(query_.region);
    box.extend(bounding_box(query_.element));
    const bool is_thin = box.sizes().head<2>().minCoeff() < 1;
    const int margin = is_thin ? 1 : between(0, 1);
    const auto low = [&](int axis) { return static_cast<int>(box.min()[axis]) - margin; };
    const auto high = [&](int axis) { return static_cast<int>(box.max()[axis]) + margin; };
    const int slope = one_in(3) ? between(-1, 1) : 0;
    Polygons wall =
        tiled_wall(low(0), low(1), high(0), high(1), 6 - slope * (low(0) + high(0)) / 2, slope);
    if (!one_in(3)) fray(wall);
    for (ConvexPolygon& piece : wall) occlude(std::move(piece));
    if (one_in(2)) occlude(polygon(0, 8, 2, 9));
  }

  void make_umbra() {
    const int r = between(2, 4), h = between(1, 3), k = between(1, 3), o = r + between(0, 2);
    const int e = o + (o - r) * k;
    query_.region = horizontal(-r, -r, r, r, 0);
    query_.element = horizontal(-e + graze(), -e + graze(), e + graze(), e + graze(), h + h * k);
    if (one_in(3)) query_.element.pop_back();
    if (one_in(3)) query_.region.pop_back();
    Polygons wall = tiled_wall(-o, -o, o, o, h, 0);
    if (one_in(4)) fray(wall);
    for (ConvexPolygon& piece : wall) occlude(std::move(piece));
    if (one_in(3)) occlude(polygon(-4, 4, 1, 4));
  }

  void make_corner() {
    const int w = between(2, 5), a = between(1, 4), b = between(1, 4), n = between(1, 2);
    const auto at = [](int x, int y, int z) { return Point(x, y, z); };
    query_.region = {at(0, 0, 0), at(a, 0, 0), at(a, w, 0), at(0, w, 0)};
    query_.element = {at(0, 0, 0), at(0, w, 0), at(0, w, b), at(0, 0, b)};
    if (one_in(3)) query_.region.pop_back();
    if (one_in(3)) query_.element[2].y() -= 1;
    // Plates from the common edge out to the segment from (a, 0) to (0, b) or beyond.
    const Point step = at(n * a + graze(), 0, n * b);
    const int cut = between(1, w - 1), low = -between(0, 1), high = w + graze();
    const auto plate = [&](int y0, int y1) {
      const Point p = at(0, y0, 0), q = at(0, y1, 0);
      occlude({p, q, q + step, p + step});
    };
    if (one_in(2)) {
      plate(low, high);
    } else {
      plate(low, cut);
      plate(cut + (one_in(3) ? 1 : 0), std::max(high, cut + 2));
    }
    if (one_in(2)) occlude(polygon(-1, 5, -1, 5));
  }

  void make_boxes() {
    query_.region = horizontal(0, 0, between(1, 3), between(1, 5), 0);
    query_.element = upright_x(12, between(0, 3), between(0, 2), between(4, 7), between(3, 5));
    const int count = between(1, 3);
    for (int i = 0; i < count; ++i) {
      const Point low(between(3, 9), between(-4, 3), between(-2, 1));
      const Point size(between(1, 4), between(2, 10), between(2, 9));
      for (ConvexPolygon& side : box(low, low + size)) occlude(std::move(side));
    }
  }

  void make_crossed() {
    query_.region = horizontal(0, 0, between(1, 4), between(2, 4), 0);
    const int x = between(-2, 6), tilt = between(-1, 1), low = -between(1, 3), high = between(1, 3);
    const auto on_element = [&](double offset, int y, int z) {
      return Point(x + offset + tilt * z, y, z);
    };
    query_.element = {on_element(0, 0, low), on_element(0, 4, low), on_element(0, 4, high),
                      on_element(0, 0, high)};
    if (one_in(3)) query_.element.pop_back();
    for (const int side : {-1, 1}) {
      if (one_in(12)) continue;
      if (one_in(4)) {  // along R
        occlude(horizontal(-8 + graze(), -8, between(7, 13), 12, side * 0.25));
      } else {  // along E, on each side of it
        const int reach = side < 0 ? low : high;
        for (const double offset : {-0.25, 0.25}) {
          occlude({on_element(offset, -6, reach), on_element(offset, -6, 0),
                   on_element(offset, 10 + graze(), 0), on_element(offset, 10, reach)});
        }
      }
    }
    if (one_in(2)) occlude(polygon(-2, 6, -3, 3));
  }

  static constexpr SoupOptions kSoup = {8, 24, 0.3, 0.9};

  QueryFamily family_;
  RandomNumbers random_;
  SightQuery query_;
};

}  // namespace viewcover::testing
