#pragma once

#include <array>
#include <boost/graph/adjacency_list.hpp>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "exact/sight_query.h"

namespace viewcover {

/// One of the polygons of a query.
struct PolygonName {
  enum class Role : std::uint8_t { kRegion, kElement, kOccluder };

  Role role = Role::kRegion;
  std::size_t number = 0;  ///< of an occluder

  friend auto operator<=>(const PolygonName&, const PolygonName&) = default;
};

/// A corner or an edge that lines touch.
///
/// An occluder that reaches through the plane of the region or the element counts only on the side
/// where the shaft is: the edge along which that plane cuts it, and the ends of that edge, are
/// generators as well.
struct Generator {
  enum class Feature : std::uint8_t { kVertex, kEdge };
  enum class Cut : std::uint8_t { kNone, kRegionPlane, kElementPlane };

  PolygonName polygon;
  Feature feature = Feature::kVertex;
  Cut cut = Cut::kNone;
  /// Corner i, or the edge from corner i to the next one, as the query numbers them; corners within
  /// edges are none. Of a vertex made by a cut: the edge that was cut. 0 for an edge made by a cut.
  std::size_t index = 0;

  friend auto operator<=>(const Generator&, const Generator&) = default;
};

/// a + b sqrt(root); rationals as text, "-3/7" or "5". b is 0 or root is not a square.
struct RootNumber {
  std::string a = "0", b = "0", root = "0";

  friend auto operator<=>(const RootNumber&, const RootNumber&) = default;
};

/// An extremal stabbing line.
struct SkeletonNode {
  /// Direction d and moment x cross d for points x of the line, in scene coordinates, exact. They
  /// are scaled so that the same line always has the same text: the first component that is not 0
  /// is 1 or -1, all components share one root, and the first irrational one has b = 1 or -1.
  /// Directed from region to element.
  std::array<RootNumber, 6> line;
  std::array<double, 6> rounded{};
  /// Where the line meets the planes of region and element; a common point with the polygon where
  /// it lies in the plane.
  Point region_point = Point::Zero(), element_point = Point::Zero();
  /// One letter a generator, sorted: "VV", "VEE", "EEEE"; degenerate kinds have more, or fewer
  /// where faces hold the line.
  std::string kind;
  /// All vertices the line passes through and all edges it touches between their ends, sorted. What
  /// coincides geometrically counts once, under the smallest name: corners at one point, edges on
  /// one line, a corner on an edge.
  std::vector<Generator> generators;
  std::vector<PolygonName> faces;  ///< polygons that the line touches and lies in the plane of
};

/// A critical swath: lines that touch the same generators, three edges or a vertex and an edge, and
/// move with one degree of freedom, from one node to the next.
struct SkeletonArc {
  std::string kind;                   ///< "VE" or "EEE"; more or fewer letters where degenerate
  std::vector<Generator> generators;  ///< what all lines of the open swath touch
};

using SkeletonGraph =
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, SkeletonNode, SkeletonArc>;

/// The visibility skeleton of a shaft (Durand, Drettakis and Puech 1997): what bounds the set of
/// free lines between region and element, lines whose segment between them meets no occluder.
///
///  - Nodes are the lines that are limits of free lines and that the generators they touch pin
///    down: no line near touches the same. "Touches" means the edge itself, not its extension, and
///    between region and element. Exact.
///  - Arcs are the swaths of limits of free lines that join them. There may be several between two
///    nodes.
///
/// Generators are the corners and edges of the region, the element and those occluders that block
/// any line of the shaft. Where the region reaches through the element's plane or the reverse, the
/// skeleton is that of both sides together; the cut is no generator. Lines to the back of a
/// one-sided element are not free.
///
/// A hidden query has no nodes. Cost: that of subtracting all blocking cones without a chance to
/// stop early, and some 0.1 ms a node; the free set of 30 triangles strewn over a shaft has
/// thousands of nodes. Thread-safe.
SkeletonGraph visibility_skeleton(const SightQuery& query);

}  // namespace viewcover
