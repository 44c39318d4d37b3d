#include "scene/read/polygon_soup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <limits>

#include "scene/error.h"
#include "scene/scratch_folder.h"

namespace viewcover {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;
using Face = PolygonSoup::Face;

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

class Soup : public testing::Test {
 protected:
  PolygonSoup read(const std::string& name, std::string_view content) const {
    return read_polygon_soup(folder_.write(name, content));
  }
  /// What comes after the folder's name in the message, or "no error".
  std::string error(const std::string& name, std::string_view content) const {
    return error_of(folder_.write(name, content));
  }
  std::string error_of(const std::filesystem::path& file) const {
    try {
      read_polygon_soup(file);
    } catch (const InputError& error) {
      const std::string line = error.what();
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      const std::string folder = folder_.path().string() + "/";
      EXPECT_THAT(line, StartsWith(folder));
      return line.substr(std::min(folder.size(), line.size()));
    }
    return "no error";
  }
  std::string obj_error(const std::string& statements) const {
    return error("a.obj", kSquare + statements);
  }

  ScratchFolder folder_;
};

using ObjSoup = Soup;
using OffSoup = Soup;
using PlySoup = Soup;
using StlSoup = Soup;

TEST_F(ObjSoup, KeepsVerticesFacesAndLines) {
  const auto soup = read("a.obj", "# a comment\n" + std::string(kSquare) + "\nf 1 2 3\nf 1 3 4\n");
  ASSERT_EQ(soup.vertices.size(), 4u);
  EXPECT_EQ(soup.vertices[2], Point(1, 1, 0));
  EXPECT_THAT(soup.faces, ElementsAre(Face{0, 1, 2}, Face{0, 2, 3}));
  EXPECT_THAT(soup.vertex_lines, ElementsAre(2, 3, 4, 5));
  EXPECT_THAT(soup.face_lines, ElementsAre(7, 8));
  EXPECT_THAT(soup.groups, ElementsAre(""));
  EXPECT_EQ(soup.place_of_face(1), (folder_.path() / "a.obj").string() + ":8");
}

TEST_F(ObjSoup, ReadsDoublesToTheLastBit) {
  const auto soup = read("a.obj",
                         "v 0.1 +0.30000000000000004 -1.7976931348623157e308\n"
                         "v 1e-400 4.9406564584124654e-324 .5\nv 1. 1E3 -0\nf 1 2 3\n");
  EXPECT_EQ(soup.vertices[0], Point(0.1, 0.1 + 0.2, -std::numeric_limits<double>::max()));
  EXPECT_EQ(soup.vertices[1], Point(0, std::numeric_limits<double>::denorm_min(), 0.5));
  EXPECT_EQ(soup.vertices[2], Point(1, 1000, 0));
}

TEST_F(ObjSoup, TakesTabsLineEndsContinuationsAndSlashes) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string text =
        "\xEF\xBB\xBFv\t0\t0\t0|v 1\t0 0|  v 1 1 0 0.5 0.5 0.5|v 0 \\|  1 \\|0|"
        "vt 0 0|vn 0 0 1|f\t1\t2\t3|f 1/1 2/1 3/1 4/1 # all of it|f 1//1 2//1 3//1|"
        "f 1/1/1 \\|2/1/1 3/1/1|";
    for (std::size_t at = 0; (at = text.find('|', at)) != std::string::npos;) {
      text.replace(at, 1, end);
    }
    const auto soup = read("a.obj", text);
    ASSERT_EQ(soup.vertices.size(), 4u);
    EXPECT_EQ(soup.vertices[3], Point(0, 1, 0));
    EXPECT_THAT(soup.faces,
                ElementsAre(Face{0, 1, 2}, Face{0, 1, 2, 3}, Face{0, 1, 2}, Face{0, 1, 2}));
    EXPECT_THAT(soup.vertex_lines, ElementsAre(1, 2, 3, 4));
    EXPECT_THAT(soup.face_lines, ElementsAre(9, 10, 11, 12));
  }
}

TEST_F(ObjSoup, CountsNegativeNumbersBackFromTheFace) {
  const auto soup = read("a.obj", kSquare + std::string("f -4 -3 -2\nv 5 5 5\nf -1 -5 -4\n"));
  EXPECT_THAT(soup.faces, ElementsAre(Face{0, 1, 2}, Face{4, 0, 1}));
}

TEST_F(ObjSoup, VerticesMayFollowTheFace) {
  EXPECT_THAT(read("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").faces,
              ElementsAre(Face{0, 1, 2}));
}

TEST_F(ObjSoup, PassesOverStatementsThatAreNoPolygons) {
  const auto soup = read("a.obj", "mtllib a.mtl\n" + std::string(kSquare) +
                                      "s off\nusemtl red\nl 1 2\np 1\nnonsense here\n"
                                      "# C:\\folder\\\nf 1 2 3\n");
  EXPECT_THAT(soup.faces, ElementsAre(Face{0, 1, 2}));
}

TEST_F(ObjSoup, CombinesObjectsAndGroups) {
  const auto soup = read("a.obj", kSquare + std::string("f 1 2 3\n"
                                                        "o table\nf 1 2 3\n"
                                                        "g top\nf 1 2 3\n"
                                                        "g leg  left\nf 1 2 3\n"
                                                        "o chair\nf 1 2 3\n"
                                                        "g\nf 1 2 3\n"
                                                        "g chair\nf 1 2 3\n"
                                                        "g never used\n"
                                                        "o table\ng top\nf 1 2 3\n"
                                                        "o\ng\nf 1 2 3\n"));
  EXPECT_THAT(soup.groups,
              ElementsAre("", "table", "table/top", "table/leg left", "chair/leg left", "chair"));
  const std::vector<std::size_t> expected = {0, 1, 2, 3, 4, 5, 5, 2, 0};
  ASSERT_EQ(soup.face_groups.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(soup.face_groups[i], GroupId(expected[i])) << "face " << i;
  }
}

TEST_F(ObjSoup, RefusesBadVerticesAtTheirLine) {
  for (const char* bad :
       {"nan", "inf", "-inf", "1e999", "x", "1.5.2", "0x10", "1,5", "--1", "+-1", "1e", "-"}) {
    EXPECT_THAT(obj_error(std::string("v 0 ") + bad + " 0\nf 1 2 3\n"),
                StartsWith(std::string("a.obj:5: coordinate '") + bad + "'"));
  }
  EXPECT_THAT(obj_error("f 1 2 3\nv 1 2\n"), StartsWith("a.obj:6: a vertex with 2 coordinates"));
  EXPECT_THAT(obj_error("v 1 2 # 3\n"), StartsWith("a.obj:5: a vertex with 2 coordinates"));
}

TEST_F(ObjSoup, RefusesBadCornersAtTheirLine) {
  EXPECT_THAT(obj_error("f 1 2 3\nf 1 2 5\n"), StartsWith("a.obj:6: vertex 5 does not exist"));
  EXPECT_THAT(obj_error("f 1 2 99999999999999999999\n"), StartsWith("a.obj:5: vertex 9"));
  EXPECT_THAT(obj_error("\nf 1 2 -5\n"), StartsWith("a.obj:6: vertex -5 does not exist"));
  EXPECT_THAT(obj_error("f 1 2 -99999999999999999999\n"), StartsWith("a.obj:5: vertex -9"));
  EXPECT_THAT(obj_error("f 1 2 0\n"), StartsWith("a.obj:5: vertex number 0"));
  for (const char* bad : {"x", "1.5", "/1", "nan", "3x/1"}) {
    EXPECT_THAT(obj_error(std::string("f 1 2 ") + bad + "\n"),
                StartsWith(std::string("a.obj:5: corner '") + bad + "'"));
  }
  // The last vertex is in range, the one after it is not: CGAL 5.5 itself takes both.
  EXPECT_EQ(obj_error("f 1 2 4\n"), "no error");
}

TEST_F(ObjSoup, RefusesFacesOfLessThanThreeCorners) {
  EXPECT_THAT(obj_error("f 1 2 3\nf 1 2\n"), StartsWith("a.obj:6: a face with 2 corners"));
  EXPECT_THAT(obj_error("f 1\n"), StartsWith("a.obj:5: a face with 1 corners"));
  EXPECT_THAT(obj_error("f\n"), StartsWith("a.obj:5: a face with 0 corners"));
}

TEST_F(Soup, RefusesFilesWithoutFaces) {
  EXPECT_EQ(obj_error(""), "a.obj: the file has no face");
  EXPECT_EQ(error("a.obj", "#\n"), "a.obj: the file has no face");
  EXPECT_EQ(error("a.off", "OFF 1 0 0\n0 0 0\n"), "a.off: the file has no face");
  EXPECT_EQ(error("a.stl", "solid\nendsolid\n"), "a.stl: the file has no face");
}

TEST_F(Soup, RefusesWhatIsNoReadableFile) {
  EXPECT_EQ(error_of(folder_.path() / "none.obj"), "none.obj: no such file");
  EXPECT_EQ(error("a.obj", ""), "a.obj: the file is empty");
  EXPECT_THAT(error("a.3ds", "x"), StartsWith("a.3ds: the file type '.3ds' is not known"));
  EXPECT_THAT(error("obj", "x"), StartsWith("obj: the file type '' is not known"));
  std::filesystem::create_directory(folder_.path() / "folder.obj");
  EXPECT_EQ(error_of(folder_.path() / "folder.obj"), "folder.obj: not a regular file");
  EXPECT_EQ(error_of(folder_.path() / "a.obj" / "b.obj"), "a.obj/b.obj: no such file");
}

TEST_F(Soup, TakesSuffixesInAnyCase) {
  EXPECT_EQ(read("A.OBJ", kSquare + std::string("f 1 2 3\n")).faces.size(), 1u);
  EXPECT_EQ(read("A.Off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").faces.size(), 1u);
}

TEST_F(OffSoup, ReadsVariants) {
  for (const char* text :
       {"OFF\n# one\n4 2 5\n0 0 0\n1 0 0 # two\n\n1 1 0\n0 1 0\n3 0 1 2\n4 0 1 2 3\n",
        "OFF 4 2\r\n0 0 0\r\n1 0 0\r\n1 1 0\r\n0 1 0\r\n3 0 1 2 255 0 0\r\n4 0 1 2 3",
        "COFF\n4 2 0\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n1 1 0 1 0 0 1\n0 1 0 1 0 0 1\n"
        "3 0 1 2\n4 0 1 2 3\n"}) {
    const auto soup = read("a.off", text);
    ASSERT_EQ(soup.vertices.size(), 4u) << text;
    EXPECT_EQ(soup.vertices[2], Point(1, 1, 0));
    EXPECT_THAT(soup.faces, ElementsAre(Face{0, 1, 2}, Face{0, 1, 2, 3}));
    EXPECT_THAT(soup.groups, ElementsAre(""));
    EXPECT_THAT(soup.face_groups, ElementsAre(GroupId(), GroupId()));
  }
}

TEST_F(OffSoup, RefusesWrongCountsAndContent) {
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_THAT(error("a.off", "OFF 3 2 0\n" + vertices + "3 0 1 2\n"),
              StartsWith("a.off: the file ends after 1 of 2 faces"));
  EXPECT_THAT(error("a.off", "OFF 4 1 0\n" + vertices),
              StartsWith("a.off: the file ends after 3 of 4 vertices"));
  EXPECT_THAT(error("a.off", "OFF 3 1 0\n" + vertices + "3 0 1 2\n3 0 1 2\n"),
              StartsWith("a.off:6: more lines than"));
  EXPECT_THAT(error("a.off", "OFF 3 1 0\n" + vertices + "3 0 1 3\n"),
              StartsWith("a.off:5: vertex 3 does not exist"));
  EXPECT_THAT(error("a.off", "OFF 3 1 0\n" + vertices + "3 0 1 -1\n"),
              StartsWith("a.off:5: vertex -1 does not exist"));
  EXPECT_THAT(error("a.off", "OFF 3 1 0\n" + vertices + "3 0 1\n"),
              StartsWith("a.off:5: a face of 3 corners on a line with 2"));
  EXPECT_THAT(error("a.off", "OFF 3 1 0\n" + vertices + "2 0 1\n"),
              StartsWith("a.off:5: a face with 2 corners"));
  EXPECT_THAT(error("a.off", "OFF 3 1 0\n" + vertices + "x 0 1\n"),
              StartsWith("a.off:5: 'x' is no number of corners"));
  EXPECT_THAT(error("a.off", "OFF 3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
              StartsWith("a.off:3: coordinate 'nan'"));
  EXPECT_THAT(error("a.off", "OFF 3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n"),
              StartsWith("a.off:3: a vertex with 2 coordinates"));
  EXPECT_THAT(error("a.off", "OOF 3 1 0\n"), StartsWith("a.off:1: 'OOF' is no OFF header"));
  EXPECT_THAT(error("a.off", "4OFF 3 1 0\n"), StartsWith("a.off:1: '4OFF' is no OFF header"));
  EXPECT_THAT(error("a.off", "OFF BINARY\n"), StartsWith("a.off:1: the header does not give"));
  EXPECT_THAT(error("a.off", "OFF -1 2 3\n"), StartsWith("a.off:1: the header does not give"));
  EXPECT_THAT(error("a.off", "OFF\n"), StartsWith("a.off:1: the header does not give"));
  EXPECT_THAT(error("a.off", "# nothing\n"), StartsWith("a.off:1: no OFF header"));
}

TEST_F(OffSoup, IsNotImpressedByHostileCounts) {
  EXPECT_THAT(error("a.off", "OFF 100000000000 1 0\n0 0 0\n"),
              StartsWith("a.off: the file ends after 1 of 100000000000 vertices"));
  EXPECT_THAT(error("a.off", "OFF 2000000000 2000000000 0\n0 0 0\n"),
              StartsWith("a.off: the file ends after 1 of"));
  EXPECT_THAT(error("a.off", "OFF 1 99999999999999999999 0\n0 0 0\n"),
              StartsWith("a.off: the file ends after 0 of"));
  EXPECT_THAT(error("a.off", "OFF 1 1 0\n0 0 0\n4000000000 0 0 0\n"),
              StartsWith("a.off:3: a face of 4000000000 corners"));
}

std::string ply_header(const std::string& format, std::size_t vertices, std::size_t faces) {
  return "ply\nformat " + format + " 1.0\ncomment made by hand\nelement vertex " +
         std::to_string(vertices) +
         "\nproperty double x\nproperty double y\nproperty float quality\nproperty double z\n"
         "element edge 1\nproperty list uchar short stuff\nelement face " +
         std::to_string(faces) +
         "\nproperty uchar red\nproperty list uchar int vertex_indices\nend_header\n";
}

template <class T>
void append(std::string& bytes, T value, bool is_big) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  if (is_big) std::reverse(raw, raw + sizeof value);
  bytes.append(raw, sizeof value);
}

std::string binary_ply_body(bool is_big, double special = 0.1, std::int32_t last_corner = 3) {
  std::string bytes;
  for (const Point& p : {Point(0, 0, 0), Point(1, 0, 0), Point(1, 1, 0), Point(0, 1, special)}) {
    append(bytes, p.x(), is_big);
    append(bytes, p.y(), is_big);
    append(bytes, 7.5f, is_big);
    append(bytes, p.z(), is_big);
  }
  append<std::uint8_t>(bytes, 2, is_big);
  append<std::int16_t>(bytes, 10, is_big);
  append<std::int16_t>(bytes, 13, is_big);
  append<std::uint8_t>(bytes, 255, is_big);
  append<std::uint8_t>(bytes, 4, is_big);
  for (const std::int32_t corner : {0, 1, 2, last_corner}) append(bytes, corner, is_big);
  return bytes;
}

TEST_F(PlySoup, ReadsTextAndBothKindsOfBinary) {
  const std::string text = "0 0 7.5 0\n1 0 7.5 0\n1 1 nan 0\n0 1 7.5 0.1\n2 10 13\n255 4 0 1 2 3\n";
  for (const auto& content : {ply_header("ascii", 4, 1) + text,
                              ply_header("binary_little_endian", 4, 1) + binary_ply_body(false),
                              ply_header("binary_big_endian", 4, 1) + binary_ply_body(true)}) {
    const auto soup = read("a.ply", content);
    ASSERT_EQ(soup.vertices.size(), 4u);
    EXPECT_EQ(soup.vertices[3], Point(0, 1, 0.1));
    EXPECT_THAT(soup.faces, ElementsAre(Face{0, 1, 2, 3}));
    EXPECT_THAT(soup.groups, ElementsAre(""));
  }
}

TEST_F(PlySoup, RefusesBadContentAtItsPlace) {
  const std::string little = ply_header("binary_little_endian", 4, 1);
  EXPECT_THAT(error("a.ply", little + binary_ply_body(false, NAN)),
              StartsWith("a.ply: vertex 4: a coordinate is not finite"));
  EXPECT_THAT(error("a.ply", little + binary_ply_body(false, 0, 4)),
              StartsWith("a.ply: face 1: a corner is out of range"));
  EXPECT_THAT(error("a.ply", little + binary_ply_body(false, 0, -1)),
              StartsWith("a.ply: face 1: a corner is out of range"));
  const std::string ascii = ply_header("ascii", 3, 1) + "0 0 7 0\n1 0 7 0\n";
  EXPECT_THAT(error("a.ply", ascii + "1 1 7 nan\n0\n255 3 0 1 2\n"),
              StartsWith("a.ply:17: coordinate 'nan'"));
  EXPECT_THAT(error("a.ply", ascii + "1 1 7 0\n0\n255 3 0 1 3\n"),
              StartsWith("a.ply:19: a corner is out of range"));
  EXPECT_THAT(error("a.ply", ascii + "1 1 7 0\n0\n255 3 0 1 2.5\n"),
              StartsWith("a.ply:19: '2.5' is no whole number"));
  EXPECT_THAT(error("a.ply", ascii + "1 1 7 0\n0\n255 2 0 1\n"),
              StartsWith("a.ply:19: a face with 2 corners"));
  EXPECT_THAT(error("a.ply", ascii + "1 1 7 0\n0\n255 -3 0 1 2\n"), StartsWith("a.ply:19: a list"));
}

TEST_F(PlySoup, RefusesWrongCounts) {
  const std::string body = binary_ply_body(false);
  const std::string little = ply_header("binary_little_endian", 4, 1);
  // Cut short at every byte: always an error, never a crash.
  for (std::size_t size = 0; size < body.size(); ++size) {
    EXPECT_THAT(error("a.ply", little + body.substr(0, size)),
                StartsWith("a.ply: the file ends in"));
  }
  EXPECT_THAT(error("a.ply", little + body + "x"), StartsWith("a.ply: the file goes on after"));
  EXPECT_THAT(
      error("a.ply", ply_header("ascii", 3, 1) + "0 0 7 0 1 0 7 0 1 1 7 0 0 9 3 0 1 2\n5\n"),
      StartsWith("a.ply:16: the file goes on after"));
}

TEST_F(PlySoup, IsNotImpressedByHostileCounts) {
  EXPECT_THAT(error("a.ply", ply_header("ascii", 100000000000, 1) + "0 0 0 0\n"),
              StartsWith("a.ply: the file ends in vertex 2 of 100000000000"));
  EXPECT_THAT(error("a.ply", ply_header("binary_little_endian", 100000000000, 1)),
              StartsWith("a.ply: the file ends in vertex 1 of"));
  std::string header = ply_header("binary_little_endian", 0, 1);
  header.replace(header.find("list uchar int"), 14, "list uint int");
  EXPECT_THAT(error("a.ply", header + std::string("\0\1\xFF\xFF\xFF\xFF", 6)),
              StartsWith("a.ply: the file ends in face 1"));
  EXPECT_THAT(
      error("a.ply",
            "ply\nformat ascii 1.0\nelement nothing 99999999999999999999\nelement vertex 0\n"
            "property float x\nproperty float y\nproperty float z\nelement face 0\n"
            "property list uchar int vertex_index\nend_header\n"),
      StartsWith("a.ply: the file has no face"));
}

TEST_F(PlySoup, RefusesHeadersItCannotFollow) {
  const auto header = [&](const std::string& from, const std::string& to) {
    std::string text = ply_header("ascii", 3, 1);
    text.replace(text.find(from), from.size(), to);
    return error("a.ply", text);
  };
  EXPECT_THAT(header("ply\n", "plx\n"), StartsWith("a.ply:1: no PLY header"));
  EXPECT_THAT(header("ascii", "utf8"), StartsWith("a.ply:2: the format 'utf8'"));
  EXPECT_THAT(header("format ascii 1.0\n", ""), StartsWith("a.ply:13: the header names no format"));
  EXPECT_THAT(header("double x", "real x"), StartsWith("a.ply:5: the type 'real'"));
  EXPECT_THAT(header("double x", "int x"), HasSubstr("coordinates of type int"));
  EXPECT_THAT(header("double x", "double u"), HasSubstr("once with x, y and z"));
  EXPECT_THAT(header("element vertex 3\n", ""), StartsWith("a.ply:4: a property of no element"));
  EXPECT_THAT(header("uchar int vertex_indices", "float int vertex_indices"),
              StartsWith("a.ply:13: a list counted by 'float'"));
  EXPECT_THAT(header("uchar int vertex_indices", "uchar short vertex_indices"),
              HasSubstr("corners of type short"));
  EXPECT_THAT(header("vertex_indices", "corners"), HasSubstr("faces once with their corners"));
  EXPECT_THAT(header("element face 1", "element vertex 3"), HasSubstr("does not declare"));
  EXPECT_THAT(header("end_header\n", ""), StartsWith("a.ply:13: the header does not end"));
  EXPECT_THAT(header("element face 1", "element face"), StartsWith("a.ply:11: 'element'"));
}

std::string stl_facet(const std::string& last = "0 1 0") {
  return "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex " + last +
         "\n endloop\nendfacet\n";
}

TEST_F(StlSoup, ReadsTextWithItsSolidsAsGroups) {
  const auto soup =
      read("a.stl", "solid a facet of life\n" + stl_facet() + stl_facet("1 1 0") +
                        "endsolid a facet of life\nsolid\n" + stl_facet("0 0 0.1") + "endsolid\n");
  EXPECT_THAT(soup.groups, ElementsAre("a facet of life", ""));
  EXPECT_THAT(soup.face_groups, ElementsAre(GroupId(0), GroupId(0), GroupId(1)));
  ASSERT_EQ(soup.faces.size(), 3u);
  EXPECT_EQ(soup.vertices[soup.faces[2][2]], Point(0, 0, 0.1));
}

TEST_F(StlSoup, RefusesBadText) {
  EXPECT_THAT(error("a.stl", "solid\n" + stl_facet() + stl_facet("0 inf 0") + "endsolid\n"),
              StartsWith("a.stl:13: 'inf' is out of place"));
  EXPECT_THAT(error("a.stl", "solid\n" + stl_facet("0 1 0\n vertex 1 1 0") + "endsolid\n"),
              StartsWith("a.stl:7: 'vertex' is out of place"));
  EXPECT_THAT(error("a.stl", "solid\n" + stl_facet()), HasSubstr("the file is cut short"));
  EXPECT_THAT(error("a.stl", "solid\n" + stl_facet("0 0 0\n")), Not(HasSubstr("no error")));
  EXPECT_THAT(error("a.stl", "facets\n"), StartsWith("a.stl: neither a text nor a binary"));
}

std::string binary_stl(std::uint32_t claimed, std::size_t triangles, float special = 1) {
  std::string bytes("solid, but binary");
  bytes.resize(80, ' ');
  append(bytes, claimed, false);
  for (std::size_t i = 0; i < triangles; ++i) {
    for (const float x : {0.f, 0.f, std::numeric_limits<float>::quiet_NaN(), 0.f, 0.f, 0.f, 1.f,
                          0.f, 0.f, 0.f, special, static_cast<float>(i)}) {
      append(bytes, x, false);
    }
    bytes.append(2, '\0');
  }
  return bytes;
}

TEST_F(StlSoup, ReadsBinaryWhateverItsHeaderSays) {
  const auto soup = read("a.stl", binary_stl(3, 3));
  ASSERT_EQ(soup.faces.size(), 3u);
  EXPECT_EQ(soup.vertices[soup.faces[2][2]], Point(0, 1, 2));
  // A header that reads as the start of a text makes CGAL try that first.
  std::string text_like = binary_stl(3, 3);
  const std::string start = "solid\nfacet vertex 0 0 0 vertex 1 0 0 vertex 0 1 0 endfacet\nfacet";
  text_like.replace(0, start.size(), start);
  EXPECT_EQ(read("a.stl", text_like).faces.size(), 3u);
}

TEST_F(StlSoup, RefusesBadBinary) {
  std::string bytes = binary_stl(2, 2, NAN);
  EXPECT_THAT(error("a.stl", bytes), StartsWith("a.stl: face 1: a coordinate is not finite"));
  bytes = binary_stl(0xFFFFFFFF, 2);
  bytes[0] = 'x';
  EXPECT_THAT(error("a.stl", bytes), StartsWith("a.stl: the file has 184 bytes"));
  bytes = binary_stl(2, 2);
  bytes[0] = 'x';
  bytes.pop_back();
  EXPECT_THAT(error("a.stl", bytes), StartsWith("a.stl: the file has 183 bytes"));
}

}  // namespace
}  // namespace viewcover
