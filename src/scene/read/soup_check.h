#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "scene/read/group_names.h"
#include "scene/types.h"

namespace viewcover {

/// A file's polygons as a plain text (or bytes) that CGAL 5.5 reads faithfully, and what CGAL does
/// not tell: lines and groups.
///
/// CGAL's readers stop at words they do not know, take some indices that are out of range, name no
/// line, and allocate what a header claims before they read it. The checks below read the file
/// first, refuse what is wrong with its place, and pass on the coordinates and indices only, in
/// the file's own digits.
struct CheckedSoup {
  std::string text;          ///< for CGAL's reader of the same format
  std::size_t vertices = 0;  ///< to come back from CGAL; not set for STL, whose vertices CGAL welds
  std::size_t faces = 0;     ///< to come back from CGAL
  std::vector<GroupId> face_groups;       ///< one a face, or empty: all in one group
  GroupNames groups;                      ///< in the order of their first face
  std::vector<std::size_t> vertex_lines;  ///< 1-based; empty where there are none
  std::vector<std::size_t> face_lines;    ///< 1-based; empty where there are none
};

/// The checks, one a format. `file` is the file's name for messages, `text` its content.
/// Errors: InputError. Cost: linear in the text.

/// Wavefront OBJ: `v`, `f`, `o` and `g`; other statements are passed over. Lines may end in LF,
/// CRLF or CR and go on after a backslash. Refuses what is no number, index 0 and indices beyond
/// the vertices of the file.
CheckedSoup check_obj(std::string_view text, const std::string& file);

/// OFF as text, with colours, normals or texture coordinates (ST, C, N) left out. Refuses binary,
/// homogeneous and n-dimensional files and counts that do not agree with the lines.
CheckedSoup check_off(std::string_view text, const std::string& file);

/// PLY, text or binary: the coordinates of the vertices and the index lists of the faces; other
/// properties and elements are passed over. Refuses counts that do not agree with the content.
CheckedSoup check_ply(std::string_view text, const std::string& file);

/// STL, text (several solids are several groups) or binary (its size decides). Refuses facets that
/// are no triangles, coordinates that are not finite and files that are cut short.
CheckedSoup check_stl(std::string_view text, const std::string& file);

}  // namespace viewcover
