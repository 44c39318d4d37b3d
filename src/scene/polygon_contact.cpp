#include "scene/polygon_contact.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/squared_distance_3.h>

#include <limits>

#include "scene/convex_polygon.h"
#include "scene/predicates.h"

namespace viewcover {
namespace {

using Rational = CGAL::Exact_rational;
using ExactKernel = CGAL::Simple_cartesian<Rational>;

// The edges of a convex polygon that end its segment on a plane: `up` leads from the back of the
// plane (or the plane itself) to the front, `down` from the front (or the plane) to the back.
struct Crossing {
  std::size_t up = 0;
  std::size_t down = 0;
  bool exists = false;
};

Crossing crossing(std::span<const Point> polygon, std::span<const Point> plane) {
  Crossing result;
  bool has_up = false, has_down = false;
  const auto side = [&](std::size_t i) {
    return orientation(plane[0], plane[1], plane[2], polygon[i]);
  };
  const std::size_t n = polygon.size();
  int before = side(n - 1);
  for (std::size_t i = 0; i < n; ++i) {
    const int here = side(i);
    if (before <= 0 && here > 0) {
      result.up = (i + n - 1) % n;
      has_up = true;
    } else if (before >= 0 && here < 0) {
      result.down = (i + n - 1) % n;
      has_down = true;
    }
    before = here;
  }
  result.exists = has_up && has_down;
  return result;
}

// Sign of the tetrahedron of edge number i of p and edge number j of q.
int edge_orientation(std::span<const Point> p, std::size_t i, std::span<const Point> q,
                     std::size_t j) {
  return orientation(p[i], p[(i + 1) % p.size()], q[j], q[(j + 1) % q.size()]);
}

ExactKernel::Triangle_3 fan_triangle(std::span<const Point> polygon, std::size_t i) {
  const auto exact = [](const Point& x) {
    return ExactKernel::Point_3(Rational(x.x()), Rational(x.y()), Rational(x.z()));
  };
  return {exact(polygon[0]), exact(polygon[i - 1]), exact(polygon[i])};
}

// A squared distance computed from rounded differences is off by at most 5 units roundoff u = 2^-53
// (difference, square: 3 u; two sums: 2 u), the square of the limit by one more: less than 4 * 2 u.
constexpr double kSquaredDistanceSlack = 4 * std::numeric_limits<double>::epsilon();

}  // namespace

// Let the planes have normals n_p and n_q, and d = n_p x n_q be the direction of their common line.
// Seen from the front of p, the left of d is behind q, so p's segment on the line begins at p's
// edge up through q and ends at its edge down; for q, begin and end are exchanged. For an edge u of
// p through the line at x and an edge v of q through it at y = x + t d, the sign of the tetrahedron
// of the edges is sign(t) sign(n_p v) sign(n_q u). So `up` and `up` compare p's begin with q's end,
// `down` and `down` p's end with q's begin.
bool cut_each_other(std::span<const Point> p, std::span<const Point> q) {
  const Crossing of_p = crossing(p, q);
  if (!of_p.exists) return false;
  const Crossing of_q = crossing(q, p);
  if (!of_q.exists) return false;
  return edge_orientation(p, of_p.up, q, of_q.up) > 0 &&
         edge_orientation(p, of_p.down, q, of_q.down) < 0;
}

bool is_nearer_than(std::span<const Point> p, std::span<const Point> q, double distance) {
  const double squared = distance * distance;
  if (bounding_box(p).squaredExteriorDistance(bounding_box(q)) >
      squared * (1 + kSquaredDistanceSlack)) {
    return false;
  }
  for (const Point& a : p) {
    for (const Point& b : q) {
      if ((a - b).squaredNorm() < squared * (1 - kSquaredDistanceSlack)) return true;
    }
  }
  const Rational limit = Rational(distance) * Rational(distance);
  for (std::size_t i = 2; i < p.size(); ++i) {
    const ExactKernel::Triangle_3 part_of_p = fan_triangle(p, i);
    for (std::size_t j = 2; j < q.size(); ++j) {
      if (CGAL::squared_distance(part_of_p, fan_triangle(q, j)) < limit) return true;
    }
  }
  return false;
}

}  // namespace viewcover
