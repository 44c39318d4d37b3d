#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "scene/address.h"
#include "scene/convex_polygon.h"
#include "scene/lattice.h"
#include "scene/region_shape.h"
#include "scene/scene.h"

namespace viewcover {

/// The global viewing region: all places a camera may be (paper, section 2.1), as convex planar
/// polygons and free axis-parallel boxes. Each is subdivided into 4^level viewing regions: a
/// polygon by a uniform quadtree, a box into boxes, its cells (RegionShape::quarters).
///
/// What is seen from a cell is what its six faces see through it (paper, section 3;
/// papers/volumes.md), so visibility is computed for `parts`: the polygons, and the faces of cells,
/// whole, each with its front to the cell. Regions and faces are told apart by the owner of their
/// address: polygons count first, then faces, then boxes.
struct ViewingRegion {
  static constexpr std::size_t kFacesOfCell = 6;

  std::vector<ConvexPolygon> parts;  ///< polygons, then faces cell by cell; indexed by PartId
  int level = 0;                     ///< regions a polygon or box: 4^level
  std::vector<Box> boxes{};

  std::size_t face_count() const { return kFacesOfCell * boxes.size() * regions_per_part(); }
  std::size_t polygon_count() const { return parts.size() - face_count(); }
  std::span<const ConvexPolygon> polygons() const { return {parts.data(), polygon_count()}; }
  std::size_t regions_per_part() const { return std::size_t{1} << (2 * level); }
  std::size_t region_count() const { return (polygon_count() + boxes.size()) * regions_per_part(); }

  bool is_face(RegionAddress node) const {
    return node.owner().value >= polygon_count() && node.owner().value < parts.size();
  }
  bool is_in_box(RegionAddress node) const { return node.owner().value >= parts.size(); }

  /// Region number `index` in [0, region_count()): polygons in turn, then boxes, each in quadtree
  /// order.
  RegionAddress address(std::size_t index) const {
    const std::size_t owner = index / regions_per_part();
    return {PartId(owner < polygon_count() ? owner : owner + face_count()), level,
            index % regions_per_part()};
  }
  /// The regions below a node of a polygon or box, or the one that a face is of, are the numbers
  /// [first, first + count): they see what is seen from the node.
  std::size_t first_index(RegionAddress node) const {
    const std::size_t owner = node.owner().value, polygons = polygon_count();
    if (is_face(node)) return polygons * regions_per_part() + (owner - polygons) / kFacesOfCell;
    return (owner - (is_in_box(node) ? face_count() : 0)) * regions_per_part() +
           (node.path() << (2 * (level - node.level())));
  }
  std::size_t index_count(RegionAddress node) const {
    return is_face(node) ? 1 : std::size_t{1} << (2 * (level - node.level()));
  }

  /// Requires a node that is not in a box.
  ConvexPolygon polygon(RegionAddress node) const {
    return subdivided(parts[node.owner().value], node);
  }
  RegionShape shape(RegionAddress node) const {
    if (!is_in_box(node)) return polygon(node);
    return subdivided(RegionShape(boxes[node.owner().value - parts.size()]), node);
  }
};

/// The region of polygons and boxes, with the faces of the cells. Boxes have a volume. Cost: O(n)
/// for n cells.
ViewingRegion make_viewing_region(std::vector<ConvexPolygon> polygons, std::vector<Box> boxes,
                                  int level);

/// Reads a region: JSON `{"polygons": [...], "boxes": [...]}` (convex polygons, and boxes as
/// `{"min": [x, y, z], "max": [x, y, z]}`), or the faces of a mesh file
/// (scene/read/polygon_soup.h), made convex like those of a scene. Coordinates go to `lattice`.
///
/// `regions_per_part` is a power of 4 (1, 4, 16, ..., 4^10): regions a polygon or box. A JSON
/// polygon that is planar and convex as far as four significant digits tell, but not on the
/// lattice, becomes the triangles of a fan; corners within its edges are removed. Errors:
/// InputError for a malformed file, a polygon that is degenerate, not planar or not convex, no
/// polygon at all, a corner more than 2^26 lattice steps from the origin, or a number that is not a
/// power of 4.
ViewingRegion load_viewing_region(const std::filesystem::path& file, const Lattice& lattice,
                                  std::size_t regions_per_part);

/// What a region file has: convex polygons and boxes with a volume, on the lattice.
struct RegionFile {
  std::vector<ConvexPolygon> polygons;
  std::vector<Box> boxes;
};

/// The content of a JSON file; `file` names it in messages. Errors as above.
RegionFile parse_json_region(const std::string& content, const std::string& file,
                             const Lattice& lattice);

struct RegionCheck {
  double clearance = 0;        ///< least distance of a camera from any surface, scene units
  bool allow_outside = false;  ///< accept a region outside the scene's bounding box
};

/// Refuses a region where no camera can be: a polygon that is cut by a surface, a box with a part
/// of a surface inside (both exact; touching is allowed), one that comes nearer than `clearance` to
/// one, that lies inside a closed object of the scene, or wholly outside the scene's bounding box.
/// `file` names the region in messages.
///
/// "Inside a closed object": the innermost closed connected surface round a point of the part faces
/// away from it, or either way, and more of the scene's area lies outside that surface's bounding
/// box than within (a room round a region is no object). "Wholly outside" is judged by the part's
/// bounding box and its plane, so a part that passes a corner of the box may be accepted.
///
/// A box is judged as a whole, and its faces for clearance and closed objects. A face may lie on a
/// surface: it looks through its box, away from that.
/// Errors: InputError that names the first such part and the first few faces (1-based, as in the
/// file) and groups concerned; at `--clearance` for one that is negative or not finite.
/// Cost: O(n log n) for n surfaces and O(n) a part, under 0.1 s for 16,000 surfaces; with a
/// clearance 0.1 ms more for each surface whose distance neither bounding box nor corners decide.
void check_region_is_free(const std::filesystem::path& file, const Scene& scene,
                          const ViewingRegion& region, const RegionCheck& check = {});

}  // namespace viewcover
