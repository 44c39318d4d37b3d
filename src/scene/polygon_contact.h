#pragma once

#include <span>

#include "scene/types.h"

namespace viewcover {

/// True iff two convex planar polygons cut each other: each has corners strictly on both sides of
/// the other's plane, and the segments in which they meet the common line of the planes overlap in
/// more than a point. Touching is no cut, whether in a corner, along an edge or as coplanar
/// polygons.
///
/// Properties: (1) symmetric; (2) independent of the orientation of either; (3) decided exactly for
/// all finite doubles by `orientation` alone. Both must be strictly convex and exactly planar.
/// Cost: at most one `orientation` a corner and two more. Thread-safe.
bool cut_each_other(std::span<const Point> p, std::span<const Point> q);

/// True iff the polygon has a point inside the box; touching it from outside is not enough.
///
/// Decided exactly for all finite doubles: the polygon stays outside iff one of the planes of the
/// box, its own plane, or a plane through one of its edges and parallel to an axis is between the
/// two. It must be strictly convex and exactly planar, the box have a volume.
/// Cost: at most 8 `orientation` and 12 `turn` an edge. Thread-safe.
bool enters_box(std::span<const Point> polygon, const Box& box);

/// True iff some point of `p` and some point of `q` are less than `distance` apart.
///
/// Decided exactly (rational numbers) for all finite doubles; polygons that meet are 0 apart.
/// Both must be strictly convex and planar, `distance` finite and not negative.
/// Cost: a few ns where bounding boxes or corners decide, else about 0.1 ms a pair of triangles
/// (a polygon counts as the triangles of its fan).
/// Thread-safe.
bool is_nearer_than(std::span<const Point> p, std::span<const Point> q, double distance);

}  // namespace viewcover
