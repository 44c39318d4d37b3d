#pragma once

#include <array>
#include <span>
#include <vector>

#include "scene/address.h"
#include "scene/small_list.h"
#include "scene/types.h"

namespace viewcover {

/// A strictly convex planar polygon: at least 3 corners in order round the boundary, no three
/// consecutive ones on a line. The front is the side from which they run counter-clockwise.
using ConvexPolygon = SmallList<Point, 4>;

/// Twice the area times the unit normal (towards the front), by Newell's sum; for any loop.
Point area_vector(std::span<const Point> loop);
/// In scene units squared. Rounded; relative error a few units in the last place.
double area(std::span<const Point> loop);
/// Mean of the corners, rounded: a point inside a convex polygon, not its centre of mass.
Point corner_mean(std::span<const Point> loop);
/// Centre of mass of a convex polygon, rounded.
Point centroid(std::span<const Point> polygon);
Box bounding_box(std::span<const Point> points);
/// Number k with the greater x, y and z where bits 0, 1 and 2 of k are set.
std::array<Point, 8> box_corners(const Box& box);

/// The axis (0, 1, 2) along which the polygon's normal is largest; projecting along it keeps
/// lattice coordinates and never makes the polygon degenerate.
int projection_axis(std::span<const Point> loop);

/// True iff all corners lie in one plane, decided exactly. Requires a non-degenerate loop.
bool is_planar(std::span<const Point> loop);
/// True iff the planar loop is simple and every corner turns the same strict way, decided exactly.
bool is_strictly_convex(std::span<const Point> loop);

/// The corners at which the loop does not run straight on, as places in it; decided exactly.
std::vector<std::size_t> turning_corners(std::span<const Point> loop);

/// The four quarters of a polygon by exact midpoints (1 further bit a coordinate and level for
/// triangles and parallelograms, 2 for other quadrilaterals). They tile the polygon and are
/// strictly convex, oriented like it.
///  - triangle: three corner triangles, then the middle one
///  - quadrilateral: the quarter at each corner; edge midpoints and the mean of the corners
///  - more corners: cut twice by diagonals into halves of nearly equal corner count; a half that
///    is down to 3 or 4 corners is cut through edge midpoints
std::array<ConvexPolygon, 4> quarters(const ConvexPolygon& polygon);

/// The node of the quadtree over `root` that `address` names. Cost: one `quarters` a level.
template <class Owner>
ConvexPolygon subdivided(const ConvexPolygon& root, QuadAddress<Owner> address) {
  ConvexPolygon polygon = root;
  for (int depth = 0; depth < address.level(); ++depth) {
    polygon = quarters(polygon)[static_cast<std::size_t>(address.digit(depth))];
  }
  return polygon;
}

}  // namespace viewcover
