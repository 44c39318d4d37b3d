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

/// On which sides of a line or plane points lie.
struct Sides {
  bool front = false, back = false;
  void add(int side) {
    front |= side > 0;
    back |= side < 0;
  }
};

/// Does a plane keep the polygon on one side and the box on the other?
bool are_apart(const Sides& polygon, const Sides& box) {
  return !(polygon.front && box.front) && !(polygon.back && box.back) &&
         !(polygon.front && polygon.back) && !(box.front && box.back);
}

/// By the plane through an edge of the polygon and parallel to an axis.
bool edge_keeps_apart(std::span<const Point> polygon, std::size_t edge, const Box& box, int axis) {
  const Point &a = polygon[edge], &b = polygon[(edge + 1) % polygon.size()];
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (a[u] == b[u] && a[v] == b[v]) return false;  // there is no such plane
  Sides of_polygon, of_box;
  for (const Point& corner : polygon) of_polygon.add(turn(a, b, corner, axis));
  for (const Point& corner : box_corners(box)) of_box.add(turn(a, b, corner, axis));
  return are_apart(of_polygon, of_box);
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

// The sum of the box and the mirrored polygon is a polyhedron whose facets come from a face of the
// box, the polygon, or an edge of each; the polygon stays outside iff the origin is not inside it.
bool enters_box(std::span<const Point> polygon, const Box& box) {
  const Box extent = bounding_box(polygon);
  if ((extent.min().array() >= box.max().array()).any() ||
      (extent.max().array() <= box.min().array()).any()) {
    return false;
  }
  Sides of_box;
  for (const Point& corner : box_corners(box)) {
    of_box.add(orientation(polygon[0], polygon[1], polygon[2], corner));
  }
  if (!(of_box.front && of_box.back)) return false;
  for (std::size_t edge = 0; edge < polygon.size(); ++edge) {
    for (int axis = 0; axis < 3; ++axis) {
      if (edge_keeps_apart(polygon, edge, box, axis)) return false;
    }
  }
  return true;
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
