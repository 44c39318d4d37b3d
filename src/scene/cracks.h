#pragma once

#include <cstdint>
#include <vector>

#include "scene/polygon_soup.h"

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

/// What does not close in a soup, though it nearly does.
struct Cracks {
  std::vector<Crack> beside_edges;  ///< by face, edge and place along it
  std::vector<NearVertices>
      apart;                  ///< by vertices; of several vertices at one place the first only
  std::size_t junctions = 0;  ///< vertices exactly on an edge of another face: closed
};

/// Vertices at most `width` from an edge, farther than that from its ends, or from another vertex.
/// Distances are rounded; whether a vertex lies on an edge is decided exactly.
/// Cost: O(n log n) for edges that are mostly far apart (boxes that meet are found by sweeping).
Cracks find_cracks(const PolygonSoup& soup, double width);

/// What `heal` did.
struct Healing {
  std::size_t moved = 0;     ///< vertices that moved to another one
  std::size_t inserted = 0;  ///< vertices that became corners of a face beside them
  double largest_move = 0;   ///< at most `width`
};

/// Closes cracks of at most `width`: a vertex near an earlier one moves to it, and a vertex beside
/// an edge becomes a corner there, so that the edge goes through it exactly. Nothing moves farther
/// than `width`; faces with a new corner may no longer be planar and are triangulated when they are
/// made convex (scene/convex_faces.h). Gaps between a vertex and the inside of a face stay. Cost:
/// as find_cracks, twice.
Healing heal(PolygonSoup& soup, double width);

}  // namespace viewcover
