#pragma once

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "viewpoints/region_views.h"
#include "viewpoints/viewpoint.h"

namespace viewcover {

/// Where few images often have to be taken from: corners of the viewing region, and crossings of
/// the lines in which planes of surfaces cut it, in a box of those planes. In a gallery these are
/// its vertices and the crossings of its extended edges, where guards of smallest sets tend to
/// stand.
///
/// Positions that would touch a surface are moved off it by a millionth of a region, into each of
/// the regions that meet there.
/// Immutable, safe to share.
class SpecialPositions {
 public:
  explicit SpecialPositions(const RegionViews& views);

  /// At the corners of the polygons and boxes of the viewing region.
  std::vector<Viewpoint> corners() const;
  /// On the lines nearest to a position, at their crossings, and in the middle of the triangles
  /// between them; in a box on the nearest planes, on their common lines and at their crossings.
  /// Ascending by distance.
  std::vector<Viewpoint> near(const Viewpoint& viewpoint) const;
  /// Just beside a position, all round: off the planes that hold it, whose surfaces are not seen
  /// from there.
  std::vector<Viewpoint> beside(const Viewpoint& viewpoint) const;

 private:
  /// The points x with normal . x = offset: in a box a plane, in a polygon's plane, if the normal
  /// is in it, a line.
  struct Line {
    Point normal;  ///< of length 1
    double offset = 0;

    double distance(const Point& x) const { return std::fabs(normal.dot(x) - offset); }
  };

  static std::optional<Point> crossing(const Line& a, const Line& b, const Point& from,
                                       const Point& up);
  void remove_repeated(std::vector<Line>& lines) const;
  static std::vector<Point> near_in_polygon(std::span<const Line> lines, const Point& from,
                                            const Point& up);
  static std::vector<Point> near_in_box(std::span<const Line> planes, const Point& from);
  /// Positions at a point in all regions that hold it, but for rounding.
  void add_at(const Point& point, std::vector<Viewpoint>& positions) const;

  const RegionViews& views_;
  double extent_ = 0;
  std::vector<Box> boxes_;                ///< by region, with a margin
  std::vector<std::vector<Line>> lines_;  ///< by polygon
  std::vector<Line> planes_;              ///< of surfaces, if there are boxes
};

}  // namespace viewcover
