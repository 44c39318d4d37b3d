#pragma once

#include <span>

#include "audit/flat_polygon.h"
#include "exact/integer_geometry.h"
#include "scene/convex_polygon.h"

namespace viewcover {

/// Points in integers: multiples of a power of two in all axes. Exact.
using exact::BigInteger;
using exact::IntegerFrame;
using IntegerPoint = exact::Vector3<BigInteger>;

/// The exponent of the power of two that is a frame's unit.
inline int unit_exponent(const IntegerFrame& frame) { return frame.unit_exponent() - frame.bits(); }

/// n . x = offset.
struct SpacePlane {
  IntegerPoint normal;
  BigInteger offset;

  /// Through three points on no line.
  SpacePlane(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& c);
  SpacePlane(IntegerPoint n, BigInteger d) : normal(std::move(n)), offset(std::move(d)) {}
};

/// The plane of a surface, seen along the axis nearest to its normal: polygons in it as flat ones.
/// Coordinates are in units of a scene's frame.
class SurfacePlane {
 public:
  SurfacePlane(const IntegerFrame& frame, std::span<const Point> surface);

  /// Of a polygon in this plane.
  flat::FlatPolygon flat(std::span<const Point> polygon) const;
  /// Back to scene units, rounded.
  ConvexPolygon lifted(const flat::FlatPolygon& polygon) const;
  /// The plane, its normal toward the front of the surface.
  SpacePlane plane() const;
  /// Where another plane, not parallel to this one, meets it; positive on that plane's front side.
  flat::FlatLine meet(const SpacePlane& other) const;

 private:
  std::size_t axis_, u_, v_;
  IntegerFrame frame_;
  SpacePlane plane_;       // normal[axis_] > 0
  bool reversed_ = false;  // against the surface's
};

}  // namespace viewcover
