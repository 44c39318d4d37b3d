#include "scene/read/mesh_file.h"

#include <cassert>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

#include "scene/error.h"
#include "scene/read/open_mesh.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

OpenMeshPolygons coloured_mesh(std::span<const ConvexPolygon> polygons,
                               std::span<const Colour> colours) {
  OpenMeshPolygons mesh;
  mesh.request_vertex_colors();
  mesh.request_face_colors();
  for (std::size_t i = 0; i < polygons.size(); ++i) {
    const OpenMesh::Vec3uc colour(colours[i][0], colours[i][1], colours[i][2]);
    std::vector<OpenMeshPolygons::VertexHandle> corners;
    for (const Point& p : polygons[i]) {
      corners.push_back(mesh.add_vertex(OpenMeshPolygons::Point(p.x(), p.y(), p.z())));
      mesh.set_color(corners.back(), colour);
    }
    mesh.set_color(mesh.add_face(corners), colour);
  }
  return mesh;
}

[[noreturn]] void fail(const std::filesystem::path& file, int error) {
  throw InputError(file.string(), std::string("cannot be written: ") + std::strerror(error), "");
}

}  // namespace

void write_mesh(const std::filesystem::path& file, std::span<const ConvexPolygon> polygons,
                std::span<const Colour> colours) {
  assert(polygons.size() == colours.size());
  const std::string suffix = lower_suffix(file);
  if (suffix != ".ply" && suffix != ".om") {
    throw InputError(file.string(), "meshes are not written as '" + suffix + "'",
                     "the suffix is .ply or .om");
  }
  omlog().disable();  // a line about the bytes written
  // Through memory: OpenMesh's writers do not report a full disk.
  std::ostringstream content(std::ios::binary);
  OpenMesh::IO::Options options = OpenMesh::IO::Options::Binary;
  options += OpenMesh::IO::Options::LSB;
  options += OpenMesh::IO::Options::VertexColor;
  options += OpenMesh::IO::Options::FaceColor;
  if (!OpenMesh::IO::write_mesh(coloured_mesh(polygons, colours), content, suffix, options)) {
    throw InputError(file.string(), "the mesh cannot be written in this format", "");
  }

  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  if (!stream) fail(file, errno);
  const std::string bytes = std::move(content).str();
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  if (!stream) {
    const int error = errno;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored)) std::filesystem::remove(file, ignored);
    fail(file, error);
  }
}

}  // namespace viewcover
