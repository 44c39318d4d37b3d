#include <gmock/gmock.h>

#include <cmath>
#include <sstream>

#include "bundle_files.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Repeated.
std::string times(std::size_t count, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

/// In UTF-16, little-endian, with its mark.
std::string utf16(const std::string& text) {
  std::string wide = "\xFF\xFE";
  for (const char c : text) wide += std::string(1, c) + '\0';
  return wide;
}

const std::string kZero(1, '\0');
const std::string kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string kPlyStart = "ply\nformat ascii 1.0\nelement vertex ";
const std::string kPlyRest =
    "\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
    "property list uchar int vertex_indices\nend_header\n";
const std::string kPlyBody = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string kFacet =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n";
const std::string kMatrix = "%%MatrixMarket matrix coordinate pattern general\n";
const std::string kGltf = R"({"asset": {"version": "2.0"}, )";

/// A file and what the one line says of it, from its name on.
struct Case {
  std::string name, content, says;
};

class Malformed : public ::testing::Test {
 protected:
  void expect_refused(const Case& bad, std::vector<std::string> before,
                      const std::vector<std::string>& after = {}) {
    SCOPED_TRACE(bad.name + ": " + bad.content.substr(0, 120));
    before.push_back(folder_.write(bad.name, bad.content).string());
    before.insert(before.end(), after.begin(), after.end());
    const Outcome outcome = viewcover_run(before);
    testing::expect_refused(outcome, bad.says);
    EXPECT_THAT(outcome.error,
                StartsWith("viewcover: " + folder_.path().string() + "/" + bad.name));
    EXPECT_EQ(outcome.out, "");
  }

  ScratchFolder folder_;
};

TEST_F(Malformed, Scenes) {
  const std::vector<Case> cases = {
      {"empty.obj", "", "the file is empty"},
      {"zero.obj", times(100, kZero), "the file has no face"},
      {"comments.obj", times(1000, "# nothing\n#\n"), "the file has no face"},
      {"utf16.obj", utf16(kTriangle + "f 1 2 3\n"), "UTF-16"},
      {"utf16.dae", utf16("<COLLADA/>"), "UTF-16"},
      {"zero_inside.obj", kTriangle + "v 0 " + kZero + " 0\nf 1 2 3\n", ":4: coordinate '?'"},
      {"comma.obj", "v 0,5 0 0\nf 1 1 1\n", ":1: coordinate '0,5'"},
      {"hexadecimal.obj", "v 0x1p3 0 0\nf 1 1 1\n", ":1: coordinate '0x1p3'"},
      {"nan.obj", kTriangle + "v NaN 0 0\nf 1 2 3\n", ":4: coordinate 'NaN'"},
      {"infinite.obj", kTriangle + "v 0 -Infinity 0\nf 1 2 3\n", ":4: coordinate '-Infinity'"},
      {"two.obj", kTriangle + "f 1 2\n", ":4: a face with 2 corners"},
      {"back.obj", kTriangle + "f -1 -2 -4\n", ":4: vertex -4 does not exist"},
      {"beyond.obj", kTriangle + "f 1 2 100000000000\n", ":4: vertex 100000000000 does not exist"},
      {"huge.obj", "v 1e300 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\n", ":1: a coordinate is too large"},
      {"tiny.obj", "v 1e-300 0 0\nv 0 1e-300 0\nv 0 0 1e-300\nf 1 2 3\n", "too small"},
      {"flat.obj", "v 1e30 0 0\nv 1e-30 0 0\nv 0 1e-30 0\nf 1 2 3\n", "has area"},
      {"crossing.obj", "v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n", ":5: the face crosses"},
      {"header.off", "OFF", ":1: the header does not give"},
      {"claim.off", "OFF 100000000000 1 0\n0 0 0\n", "after 1 of 100000000000 vertices"},
      {"claim_faces.off", "OFF 1 100000000000 0\n0 0 0\n", "after 0 of 100000000000 faces"},
      {"binary.off", "OFF BINARY\n" + times(9, kZero), ":1: the header does not give"},
      {"more.off", "OFF 1 1 0\n0 0 0\n3 0 0 0\n\n1\n", ":5: more lines"},
      {"magic.ply", "PLY\n", ":1: no PLY header"},
      {"endless.ply", kPlyStart + "3\n" + times(1000, "comment\n"), "the header does not end"},
      {"claim.ply", kPlyStart + "100000000000" + kPlyRest + kPlyBody, "vertex 5 of 100000000000"},
      {"corner.ply", kPlyStart + "3" + kPlyRest + "0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n",
       ":13: a corner is out of range"},
      {"list.ply", kPlyStart + "3" + kPlyRest + "0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n",
       "ends in face 1"},
      {"short.ply", kPlyStart + "3" + kPlyRest + "0 0 0\n1 0 0\n0 1", "vertex 3 of 3"},
      {"facets.stl", "solid\n" + kFacet + "facet normal", ":9: "},
      {"open.stl", "solid\n" + kFacet, ": the file is cut short"},
      {"name.stl", "solid", ": the file is cut short"},
      {"little.stl", "abc", "neither a text nor a binary STL"},
      {"claim.stl", "x" + times(79, kZero) + "\xFF\xFF\xFF\xFF", "the file has 84 bytes"},
      {"list.gltf", "[]", "is no glTF 2.0"},
      {"cut.gltf", kGltf + "\"nodes\": [", ":1: "},
      {"deep.gltf", times(100'000, "["), "nested deeper"},
      {"objects.gltf", times(100'000, "{\"a\":"), "nested deeper"},
      {"mesh.gltf", kGltf + R"("scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 5}]})",
       "assimp cannot read it"},
      {"none.gltf", kGltf + R"("scenes": [{"nodes": []}]})", ""},
      {"claim.gltf", kGltf + R"("accessors": [{"count": 100000000000}]})", "accessor 0 claims"},
      {"passwd.gltf", kGltf + R"("buffers": [{"uri": "/etc/passwd", "byteLength": 9}]})",
       "not read"},
      {"cut.glb", "glTF", "the file is cut short"},
      {"zero.glb", times(100, kZero), ":1: "},
      {"text.dae", "COLLADA\n", "is no COLLADA"},
      {"html.dae", "<html>\n</html>\n", ":1: 'html' is out of place"},
      {"open.dae", "<COLLADA>\n<asset>", "'asset' is not closed"},
      {"empty_root.dae", "<COLLADA/>", "assimp cannot read it"},
      {"scene", kTriangle, "the file type '' is not known"},
      {"scene.fbx", kTriangle, "give .obj, .off, .ply, .stl, .gltf, .glb or .dae"},
  };
  for (const Case& bad : cases) expect_refused(bad, {"inspect"});
}

TEST_F(Malformed, Regions) {
  const RoomFolder room;
  const auto square = [](const std::string& corner) {
    return R"({"polygons": [[[1,1,1.5],[2,1,1.5],[2,2,1.5],)" + corner + "]]}";
  };
  const std::vector<Case> cases = {
      {"blank.json", " \n\n", "is empty"},
      {"zero.json", times(50, kZero), ":1: "},
      {"utf16.json", utf16(square("[1,2,1.5]")), "UTF-16"},
      {"deep.json", "{\"polygons\": " + times(100'000, "["), "nested deeper"},
      {"deep_but_whole.json", "{\"polygons\": " + times(99'999, "[") + times(99'999, "]") + "}",
       "nested deeper"},
      {"nan.json", square("[1,2,NaN]"), ":1: "},
      {"large.json", square("[1,2,1e400]"), "1e400 is not finite"},
      {"far.json", square("[1,2,1e30]"), "corner 4: lies too far"},
      {"text.json", square(R"(["1",2,1.5])"), "corner 4: is not a point"},
      {"two.json", square("[1,2]"), "corner 4: is not a point"},
      {"point.json", R"({"polygons": [[[1,1,1],[1,1,1],[1,1,1]]]})", "has no area"},
      {"line.json", R"({"polygons": [[[1,1,1],[2,2,1],[3,3,1]]]})", "has no area"},
      {"bent.json", square("[1,2,1.9]"), "is not planar"},
      {"bow.json", R"({"polygons": [[[1,1,1],[2,2,1],[2,1,1],[1,2,1]]]})", "crosses itself"},
      {"box.json", R"({"boxes": [{"min": [1,1,1], "max": [1,2,2]}]})", "min is not below max"},
      {"key.json", R"({"polygon": []})", "unknown key"},
      {"twice.json", square("[1,2,1.5]") + "{}", ":1: "},
      {"comment.json", "// a region\n" + square("[1,2,1.5]"), ":1: "},
  };
  for (const Case& bad : cases) {
    expect_refused(bad, {"solve", room.scene(), "-o", room.bundle(), "--region"});
    EXPECT_FALSE(std::filesystem::exists(room.bundle()));
  }
}

TEST_F(Malformed, FloorPlans) {
  const std::vector<Case> cases = {
      {"empty.txt", "", "has no corners"},
      {"comments.txt", "# a\n# b\n", "has no corners"},
      {"zero.txt", times(9, kZero), ":1: "},
      {"utf16.txt", utf16("0 0\n1 0\n0 1\n"), "UTF-16"},
      {"three.txt", "0 0\n1 0 5\n", ":2: '1 0 5' is no corner"},
      {"nan.txt", "0 0\n1 0\nnan 1\n", ":3: 'nan 1' is no corner"},
      {"two.txt", "0 0\n1 0\n", "fewer than 3 corners"},
      {"hole.txt", "0 0\n9 0\n9 9\n0 9\nhole\n1 1\n2 2\n", "fewer than 3 corners"},
      {"bow.txt", "0 0\n1 1\n1 0\n0 1\n", ""},
      {"outside.txt", "0 0\n1 0\n1 1\n0 1\n\n5 5\n6 5\n6 6\n", ""},
  };
  for (const Case& bad : cases) {
    const std::string output = (folder_.path() / "plan.obj").string();
    expect_refused(bad, {"generate", "gallery"}, {"--height", "3", "-o", output});
    EXPECT_FALSE(std::filesystem::exists(output));
  }
  const std::string huge = folder_.write("huge.txt", "0 0\n1e300 0\n1e300 1e300\n").string();
  testing::expect_refused(
      viewcover_run({"generate", "gallery", huge, "--height", "3", "-o", huge + ".obj"}),
      "--height: 3 is too low for the plan");
}

TEST_F(Malformed, Matrices) {
  const std::vector<Case> matrices = {
      {"empty.mtx", "", ""},
      {"real.mtx", "%%MatrixMarket matrix coordinate real general\n1 1 1\n1 1 1\n", ":1: "},
      {"claim.mtx", kMatrix + "100000000000 1 1\n1 1\n", "too large"},
      {"claim_entries.mtx", kMatrix + "2 2 100000000000\n1 1\n", "the file ends before a row"},
      {"zero_index.mtx", kMatrix + "2 2 1\n0 1\n", ":3: 0 is not a row"},
      {"word.mtx", kMatrix + "2 2 1\none 1\n", ":3: 'one' is not a row"},
      {"more.mtx", kMatrix + "2 2 1\n1 1\n2 2\n", ":4: there is more"},
  };
  for (const Case& bad : matrices) expect_refused(bad, {"cover"});
  const std::vector<Case> or_library = {
      {"empty", "", "the file ends before"},
      {"claim", "2000000000 2000000000\n", "too large"},
      {"claim_costs", "10 1000000\n1 1 1\n", "the file ends before"},
      {"fraction", "1.5 2\n", ":1: "},
      {"zero", times(20, kZero), ":1: "},
  };
  for (const Case& bad : or_library) {
    expect_refused(bad, {"cover", "--format", "scp"});
    expect_refused(bad, {"cover", "--format", "rail"});
  }
}

TEST_F(Malformed, Queries) {
  const std::string good =
      R"({"id": 7, "viewpoint": [0,0,0], "element": [[0,0,1],[1,0,1],[0,1,1]]})";
  const std::vector<std::string> bad = {
      "{",
      "[]",
      "null",
      times(30, kZero),
      utf16("{}"),
      times(200'000, "["),
      R"({"id": )" + times(200'000, "[") + times(200'000, "]") + "}",
      R"({"viewpoint": [0,0,1e999], "element": [[0,0,1],[1,0,1],[0,1,1]]})",
      R"({"viewpoint": [0,0,1e200], "element": [[0,0,1],[1,0,1],[0,1,1]]})",
      R"({"viewpoint": [0,0,1e-200], "element": [[0,0,1],[1,0,1],[0,1,1]]})",
      R"({"viewpoint": [0,0], "element": [[0,0,1],[1,0,1],[0,1,1]]})",
      R"({"viewpoint": [0,0,0], "element": [[0,0,1],[1,0,1],[0,1,1]], "occluders": {}})",
      R"({"viewpoint": [0,0,0], "element": [[0,0,1],[1,0,1],[2,0,1]]})",
  };
  std::string lines = "\xEF\xBB\xBF" + good + "\r\n\r\n";
  for (const std::string& line : bad) lines += line + "\n";
  const Outcome outcome =
      viewcover_run({"sees", folder_.write("q.jsonl", lines + good).string()});  // no last line end
  EXPECT_EQ(outcome.exit_code, 2);
  std::istringstream answers(outcome.out);
  std::string answer;
  for (std::size_t i = 0; i < bad.size() + 2; ++i) {
    ASSERT_TRUE(std::getline(answers, answer)) << i;
    const bool is_good = i == 0 || i == bad.size() + 1;
    EXPECT_EQ(Json::parse(answer).contains("error"), !is_good) << answer.substr(0, 200);
  }
  EXPECT_FALSE(std::getline(answers, answer));
}

TEST_F(Malformed, FoldersInPlaceOfFiles) {
  const std::string folder = folder_.path().string();
  const RoomFolder room;
  const auto refused = [&](const std::vector<std::string>& arguments) {
    SCOPED_TRACE(::testing::PrintToString(arguments));
    testing::expect_refused(viewcover_run(arguments), folder);
  };
  std::filesystem::create_directory(folder + "/a.obj");
  std::filesystem::create_directory(folder + "/a.glb");
  refused({"inspect", folder + "/a.obj"});
  refused({"inspect", folder + "/a.glb"});
  refused({"solve", room.scene(), "-o", room.bundle(), "--region", folder});
  refused({"generate", "gallery", folder, "--height", "3", "-o", room.bundle("g.obj")});
  refused({"cover", folder});
  refused({"cover", folder, "--format", "scp"});
  refused({"sees", folder});
}

/// Odd, but it can be read: so many faces in the file, polygons, and repairs of one kind.
struct Odd {
  std::string name, content;
  int faces, polygons;
  std::string repair;
  int repaired;
};

TEST_F(Malformed, OddScenesAreReadOrRepaired) {
  std::string polygon, corners;
  for (int i = 0; i < 66; ++i) {
    const double angle = 6.283185307179586 * i / 66;
    polygon +=
        "v " + std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0\n";
    corners += " " + std::to_string(i + 1);
  }
  const std::string square = kTriangle + "v 1 1 0\n";
  const std::vector<Odd> cases = {
      {"mark.obj", "\xEF\xBB\xBF" + kTriangle + "f 1 2 3", 1, 1, "split_faces", 0},
      {"crlf.obj", "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n", 1, 1, "split_faces", 0},
      {"cr.obj", "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3", 1, 1, "split_faces", 0},
      {"comments.obj", times(9, "#\n# f 1 2 9\n") + kTriangle + "f 1 2 3 # 4\n#", 1, 1,
       "split_faces", 0},
      {"back.obj", kTriangle + "f -3 -2 -1\n", 1, 1, "split_faces", 0},
      {"sixty_six.obj", polygon + "f" + corners + "\n", 1, 1, "degenerate_faces", 0},
      {"concave.obj", "v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n", 1, 2, "split_faces", 1},
      {"bent.obj", square + "v 0 1 0.25\nf 1 2 4 5\n", 1, 2, "triangulated_faces", 1},
      {"twice.obj", kTriangle + "f 1 2 3\nf 2 3 1\nf 3 2 1\n", 3, 1, "duplicate_faces", 2},
      {"needle.obj", kTriangle + "f 1 2 3\nf 1 2 2\nf 1 1 1\n", 3, 1, "degenerate_faces", 2},
      {"huge.obj", "v 1e30 0 0\nv 0 1e30 0\nv 0 0 1e30\nf 1 2 3\n", 1, 1, "degenerate_faces", 0},
      {"tiny.obj", "v 1e-30 0 0\nv 0 1e-30 0\nv 0 0 1e-30\nf 1 2 3\n", 1, 1, "degenerate_faces", 0},
      {"huge_and_tiny.obj",
       "v 1e30 0 0\nv 0 1e30 0\nv 0 0 1e30\nf 1 2 3\nv 1e-30 0 0\nv 0 1e-30 0\nv 0 0 1e-30\nf 4 5 "
       "6\n",
       2, 1, "degenerate_faces", 1},
      {"denormal.obj", kTriangle + "v 1e-320 1 1\nf 1 2 3\nf 1 2 4\n", 2, 2, "degenerate_faces", 0},
      {"colours.off", "COFF 3 1\n0 0 0 1 0 0 1\n1 0 0 1 0 0 1\n0 1 0 1 0 0 1\n3 0 1 2 9 9 9", 1, 1,
       "split_faces", 0},
      {"plain.ply", kPlyStart + "3" + kPlyRest + kPlyBody, 1, 1, "split_faces", 0},
      {"crlf.stl", "solid\r\n" + kFacet + "endsolid", 1, 1, "split_faces", 0},
      {"solids.stl", "solid a\n" + kFacet + "endsolid a\nsolid b\n" + kFacet + "endsolid", 2, 1,
       "duplicate_faces", 1},
      {"CAPITALS.OBJ", kTriangle + "f 1 2 3\n", 1, 1, "split_faces", 0},
  };
  for (const Odd& odd : cases) {
    SCOPED_TRACE(odd.name);
    const Outcome outcome =
        viewcover_run({"inspect", folder_.write(odd.name, odd.content).string(), "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const Json found = Json::parse(last_line(outcome.out));
    EXPECT_EQ(found.at("size").at("faces"), odd.faces);
    EXPECT_EQ(found.at("size").at("polygons"), odd.polygons);
    EXPECT_EQ(found.at("repairs").at(odd.repair), odd.repaired);
  }
}

}  // namespace
}  // namespace viewcover::testing
