#include "scene/read/mesh_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/error.h"
#include "scene/read/open_mesh.h"
#include "scene/read/polygon_soup.h"
#include "scene/scratch_folder.h"

namespace viewcover {
namespace {

using testing::HasSubstr;

const std::vector<ConvexPolygon> kPolygons = {
    {{0, 0, 0}, {1, 0, 0}, {0.125, 1 + 0x1p-22, 0}},
    {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0.5, 0, 2}, {0, 0, 1}}};
const std::vector<Colour> kColours = {{255, 0, 10}, {1, 200, 3}};

std::string error_of(const std::filesystem::path& file) {
  try {
    write_mesh(file, kPolygons, kColours);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(MeshFile, PlyKeepsLatticePoints) {
  const ScratchFolder folder;
  write_mesh(folder.path() / "a.PLY", kPolygons, kColours);
  const PolygonSoup soup = read_polygon_soup(folder.path() / "a.PLY");
  ASSERT_EQ(soup.faces.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(soup.faces[i].size(), kPolygons[i].size());
    for (std::size_t k = 0; k < soup.faces[i].size(); ++k) {
      EXPECT_EQ(soup.vertices[soup.faces[i][k]], kPolygons[i][k]);
    }
  }
}

TEST(MeshFile, ColoursStandAtVerticesAndFaces) {
  const ScratchFolder folder;
  for (const char* name : {"a.ply", "a.om"}) {
    write_mesh(folder.path() / name, kPolygons, kColours);
    OpenMeshPolygons mesh;
    mesh.request_vertex_colors();
    mesh.request_face_colors();
    OpenMesh::IO::Options options = OpenMesh::IO::Options::Binary;
    options += OpenMesh::IO::Options::VertexColor;
    options += OpenMesh::IO::Options::FaceColor;
    ASSERT_TRUE(OpenMesh::IO::read_mesh(mesh, (folder.path() / name).string(), options)) << name;
    ASSERT_EQ(mesh.n_vertices(), 8u);
    ASSERT_EQ(mesh.n_faces(), 2u);
    EXPECT_TRUE(options.check(OpenMesh::IO::Options::VertexColor)) << name;
    for (const auto face : mesh.faces()) {
      const Colour& expected = kColours[static_cast<std::size_t>(face.idx())];
      for (const auto vertex : mesh.fv_range(face)) {
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(mesh.color(vertex)[k], expected[k]) << name;
      }
    }
  }
}

TEST(MeshFile, OmKeepsDoubles) {
  const ScratchFolder folder;
  const std::vector<ConvexPolygon> triangle = {{{0, 0, 0}, {1, 0, 0}, {0.1, 1 + 0x1p-50, 0}}};
  write_mesh(folder.path() / "a.om", triangle, std::vector<Colour>(1));
  OpenMeshPolygons mesh;
  ASSERT_TRUE(OpenMesh::IO::read_mesh(mesh, (folder.path() / "a.om").string()));
  const auto point = mesh.point(OpenMeshPolygons::VertexHandle(2));
  EXPECT_EQ(Point(point[0], point[1], point[2]), triangle[0][2]);
}

TEST(MeshFile, SaysWhatItCannotWrite) {
  const ScratchFolder folder;
  EXPECT_THAT(error_of(folder.path() / "a.xyz"), HasSubstr("meshes are not written as '.xyz'"));
  EXPECT_EQ(error_of(folder.path() / "a.ply"), "no error");
  EXPECT_THAT(error_of(folder.path() / "none" / "a.ply"),
              HasSubstr("a.ply: cannot be written: No"));
  std::filesystem::create_symlink("/dev/full", folder.path() / "full.ply");
  EXPECT_THAT(error_of(folder.path() / "full.ply"),
              HasSubstr("full.ply: cannot be written: No space left"));
}

}  // namespace
}  // namespace viewcover
