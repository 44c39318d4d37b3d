#include "scene/viewing_region.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "scene/error.h"

namespace viewcover {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// A file in a folder of its own, gone with the test.
class RegionFile : public testing::Test {
 protected:
  void SetUp() override {
    std::string folder = (std::filesystem::temp_directory_path() / "region-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder.data()), nullptr);
    folder_ = folder;
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& text, const std::string& name = "r.json") {
    const std::filesystem::path file = folder_ / name;
    std::ofstream(file) << text;
    return file;
  }
  ViewingRegion load(const std::string& text, Lattice lattice = {10}, std::size_t regions = 1) {
    return load_viewing_region(write(text), lattice, regions);
  }
  // The message, without the folder; empty if the text is accepted.
  std::string error_of(const std::string& text, Lattice lattice = {10}, std::size_t regions = 1) {
    try {
      load(text, lattice, regions);
    } catch (const InputError& error) {
      std::string message = error.what();
      const std::string prefix = folder_.string() + "/";
      if (message.starts_with(prefix)) message.erase(0, prefix.size());
      EXPECT_EQ(message.find('\n'), std::string::npos) << message;
      return message;
    }
    return "";
  }

  std::filesystem::path folder_;
};

using ViewingRegionFile = RegionFile;
using ViewingRegionError = RegionFile;

TEST_F(ViewingRegionFile, PolygonsAndBoxes) {
  const ViewingRegion region = load(R"({
    "polygons": [[[0,0,1], [4,0,1], [4,2,1], [0,2,1]], [[0,0,2.5], [1,0,2.5], [0,1,2.5]]],
    "boxes": [{"min": [0,0,3], "max": [1,2,6]}]})");
  ASSERT_EQ(region.parts.size(), 8u);
  EXPECT_EQ(region.parts[0], (ConvexPolygon{{0, 0, 1}, {4, 0, 1}, {4, 2, 1}, {0, 2, 1}}));
  EXPECT_EQ(region.parts[1], (ConvexPolygon{{0, 0, 2.5}, {1, 0, 2.5}, {0, 1, 2.5}}));
  Point sum = Point::Zero();
  double box_area = 0;
  for (std::size_t i = 2; i < 8; ++i) {
    EXPECT_TRUE(is_planar(region.parts[i]));
    EXPECT_TRUE(is_strictly_convex(region.parts[i]));
    EXPECT_LT(area_vector(region.parts[i]).dot(corner_mean(region.parts[i]) - Point(.5, 1, 4.5)), 0)
        << "the front is inward";
    sum += area_vector(region.parts[i]);
    box_area += area(region.parts[i]);
  }
  EXPECT_EQ(sum, Point(0, 0, 0));
  EXPECT_EQ(box_area, 2 * (1 * 2 + 2 * 3 + 3 * 1));
}

// Each box looks through a face that they share to its own side.
TEST_F(ViewingRegionFile, FaceSharedByTwoBoxesIsOneOfEach) {
  const ViewingRegion region = load(R"({"boxes": [{"min": [0,0,0], "max": [1,1,1]},
                                                  {"min": [1,0,0], "max": [3,1,1]}]})");
  ASSERT_EQ(region.parts.size(), 12u);
  std::vector<Point> shared;
  for (const ConvexPolygon& face : region.parts) {
    if (corner_mean(face) == Point(1, 0.5, 0.5)) shared.push_back(area_vector(face));
  }
  ASSERT_EQ(shared.size(), 2u);
  EXPECT_LT(shared[0].x(), 0);
  EXPECT_GT(shared[1].x(), 0);
}

TEST_F(ViewingRegionFile, CoordinatesGoToTheLattice) {
  const ViewingRegion region =
      load(R"({"polygons": [[[0.1,0,-0.01], [1.4,0,0], [1.4,0.9,0.01]]]})", {1});
  EXPECT_EQ(region.parts[0], (ConvexPolygon{{0, 0, 0}, {1.5, 0, 0}, {1.5, 1, 0}}));
  EXPECT_FALSE(std::signbit(region.parts[0][0].z()));
}

TEST_F(ViewingRegionFile, NeedlessCornersAreRemoved) {
  const ViewingRegion region = load(R"({"polygons": [[[0,0,0], [0,0,0], [2,0,0], [4,0,0], [4,4,0],
      [4,4,0], [2,4,0], [1,4,0], [0,4,0], [0,1,0], [0,0,0]]]})");
  ASSERT_EQ(region.parts.size(), 1u);
  EXPECT_EQ(area(region.parts[0]), 16);
  EXPECT_EQ(region.parts[0].size(), 4u);
  EXPECT_TRUE(is_strictly_convex(region.parts[0]));
  EXPECT_EQ(
      load("{\"polygons\": [[[0,0,0],[0,0,0],[0,0,0],[2,0,0],[0,2,0],[0,0,0],[0,0,0]]]}").parts,
      std::vector<ConvexPolygon>({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}}));
}

// In the plane 3 z = x + y, with corners in the middle of edges, written with four decimals.
TEST_F(ViewingRegionFile, SlantedPolygonIsMadeExactlyPlanar) {
  const ViewingRegion region = load(R"({"polygons": [[[0,0,0], [1,0,0.3333], [2,0,0.6667],
      [2.5,1,1.1667], [2,2,1.3333], [1,2,1], [0,2,0.6667], [-0.5,1,0.1667]]]})",
                                    {20});
  EXPECT_GT(region.parts.size(), 1u);
  double total = 0;
  for (const ConvexPolygon& part : region.parts) {
    EXPECT_EQ(part.size(), 3u);
    EXPECT_TRUE(is_strictly_convex(part));
    total += area(part);
  }
  // 5 in the plane of x and y; the plane is steeper by sqrt(1 + 2/9).
  EXPECT_NEAR(total, 5 * std::sqrt(11.0 / 9), 1e-3);
}

// In the plane z = 0 rounding keeps corners planar but may push one across the chord.
TEST_F(ViewingRegionFile, RoundingMakesNoPolygonConcave) {
  for (const int exponent : {1, 2, 3, 4, 5, 10, 20}) {
    const ViewingRegion region = load(
        R"({"polygons": [[[0,0,0], [1,0.3333333333,0], [2,0.6666666667,0], [3,1,0], [0,3,0]],
                         [[0,0,0], [0,3,0], [3,1,0], [2,0.6666666667,0], [1,0.3333333333,0]]]})",
        {exponent});
    ASSERT_EQ(region.parts.size(), 2u);
    for (const ConvexPolygon& part : region.parts) {
      EXPECT_TRUE(is_strictly_convex(part));
      EXPECT_NEAR(area(part), 4.5, std::ldexp(1.0, -exponent));
    }
  }
}

TEST_F(ViewingRegionFile, MeshFaces) {
  const auto file = write("v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n", "r.OBJ");
  const ViewingRegion region = load_viewing_region(file, {10}, 16);
  ASSERT_EQ(region.parts.size(), 1u);
  EXPECT_EQ(area(region.parts[0]), 4);
  EXPECT_EQ(region.region_count(), 16u);
}

TEST_F(ViewingRegionError, File) {
  try {
    load_viewing_region(folder_ / "none.json", {10}, 1);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("none.json: no such file"));
  }
  try {
    load_viewing_region(folder_, {10}, 1);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(": is a folder"));
  }
  EXPECT_THAT(error_of(""), StartsWith("r.json: is empty"));
  EXPECT_THAT(error_of(" \n\n"), StartsWith("r.json: is empty"));
}

TEST_F(ViewingRegionError, SyntaxNamesTheLine) {
  EXPECT_THAT(error_of("{\"polygons\": [[\n[0,0,0],\n[1,0,],\n[0,1,0]]]}"),
              StartsWith("r.json:3: syntax error"));
  EXPECT_THAT(error_of("{\n\"polygons\": [[[0,0,NaN"), StartsWith("r.json:2: syntax error"));
  EXPECT_THAT(error_of("{\"boxes\":\n\n"), StartsWith("r.json:"));
  EXPECT_THAT(error_of("{\n\"polygons\": [[[0,0,0],[1,0,0],\n[0,-1e999,0]]]}"),
              StartsWith("r.json:3: the number -1e999 is not finite"));
  EXPECT_THAT(error_of(std::string("{\"polygons\": \"\x01\xff\n\"}")), StartsWith("r.json:1: "));
}

TEST_F(ViewingRegionError, Structure) {
  EXPECT_THAT(error_of("[]"), StartsWith("r.json: is not a JSON object"));
  EXPECT_THAT(error_of("{}"), StartsWith("r.json: has no polygon and no box"));
  EXPECT_THAT(error_of(R"({"polygons": [], "boxes": []})"),
              StartsWith("r.json: has no polygon and no box"));
  EXPECT_EQ(error_of(R"({"polgons": []})"),
            "r.json: unknown key \"polgons\"; use \"polygons\" or \"boxes\"");
  EXPECT_EQ(error_of(R"({"line\nbreak": []})"),
            "r.json: unknown key \"line\\nbreak\"; use \"polygons\" or \"boxes\"");
  EXPECT_THAT(error_of(R"({"polygons": {}})"), StartsWith("r.json: \"polygons\" is not a list"));
  EXPECT_THAT(error_of(R"({"boxes": 3})"), StartsWith("r.json: \"boxes\" is not a list"));
}

TEST_F(ViewingRegionError, Polygons) {
  const auto second = [&](const std::string& polygon) {
    return error_of(R"({"polygons": [[[0,0,0],[1,0,0],[0,1,0]], )" + polygon + "]}");
  };
  EXPECT_EQ(second("[[0,0,0],[1,0,0],[0,1,0]]"), "");
  EXPECT_THAT(second("7"), StartsWith("r.json: polygon 2: is not a list of corners"));
  EXPECT_THAT(second("[]"), StartsWith("r.json: polygon 2: has 0 corners"));
  EXPECT_THAT(second("[[0,0,0],[1,0,0]]"), StartsWith("r.json: polygon 2: has 2 corners"));
  EXPECT_THAT(second("[[0,0,0],[1,0],[1,1,0]]"),
              StartsWith("r.json: polygon 2: corner 2: is not a point"));
  EXPECT_THAT(second("[[0,0,0],[1,0,0],[1,\"1\",0]]"),
              StartsWith("r.json: polygon 2: corner 3: is not a point"));
  EXPECT_THAT(second("[[0,0,0],[1,0,0],[1e9,1,0]]"),
              StartsWith("r.json: polygon 2: corner 3: lies too far"));
  EXPECT_THAT(second("[[0,0,0],[1,0,0],[3,0,0]]"), StartsWith("r.json: polygon 2: has no area"));
  EXPECT_THAT(second("[[0,0,0],[1,1,1],[1e-5,0,0],[1,1,1]]"),
              StartsWith("r.json: polygon 2: has no area"));
  EXPECT_THAT(second("[[2,2,2],[2,2,2],[2,2,2]]"), StartsWith("r.json: polygon 2: has no area"));
  EXPECT_THAT(second("[[0,0,0],[4,0,0],[4,4,0.5],[0,4,0]]"),
              StartsWith("r.json: polygon 2: is not planar: corner "));
  EXPECT_THAT(second("[[0,0,0],[4,0,0],[1,1,0],[0,4,0]]"),
              StartsWith("r.json: polygon 2: is not convex at corner 3"));
  EXPECT_THAT(second("[[0,0,0],[0,4,0],[1,1,0],[4,0,0]]"),
              StartsWith("r.json: polygon 2: is not convex at corner 3"));
  EXPECT_THAT(second("[[0,0,0],[2,0,0],[4,0,0],[4,4,0],[2,3.98,0],[0,4,0]]"),
              StartsWith("r.json: polygon 2: is not convex at corner 5"));
  EXPECT_THAT(second("[[0,0,0],[4,4,0],[4,0,0],[0,4,0]]"),
              StartsWith("r.json: polygon 2: crosses itself"));
  EXPECT_THAT(second("[[0,0,0],[9,0,0],[4,0,0],[4,4,0],[0,4,0]]"),
              StartsWith("r.json: polygon 2: is not convex at corner "))
      << "a spike";
  EXPECT_THAT(second("[[10,0,0],[-8,6,0],[3,-10,0],[3,10,0],[-8,-6,0]]"),
              StartsWith("r.json: polygon 2: crosses itself"))
      << "a pentagram turns the same way at each corner";
}

TEST_F(ViewingRegionError, Boxes) {
  const auto box = [&](const std::string& text) { return error_of("{\"boxes\": [" + text + "]}"); };
  EXPECT_EQ(box(R"({"min": [0,0,0], "max": [1,1,1]})"), "");
  EXPECT_THAT(box("[]"), StartsWith("r.json: box 1: is not a box"));
  EXPECT_THAT(box(R"({"min": [0,0,0]})"), StartsWith("r.json: box 1: has no \"max\""));
  EXPECT_THAT(box(R"({"min": [0,0,0], "max": [1,1,1], "mid": 0})"),
              StartsWith("r.json: box 1: unknown key \"mid\""));
  EXPECT_THAT(box(R"({"min": [0,0,0], "max": [1,1]})"),
              StartsWith("r.json: box 1: max: is not a point"));
  EXPECT_THAT(box(R"({"min": [0,1,0], "max": [1,1,1]})"),
              StartsWith("r.json: box 1: min is not below max in y"));
  EXPECT_THAT(box(R"({"min": [0,0,2], "max": [1,1,1]})"),
              StartsWith("r.json: box 1: min is not below max in z"));
}

TEST_F(ViewingRegionError, NumberOfRegions) {
  const std::string triangle = R"({"polygons": [[[0,0,0],[1,0,0],[0,1,0]]]})";
  EXPECT_EQ(error_of(triangle, {10}, 63), "--regions: 63 is not a power of 4; use 16 or 64");
  EXPECT_EQ(error_of(triangle, {10}, 2), "--regions: 2 is not a power of 4; use 1 or 4");
  EXPECT_EQ(error_of(triangle, {10}, 0), "--regions: 0 is not a power of 4; use 1 or more");
  EXPECT_EQ(error_of(triangle, {10}, 1 << 22),
            "--regions: 4194304 is too many; use at most 1048576");
  EXPECT_EQ(error_of(triangle, {10}, std::numeric_limits<std::size_t>::max()),
            "--regions: 18446744073709551615 is too many; use at most 1048576");
  EXPECT_EQ(load(triangle, {10}, 1).level, 0);
  EXPECT_EQ(load(triangle, {10}, 64).level, 3);
  EXPECT_EQ(load(triangle, {10}, 1 << 20).level, 10);
}

class Subdivision : public testing::TestWithParam<std::size_t> {};

TEST_P(Subdivision, TilesEachPartAndAddressesRoundTrip) {
  ViewingRegion region;
  while (region.regions_per_part() < GetParam()) ++region.level;
  region.parts = {ConvexPolygon{{0, 0, 1}, {5, 0, 1}, {4, 3, 1}, {0, 2, 1}},
                  ConvexPolygon{{0, 0, 0}, {3, 1, 2}, {-1, 4, 5}},
                  ConvexPolygon{{2, 0, 0}, {4, 0, 0}, {5, 2, 0}, {4, 4, 0}, {2, 5, 0}, {0, 2, 0}}};
  ASSERT_EQ(region.region_count(), 3 * GetParam());
  std::vector<double> areas(3);
  for (std::size_t i = 0; i < region.region_count(); ++i) {
    const RegionAddress address = region.address(i);
    const ConvexPolygon polygon = region.polygon(address);
    ASSERT_EQ(region.first_index(address), i);
    ASSERT_EQ(region.index_count(address), 1u);
    ASSERT_TRUE(is_strictly_convex(polygon)) << i;
    ASSERT_TRUE(is_planar(polygon)) << i;
    ASSERT_GT(area_vector(polygon).dot(area_vector(region.parts[address.owner().value])), 0);
    areas[address.owner().value] += area(polygon);
  }
  for (std::size_t part = 0; part < 3; ++part) {
    const double whole = area(region.parts[part]);
    EXPECT_NEAR(areas[part] / whole, 1, 1e-12);
    const RegionAddress root{PartId(part)};
    EXPECT_EQ(region.first_index(root), part * GetParam());
    EXPECT_EQ(region.index_count(root), GetParam());
    EXPECT_EQ(region.first_index(root.child(3)), part * GetParam() + 3 * GetParam() / 4);
  }
}

INSTANTIATE_TEST_SUITE_P(Counts, Subdivision, testing::Values(64, 1024, 4096));

}  // namespace
}  // namespace viewcover
