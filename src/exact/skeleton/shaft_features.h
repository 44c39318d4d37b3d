#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "exact/skeleton/skeleton.h"
#include "exact/skeleton/stabbing_line.h"

namespace viewcover::exact {

inline constexpr std::size_t kNone = static_cast<std::size_t>(-1);

using BigPoint = HomogeneousPoint<BigInteger>;
using BigPlane = IntegerPlane<BigInteger>;

/// A polygon and what its corners and edges are called; no name where a cut that does not count
/// made them.
struct NamedPolygon {
  PolygonName name;
  BigPlane plane;
  std::vector<BigPoint> corners;
  std::vector<std::optional<Generator>> corner_names, edge_names;

  /// The part in front of a plane, closed. Requires corners in front. What the plane makes is
  /// called after `cut`, or has no name if that is kNone.
  NamedPolygon clipped(const BigPlane& by, Generator::Cut cut) const;
};

/// Two edges through one point; the line lies in their plane iff `plane` is 0 on it.
struct EdgePair {
  std::size_t first, second;
  const LineVector* plane;
};

/// A point that pins lines: a vertex, or where edges of different polygons cross.
struct FeaturePoint {
  BigPoint x;
  std::optional<Generator> vertex;
  std::array<const LineVector*, 3> star{};  ///< a line passes through the point iff all are 0
  std::vector<std::size_t> edges;           ///< that contain the point, sorted
  std::vector<EdgePair> pairs;              ///< of those on different lines
};

struct FeatureEdge {
  BigPoint a, b;
  Generator name;
  const LineVector* functional = nullptr;
  const LineVector* ray = nullptr;
  std::size_t line = 0;  ///< the same for all edges on one line
  std::vector<std::size_t> points;

  LineComponents components() const { return line_through(a, b); }
};

struct FeatureFace {
  PolygonName name;
  BigPlane plane;
  std::vector<BigPoint> corners;
  std::vector<std::size_t> points, edges;  ///< of corners and edges, kNone where they do not count
  /// Through the edges, and through the corners along the normal.
  std::vector<const LineVector*> lines, normals;
};

/// What a line touches.
struct Touch {
  /// A point and two edges through it whose plane holds the line.
  using PinnedPlane = std::array<std::size_t, 3>;

  std::vector<std::size_t> points;  ///< vertices and crossings, sorted
  std::vector<std::size_t> edges;   ///< between their ends and away from vertices, sorted
  std::vector<std::size_t> faces;   ///< that hold the line
  std::vector<PinnedPlane> planes;

  friend bool operator==(const Touch&, const Touch&) = default;
};

/// Everything that lines between one side of the region and one side of the element can touch:
/// region and element cut at each other's planes, and occluders that block lines between them, cut
/// at both.
class ShaftFeatures {
 public:
  /// `from` and `to` are the planes of region and element, element and region in front.
  ShaftFeatures(LineArithmetic& arithmetic, NamedPolygon region, NamedPolygon element,
                std::span<const NamedPolygon> occluders, BigPlane from, BigPlane to);

  const std::vector<FeaturePoint>& points() const { return points_; }
  const std::vector<FeatureEdge>& edges() const { return edges_; }
  const std::vector<FeatureFace>& faces() const { return faces_; }
  const std::vector<std::size_t>& crossings() const { return crossings_; }
  const BigPlane& from() const { return from_; }
  const BigPlane& to() const { return to_; }

  /// What a line from region to element touches between them. None if it misses one of them, or if
  /// an occluder certainly blocks all lines near it.
  std::optional<Touch> touch(const StabbingLine& line) const;
  /// False only if a line certainly is not pinned, or no limit of free lines. Looks at signs that
  /// are certain for the rounded line. May be wrong for lines that the crossing of two edges and
  /// the plane of these edges pin.
  bool may_be_pinned(const Approximation<6, double>& line) const;
  /// Is a line the only one near it that touches the same?
  bool is_pinned(const Touch& touch) const;
  /// Edges that contain touched points, and touched edges.
  std::vector<std::size_t> closed_edges(const Touch& touch) const;
  /// What a line touches of the edges, without repetitions of their lines.
  std::vector<std::size_t> distinct_edges(const Touch& touch) const;
  std::vector<Generator> generators(const Touch& touch) const;

  /// Are two edges in one plane?
  bool are_coplanar(std::size_t edge, std::size_t other) const {
    return coplanar_[edge * edges_.size() + other];
  }
  /// Directs a line from region to element. False if it lies in both planes: then either may do.
  bool direct(StabbingLine& line) const;

  /// A point of region and of element on the line.
  std::array<Surd, 3> region_point(const StabbingLine& line) const;
  std::array<Surd, 3> element_point(const StabbingLine& line) const;

 private:
  struct Hits;

  std::size_t add_point(const BigPoint& point, const std::optional<Generator>& name);
  std::size_t add_edge(const BigPoint& a, const BigPoint& b, const Generator& name);
  void add_face(const NamedPolygon& polygon);
  void find_incidences();
  void find_crossings();
  void add_pairs();
  const LineVector* functional(const LineComponents& line) const;
  const LineVector* of_direction(const Vector3<BigInteger>& normal) const;
  bool is_on(std::size_t edge, const BigPoint& point) const;
  bool passes(const StabbingLine& line, std::size_t point) const;

  bool hit(const StabbingLine& line, const FeatureFace& face, bool must_meet, Hits& hits) const;
  bool hit_in_plane(const StabbingLine& line, const FeatureFace& face, Hits& hits) const;
  void drop_beyond(const StabbingLine& line, Hits& hits) const;
  /// Where a line meets a face, or its ends there if it lies in the plane.
  std::vector<std::array<Surd, 3>> ends(const StabbingLine& line, const FeatureFace& face) const;
  Vector3<BigInteger> plane_normal(std::size_t edge, const BigPoint& point) const;
  bool has_rank_four(std::span<const std::size_t> edges) const;

  LineArithmetic& arithmetic_;
  BigPlane from_, to_;
  const LineVector* along_from_;  ///< direction . normal
  const LineVector* along_to_;
  std::vector<FeaturePoint> points_;
  std::vector<FeatureEdge> edges_;
  std::vector<FeatureFace> faces_;  ///< region, element, occluders
  std::vector<std::size_t> crossings_;
  std::vector<bool> coplanar_;  // #edges x #edges
  using PointKey = std::array<BigInteger, 4>;
  std::map<PointKey, std::size_t> point_at_;
  std::map<std::array<PointKey, 2>, std::size_t> edge_between_;
  std::map<LineComponents, std::size_t> line_numbers_;
};

}  // namespace viewcover::exact
