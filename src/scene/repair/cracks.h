#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "scene/read/polygon_soup.h"

namespace viewcover {

/// A vertex beside an edge that it does not belong to, so near that it may be meant to lie on it:
/// between the two there may be a gap that one can see through.
struct Crack {
  std::uint32_t vertex = 0;  ///< of the soup
  std::uint32_t face = 0;    ///< of the soup, whose edge it is
  std::uint32_t edge = 0;    ///< from this corner of the face to the next
  double along = 0;          ///< place on the edge, 0 to 1
  double width = 0;          ///< distance from the edge, more than 0
};

/// Two places with vertices that are near but not the same.
struct NearVertices {
  std::uint32_t first = 0, second = 0;  ///< vertices of the soup, first < second
  double distance = 0;
};

/// A vertex beside the inside of a face, farther than the width from its edges: a table leg that
/// ends a little above the floor.
struct VertexBesideFace {
  std::uint32_t vertex = 0, face = 0;  ///< of the soup
  double distance = 0;                 ///< from the face's plane, more than 0
};

/// What does not close in a soup, though it nearly does.
struct Cracks {
  std::vector<Crack> beside_edges;  ///< by face, edge and place along it
  std::vector<NearVertices>
      apart;  ///< by vertices; of several vertices at one place the first only
  std::vector<VertexBesideFace> beside_faces;  ///< by face and vertex
  std::size_t junctions = 0;  ///< vertices exactly on an edge of another face: closed
};

/// For each vertex the first one at the same place.
std::vector<std::uint32_t> first_at_place(const std::vector<Point>& vertices);

/// Distance of a vertex from a planar face that it is beside, at most `width` from its inside and
/// farther than that from its edges; exactly 0 in its plane.
std::optional<double> distance_from_inside(const PolygonSoup& soup, std::uint32_t vertex,
                                           std::uint32_t face, double width);

/// Vertices at most `width` from an edge, farther than that from its ends, from the inside of a
/// planar face, farther than that from its edges, or from another vertex.
/// Distances are rounded; whether a vertex lies on an edge or in a plane is decided exactly.
/// Cost: O(n log n) for edges that are mostly far apart (boxes that meet are found by sweeping).
Cracks find_cracks(const PolygonSoup& soup, double width);
/// Each alone.
std::vector<NearVertices> vertices_apart(const PolygonSoup& soup, double width);
std::vector<Crack> vertices_beside_edges(const PolygonSoup& soup, double width);
std::vector<VertexBesideFace> vertices_beside_faces(const PolygonSoup& soup, double width);

}  // namespace viewcover
