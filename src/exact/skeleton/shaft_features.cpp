#include "exact/skeleton/shaft_features.h"

#include <algorithm>

#include "exact/skeleton/sorted_lists.h"

namespace viewcover::exact {
namespace {

std::array<BigInteger, 4> key(const BigPoint& p) { return {p.x[0], p.x[1], p.x[2], p.w}; }

BigPoint primitive(const BigPoint& p) {
  std::array<BigInteger, 4> all = key(p);
  make_primitive(all);
  return {{all[0], all[1], all[2]}, all[3]};
}

}  // namespace

NamedPolygon NamedPolygon::clipped(const BigPlane& by, Generator::Cut cut) const {
  NamedPolygon result{name, plane, {}, {}, {}};
  std::optional<Generator> new_edge;
  if (cut != Generator::Cut::kNone) new_edge = {name, Generator::Feature::kEdge, cut, 0};
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const BigPoint &a = corners[i], &b = corners[(i + 1) % n];
    const BigInteger at_a = by.value(a), at_b = by.value(b);
    if (sign(at_a) >= 0) {
      result.corners.push_back(a);
      result.corner_names.push_back(corner_names[i]);
      const bool leaves_here = sign(at_a) == 0 && sign(at_b) < 0;
      result.edge_names.push_back(leaves_here ? new_edge : edge_names[i]);
    }
    if (sign(at_a) * sign(at_b) >= 0) continue;
    BigPoint meeting;
    const int s = sign(at_a);
    for (std::size_t k = 0; k < 3; ++k) meeting.x[k] = at_a * b.x[k] - at_b * a.x[k];
    meeting.w = at_a * b.w - at_b * a.w;
    if (s < 0) meeting = {-meeting.x, -meeting.w};
    result.corners.push_back(primitive(meeting));
    auto& corner_name = result.corner_names.emplace_back();
    if (new_edge && edge_names[i]) {
      corner_name = {name, Generator::Feature::kVertex, cut, edge_names[i]->index};
    }
    result.edge_names.push_back(s > 0 ? new_edge : edge_names[i]);
  }
  return result;
}

ShaftFeatures::ShaftFeatures(LineArithmetic& arithmetic, NamedPolygon region, NamedPolygon element,
                             std::span<const NamedPolygon> occluders, BigPlane from, BigPlane to)
    : arithmetic_(arithmetic),
      from_(std::move(from)),
      to_(std::move(to)),
      along_from_(of_direction(from_.normal)),
      along_to_(of_direction(to_.normal)) {
  const auto inside = [](const NamedPolygon& polygon, const BigPlane& plane, Generator::Cut cut) {
    return Sides::of<BigInteger>(plane, polygon.corners).back ? polygon.clipped(plane, cut)
                                                              : polygon;
  };
  add_face(inside(region, to_, Generator::Cut::kNone));
  add_face(inside(element, from_, Generator::Cut::kNone));
  for (const NamedPolygon& occluder : occluders) {
    add_face(inside(inside(occluder, from_, Generator::Cut::kRegionPlane), to_,
                    Generator::Cut::kElementPlane));
  }
  find_incidences();
  find_crossings();
  add_pairs();
}

std::size_t ShaftFeatures::add_point(const BigPoint& point, const std::optional<Generator>& name) {
  const auto [place, is_new] = point_at_.try_emplace(key(point), points_.size());
  if (!is_new) return place->second;
  FeaturePoint& added = points_.emplace_back();
  added.x = point;
  added.vertex = name;
  for (std::size_t k = 0; k < 3; ++k) {
    Vector3<BigInteger> axis = {BigInteger(0), BigInteger(0), BigInteger(0)};
    axis[k] = BigInteger(1);
    const auto m = cross(point.x, axis), d = point.w * axis;
    added.star[k] = functional({d[0], d[1], d[2], m[0], m[1], m[2]});
  }
  return place->second;
}

std::size_t ShaftFeatures::add_edge(const BigPoint& a, const BigPoint& b, const Generator& name) {
  std::array<PointKey, 2> ends = {key(a), key(b)};
  if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);
  const auto [place, is_new] = edge_between_.try_emplace(ends, edges_.size());
  if (!is_new) return place->second;
  FeatureEdge& added = edges_.emplace_back();
  added.a = a;
  added.b = b;
  added.name = name;
  LineComponents line = added.components();
  added.functional = functional(line);
  added.ray = arithmetic_.pool().add(Role::kRay, line);
  make_primitive(line);
  const auto first =
      std::find_if(line.begin(), line.end(), [](const BigInteger& x) { return sign(x) != 0; });
  if (sign(*first) < 0) {
    for (BigInteger& x : line) x = -x;
  }
  added.line = line_numbers_.try_emplace(line, line_numbers_.size()).first->second;
  return place->second;
}

void ShaftFeatures::add_face(const NamedPolygon& polygon) {
  FeatureFace face{polygon.name, polygon.plane, polygon.corners, {}, {}, {}, {}};
  const std::size_t n = polygon.corners.size();
  for (std::size_t k = 0; k < n; ++k) {
    const BigPoint &a = polygon.corners[k], &b = polygon.corners[(k + 1) % n];
    face.points.push_back(polygon.corner_names[k] ? add_point(a, polygon.corner_names[k]) : kNone);
    face.edges.push_back(polygon.edge_names[k] ? add_edge(a, b, *polygon.edge_names[k]) : kNone);
    face.lines.push_back(functional(line_through(a, b)));
    const auto m = cross(a.x, face.plane.normal), d = a.w * face.plane.normal;
    face.normals.push_back(functional({d[0], d[1], d[2], m[0], m[1], m[2]}));
  }
  faces_.push_back(std::move(face));
}

const LineVector* ShaftFeatures::functional(const LineComponents& line) const {
  return arithmetic_.pool().add(
      Role::kFunctional, LineComponents{line[3], line[4], line[5], line[0], line[1], line[2]});
}

const LineVector* ShaftFeatures::of_direction(const Vector3<BigInteger>& normal) const {
  const BigInteger zero(0);
  return arithmetic_.pool().add(Role::kFunctional,
                                LineComponents{normal[0], normal[1], normal[2], zero, zero, zero});
}

bool ShaftFeatures::is_on(std::size_t edge, const BigPoint& point) const {
  const FeatureEdge& e = edges_[edge];
  if (!is_zero(offset_from(e.components(), point.x, point.w))) return false;
  const auto to_a = e.a.w * point.x - point.w * e.a.x, to_b = e.b.w * point.x - point.w * e.b.x;
  return sign(dot(to_a, to_b)) <= 0;
}

void ShaftFeatures::find_incidences() {
  LinePool& pool = arithmetic_.pool();
  for (std::size_t p = 0; p < points_.size(); ++p) {
    const auto& star = points_[p].star;
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      const bool is_on_line = std::all_of(star.begin(), star.end(), [&](const LineVector* line) {
        return pool.sign_of_product(*line, *edges_[e].ray) == 0;
      });
      if (!is_on_line || !is_on(e, points_[p].x)) continue;
      points_[p].edges.push_back(e);
      edges_[e].points.push_back(p);
    }
  }
}

void ShaftFeatures::find_crossings() {
  LinePool& pool = arithmetic_.pool();
  const std::size_t n = edges_.size();
  coplanar_.assign(n * n, true);
  for (std::size_t e = 0; e < n; ++e) {
    for (std::size_t f = 0; f < e; ++f) {
      const FeatureEdge &first = edges_[e], &second = edges_[f];
      coplanar_[e * n + f] = coplanar_[f * n + e] =
          pool.sign_of_product<3>(*first.ray, *second.ray) == 0;
      if (first.line == second.line || !are_coplanar(e, f)) continue;
      const LineComponents line = second.components();
      const auto at_a = offset_from(line, first.a.x, first.a.w),
                 at_b = offset_from(line, first.b.x, first.b.w);
      // Both offsets are multiples of one vector, the plane's normal.
      const std::size_t k = sign(at_a[0]) != 0 || sign(at_b[0]) != 0   ? 0
                            : sign(at_a[1]) != 0 || sign(at_b[1]) != 0 ? 1
                                                                       : 2;
      if (sign(at_a[k]) * sign(at_b[k]) >= 0) continue;
      BigPoint x;
      for (std::size_t i = 0; i < 3; ++i) x.x[i] = at_a[k] * first.b.x[i] - at_b[k] * first.a.x[i];
      x.w = at_a[k] * first.b.w - at_b[k] * first.a.w;
      if (sign(x.w) < 0) x = {-x.x, -x.w};
      x = primitive(x);
      if (!is_on(f, x)) continue;
      const std::size_t count = points_.size();
      const std::size_t p = add_point(x, std::nullopt);
      if (points_[p].vertex) continue;  // found with the incidences
      if (points_.size() > count) crossings_.push_back(p);
      for (const std::size_t edge : {e, f}) {
        insert(points_[p].edges, edge);
        insert(edges_[edge].points, p);
      }
    }
  }
}

void ShaftFeatures::add_pairs() {
  for (FeaturePoint& point : points_) {
    for (std::size_t i = 0; i < point.edges.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const FeatureEdge &first = edges_[point.edges[j]], &second = edges_[point.edges[i]];
        if (first.line == second.line) continue;
        const LineComponents x = first.components(), y = second.components();
        const auto normal = cross<BigInteger>({x[0], x[1], x[2]}, {y[0], y[1], y[2]});
        point.pairs.push_back({point.edges[j], point.edges[i], of_direction(normal)});
      }
    }
  }
}

}  // namespace viewcover::exact
