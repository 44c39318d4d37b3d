#pragma once

#include <optional>
#include <vector>

#include "viewpoints/region_views.h"
#include "viewpoints/viewpoint.h"

namespace viewcover {

/// Where few images often have to be taken from: corners of the viewing region, and crossings of
/// the lines in which planes of surfaces cut it. In a gallery these are its vertices and the
/// crossings of its extended edges, where guards of smallest sets tend to stand.
///
/// Positions that would touch a surface are moved off it by a millionth of a region, into each of
/// the regions that meet there.
/// Immutable, safe to share.
class SpecialPositions {
 public:
  explicit SpecialPositions(const RegionViews& views);

  /// At the corners of the parts of the viewing region.
  std::vector<Viewpoint> corners() const;
  /// On the lines nearest to a position, at their crossings, and in the middle of the triangles
  /// between them. Ascending by distance.
  std::vector<Viewpoint> near(const Viewpoint& viewpoint) const;
  /// Just beside a position, all round: off the planes that hold it, whose surfaces are not seen
  /// from there.
  std::vector<Viewpoint> beside(const Viewpoint& viewpoint) const;

 private:
  /// The line of points x in a part's plane with normal . x = offset.
  struct Line {
    Point normal;  ///< in the plane, of length 1
    double offset = 0;
  };

  static std::optional<Point> crossing(const Line& a, const Line& b, const Point& from,
                                       const Point& up);
  /// Positions at a point in all regions that hold it, but for rounding.
  void add_at(const Point& point, std::vector<Viewpoint>& positions) const;

  const RegionViews& views_;
  double extent_ = 0;
  std::vector<Box> boxes_;                ///< by region, with a margin
  std::vector<std::vector<Line>> lines_;  ///< by part
};

}  // namespace viewcover
