#include "exact/skeleton_brute_force.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <vector>

#include "exact/root_numbers.h"
#include "scene/random_numbers.h"

namespace viewcover::testing {
namespace {

using Row = Line<Fraction>;

/// The plane of a polygon: normal . x = offset.
struct Plane {
  Vec<Fraction> normal;
  Fraction offset;
  Plane(const Vec<Fraction>& a, const Vec<Fraction>& b, const Vec<Fraction>& c)
      : normal(cross(minus(b, a), minus(c, a))), offset(dot(normal, a)) {}
};

struct Polygon {
  std::vector<Vec<Fraction>> corners;
  Plane plane;
  std::size_t next(std::size_t k) const { return (k + 1) % corners.size(); }
};

struct Edge {
  std::size_t polygon, index;
};

template <class N>
bool is_zero(const Line<N>& line) {
  for (const N& x : line) {
    if (sign_of(x) != 0) return false;
  }
  return true;
}

/// What a line touches: (polygon, corner or edge), and polygons that hold it.
struct Touched {
  std::vector<Edge> vertices, edges;
  std::vector<std::size_t> planes;
  bool in_shaft = true;
};

std::vector<Row> kernel(std::vector<Row> rows) {
  std::vector<std::size_t> pivots;
  for (std::size_t column = 0; column < 6; ++column) {
    const std::size_t rank = pivots.size();
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][column] == 0) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[pivot], rows[rank]);
    const Fraction scale = rows[rank][column];
    for (Fraction& x : rows[rank]) x /= scale;
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const Fraction factor = rows[r][column];
      if (r == rank || factor == 0) continue;
      for (std::size_t k = 0; k < 6; ++k) rows[r][k] -= factor * rows[rank][k];
    }
    pivots.push_back(column);
  }
  std::vector<Row> result;
  for (std::size_t column = 0; column < 6; ++column) {
    if (std::find(pivots.begin(), pivots.end(), column) != pivots.end()) continue;
    Row& vector = result.emplace_back();
    vector.fill(0);
    vector[column] = 1;
    for (std::size_t r = 0; r < pivots.size(); ++r) vector[pivots[r]] = -rows[r][column];
  }
  return result;
}

/// As a functional: direction and moment change places.
Row row_of(const Line<Fraction>& line) {
  return {line[3], line[4], line[5], line[0], line[1], line[2]};
}

class BruteForce {
 public:
  explicit BruteForce(const SightQuery& query) {
    add(query.region);
    add(query.element);
    std::vector<Vec<Fraction>> ends = polygons_[0].corners;
    ends.insert(ends.end(), polygons_[1].corners.begin(), polygons_[1].corners.end());
    for (const ConvexPolygon& occluder : query.occluders) {
      if (meets_inside(occluder, ends)) add(occluder);
    }
  }

  std::map<std::string, std::string> run() {
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) consider_rational(through(start(i), start(j)));
    }
    for (const Edge& vertex : edges_) {
      const auto& p = polygons_[vertex.polygon].corners[vertex.index];
      for (std::size_t i = 0; i < edges_.size(); ++i) {
        // In the vertex' own plane.
        const Plane& plane = polygons_[vertex.polygon].plane;
        const Fraction at_a = dot(plane.normal, start(i)) - plane.offset;
        const Fraction at_b = dot(plane.normal, end(i)) - plane.offset;
        if (at_a.sign() * at_b.sign() < 0) {
          Vec<Fraction> x;
          for (std::size_t k = 0; k < 3; ++k) {
            x[k] = (at_b * start(i)[k] - at_a * end(i)[k]) / (at_b - at_a);
          }
          consider_rational(through(p, x));
        }
        // In the planes through two edges.
        for (std::size_t j = 0; j < i; ++j) {
          if (same(start(i), p) || same(end(i), p) || same(start(j), p) || same(end(j), p)) {
            continue;
          }
          const Plane first(p, start(i), end(i)), second(p, start(j), end(j));
          const auto d = cross(first.normal, second.normal), m = cross(p, d);
          consider_rational({d[0], d[1], d[2], m[0], m[1], m[2]});
        }
      }
    }
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          for (std::size_t l = 0; l < k; ++l) consider_transversals({i, j, k, l});
        }
      }
    }
    return std::move(nodes_);
  }

 private:
  void add(const ConvexPolygon& polygon) {
    std::vector<Vec<Fraction>> corners;
    for (const Point& corner : polygon) corners.push_back(vec(corner));
    const Plane plane(corners[0], corners[1], corners[2]);
    for (std::size_t k = 0; k < corners.size(); ++k) edges_.push_back({polygons_.size(), k});
    polygons_.push_back({std::move(corners), plane});
  }
  /// Does a polygon meet the interior of the convex hull of points?
  static bool meets_inside(const ConvexPolygon& polygon, const std::vector<Vec<Fraction>>& points) {
    std::vector<Plane> bounds;  // inside is in front
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = 0; j < points.size(); ++j) {
        for (std::size_t k = 0; k < j; ++k) {
          const Plane plane(points[i], points[j], points[k]);
          if (sign_of(dot(plane.normal, plane.normal)) == 0) continue;
          const bool bounds_all = std::all_of(points.begin(), points.end(), [&](const auto& x) {
            return dot(plane.normal, x) >= plane.offset;
          });
          if (bounds_all) bounds.push_back(plane);
        }
      }
    }
    std::vector<Vec<Fraction>> rest;
    for (const Point& corner : polygon) rest.push_back(vec(corner));
    for (const Plane& plane : bounds) {
      std::vector<Vec<Fraction>> kept;
      for (std::size_t i = 0; i < rest.size(); ++i) {
        const auto &a = rest[i], &b = rest[(i + 1) % rest.size()];
        const Fraction at_a = dot(plane.normal, a) - plane.offset,
                       at_b = dot(plane.normal, b) - plane.offset;
        if (at_a >= 0) kept.push_back(a);
        if (at_a.sign() * at_b.sign() >= 0) continue;
        Vec<Fraction> x;
        for (std::size_t k = 0; k < 3; ++k) x[k] = (at_a * b[k] - at_b * a[k]) / (at_a - at_b);
        kept.push_back(x);
      }
      rest = std::move(kept);
    }
    return std::all_of(bounds.begin(), bounds.end(), [&](const Plane& plane) {
      return std::any_of(rest.begin(), rest.end(),
                         [&](const auto& x) { return dot(plane.normal, x) > plane.offset; });
    });
  }

  const Vec<Fraction>& start(std::size_t i) const {
    return polygons_[edges_[i].polygon].corners[edges_[i].index];
  }
  const Vec<Fraction>& end(std::size_t i) const {
    const Polygon& polygon = polygons_[edges_[i].polygon];
    return polygon.corners[polygon.next(edges_[i].index)];
  }
  static bool same(const Vec<Fraction>& a, const Vec<Fraction>& b) { return a == b; }

  void consider_rational(const Line<Fraction>& line) {
    if (is_zero(line)) return;
    Line<Root> roots;
    for (std::size_t k = 0; k < 6; ++k) roots[k] = Root(line[k]);
    consider(roots);
  }

  void consider_transversals(const std::array<std::size_t, 4>& edges) {
    std::vector<Row> rows;
    for (const std::size_t edge : edges) rows.push_back(row_of(through(start(edge), end(edge))));
    const std::vector<Row> basis = kernel(rows);
    if (basis.size() != 2) return;
    const Row &x = basis[0], &y = basis[1];
    const Fraction qx = form(x, x), qy = form(y, y), b = form(x, y);
    if (qx == 0) {
      consider_rational(x);
      if (b == 0 && qy == 0) return;
      // x s + y: 2 b s + qy = 0.
      if (b == 0) return;
      Row other;
      for (std::size_t k = 0; k < 6; ++k) other[k] = y[k] - x[k] * qy / (2 * b);
      consider_rational(other);
      return;
    }
    const Fraction square = b * b - qx * qy;
    if (square < 0) return;
    for (const int way : {1, -1}) {
      Line<Root> line;
      const Fraction rational = -b / qx, factor = way / qx;
      std::optional<Fraction> root = square_root(square);
      for (std::size_t k = 0; k < 6; ++k) {
        line[k] = root ? Root(y[k] + x[k] * (rational + factor * *root))
                       : Root(y[k] + x[k] * rational, x[k] * factor, square);
      }
      consider(line);
    }
  }

  static std::optional<Fraction> square_root(const Fraction& x) {
    const Integer above = numerator(x), below = denominator(x);
    const Integer a = sqrt(above), b = sqrt(below);
    if (a * a != above || b * b != below) return std::nullopt;
    return Fraction(a, b);
  }

  static Vec<Root> meeting(const Line<Root>& line, const Plane& plane) {
    const auto [d, m] = halves(line);
    const Root below = dot(d, plane.normal);
    const Vec<Root> across = cross(roots(plane.normal), m);
    Vec<Root> x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = (across[k] + d[k] * Root(plane.offset)) / below;
    return x;
  }

  Touched touched(const Line<Root>& line) const {
    Touched result;
    const auto [d, m] = halves(line);
    const Root square = dot(d, d);
    if (sign_of(square) == 0) {
      result.in_shaft = false;
      return result;
    }
    for (std::size_t number = 0; number < polygons_.size(); ++number) {
      const Polygon& polygon = polygons_[number];
      const std::size_t n = polygon.corners.size();
      std::vector<int> sides;
      if (sign_of(dot(d, polygon.plane.normal)) == 0) {
        Vec<Root> foot = cross(d, m);
        for (Root& x : foot) x = x / square;
        const bool in_plane =
            sign_of(dot(foot, polygon.plane.normal) - Root(polygon.plane.offset)) == 0;
        if (number < 2) result.in_shaft = false;
        if (!result.in_shaft) return result;
        if (!in_plane) continue;
        for (const auto& corner : polygon.corners) {
          const Vec<Root> across = cross(d, minus(roots(corner), foot));
          sides.push_back(sign_of(dot(across, polygon.plane.normal)));
        }
        bool meets = false;
        for (std::size_t k = 0; k < n; ++k) {
          if (sides[k] == 0) result.vertices.push_back({number, k});
          if (sides[k] * sides[polygon.next(k)] < 0) result.edges.push_back({number, k});
          meets |= sides[k] * sides[polygon.next(k)] <= 0;
        }
        if (meets) result.planes.push_back(number);
        continue;
      }
      const Vec<Root> x = meeting(line, polygon.plane);
      bool inside = true;
      for (std::size_t k = 0; k < n; ++k) {
        const auto& corner = polygon.corners[k];
        const auto inward =
            cross(polygon.plane.normal, minus(polygon.corners[polygon.next(k)], corner));
        sides.push_back(sign_of(dot(minus(x, corner), inward)));
        inside &= sides.back() >= 0;
      }
      if (!inside) {
        if (number < 2) result.in_shaft = false;
        if (!result.in_shaft) return result;
        continue;
      }
      bool any = false;
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t before = (k + n - 1) % n;
        any |= sides[k] == 0;
        if (sides[k] == 0 && sides[before] == 0) {
          result.vertices.push_back({number, k});
        } else if (sides[k] == 0 && sides[polygon.next(k)] != 0) {
          result.edges.push_back({number, k});
        }
      }
      if (!any && number >= 2) {  // through the inside of an occluder
        result.in_shaft = false;
        return result;
      }
    }
    return result;
  }

  bool is_pinned(const Touched& touched) const {
    std::vector<Row> rows;
    for (const Edge& vertex : touched.vertices) {
      const auto& p = polygons_[vertex.polygon].corners[vertex.index];
      for (std::size_t k = 0; k < 3; ++k) {
        Vec<Fraction> other = p;
        other[k] += 1;
        rows.push_back(row_of(through(p, other)));
      }
    }
    const auto add_edge = [&](const Polygon& polygon, std::size_t k) {
      rows.push_back(row_of(through(polygon.corners[k], polygon.corners[polygon.next(k)])));
    };
    for (const Edge& edge : touched.edges) add_edge(polygons_[edge.polygon], edge.index);
    for (const std::size_t number : touched.planes) {
      for (std::size_t k = 0; k < 3; ++k) add_edge(polygons_[number], k);
    }
    const std::vector<Row> basis = kernel(rows);
    if (basis.size() != 2) return basis.size() < 2;
    return form(basis[0], basis[0]) != 0 || form(basis[0], basis[1]) != 0 ||
           form(basis[1], basis[1]) != 0;
  }

  /// A rational within 2^-200 or so.
  static Fraction approximate(const Root& x) {
    if (x.b == 0 || x.root == 0) return x.a;
    const Integer above = numerator(x.root), below = denominator(x.root);
    const Integer scale = Integer(1) << 300;
    const Integer root = sqrt(above * below * scale * scale);
    return x.a + x.b * Fraction(root, below * scale);
  }

  /// Looks for a free segment near, in directions from the middle of each cell into which what is
  /// touched parts the space of segments, to first order, and in some others.
  bool is_limit(const Line<Root>& line, const Touched& touched) const {
    const Vec<Root> p = meeting(line, polygons_[0].plane), q = meeting(line, polygons_[1].plane);
    Vec<Fraction> p0, q0;
    Eigen::Vector3d at_p, at_q;
    for (std::size_t k = 0; k < 3; ++k) {
      p0[k] = approximate(p[k]);
      q0[k] = approximate(q[k]);
      at_p[static_cast<Eigen::Index>(k)] = p[k].rounded();
      at_q[static_cast<Eigen::Index>(k)] = q[k].rounded();
    }
    const auto difference = [&](const Polygon& polygon, std::size_t k) {
      const auto d = minus(polygon.corners[polygon.next(k)], polygon.corners[k]);
      return Eigen::Vector3d(d[0].convert_to<double>(), d[1].convert_to<double>(),
                             d[2].convert_to<double>());
    };
    const std::array<Eigen::Vector3d, 4> moves = {
        difference(polygons_[0], 0), difference(polygons_[0], 1), difference(polygons_[1], 0),
        difference(polygons_[1], 1)};
    const Eigen::Vector3d along = at_q - at_p;
    std::vector<Eigen::Vector4d> functionals;
    const auto add = [&](const Edge& edge) {
      const Polygon& polygon = polygons_[edge.polygon];
      const Eigen::Vector3d g = difference(polygon, edge.index);
      const auto& corner = polygon.corners[edge.index];
      const Eigen::Vector3d c(corner[0].convert_to<double>(), corner[1].convert_to<double>(),
                              corner[2].convert_to<double>());
      // p + t along is on the edge's line.
      const Eigen::Vector3d normal = along.cross(g);
      double t = 0;
      Eigen::Index axis = 0;
      normal.cwiseAbs().maxCoeff(&axis);
      const Eigen::Index u = (axis + 1) % 3, v = (axis + 2) % 3;
      const Eigen::Vector3d r = c - at_p;
      t = (r[u] * g[v] - r[v] * g[u]) / (along[u] * g[v] - along[v] * g[u]);
      Eigen::Vector4d functional;
      for (std::size_t k = 0; k < 4; ++k) {
        functional[static_cast<Eigen::Index>(k)] = (k < 2 ? 1 - t : t) * normal.dot(moves[k]);
      }
      functionals.push_back(functional.normalized());
    };
    for (const Edge& edge : touched.edges) add(edge);
    for (const Edge& vertex : touched.vertices) {
      add(vertex);
      const std::size_t n = polygons_[vertex.polygon].corners.size();
      add({vertex.polygon, (vertex.index + n - 1) % n});
    }
    RandomNumbers random(1);
    const auto any_direction = [&] {
      Eigen::Vector4d v;
      for (int k = 0; k < 4; ++k) v[k] = random.between(-1, 1);
      return v;
    };
    for (int i = 0; i < 2; ++i) functionals.push_back(any_direction().normalized());
    const std::size_t n = functionals.size();
    for (std::size_t mask = 0; mask < std::size_t{1} << n; ++mask) {
      if (std::popcount(mask) != 4) continue;
      Eigen::Matrix4d m;
      Eigen::Index row = 0;
      for (std::size_t i = 0; i < n; ++i) {
        if (mask >> i & 1) m.row(row++) = functionals[i].transpose();
      }
      const Eigen::FullPivLU<Eigen::Matrix4d> lu(m);
      if (lu.rank() < 4) continue;
      for (unsigned signs = 0; signs < 16; ++signs) {
        Eigen::Vector4d values;
        for (unsigned k = 0; k < 4; ++k) values[k] = signs >> k & 1 ? 1 : -1;
        if (is_free(p0, q0, lu.solve(values))) return true;
      }
    }
    for (int i = 0; i < 64; ++i) {
      if (is_free(p0, q0, any_direction())) return true;
    }
    return false;
  }

  bool is_free(const Vec<Fraction>& p, const Vec<Fraction>& q,
               const Eigen::Vector4d& direction) const {
    const Eigen::Vector4d unit = direction.normalized() * 0x1p-64;
    Vec<Fraction> from = p, to = q;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto in_region =
          minus(polygons_[0].corners[polygons_[0].next(k)], polygons_[0].corners[k]);
      const auto in_element =
          minus(polygons_[1].corners[polygons_[1].next(k)], polygons_[1].corners[k]);
      for (std::size_t i = 0; i < 3; ++i) {
        from[i] += Fraction(unit[static_cast<Eigen::Index>(k)]) * in_region[i];
        to[i] += Fraction(unit[static_cast<Eigen::Index>(k) + 2]) * in_element[i];
      }
    }
    // The points are off the planes by the rounding of p and q, which the sides below do not see.
    const Line<Fraction> line = through(from, to);
    for (std::size_t number = 0; number < polygons_.size(); ++number) {
      const Polygon& polygon = polygons_[number];
      int least = 1, most = -1;
      for (std::size_t k = 0; k < polygon.corners.size(); ++k) {
        const int side =
            form(line, through(polygon.corners[k], polygon.corners[polygon.next(k)])).sign();
        least = std::min(least, side);
        most = std::max(most, side);
      }
      // Strictly inside: one strict sign. Free: two strict signs.
      if (number < 2 ? least != most || least == 0 : least >= 0 || most <= 0) return false;
    }
    return true;
  }

  static std::string text(const Fraction& x) { return x.str(); }

  void consider(const Line<Root>& line) {
    const Touched what = touched(line);
    if (!what.in_shaft || !is_pinned(what)) return;
    std::size_t first = 0;
    while (sign_of(line[first]) == 0) ++first;
    Line<Root> scaled;
    for (std::size_t k = 0; k < 6; ++k) scaled[k] = line[k] / line[first];
    // From region to element.
    const Vec<Root> along =
        minus(meeting(line, polygons_[1].plane), meeting(line, polygons_[0].plane));
    const Vec<Root> d = halves(scaled)[0];
    const int way = sign_of(dot(along, d));
    Fraction factor = 0;
    for (std::size_t k = 0; k < 6 && factor == 0; ++k) factor = abs(scaled[k].b);
    std::string key;
    for (const Root& x : scaled) {
      key += text(way * x.a) + "," + (factor == 0 ? "0" : text(way * x.b / factor)) + "," +
             (factor == 0 ? "0" : text(factor * factor * x.root)) + ";";
    }
    if (nodes_.count(key) != 0 || rejected_.count(key) != 0) return;
    if (!is_limit(line, what)) {
      rejected_.emplace(key, "");
      return;
    }
    nodes_.emplace(key,
                   std::string(what.vertices.size(), 'V') + std::string(what.edges.size(), 'E'));
  }

  std::vector<Polygon> polygons_;
  std::vector<Edge> edges_;
  std::map<std::string, std::string> nodes_, rejected_;
};

}  // namespace

std::map<std::string, std::string> brute_force_nodes(const SightQuery& query) {
  return BruteForce(query).run();
}

}  // namespace viewcover::testing
