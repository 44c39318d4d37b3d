#include "audit/surface_plane.h"

#include <cmath>

namespace viewcover {

using exact::cross;
using exact::dot;
using exact::operator-;
using flat::FlatLine;
using flat::FlatPoint;
using flat::FlatPolygon;

SpacePlane::SpacePlane(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c)
    : normal(cross(b - a, c - a)), offset(dot(normal, a)) {
  std::array<BigInteger, 4> all = {normal[0], normal[1], normal[2], offset};
  exact::make_primitive(all);
  normal = {all[0], all[1], all[2]};
  offset = all[3];
}

SurfacePlane::SurfacePlane(const IntegerFrame& frame, std::span<const Point> surface)
    : axis_(static_cast<std::size_t>(projection_axis(surface))),
      u_((axis_ + 1) % 3),
      v_((axis_ + 2) % 3),
      frame_(frame),
      plane_(frame.operator()<BigInteger>(surface[0]), frame.operator()<BigInteger>(surface[1]),
             frame.operator()<BigInteger>(surface[2])) {
  if (exact::sign(plane_.normal[axis_]) < 0) {
    reversed_ = true;
    plane_ = {-plane_.normal, -plane_.offset};
  }
}

SpacePlane SurfacePlane::plane() const {
  if (reversed_) return {-plane_.normal, -plane_.offset};
  return plane_;
}

FlatPolygon SurfacePlane::flat(std::span<const Point> polygon) const {
  IntegerFrame finer = frame_;
  finer.include(polygon);
  BigInteger weight;
  mpz_setbit(weight.mpz(), static_cast<mp_bitcnt_t>(unit_exponent(frame_) - unit_exponent(finer)));
  std::vector<FlatPoint> corners;
  corners.reserve(polygon.size());
  for (const Point& point : polygon) {
    const IntegerPoint x = finer.operator()<BigInteger>(point);
    corners.emplace_back(x[u_], x[v_], weight);
  }
  return FlatPolygon(std::move(corners));
}

ConvexPolygon SurfacePlane::lifted(const FlatPolygon& polygon) const {
  ConvexPolygon result;
  const IntegerPoint& n = plane_.normal;
  for (const FlatPoint& p : polygon.corners()) {
    const BigInteger height = plane_.offset * p.w - n[u_] * p.u - n[v_] * p.v;
    Point& corner = result.emplace_back();
    corner[static_cast<Eigen::Index>(u_)] = p.near_u;
    corner[static_cast<Eigen::Index>(v_)] = p.near_v;
    corner[static_cast<Eigen::Index>(axis_)] = flat::quotient(height, n[axis_] * p.w);
    for (double& x : corner) x = std::ldexp(x, unit_exponent(frame_));
  }
  return result;
}

FlatLine SurfacePlane::meet(const SpacePlane& other) const {
  // On this plane x_axis = (offset - n_u u - n_v v) / n_axis; the other's value times n_axis > 0.
  const IntegerPoint &n = plane_.normal, &m = other.normal;
  using flat::minor;
  return {minor(m[u_], n[axis_], m[axis_], n[u_]), minor(m[v_], n[axis_], m[axis_], n[v_]),
          minor(m[axis_], plane_.offset, other.offset, n[axis_])};
}

}  // namespace viewcover
