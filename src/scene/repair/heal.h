#pragma once

#include <cstddef>

#include "scene/read/polygon_soup.h"

namespace viewcover {

/// What `heal` did.
struct Healing {
  std::size_t moved = 0;     ///< vertices that moved to another one
  std::size_t inserted = 0;  ///< vertices that became corners of a face beside them
  std::size_t bent = 0;      ///< vertices that became inner vertices of a face beside them
  double largest_move = 0;   ///< of a vertex or of a place on a face, at most `width`
};

/// Closes cracks of at most `width` (scene/repair/cracks.h). A vertex near an earlier one moves to
/// it. A vertex beside an edge becomes a corner there, so that the edge goes through it exactly. A
/// vertex beside the inside of a planar face becomes a vertex of that face, which is cut into
/// triangles that meet there, along edges between such vertices, too: a table leg that ended above
/// the floor stands on it. Where several of them are near to each other along the face, that is for
/// the one nearest to it. Nothing moves farther than `width`.
///
/// A face that would cross itself stays as it is. Faces with a new corner may no longer be planar
/// and are triangulated when they are made convex (scene/repair/convex_faces.h); triangles of one
/// face stay next to each other and have its number. Cost: as find_cracks.
Healing heal(PolygonSoup& soup, double width);

}  // namespace viewcover
