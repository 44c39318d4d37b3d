#include <algorithm>

#include "exact/skeleton/shaft_features.h"
#include "exact/skeleton/sorted_lists.h"

namespace viewcover::exact {
namespace {

/// Position along a line, times the direction's length.
Surd along(const StabbingLine& line, const std::array<Surd, 3>& x) {
  return line[0] * x[0] + line[1] * x[1] + line[2] * x[2];
}

std::array<Surd, 3> surds(const BigPoint& p) {
  return {Surd(coordinate(p, 0)), Surd(coordinate(p, 1)), Surd(coordinate(p, 2))};
}

std::array<Surd, 3> touching_point(const StabbingLine& line, const BigPoint& a, const BigPoint& b) {
  const Surd s = place_on(line, a, b);
  std::array<Surd, 3> x;
  for (std::size_t k = 0; k < 3; ++k) {
    const CGAL::Gmpq start = coordinate(a, k);
    x[k] = s * (coordinate(b, k) - start) + start;
  }
  return x;
}

}  // namespace

struct ShaftFeatures::Hits {
  struct Hit {
    std::size_t face;
    bool is_point;
    std::size_t feature;
  };
  std::vector<Hit> hits;
  std::vector<std::size_t> faces;  // that hold the line
  bool in_end_plane = false;       // of region or element
};

bool ShaftFeatures::passes(const StabbingLine& line, std::size_t point) const {
  const auto& star = points_[point].star;
  return std::all_of(star.begin(), star.end(), [&](const LineVector* functional) {
    return arithmetic_.sign(line, *functional) == 0;
  });
}

bool ShaftFeatures::direct(StabbingLine& line) const {
  int way = arithmetic_.sign(line, *along_from_);
  if (way == 0) way = -arithmetic_.sign(line, *along_to_);
  if (way < 0) line.reverse();
  return way != 0;
}

bool ShaftFeatures::hit(const StabbingLine& line, const FeatureFace& face, bool must_meet,
                        Hits& hits) const {
  const std::size_t n = face.lines.size();
  bool positive = false, negative = false;
  std::size_t zeros = 0, first = 0, last = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const int side = arithmetic_.sign(line, *face.lines[k]);
    positive |= side > 0;
    negative |= side < 0;
    if (positive && negative) return !must_meet;
    if (side != 0) continue;
    if (zeros == 0) first = k;
    last = k;
    ++zeros;
  }
  if (zeros == n) return hit_in_plane(line, face, hits) || !must_meet;
  if (zeros == 0) return must_meet || hits.in_end_plane;
  const auto number = static_cast<std::size_t>(&face - faces_.data());
  const auto add_edge_hit = [&](std::size_t k) {
    if (face.edges[k] != kNone) hits.hits.push_back({number, false, face.edges[k]});
  };
  if (zeros == 1) {
    add_edge_hit(first);
  } else {
    const std::size_t corner = first == 0 && last == n - 1 ? 0 : last;
    if (face.points[corner] != kNone) {
      hits.hits.push_back({number, true, face.points[corner]});
    } else {
      add_edge_hit(first);
      add_edge_hit(last);
    }
  }
  return true;
}

/// False if the line misses the face.
bool ShaftFeatures::hit_in_plane(const StabbingLine& line, const FeatureFace& face,
                                 Hits& hits) const {
  const auto number = static_cast<std::size_t>(&face - faces_.data());
  const std::size_t n = face.normals.size();
  std::vector<int> sides;
  for (const LineVector* normal : face.normals) sides.push_back(arithmetic_.sign(line, *normal));
  bool meets = false;
  for (std::size_t k = 0; k < n; ++k) {
    if (sides[k] == 0) {
      meets = true;
      if (face.points[k] != kNone) {
        hits.hits.push_back({number, true, face.points[k]});
      } else {
        for (const std::size_t edge : {face.edges[(k + n - 1) % n], face.edges[k]}) {
          if (edge != kNone) hits.hits.push_back({number, false, edge});
        }
      }
    } else if (sides[k] * sides[(k + 1) % n] < 0) {
      meets = true;
      if (face.edges[k] != kNone) hits.hits.push_back({number, false, face.edges[k]});
    }
  }
  if (meets) hits.faces.push_back(number);
  return meets;
}

std::optional<Touch> ShaftFeatures::touch(const StabbingLine& line) const {
  Hits hits;
  hits.in_end_plane =
      arithmetic_.sign(line, *along_from_) == 0 || arithmetic_.sign(line, *along_to_) == 0;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    if (!hit(line, faces_[f], f < 2, hits)) return std::nullopt;
  }
  if (hits.in_end_plane) drop_beyond(line, hits);

  Touch touch;
  for (const Hits::Hit& hit : hits.hits) {
    if (hit.is_point) insert(touch.points, hit.feature);
  }
  for (const Hits::Hit& hit : hits.hits) {
    if (hit.is_point) continue;
    const auto& on_edge = edges_[hit.feature].points;
    const bool at_vertex = std::any_of(touch.points.begin(), touch.points.end(),
                                       [&](std::size_t p) { return contains(on_edge, p); });
    if (!at_vertex) insert(touch.edges, hit.feature);
  }
  for (const std::size_t p : crossings_) {
    const auto& crossed = points_[p].edges;
    const auto touched = std::count_if(crossed.begin(), crossed.end(), [&](std::size_t edge) {
      return contains(touch.edges, edge);
    });
    if (touched >= 2 && passes(line, p)) insert(touch.points, p);
  }
  touch.faces = std::move(hits.faces);
  for (const std::size_t p : touch.points) {
    for (const EdgePair& pair : points_[p].pairs) {
      if (arithmetic_.sign(line, *pair.plane) == 0) {
        touch.planes.push_back({p, pair.first, pair.second});
      }
    }
  }
  return touch;
}

/// In the plane of region or element, a line touches what lies from the first to the last of its
/// common points with both.
void ShaftFeatures::drop_beyond(const StabbingLine& line, Hits& hits) const {
  std::optional<Surd> first, last;
  for (std::size_t f = 0; f < 2; ++f) {
    for (const auto& point : ends(line, faces_[f])) {
      const Surd t = along(line, point);
      if (!first || t < *first) first = t;
      if (!last || t > *last) last = t;
    }
  }
  std::erase_if(hits.hits, [&](const Hits::Hit& hit) {
    const Surd t = along(
        line, hit.is_point ? surds(points_[hit.feature].x)
                           : touching_point(line, edges_[hit.feature].a, edges_[hit.feature].b));
    return t < *first || t > *last;
  });
  std::erase_if(hits.faces, [&](std::size_t face) {
    return std::none_of(hits.hits.begin(), hits.hits.end(),
                        [&](const Hits::Hit& hit) { return hit.face == face; });
  });
}

std::vector<std::array<Surd, 3>> ShaftFeatures::ends(const StabbingLine& line,
                                                     const FeatureFace& face) const {
  if (arithmetic_.sign(line, *face.lines[0]) != 0 || arithmetic_.sign(line, *face.lines[1]) != 0 ||
      arithmetic_.sign(line, *face.lines[2]) != 0) {
    return {meeting_point(line, face.plane)};
  }
  std::vector<std::array<Surd, 3>> result;
  const std::size_t n = face.normals.size();
  for (std::size_t k = 0; k < n; ++k) {
    const BigPoint &a = face.corners[k], &b = face.corners[(k + 1) % n];
    const int side = arithmetic_.sign(line, *face.normals[k]);
    if (side == 0) {
      result.push_back(surds(a));
    } else if (side * arithmetic_.sign(line, *face.normals[(k + 1) % n]) < 0) {
      result.push_back(touching_point(line, a, b));
    }
  }
  return result;
}

std::array<Surd, 3> ShaftFeatures::region_point(const StabbingLine& line) const {
  return ends(line, faces_[0]).front();
}
std::array<Surd, 3> ShaftFeatures::element_point(const StabbingLine& line) const {
  return ends(line, faces_[1]).front();
}

std::vector<std::size_t> ShaftFeatures::closed_edges(const Touch& touch) const {
  std::vector<std::size_t> result = touch.edges;
  for (const std::size_t p : touch.points) {
    for (const std::size_t edge : points_[p].edges) insert(result, edge);
  }
  return result;
}

std::vector<std::size_t> ShaftFeatures::distinct_edges(const Touch& touch) const {
  std::vector<std::size_t> result;
  for (const std::size_t edge : touch.edges) {
    const bool is_new = std::none_of(result.begin(), result.end(), [&](std::size_t other) {
      return edges_[other].line == edges_[edge].line;
    });
    if (is_new) result.push_back(edge);
  }
  return result;
}

std::vector<Generator> ShaftFeatures::generators(const Touch& touch) const {
  std::vector<Generator> result;
  for (const std::size_t p : touch.points) {
    if (points_[p].vertex) result.push_back(*points_[p].vertex);
  }
  for (const std::size_t edge : distinct_edges(touch)) result.push_back(edges_[edge].name);
  std::sort(result.begin(), result.end());
  return result;
}

Vector3<BigInteger> ShaftFeatures::plane_normal(std::size_t edge, const BigPoint& point) const {
  return offset_from(edges_[edge].components(), point.x, point.w);
}

/// A line that is pinned passes four edges or more, of faces that it may meet: two of the face of
/// each vertex, all of a face that it lies in; such a face counts once more, as a triangle with two
/// vertices on the line is enough.
bool ShaftFeatures::may_be_pinned(const Approximation<6, double>& line) const {
  std::size_t passed = 0;
  for (std::size_t f = 0; f < faces_.size(); ++f) {
    const FeatureFace& face = faces_[f];
    bool positive = false, negative = false;
    std::size_t unsure = 0;
    for (const LineVector* edge : face.lines) {
      const int side = LineArithmetic::certain_sign(line, *edge);
      positive |= side > 0;
      negative |= side < 0;
      unsure += side == 0;
      if (positive && negative) break;
    }
    if (positive && negative) {
      if (f < 2) return false;
      continue;
    }
    passed += unsure + (unsure == face.lines.size());
    if (unsure == 0 && f >= 2 && LineArithmetic::certain_sign(line, *along_from_) != 0 &&
        LineArithmetic::certain_sign(line, *along_to_) != 0) {
      return false;  // blocked, as are all lines near
    }
  }
  return passed >= 4;
}

/// Points on the line and planes that hold it pin it where two of either kind, or a plane and edges
/// that cross it in two points, are touched. What is left are edges that are pairwise skew: three
/// leave a regulus, and so do more of the same regulus; four others leave at most two lines.
bool ShaftFeatures::is_pinned(const Touch& touch) const {
  if (touch.points.size() >= 2) return true;
  std::vector<Vector3<BigInteger>> normals;
  const auto add_normal = [&](const Vector3<BigInteger>& normal) {
    const bool is_new = std::none_of(
        normals.begin(), normals.end(),
        [&](const Vector3<BigInteger>& other) { return is_zero(cross(other, normal)); });
    if (is_new) normals.push_back(normal);
  };
  std::vector<std::size_t> edges = distinct_edges(touch);
  if (touch.points.size() == 1) {
    const FeaturePoint& point = points_[touch.points[0]];
    for (const Touch::PinnedPlane& plane : touch.planes) {
      const LineComponents x = edges_[plane[1]].components(), y = edges_[plane[2]].components();
      add_normal(cross<BigInteger>({x[0], x[1], x[2]}, {y[0], y[1], y[2]}));
    }
    for (const std::size_t edge : edges) {
      if (!contains(point.edges, edge)) add_normal(plane_normal(edge, point.x));
    }
    return normals.size() >= 2;
  }
  std::optional<BigPoint> in_plane;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (!are_coplanar(edges[i], edges[j])) continue;
      const FeatureEdge& other = edges_[edges[j]];
      const auto normal = plane_normal(edges[i], other.a);
      add_normal(is_zero(normal) ? plane_normal(edges[i], other.b) : normal);
      in_plane = other.a;
    }
  }
  if (normals.size() >= 2) return true;
  if (normals.size() == 1) {
    const auto is_in = [&](const BigPoint& p) {
      return sign(in_plane->w * dot(normals[0], p.x) - p.w * dot(normals[0], in_plane->x)) == 0;
    };
    return std::count_if(edges.begin(), edges.end(), [&](std::size_t edge) {
             return !is_in(edges_[edge].a) || !is_in(edges_[edge].b);
           }) >= 2;
  }
  return edges.size() >= 4 && has_rank_four(edges);
}

/// By elimination without fractions.
bool ShaftFeatures::has_rank_four(std::span<const std::size_t> edges) const {
  std::vector<LineComponents> rows;
  for (const std::size_t edge : edges) rows.push_back(edges_[edge].components());
  std::size_t rank = 0;
  for (std::size_t column = 0; column < 6 && rank < rows.size(); ++column) {
    const auto pivot =
        std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(rank), rows.end(),
                     [&](const LineComponents& row) { return sign(row[column]) != 0; });
    if (pivot == rows.end()) continue;
    std::swap(*pivot, rows[rank]);
    for (std::size_t r = rank + 1; r < rows.size(); ++r) {
      const BigInteger factor = rows[r][column];
      if (sign(factor) == 0) continue;
      for (std::size_t k = column; k < 6; ++k) {
        rows[r][k] = rows[r][k] * rows[rank][column] - factor * rows[rank][k];
      }
    }
    if (++rank == 4) return true;
  }
  return false;
}

}  // namespace viewcover::exact
