#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/types.h"

namespace viewcover {

/// The polygons of a file as they stand there: nothing welded, rounded or dropped.
struct PolygonSoup {
  using Face = std::vector<std::uint32_t>;  ///< corners: indices into `vertices`

  std::string file;                            ///< as the user named it, for messages
  std::vector<Point> vertices;                 ///< finite
  std::vector<Face> faces;                     ///< at least 1, each of at least 3 corners, in range
  std::vector<GroupId> face_groups;            ///< one a face
  std::vector<std::string> groups;             ///< names, indexed by GroupId, each with a face
  std::vector<std::size_t> vertex_lines;       ///< 1-based; empty where the format has no lines
  std::vector<std::size_t> face_lines;         ///< 1-based; empty where the format has no lines
  std::vector<std::uint32_t> numbers_in_file;  ///< of the faces, 0-based; empty: as they stand

  std::size_t number_in_file(std::size_t face) const {
    return numbers_in_file.empty() ? face : numbers_in_file[face];
  }
  /// `FILE:LINE`, or `FILE: face N` (1-based) where the format has no lines. For InputError.
  std::string place_of_face(std::size_t face) const;
  /// `FILE:LINE`, or `FILE: vertex N` (1-based) where the format has no lines. For InputError.
  std::string place_of_vertex(std::size_t vertex) const;
};

/// The suffixes that are read: ".obj, .off, ... or .dae".
std::string mesh_file_types();
/// Has the file one of them, in any case?
bool is_mesh_file(const std::filesystem::path& file);

/// Reads .obj, .off, .ply or .stl (by suffix, any case) with CGAL's readers in double precision:
/// the text is checked first (scene/read/soup_check.h), and what comes back afterwards. Reads
/// .gltf, .glb or .dae with assimp in single precision (scene/read/asset_soup.h).
///
/// Groups: an OBJ face belongs to "OBJECT/GROUP" from the last `o` and `g` before it, or to the
/// one of the two that is there, or to ""; faces of an STL file belong to the name of their solid,
/// those of an asset to "NODE/MESH", all faces of other files to "". Equal names are one group.
/// Errors: InputError for a suffix that is not known, a file that is missing, not readable, empty,
/// malformed or cut short, a coordinate that is not finite, an index out of range, a face with
/// fewer than 3 corners, no face. Memory stays proportional to the file, whatever it claims.
PolygonSoup read_polygon_soup(const std::filesystem::path& file);

/// The same from the file's content; `file` names it in messages and tells the format.
PolygonSoup parse_polygon_soup(std::string_view content, const std::filesystem::path& file);

}  // namespace viewcover
