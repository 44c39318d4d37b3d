#pragma once

#include <array>
#include <span>
#include <vector>

#include "scene/convex_polygon.h"
#include "scene/types.h"

namespace viewcover {

/// What had to be done to a face.
enum class FaceKind {
  kWhole,         ///< strictly convex and planar: one part
  kSplit,         ///< planar, concave or keyholed: split into convex parts
  kTriangulated,  ///< not planar: triangulated, triangles in one plane joined
  kDegenerate,    ///< no area: no part
  kCrossing,      ///< crosses itself: no part, as its area is in doubt
};

struct ConvexParts {
  FaceKind kind = FaceKind::kDegenerate;
  /// Strictly convex, exactly planar, oriented like the face; their interiors are disjoint and
  /// their union is the face.
  std::vector<ConvexPolygon> polygons;
};

/// The loop without repeated corners and without corners on the line through their neighbours
/// (straight on or back along the same edge). Fewer than 3 corners are left iff all lie on a line.
std::vector<Point> without_straight_corners(std::span<const Point> loop);

/// Splits a face, given as one loop of exact doubles, into convex parts.
///
/// Planar loops: an edge walked an even number of times (the bridge to a hole) is no boundary, the
/// inside lies across an odd number of boundary edges from the outside. The inside is triangulated
/// (CGAL, constrained Delaunay) and the triangles are joined again into convex polygons (Hertel
/// and Mehlhorn 1983). A loop may touch itself. Loops that are not planar are triangulated in the
/// first coordinate projection, that along the largest component of the area vector first, in
/// which they do not cross themselves.
///
/// Guarantees, all exact: parts are strictly convex and planar; in the projection the signed areas
/// of the parts add up to that of the loop (a loop for which they do not is kCrossing: parts of it
/// would be covered twice or backwards); no corners are added.
/// Cost: O(n log n) typical. Thread-safe.
ConvexParts convex_parts(std::span<const Point> loop);

/// The same for a face with holes: loops in one plane whose inside is to the left of each, seen
/// from where the first is walked counter-clockwise. Loops that do not lie exactly in the plane of
/// the first, or that cross each other: kCrossing.
ConvexParts convex_parts(std::span<const std::vector<Point>> loops);

/// Triangles of a face, oriented like it, that have `points` beside its inside as vertices and
/// `segments` between them and corners as edges. None if there are no such triangles in the
/// projection along the largest component of the area vector.
std::vector<std::array<Point, 3>> triangles_through(std::span<const Point> loop,
                                                    std::span<const Point> points,
                                                    std::span<const std::array<Point, 2>> segments);

}  // namespace viewcover
