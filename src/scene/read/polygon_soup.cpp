#include "scene/read/polygon_soup.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <system_error>

#include "scene/error.h"
#include "scene/read/asset_soup.h"
#include "scene/read/soup_check.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

using CgalPoint = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using CgalFaces = std::vector<std::vector<std::size_t>>;

struct FileFormat {
  std::string_view suffix;
  CheckedSoup (*check)(std::string_view text, const std::string& file);
  bool (*read)(std::istream& stream, std::vector<CgalPoint>& points, CgalFaces& faces);
};

const FileFormat kFormats[] = {
    {".obj", check_obj,
     [](std::istream& stream, std::vector<CgalPoint>& points, CgalFaces& faces) {
       return CGAL::IO::read_OBJ(stream, points, faces, CGAL::parameters::verbose(false));
     }},
    {".off", check_off,
     [](std::istream& stream, std::vector<CgalPoint>& points, CgalFaces& faces) {
       return CGAL::IO::read_OFF(stream, points, faces, CGAL::parameters::verbose(false));
     }},
    {".ply", check_ply,
     [](std::istream& stream, std::vector<CgalPoint>& points, CgalFaces& faces) {
       return CGAL::IO::read_PLY(stream, points, faces, CGAL::parameters::verbose(false));
     }},
    {".stl", check_stl,
     [](std::istream& stream, std::vector<CgalPoint>& points, CgalFaces& faces) {
       return CGAL::IO::read_STL(stream, points, faces, CGAL::parameters::verbose(false));
     }},
};

/// Those that assimp reads.
constexpr std::array<std::string_view, 3> kAssets = {".gltf", ".glb", ".dae"};

bool is_asset(std::string_view suffix) {
  return std::find(kAssets.begin(), kAssets.end(), suffix) != kAssets.end();
}

/// Null for those that CGAL does not read.
const FileFormat* format_of(std::string_view suffix) {
  const auto has_suffix = [&](const FileFormat& format) { return format.suffix == suffix; };
  const auto found = std::find_if(std::begin(kFormats), std::end(kFormats), has_suffix);
  return found == std::end(kFormats) ? nullptr : found;
}

void refuse_unknown_type(const std::filesystem::path& file) {
  if (is_mesh_file(file)) return;
  throw InputError(file.string(),
                   "the file type " + in_quotes(lower_suffix(file)) + " is not known",
                   "give " + mesh_file_types());
}

std::string content_of(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status)) throw InputError(file.string(), "no such file", "");
  if (!std::filesystem::is_regular_file(status)) {
    throw InputError(file.string(), "not a regular file", "");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string(), "the file cannot be opened", "is it readable?");
  std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) throw InputError(file.string(), "the file cannot be read", "");
  if (text.empty()) throw InputError(file.string(), "the file is empty", "");
  return text;
}

void check_vertices(const PolygonSoup& soup) {
  for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
    if (!soup.vertices[i].allFinite()) {
      throw InputError(soup.place_of_vertex(i), "a coordinate is not finite", "");
    }
  }
}

// Faces with indices in range and at least three corners; they become indices of 32 bits.
void take_faces(const CgalFaces& faces, PolygonSoup& soup) {
  soup.faces.reserve(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    PolygonSoup::Face face;
    for (const std::size_t vertex : faces[i]) {
      if (vertex >= soup.vertices.size()) {
        throw InputError(soup.place_of_face(i), "a corner is out of range",
                         "the file has " + std::to_string(soup.vertices.size()) + " vertices");
      }
      face.push_back(static_cast<std::uint32_t>(vertex));
    }
    if (face.size() < 3) {
      throw InputError(soup.place_of_face(i),
                       "a face with " + std::to_string(face.size()) + " corners",
                       "3 or more are needed");
    }
    soup.faces.push_back(std::move(face));
  }
}

}  // namespace

std::string PolygonSoup::place_of_face(std::size_t face) const {
  if (face_lines.empty()) return InputError::at_face(file, number_in_file(face) + 1);
  return InputError::at_line(file, face_lines[face]);
}

std::string PolygonSoup::place_of_vertex(std::size_t vertex) const {
  if (vertex_lines.empty()) return file + ": vertex " + std::to_string(vertex + 1);
  return InputError::at_line(file, vertex_lines[vertex]);
}

std::string mesh_file_types() {
  std::vector<std::string_view> suffixes;
  for (const FileFormat& format : kFormats) suffixes.push_back(format.suffix);
  suffixes.insert(suffixes.end(), kAssets.begin(), kAssets.end());
  std::string list;
  for (std::size_t i = 0; i < suffixes.size(); ++i) {
    if (i > 0) list += i + 1 == suffixes.size() ? " or " : ", ";
    list += suffixes[i];
  }
  return list;
}

bool is_mesh_file(const std::filesystem::path& file) {
  const std::string suffix = lower_suffix(file);
  return format_of(suffix) != nullptr || is_asset(suffix);
}

PolygonSoup read_polygon_soup(const std::filesystem::path& file) {
  refuse_unknown_type(file);  // before it is read
  return parse_polygon_soup(content_of(file), file);
}

PolygonSoup parse_polygon_soup(std::string_view content, const std::filesystem::path& file) {
  refuse_unknown_type(file);
  const std::string suffix = lower_suffix(file);
  if (suffix != ".stl") refuse_utf16(content, file.string());  // whose header may be anything
  if (is_asset(suffix)) return parse_asset(content, file);
  const FileFormat& format = *format_of(suffix);
  PolygonSoup soup;
  soup.file = file.string();
  CheckedSoup checked = format.check(content, soup.file);
  if (checked.faces == 0) throw InputError(soup.file, "the file has no face", "");

  std::vector<CgalPoint> points;
  CgalFaces faces;
  std::istringstream stream(std::move(checked.text));
  const bool is_read = format.read(stream, points, faces);
  const bool has_vertices = format.suffix == ".stl" || points.size() == checked.vertices;
  if (!is_read || !has_vertices || faces.size() != checked.faces) {
    throw InputError(soup.file, "the file is malformed", "");
  }
  if (points.size() > std::numeric_limits<std::uint32_t>::max()) {
    throw InputError(soup.file, "more than 2^32 vertices", "");
  }

  soup.vertex_lines = std::move(checked.vertex_lines);
  soup.face_lines = std::move(checked.face_lines);
  soup.face_groups = std::move(checked.face_groups);
  soup.groups = checked.groups.names();
  if (soup.face_groups.empty()) {
    soup.face_groups.assign(faces.size(), GroupId());
    soup.groups = {""};
  }
  soup.vertices.reserve(points.size());
  for (const CgalPoint& point : points) soup.vertices.emplace_back(point.x(), point.y(), point.z());
  check_vertices(soup);
  take_faces(faces, soup);
  return soup;
}

}  // namespace viewcover
