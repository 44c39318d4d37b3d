#pragma once

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "scene/convex_polygon.h"
#include "support/scenes.h"

namespace viewcover::testing {

using Polygons = std::vector<ConvexPolygon>;

/// The size of most cases, in units.
inline constexpr double kS = 0x1p18;

struct Flat {
  double u, v;
};
using Flats = std::vector<Flat>;

inline Polygons joined(std::initializer_list<Polygons> lists) {
  Polygons all;
  for (const Polygons& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

inline ConvexPolygon flipped(const ConvexPolygon& polygon) {
  return ConvexPolygon(polygon.rbegin(), polygon.rend());
}

/// Corners (u, v, z).
inline ConvexPolygon level(double z, const Flats& corners) {
  ConvexPolygon polygon;
  for (const Flat& c : corners) polygon.emplace_back(c.u, c.v, z);
  return polygon;
}

inline ConvexPolygon square(double half_side, double z) {
  return horizontal(-half_side, -half_side, half_side, half_side, z);
}

inline ConvexPolygon octagon(double a, double b, double z) {
  return level(z, {{a, -b}, {a, b}, {b, a}, {-b, a}, {-a, b}, {-a, -b}, {-b, -a}, {b, -a}});
}

inline ConvexPolygon pentagon(double scale, double z) {
  return level(z, {{0, 3 * scale},
                   {-3 * scale, scale},
                   {-2 * scale, -2 * scale},
                   {2 * scale, -2 * scale},
                   {3 * scale, scale}});
}

/// In the plane x = const, facing +x.
inline ConvexPolygon upright_x(double x, double y0, double z0, double y1, double z1) {
  return {{x, y0, z0}, {x, y1, z0}, {x, y1, z1}, {x, y0, z1}};
}

/// In the plane y = const, facing -y.
inline ConvexPolygon upright_y(double y, double x0, double z0, double x1, double z1) {
  return {{x0, y, z0}, {x1, y, z0}, {x1, y, z1}, {x0, y, z1}};
}

/// The rectangle over the segment ab of the profile (u = x, v = z), for y in [y0, y1].
inline ConvexPolygon slat(Flat a, Flat b, double y0, double y1) {
  return {{a.u, y0, a.v}, {b.u, y0, b.v}, {b.u, y1, b.v}, {a.u, y1, a.v}};
}

/// Slats over the segments of a polyline in the profile.
inline Polygons chain(const Flats& profile, double y0, double y1) {
  Polygons slats;
  for (std::size_t i = 1; i < profile.size(); ++i) {
    slats.push_back(slat(profile[i - 1], profile[i], y0, y1));
  }
  return slats;
}

/// square(half, z) cut along x at the given places.
inline Polygons cut_square(double half, double z, const std::vector<double>& cuts) {
  Polygons pieces;
  double last = -half;
  for (const double x : cuts) {
    pieces.push_back(horizontal(last, -half, x, half, z));
    last = x;
  }
  pieces.push_back(horizontal(last, -half, half, half, z));
  return pieces;
}

/// square(half, z) but for the open strip x in (from, to).
inline Polygons slit_x(double half, double z, double from, double to) {
  return {horizontal(-half, -half, from, half, z), horizontal(to, -half, half, half, z)};
}

/// square(half, z) but for the open strip y in (from, to).
inline Polygons slit_y(double half, double z, double from, double to) {
  return {horizontal(-half, -half, half, from, z), horizontal(-half, to, half, half, z)};
}

/// square(outer, z) but for the open square of half side `inner`, in four pieces.
inline Polygons frame(double outer, double inner, double z) {
  return {horizontal(-outer, -outer, -inner, outer, z), horizontal(inner, -outer, outer, outer, z),
          horizontal(-inner, -outer, inner, -inner, z), horizontal(-inner, inner, inner, outer, z)};
}

/// The triangles hub, v_i, v_i+1.
inline Polygons fan(const Point& hub, const ConvexPolygon& loop) {
  Polygons triangles;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    triangles.push_back({hub, loop[i], loop[(i + 1) % loop.size()]});
  }
  return triangles;
}

/// The four upright sides of a box.
inline Polygons tube(const Point& low, const Point& high) {
  return {upright_x(low.x(), low.y(), low.z(), high.y(), high.z()),
          upright_x(high.x(), low.y(), low.z(), high.y(), high.z()),
          upright_y(low.y(), low.x(), low.z(), high.x(), high.z()),
          upright_y(high.y(), low.x(), low.z(), high.x(), high.z())};
}

/// All six sides: the four of `tube`, the floor, the ceiling.
inline Polygons box(const Point& low, const Point& high) {
  Polygons sides = tube(low, high);
  for (const double z : {low.z(), high.z()}) {
    sides.push_back(horizontal(low.x(), low.y(), high.x(), high.y(), z));
  }
  return sides;
}

inline Polygons without(Polygons polygons, std::size_t index) {
  polygons.erase(polygons.begin() + static_cast<std::ptrdiff_t>(index));
  return polygons;
}

inline Polygons repeated(const Polygons& polygons, int times) {
  Polygons all;
  for (int i = 0; i < times; ++i) all.insert(all.end(), polygons.begin(), polygons.end());
  return all;
}

}  // namespace viewcover::testing
