#include "scene/read/asset_soup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "scene/error.h"
#include "scene/read/polygon_soup.h"
#include "scene/scratch_folder.h"
#include "support/sanitized.h"

namespace viewcover {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using Face = PolygonSoup::Face;

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      text += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

template <class T>
void append_bytes(std::string& bytes, T value) {
  char raw[sizeof value];
  std::memcpy(raw, &value, sizeof value);
  bytes.append(raw, sizeof value);
}

/// Four corners of the unit square at height 0.1, its two triangles, and a line.
std::string square_bytes() {
  std::string bytes;
  for (const float x : {0.f, 0.f, 0.1f, 1.f, 0.f, 0.1f, 1.f, 1.f, 0.1f, 0.f, 1.f, 0.1f}) {
    append_bytes(bytes, x);
  }
  for (const int corner : {0, 1, 2, 0, 2, 3, 0, 1}) {
    append_bytes(bytes, static_cast<std::uint16_t>(corner));
  }
  return bytes;
}

/// A mesh "square" of triangles and a line, shown by a node "left", by its child "right" 10 to the
/// side, and by a mirrored node without a name. `buffer` is what the buffer says of itself.
std::string gltf(const std::string& buffer, const std::string& nodes = "") {
  return R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 2]}],
    "nodes": [)" +
         (nodes.empty() ? R"({"name": "left", "mesh": 0, "translation": [0, 0, 2], "children": [1]},
      {"name": "right", "mesh": 0, "translation": [10, 0, 0], "scale": [1, 2, 1]},
      {"mesh": 0, "scale": [-1, 1, 1]})"
                        : nodes) +
         R"(],
    "meshes": [{"name": "square", "primitives": [
      {"attributes": {"POSITION": 0}, "indices": 1},
      {"attributes": {"POSITION": 0}, "indices": 2, "mode": 1}]}],
    "buffers": [{)" +
         buffer + R"("byteLength": 64}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 16}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0,0,0], "max": [1,1,1]},
      {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"},
      {"bufferView": 1, "byteOffset": 12, "componentType": 5123, "count": 2, "type": "SCALAR"}]})";
}

std::string embedded() {
  return R"("uri": "data:application/octet-stream;base64,)" + base64(square_bytes()) + "\", ";
}

std::string glb(std::string json) {
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const std::string binary = square_bytes();
  std::string bytes = "glTF";
  append_bytes<std::uint32_t>(bytes, 2);
  append_bytes(bytes, static_cast<std::uint32_t>(12 + 8 + json.size() + 8 + binary.size()));
  append_bytes(bytes, static_cast<std::uint32_t>(json.size()));
  bytes += "JSON" + json;
  append_bytes(bytes, static_cast<std::uint32_t>(binary.size()));
  bytes += std::string("BIN\0", 4) + binary;
  return bytes;
}

/// A quadrilateral and a triangle at height 1 foot, z up, in feet; a node and an instance of it.
std::string collada(const std::string& nodes) {
  return R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="foot" meter="0.25"/><up_axis>Z_UP</up_axis></asset>
  <library_geometries>
    <geometry id="g1" name="plate"><mesh>
      <source id="p"><float_array id="pa" count="15">0 0 1 4 0 1 4 4 1 0 4 1 8 8 1</float_array>
        <technique_common><accessor source="#pa" count="5" stride="3">
          <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
        </accessor></technique_common></source>
      <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
      <polylist count="2"><input semantic="VERTEX" source="#v" offset="0"/>
        <vcount>4 3</vcount><p>0 1 2 3 3 2 4</p></polylist>
    </mesh></geometry>
  </library_geometries>
)" + nodes +
         R"(
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
)";
}

constexpr const char* kInstances = R"(  <library_nodes><node id="n1" name="tile">
    <instance_geometry url="#g1"/></node></library_nodes>
  <library_visual_scenes><visual_scene id="scene">
    <node id="a" name="here"><instance_node url="#n1"/></node>
    <node id="b" name="there"><translate>0 0 8</translate><instance_geometry url="#g1"/></node>
  </visual_scene></library_visual_scenes>)";

class AssetSoup : public ::testing::Test {
 protected:
  PolygonSoup read(const std::string& name, std::string_view content) const {
    return read_polygon_soup(folder_.write(name, content));
  }
  std::string error(const std::string& name, std::string_view content) const {
    try {
      read(name, content);
    } catch (const InputError& error) {
      const std::string line = error.what();
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
      return line.substr(folder_.path().string().size() + 1);
    }
    return "no error";
  }

  ScratchFolder folder_;
};

void expect_squares(const PolygonSoup& soup) {
  ASSERT_EQ(soup.vertices.size(), 12u);
  const double height = 0.1f;
  EXPECT_EQ(soup.vertices[2], Point(1, 1, 2 + height));
  EXPECT_EQ(soup.vertices[6], Point(11, 2, 2 + height));  // placed within its parent
  EXPECT_EQ(soup.vertices[10], Point(-1, 1, height));
  EXPECT_THAT(soup.faces, ElementsAre(Face{0, 1, 2}, Face{0, 2, 3}, Face{4, 5, 6}, Face{4, 6, 7},
                                      Face{8, 10, 9}, Face{8, 11, 10}));  // fronts stay fronts
  ASSERT_EQ(soup.groups.size(), 3u);
  EXPECT_THAT(soup.groups[0], StartsWith("left/square"));
  EXPECT_THAT(soup.groups[1], StartsWith("right/square"));
  EXPECT_THAT(soup.face_groups,
              ElementsAre(GroupId(0), GroupId(0), GroupId(1), GroupId(1), GroupId(2), GroupId(2)));
}

TEST_F(AssetSoup, FlattensInstancesOfGltf) {
  expect_squares(read("embedded.gltf", gltf(embedded())));
  expect_squares(read("binary.glb", glb(gltf(""))));
  folder_.write("beside.bin", square_bytes());
  expect_squares(read("beside.gltf", gltf(R"("uri": "beside.bin", )")));
}

TEST_F(AssetSoup, KeepsPolygonsAndAxesOfCollada) {
  const PolygonSoup soup = read("a.dae", collada(kInstances));
  ASSERT_EQ(soup.faces.size(), 4u);
  EXPECT_EQ(soup.faces[0].size(), 4u);
  EXPECT_EQ(soup.faces[1].size(), 3u);
  EXPECT_EQ(soup.vertices[soup.faces[0][2]], Point(1, 1, 0.25));  // in metres, z up
  EXPECT_EQ(soup.vertices[soup.faces[3][2]], Point(2, 2, 2.25));
  EXPECT_THAT(soup.groups, ElementsAre("tile/plate", "there/plate"));
}

TEST_F(AssetSoup, RefusesBadGltfInOneLine) {
  const auto bad = [&](const std::string& from, const std::string& to) {
    std::string text = gltf(embedded());
    text.replace(text.find(from), from.size(), to);
    return error("a.gltf", text);
  };
  EXPECT_THAT(error("a.gltf", "{"), StartsWith("a.gltf:1: "));
  EXPECT_THAT(error("a.gltf", "[]"), StartsWith("a.gltf: is no glTF 2.0"));
  EXPECT_THAT(error("a.gltf", "solid\n"), StartsWith("a.gltf:1: "));
  EXPECT_THAT(bad("\"2.0\"", "\"1.0\""), StartsWith("a.gltf: is no glTF 2.0"));
  EXPECT_THAT(bad("\"count\": 4", "\"count\": 100000000000"), HasSubstr("accessor 0 claims"));
  EXPECT_THAT(bad("\"count\": 6", "\"count\": 60"), StartsWith("a.gltf: "));
  EXPECT_THAT(bad("\"count\": 6", "\"count\": -6"), StartsWith("a.gltf: \"count\" is no count"));
  EXPECT_THAT(bad("\"count\": 4", "\"sparse\": {}, \"count\": 4"),
              HasSubstr("accessor 0 is sparse"));
  EXPECT_THAT(bad("[1]}", "[0]}"), HasSubstr("nodes are their own children"));
  EXPECT_THAT(bad("[1]}", "[7]}"), HasSubstr("a child of node 0 does not exist"));
  EXPECT_THAT(bad("[1]}", "[1, 1]}"), HasSubstr("node 1 has two parents"));
  EXPECT_THAT(error("a.gltf", gltf(R"("uri": "none.bin", )")),
              HasSubstr("'none.bin' is not there"));
  for (const char* outside : {"../a.bin", "/etc/passwd", "http://a/b", ".", "%2e", "a\\\\b"}) {
    EXPECT_THAT(error("a.gltf", gltf("\"uri\": \"" + std::string(outside) + "\", ")),
                HasSubstr("is not read"));
  }
  folder_.write("short.bin", "abc");
  EXPECT_THAT(error("a.gltf", gltf(R"("uri": "short.bin", )")), HasSubstr("shorter than it says"));
  EXPECT_THAT(
      error("a.gltf", R"({"asset": {"version": "2.0"}, "extras": )" + std::string(100'000, '[')),
      HasSubstr("nested deeper than"));
  std::string chain = R"({"mesh": 0})";
  for (int i = 1; i < 1000; ++i)
    chain = R"({"children": [)" + std::to_string(1000 - i) + "]}, " + chain;
  EXPECT_THAT(error("a.gltf", gltf(embedded(), chain)), HasSubstr("nodes deeper than"));
}

TEST_F(AssetSoup, RefusesGlbCutShortAnywhere) {
  const std::string whole = glb(gltf(""));
  for (std::size_t size = 1; size < whole.size(); size += 7) {
    EXPECT_THAT(error("a.glb", whole.substr(0, size)), StartsWith("a.glb")) << size;
  }
  std::string bytes = whole;
  bytes[4] = 1;
  EXPECT_THAT(error("a.glb", bytes), HasSubstr("another version"));
}

TEST_F(AssetSoup, EndsAnAssimpThatAsksForMoreAndMore) {
  if (viewcover::testing::sanitized()) GTEST_SKIP() << "sanitizers need more than any limit";
  std::string text = collada(kInstances);
  const std::string corners = "<p>0 1 2";
  text.replace(text.find(corners), corners.size(), "<p>0 1\x01 2");
  EXPECT_THAT(error("a.dae", text), HasSubstr("assimp needs more memory"));
}

TEST_F(AssetSoup, RefusesBadColladaInOneLine) {
  const std::string whole = collada(kInstances);
  for (std::size_t size = 1; size < whole.find("</COLLADA>"); size += 11) {
    EXPECT_THAT(error("a.dae", whole.substr(0, size)), StartsWith("a.dae")) << size;
  }
  EXPECT_THAT(error("a.dae", "<html></html>"), StartsWith("a.dae:1: 'html' is out of place"));
  EXPECT_THAT(error("a.dae", "<COLLADA></node></COLLADA>"), StartsWith("a.dae:1: 'node' closes"));
  const auto nodes = [&](const std::string& library) {
    return error("a.dae", collada("<library_nodes>" + library + "</library_nodes>" + kInstances));
  };
  EXPECT_THAT(nodes(R"(<node id="x"><instance_node url="#x"/></node>)"),
              HasSubstr("an instance of itself"));
  std::string laughs;
  for (int i = 0; i < 40; ++i) {
    const std::string next = R"(<instance_node url="#l)" + std::to_string(i + 1) + R"("/>)";
    laughs += R"(<node id="l)" + std::to_string(i) + "\">" + next + next + "</node>\n";
  }
  EXPECT_THAT(nodes(laughs), HasSubstr("instances of nodes"));
  std::string deep, close;
  for (int i = 0; i < 1000; ++i) deep += "<node>", close += "</node>";
  EXPECT_THAT(nodes(deep + close), HasSubstr("nested deeper than"));
}

}  // namespace
}  // namespace viewcover
