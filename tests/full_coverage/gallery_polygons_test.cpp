#include "full_coverage/gallery_polygons.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <set>

#include "scene/scratch_folder.h"
#include "support/sanitized.h"

namespace viewcover::testing {
namespace {

// Visibility in the plane by rationals, with no code of the library.

using Rational = boost::multiprecision::cpp_rational;
struct Vector2 {
  Rational x, y;
  Vector2(Rational px, Rational py) : x(std::move(px)), y(std::move(py)) {}
  Vector2(const Place& p) : x(p.x()), y(p.y()) {}
};
Vector2 operator+(const Vector2& a, const Vector2& b) { return {a.x + b.x, a.y + b.y}; }
Vector2 operator-(const Vector2& a, const Vector2& b) { return {a.x - b.x, a.y - b.y}; }
Vector2 operator*(const Rational& s, const Vector2& a) { return {s * a.x, s * a.y}; }
Rational cross(const Vector2& a, const Vector2& b) { return a.x * b.y - a.y * b.x; }
Rational dot(const Vector2& a, const Vector2& b) { return a.x * b.x + a.y * b.y; }

using Piece = std::vector<Vector2>;  // convex, counter-clockwise; possibly flat
Rational double_area(const Piece& piece) {
  Rational sum = 0;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    sum += cross(piece[i], piece[(i + 1) % piece.size()]);
  }
  return sum;
}

/// The part of a piece in another, which is not flat; both are closed, so what they touch in
/// counts.
Piece common_part(Piece piece, const Piece& other) {
  for (std::size_t k = 0; k < other.size() && !piece.empty(); ++k) {
    const Vector2 &a = other[k], d = other[(k + 1) % other.size()] - a;
    std::vector<Rational> side;
    for (const Vector2& corner : piece) side.push_back(cross(d, corner - a));
    Piece kept;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const std::size_t j = (i + 1) % piece.size();
      if (side[i] >= 0) kept.push_back(piece[i]);
      if (side[i].sign() * side[j].sign() < 0) {
        kept.push_back(piece[i] + side[i] / (side[i] - side[j]) * (piece[j] - piece[i]));
      }
    }
    piece = std::move(kept);
  }
  return piece;
}

/// All that two lists of pieces have in common.
std::vector<Piece> common_parts(const std::vector<Piece>& some, const std::vector<Piece>& others) {
  std::vector<Piece> parts;
  for (const Piece& a : some) {
    for (const Piece& b : others) {
      Piece part = common_part(a, b);
      if (!part.empty()) parts.push_back(std::move(part));
    }
  }
  return parts;
}

struct Wall {
  Vector2 from, to;
};
std::vector<Wall> walls_of(const GalleryCase& gallery) {
  std::vector<Wall> walls;
  const auto add = [&](const Loop2& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      walls.push_back({loop[i], loop[(i + 1) % loop.size()]});
    }
  };
  add(gallery.outer);
  for (const Loop2& hole : gallery.holes) add(hole);
  return walls;
}

/// What is seen from a place and what is not, as triangles and quadrangles. Within a wedge between
/// neighbouring directions to corners no wall begins or ends.
struct View {
  std::vector<Piece> seen, unseen;
  /// By walls, the stretches that triangles end at, seen from the front: shares from 0 to 1.
  std::vector<std::vector<std::pair<Rational, Rational>>> stretches;
  bool corners_in_line = false;  ///< two in one direction: more may be seen along the line

  View(const std::vector<Wall>& all, const Vector2& place) : stretches(all.size()) {
    std::vector<Vector2> directions;
    for (const Wall& wall : all) {
      const Vector2 d = wall.from - place;
      if (d.x != 0 || d.y != 0) directions.push_back(d);
    }
    const auto is_lower = [](const Vector2& d) { return d.y < 0 || (d.y == 0 && d.x < 0); };
    std::ranges::sort(directions, [&](const Vector2& a, const Vector2& b) {
      return is_lower(a) != is_lower(b) ? is_lower(b) : cross(a, b) > 0;
    });
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const Vector2 &u = directions[i], &v = directions[(i + 1) % directions.size()];
      const Rational turn = cross(u, v);
      corners_in_line = corners_in_line || (turn == 0 && dot(u, v) > 0);
      if (turn > 0) add_wedge(all, place, u, v);
    }
  }

 private:
  void add_wedge(const std::vector<Wall>& all, const Vector2& place, const Vector2& u,
                 const Vector2& v) {
    const Vector2 middle = u + v;
    struct Hit {
      Rational distance;
      std::size_t wall;
    };
    std::vector<Hit> hits;
    const auto distance = [&](std::size_t wall, const Vector2& direction) {
      const Vector2 along = all[wall].to - all[wall].from;
      return Rational(cross(all[wall].from - place, along) / cross(direction, along));
    };
    for (std::size_t w = 0; w < all.size(); ++w) {
      if (cross(middle, all[w].from - place).sign() * cross(middle, all[w].to - place).sign() >=
          0) {
        continue;
      }
      Rational t = distance(w, middle);
      if (t > 0) hits.push_back({std::move(t), w});
    }
    std::ranges::sort(hits, {}, &Hit::distance);
    const auto at = [&](std::size_t hit, const Vector2& direction) {
      return place + distance(hits[hit].wall, direction) * direction;
    };
    // The outermost stretch is inside, and every second one.
    std::size_t first = hits.size() % 2;
    if (first == 1) {
      seen.push_back({place, at(0, u), at(0, v)});
      const Wall& wall = all[hits[0].wall];
      const Vector2 along = wall.to - wall.from;
      const auto share = [&](const Vector2& x) {
        return Rational(dot(x - wall.from, along) / dot(along, along));
      };
      stretches[hits[0].wall].emplace_back(share(seen.back()[1]), share(seen.back()[2]));
    }
    for (std::size_t k = first; k + 1 < hits.size(); k += 2) {
      unseen.push_back({at(k, u), at(k + 1, u), at(k + 1, v), at(k, v)});
    }
  }
};

/// Do stretches between 0 and 1 leave nothing out?
bool make_up_all(std::vector<std::pair<Rational, Rational>> stretches) {
  std::ranges::sort(stretches);
  Rational end = 0;
  for (const auto& [from, to] : stretches) {
    if (from <= end && end < to) end = to;
  }
  return end == 1;
}

class GalleryPolygons : public ::testing::TestWithParam<GalleryCase> {};

TEST_P(GalleryPolygons, TheGuardsSeeAll) {
  const GalleryCase& gallery = GetParam();
  ASSERT_EQ(gallery.guards.size(), gallery.optimum);
  const std::vector<Wall> walls = walls_of(gallery);
  Rational area = 0;
  for (const Wall& wall : walls) area += cross(wall.from, wall.to);
  ASSERT_GT(area, 0);

  std::vector<Piece> unseen;
  std::vector<std::vector<std::pair<Rational, Rational>>> stretches(walls.size());
  for (std::size_t i = 0; i < gallery.guards.size(); ++i) {
    const View view(walls, gallery.guards[i]);
    Rational sum = 0;
    for (const Piece& piece : view.seen) sum += double_area(piece);
    for (const Piece& piece : view.unseen) sum += double_area(piece);
    EXPECT_EQ(sum, area) << "guard " << i;
    unseen = i == 0 ? view.unseen : common_parts(unseen, view.unseen);
    std::erase_if(unseen, [](const Piece& piece) { return double_area(piece) == 0; });
    for (std::size_t w = 0; w < walls.size(); ++w) {
      stretches[w].insert(stretches[w].end(), view.stretches[w].begin(), view.stretches[w].end());
    }
  }
  EXPECT_EQ(unseen.size(), 0u);
  EXPECT_EQ(std::ranges::all_of(stretches, make_up_all), gallery.walls_too);
}

TEST_P(GalleryPolygons, NoFewerSeeTheWitnesses) {
  const GalleryCase& gallery = GetParam();
  const std::vector<Wall> walls = walls_of(gallery);
  const std::size_t sets = std::size_t{1} << gallery.witnesses.size();
  // By sets of witnesses: where all of them are seen from, and how many points see them at least.
  std::vector<std::vector<Piece>> seen_from(sets);
  std::vector<std::size_t> fewest(sets, 0);
  for (std::size_t i = 0; i < gallery.witnesses.size(); ++i) {
    View view(walls, gallery.witnesses[i]);
    // Then the triangles, with their boundaries, are all that sees the witness.
    ASSERT_FALSE(view.corners_in_line) << "witness " << i;
    ASSERT_FALSE(view.seen.empty()) << "witness " << i << " is outside";
    seen_from[std::size_t{1} << i] = std::move(view.seen);
  }
  for (std::size_t set = 1; set < sets; ++set) {
    const std::size_t last = set & (~set + 1), others = set ^ last;
    if (others != 0) seen_from[set] = common_parts(seen_from[others], seen_from[last]);
    fewest[set] = sets;
    for (std::size_t part = set; part != 0; part = (part - 1) & set) {
      if (!seen_from[part].empty()) fewest[set] = std::min(fewest[set], 1 + fewest[set ^ part]);
    }
  }
  EXPECT_EQ(fewest[sets - 1], gallery.optimum);
}

TEST_P(GalleryPolygons, MakeScenesWithoutBeingMoved) {
  const GalleryCase& gallery = GetParam();
  const ScratchFolder folder;
  const auto file = folder.path() / "plan.txt";
  write_floor_plan(gallery, file);
  const FloorPlan read = read_floor_plan(file), made = floor_plan_of(gallery);
  ASSERT_EQ(read.size(), made.size());
  std::set<std::pair<double, double>> corners;
  for (std::size_t loop = 0; loop < made.size(); ++loop) {
    ASSERT_EQ(read[loop].size(), made[loop].size());
    for (std::size_t i = 0; i < made[loop].size(); ++i) {
      EXPECT_EQ(read[loop][i].position, made[loop][i].position);
      EXPECT_EQ(read[loop][i].line, made[loop][i].line);
      corners.emplace(made[loop][i].position.x(), made[loop][i].position.y());
    }
  }
  for (const Point& vertex : viewcover::gallery(file, read, 2).vertices) {
    EXPECT_TRUE(corners.contains({vertex.x(), vertex.y()}));
  }
}

/// The checks share no code with the library: one of them is enough with sanitizers.
std::vector<GalleryCase> checked_cases() {
  std::vector<GalleryCase> cases = gallery_cases();
  if (sanitized()) cases.erase(cases.begin() + 1, cases.end());
  return cases;
}

INSTANTIATE_TEST_SUITE_P(All, GalleryPolygons, ::testing::ValuesIn(checked_cases()),
                         [](const auto& param) {
                           std::string name = param.param.name;
                           std::erase(name, ',');
                           std::ranges::replace(name, ' ', '_');
                           return name;
                         });

}  // namespace

}  // namespace viewcover::testing
