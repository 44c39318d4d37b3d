#pragma once

#include <filesystem>
#include <vector>

#include "scene/address.h"
#include "scene/convex_polygon.h"
#include "scene/lattice.h"
#include "scene/scene.h"

namespace viewcover {

/// The global viewing region: all places a camera may be (paper, section 2.1), as convex planar
/// parts, each subdivided by a uniform quadtree down to `level`.
struct ViewingRegion {
  std::vector<ConvexPolygon> parts;  ///< indexed by PartId
  int level = 0;                     ///< regions a part: 4^level

  std::size_t regions_per_part() const { return std::size_t{1} << (2 * level); }
  std::size_t region_count() const { return parts.size() * regions_per_part(); }

  /// Region number `index` in [0, region_count()): parts in turn, each in quadtree order.
  RegionAddress address(std::size_t index) const {
    return {PartId(index / regions_per_part()), level, index % regions_per_part()};
  }
  /// The regions below a node are the numbers [first, first + count).
  std::size_t first_index(RegionAddress node) const {
    return node.owner().value * regions_per_part() + (node.path() << (2 * (level - node.level())));
  }
  std::size_t index_count(RegionAddress node) const {
    return std::size_t{1} << (2 * (level - node.level()));
  }
  ConvexPolygon polygon(RegionAddress node) const {
    return subdivided(parts[node.owner().value], node);
  }
};

/// Reads a region: JSON `{"polygons": [...], "boxes": [...]}` (convex polygons; a box stands for
/// its six faces, a face that two boxes share counts once), or the faces of a mesh file
/// (scene/polygon_soup.h), made convex like those of a scene. Coordinates go to `lattice`.
///
/// `regions_per_part` is a power of 4 (1, 4, 16, ..., 4^10). A JSON polygon that is planar and
/// convex as far as four significant digits tell, but not on the lattice, becomes the triangles of
/// a fan; corners within its edges are removed.
/// Errors: InputError for a malformed file, a polygon that is degenerate, not planar or not
/// convex, no polygon at all, a corner more than 2^26 lattice steps from the origin, or a number
/// that is not a power of 4.
ViewingRegion load_viewing_region(const std::filesystem::path& file, const Lattice& lattice,
                                  std::size_t regions_per_part);

/// The parts of a region from the content of a JSON file; `file` names it in messages. Errors as
/// above.
std::vector<ConvexPolygon> parse_json_region(const std::string& content, const std::string& file,
                                             const Lattice& lattice);

struct RegionCheck {
  double clearance = 0;        ///< least distance of a camera from any surface, scene units
  bool allow_outside = false;  ///< accept a region outside the scene's bounding box
};

/// Refuses a region where no camera can be: one that is cut by a surface (exact; touching is
/// allowed), that comes nearer than `clearance` to one, that lies inside a closed object of the
/// scene, or wholly outside the scene's bounding box. `file` names the region in messages.
///
/// "Inside a closed object": the innermost closed connected surface round a point of the part faces
/// away from it, or either way, and more of the scene's area lies outside that surface's bounding
/// box than within (a room round a region is no object). "Wholly outside" is judged by the part's
/// bounding box and its plane, so a part that passes a corner of the box may be accepted.
/// Errors: InputError that names the first such part and the first few faces (1-based, as in the
/// file) and groups concerned; at `--clearance` for one that is negative or not finite.
/// Cost: O(n log n) for n surfaces and O(n) a part, under 0.1 s for 16,000 surfaces; with a
/// clearance 0.1 ms more for each surface whose distance neither bounding box nor corners decide.
void check_region_is_free(const std::filesystem::path& file, const Scene& scene,
                          const ViewingRegion& region, const RegionCheck& check = {});

}  // namespace viewcover
