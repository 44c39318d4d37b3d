#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "scene/convex_polygon.h"
#include "scene/lattice.h"
#include "scene/read/polygon_soup.h"
#include "scene/repair/heal.h"
#include "scene/types.h"

namespace viewcover {

/// A convex planar polygon of the scene. Surfaces may be parts of one face of the file.
struct Surface {
  ConvexPolygon polygon;
  GroupId group;
  /// 0-based number of the face in the file that the surface comes from.
  std::uint32_t source_face = 0;
  /// Is it to be seen? Others only block views.
  bool is_target = true;
};

/// What was changed between the file and the scene. Reported in run.json and in one line.
struct Repairs {
  std::size_t welded_vertices = 0;     ///< vertices that share a lattice point with another
  std::size_t degenerate_faces = 0;    ///< dropped: no area on the lattice
  std::size_t duplicate_faces = 0;     ///< dropped: the same corners as an earlier face
  std::size_t split_faces = 0;         ///< concave or keyholed, split into convex parts
  std::size_t triangulated_faces = 0;  ///< not exactly planar on the lattice, triangulated
  std::size_t merged_surfaces = 0;     ///< surfaces gone into a neighbour by --merge-coplanar
  double largest_move = 0;             ///< farthest a vertex moved to the lattice, scene units
  Healing healing;                     ///< by --heal, after that
  std::size_t cropped_faces = 0;       ///< left out by --crop, before all else

  bool any() const {
    return cropped_faces + degenerate_faces + duplicate_faces + split_faces + triangulated_faces +
               healing.moved + healing.inserted + healing.bent >
           0;
  }
  /// One line for people, such as "2 degenerate faces dropped, 80 faces triangulated".
  std::string summary() const;
};

struct SceneOptions {
  std::optional<int> lattice_exponent;  ///< default: Lattice::for_extent of the file
  bool one_sided = false;               ///< faces that differ by orientation are no duplicates
  bool merge_coplanar = false;          ///< join exactly coplanar neighbours of one group
  double heal = 0;                      ///< close cracks up to this width (scene/repair/cracks.h)
  /// Faces wholly outside are left out, before the lattice is chosen (scene/repair/crop.h).
  std::optional<Box> crop = {};
  /// Groups whose surfaces are to be seen, by their names or the names of their OBJ objects; all
  /// where there are none.
  std::vector<std::string> targets = {};
};

/// A polygonal scene on its lattice: input to everything else, immutable once made.
struct Scene {
  std::string name;                 ///< file name without directories and suffix
  std::vector<Surface> surfaces;    ///< indexed by SurfaceId
  std::vector<std::string> groups;  ///< indexed by GroupId; names as in the file, may be empty
  Lattice lattice;
  Box bounds;
  std::size_t faces = 0;  ///< faces in the file
  Repairs repairs;
  /// One line on faces so far out that they make the lattice coarse (scene/repair/crop.h); empty if
  /// none.
  std::string warning;

  const Surface& operator[](SurfaceId id) const { return surfaces[id.value]; }
  /// Total area of the surfaces, one side, scene units squared.
  double area() const;
};

/// Reads a mesh file (scene/read/polygon_soup.h) and makes every face convex and exactly planar on
/// the lattice: such faces stay whole, others are split or triangulated with their area preserved.
///
/// Errors: InputError for a file that is missing, empty, malformed, has an index out of range, a
/// coordinate that is not finite, a face with fewer than 3 corners, a face that crosses itself,
/// or no face with area; for a target that is no group.
Scene load_scene(const std::filesystem::path& file, const SceneOptions& options = {});

/// The same from what has been read.
Scene make_scene(PolygonSoup soup, const SceneOptions& options = {});

}  // namespace viewcover
