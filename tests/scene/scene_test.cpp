#include "scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <sstream>

#include "scene/error.h"
#include "scene/repair/convex_faces.h"
#include "scene/scratch_folder.h"

namespace viewcover {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

class LoadScene : public testing::Test {
 protected:
  Scene load(const std::string& text, const SceneOptions& options = {}) const {
    return load_scene(folder_.write("a.obj", text), options);
  }
  std::string error(const std::string& text, const SceneOptions& options = {}) const {
    try {
      load(text, options);
    } catch (const InputError& error) {
      std::string line = error.what();
      const std::string folder = folder_.path().string() + "/";
      if (line.starts_with(folder)) line.erase(0, folder.size());
      return line;
    }
    return "no error";
  }
  ScratchFolder folder_;
};

// The scene as OBJ, each surface with corners of its own.
std::string as_obj(const Scene& scene) {
  std::ostringstream text;
  text << std::setprecision(17);
  for (const Surface& surface : scene.surfaces) {
    text << "g " << scene.groups[surface.group.value] << '\n';
    for (const Point& p : surface.polygon) {
      text << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
    text << 'f';
    for (std::size_t i = surface.polygon.size(); i > 0; --i) text << " -" << i;
    text << '\n';
  }
  return text.str();
}

using Wide = boost::multiprecision::int128_t;
using WideVector = std::array<Wide, 3>;

WideVector minus(const WideVector& a, const WideVector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
WideVector cross(const WideVector& a, const WideVector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Wide dot(const WideVector& a, const WideVector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A face in lattice steps, 25 bits at most: products of three differences stay far below 127 bits.
using WholeFace = std::vector<WideVector>;

// Twice the vector area, exactly.
WideVector vector_area(const WholeFace& face) {
  WideVector sum{};
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const WideVector piece = cross(minus(face[i], face[0]), minus(face[i + 1], face[0]));
    for (std::size_t k = 0; k < 3; ++k) sum[k] += piece[k];
  }
  return sum;
}

bool is_planar(const WholeFace& face) {
  const WideVector normal = vector_area(face);
  for (const WideVector& corner : face) {
    if (dot(normal, minus(corner, face[0])) != 0) return false;
  }
  return true;
}

double area_in_file_units(const WideVector& twice, const Scene& scene) {
  const double size = std::sqrt(dot(twice, twice).convert_to<double>()) / 2;
  return size * scene.lattice.step() * scene.lattice.step();
}

WideVector in_steps(const Point& p, const Lattice& lattice) {
  WideVector result;
  for (int k = 0; k < 3; ++k) {
    result[static_cast<std::size_t>(k)] = std::llrint(std::ldexp(p[k], lattice.exponent));
  }
  return result;
}

// Another reader than the one tested, for the plain `v` and `f` lines of the shared scenes.
std::vector<WholeFace> faces_of_file(const std::filesystem::path& file, const Lattice& lattice) {
  std::ifstream stream(file);
  std::vector<WideVector> vertices;
  std::vector<WholeFace> faces;
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      Point p;
      words >> p.x() >> p.y() >> p.z();
      vertices.push_back(in_steps(p, lattice));
    } else if (word == "f") {
      faces.emplace_back();
      while (words >> word) {
        const long number = std::stol(word);
        const auto count = static_cast<long>(vertices.size());
        faces.back().push_back(
            vertices[static_cast<std::size_t>(number > 0 ? number - 1 : count + number)]);
      }
    }
  }
  return faces;
}

TEST_F(LoadScene, TargetsAreGroupsByTheirNamesOrTheirObjects) {
  const std::string text =
      std::string(kSquare) +
      "v 0 0 2\no room\ng floor\nf 1 2 3 4\ng wall\nf 1 2 5\no roomy\nf 2 3 5\n";
  const auto targets = [&](const std::vector<std::string>& names) {
    std::string is_target;
    for (const Surface& surface : load(text, {.lattice_exponent = {}, .targets = names}).surfaces) {
      is_target += surface.is_target ? '1' : '0';
    }
    return is_target;
  };
  EXPECT_EQ(targets({}), "111");
  EXPECT_EQ(targets({"room/wall"}), "010");
  EXPECT_EQ(targets({"room"}), "110");
  EXPECT_EQ(targets({"room/floor", "roomy/wall"}), "101");
  EXPECT_THAT(error(text, {.lattice_exponent = {}, .targets = {"roof"}}),
              AllOf(StartsWith("--target: "), HasSubstr("no group \"roof\""),
                    HasSubstr("room/floor, room/wall, roomy/wall")));
}

TEST_F(LoadScene, FillsEverythingIn) {
  const Scene scene = load(std::string(kSquare) + "v 0 0 2\ng floor\nf 1 2 3 4\ng wall\nf 1 2 5\n");
  EXPECT_EQ(scene.name, "a");
  EXPECT_THAT(scene.groups, ElementsAre("floor", "wall"));
  EXPECT_EQ(scene.faces, 2u);
  ASSERT_EQ(scene.surfaces.size(), 2u);
  EXPECT_EQ(scene[SurfaceId(1)].group, GroupId(1));
  EXPECT_EQ(scene[SurfaceId(1)].source_face, 1u);
  EXPECT_EQ(scene.bounds.min(), Point(0, 0, 0));
  EXPECT_EQ(scene.bounds.max(), Point(1, 1, 2));
  EXPECT_DOUBLE_EQ(scene.area(), 2);
  EXPECT_EQ(scene.lattice.exponent, 21);  // 2 < 2^2
  EXPECT_FALSE(scene.repairs.any());
  EXPECT_EQ(scene.repairs.welded_vertices, 0u);
  EXPECT_EQ(scene.repairs.largest_move, 0);
}

TEST_F(LoadScene, CountsRepairs) {
  const Scene scene = load(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 1 0.5\nv 0.5 0.25 0\n"
      "v 1e-9 0 0\nv 1000000 0 0\n"
      "f 1 2 3 4\n"  // 0
      "f 2 3 4 1\n"  // duplicate
      "f 4 3 2 1\n"  // duplicate unless one-sided
      "f 7 2 3 4\n"  // duplicate once welded
      "f 1 2 2\n"    // degenerate
      "f 1 2 3 5\n"  // not planar
      "f 1 6 2 4\n"  // concave: two parts
  );
  EXPECT_EQ(scene.repairs.duplicate_faces, 3u);
  EXPECT_EQ(scene.repairs.degenerate_faces, 1u);
  EXPECT_EQ(scene.repairs.triangulated_faces, 1u);
  EXPECT_EQ(scene.repairs.split_faces, 1u);
  EXPECT_EQ(scene.repairs.welded_vertices, 1u);
  EXPECT_EQ(scene.repairs.largest_move, 1e-9);
  EXPECT_EQ(scene.repairs.summary(),
            "1 degenerate face dropped, 3 duplicate faces dropped, 1 face split into convex parts, "
            "1 face triangulated");
  std::vector<std::uint32_t> sources;
  for (const Surface& surface : scene.surfaces) sources.push_back(surface.source_face);
  EXPECT_THAT(sources, ElementsAre(0, 5, 5, 6, 6));
  EXPECT_EQ(scene.lattice.exponent, 22);  // the vertex at 1000000 belongs to no face

  const std::string both = std::string(kSquare) + "f 1 2 3 4\nf 4 3 2 1\nf 3 4 1 2\n";
  EXPECT_EQ(load(both).surfaces.size(), 1u);
  EXPECT_EQ(load(both, {.lattice_exponent = {}, .one_sided = true}).surfaces.size(), 2u);
}

TEST_F(LoadScene, RefusesWhatItCannotMend) {
  EXPECT_THAT(error(std::string(kSquare) + "f 1 2 3\nf 1 3 2 4\n"),
              StartsWith("a.obj:6: the face crosses itself"));
  EXPECT_THAT(error(std::string(kSquare) + "f 1 2 1\nf 3 3 3\n"),
              StartsWith("a.obj: none of the 2 faces has area"));
  EXPECT_THAT(error("v 0 0 0\nv 1 0 0\nv 0 1e300 0\nf 1 2 3\n"),
              StartsWith("a.obj:3: a coordinate is too large"));
  EXPECT_THAT(error("v 0 0 0\nv 1e-300 0 0\nv 0 1e-300 0\nf 1 2 3\n"),
              StartsWith("a.obj: all coordinates are too small"));
  EXPECT_THAT(error("v 0 0 0\nv 0 0 0\nv 0 0 0\nf 1 2 3\n"), StartsWith("a.obj: none of the 1"));
}

TEST_F(LoadScene, LatticeCanBeChosen) {
  const std::string text = "v 0 0 0\nv 1.3 0 0\nv 0 0.7 0\nf 1 2 3\n";
  EXPECT_EQ(load(text).lattice.exponent, 22);
  const Scene coarse = load(text, {.lattice_exponent = 3});
  EXPECT_EQ(coarse.lattice.exponent, 3);
  EXPECT_THAT(coarse[SurfaceId(0)].polygon,
              ElementsAre(Point(0, 0, 0), Point(1.25, 0, 0), Point(0, 0.75, 0)));
  EXPECT_NEAR(coarse.repairs.largest_move, 0.05, 1e-12);
  for (const int exponent : {23, 2, -100, 1000000000, -1000000000}) {
    EXPECT_THAT(error(text, {.lattice_exponent = exponent}), StartsWith("--lattice: 2^-"));
  }
  EXPECT_THAT(error(text, {.lattice_exponent = 23}), HasSubstr("from 3 to 22"));
}

TEST_F(LoadScene, LoadingAgainChangesNothing) {
  // The largest coordinate is rounded up to a power of two, which needs one bit more.
  std::vector<std::string> texts = {
      "v 7.9999999999 0 0\nv 0.00000095367431640625 1 0\nv 0 0.3 0.1\nf 1 2 3\n",
      "v 3.3 0.1 0\nv 0.7 1.1 0\nv 0.1 0.3 0.1\nv -1 -2.2 0.77\nv 0 0 -0.0\n"
      "g a\nf 1 2 3 4\ng b\nf 1 5 3\nf 2 3 5 4\n"};
  for (const std::string& text : texts) {
    const Scene first = load(text);
    const Scene second = load(as_obj(first));
    EXPECT_EQ(second.lattice, first.lattice);
    EXPECT_EQ(second.repairs.largest_move, 0);
    EXPECT_FALSE(second.repairs.any());
    ASSERT_EQ(second.surfaces.size(), first.surfaces.size());
    for (std::size_t i = 0; i < first.surfaces.size(); ++i) {
      EXPECT_EQ(second.surfaces[i].polygon, first.surfaces[i].polygon);
    }
  }
  EXPECT_EQ(load(texts[0]).lattice.exponent, 19);
}

TEST_F(LoadScene, MergesCoplanarFacesOnRequest) {
  constexpr int kCells = 5;
  std::ostringstream text;
  for (int y = 0; y <= kCells; ++y) {
    for (int x = 0; x <= kCells; ++x) text << "v " << x << ' ' << y * 0.3 << " 0\n";
  }
  text << "g tiles\n";
  for (int y = 0; y < kCells; ++y) {
    for (int x = 0; x < kCells; ++x) {
      const int at = y * (kCells + 1) + x + 1;
      text << "f " << at << ' ' << at + 1 << ' ' << at + kCells + 2 << '\n';
      text << "f " << at << ' ' << at + kCells + 2 << ' ' << at + kCells + 1 << '\n';
    }
  }
  const Scene apart = load(text.str());
  EXPECT_EQ(apart.surfaces.size(), 50u);
  EXPECT_EQ(apart.repairs.merged_surfaces, 0u);
  SceneOptions options;
  options.merge_coplanar = true;
  const Scene merged = load(text.str(), options);
  ASSERT_EQ(merged.surfaces.size(), 1u);
  EXPECT_EQ(merged.surfaces[0].polygon.size(), 4u);
  EXPECT_EQ(merged.repairs.merged_surfaces, 49u);
  EXPECT_NEAR(merged.area(), apart.area(), 1e-14);
}

TEST_F(LoadScene, ConvexPolygonsOnAGivenLattice) {
  const auto file =
      folder_.write("r.off", "OFF 4 1 0\n0 0 0.4\n4 0 0.4\n1 1 0.4\n0 4 0.4\n4 0 1 2 3\n");
  const auto polygons = load_convex_polygons(file, Lattice{1});
  ASSERT_EQ(polygons.size(), 2u);
  EXPECT_EQ(polygons[0][0].z(), 0.5);
  EXPECT_NO_THROW(load_convex_polygons(file, Lattice{29}));
  try {
    load_convex_polygons(file, Lattice{30});
    ADD_FAILURE() << "4 is 2^32 steps of this lattice";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("r.off:3: a coordinate is too large for the lattice"));
  }
}

struct SharedScene {
  const char* name;
  std::size_t faces;
  std::size_t at_least_triangulated;  // faces that are not planar by themselves
};

void PrintTo(const SharedScene& scene, std::ostream* out) { *out << scene.name; }

class SharedScenes : public testing::TestWithParam<SharedScene> {};

// The parts of a face have, together, exactly its vector area; a planar face its area with that.
TEST_P(SharedScenes, KeepTheirArea) {
  const auto file = std::filesystem::path(VIEWCOVER_SHARED_SCENES) / GetParam().name;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is missing";
  const Scene scene = load_scene(file);
  const std::vector<WholeFace> faces = faces_of_file(file, scene.lattice);
  ASSERT_EQ(scene.faces, GetParam().faces);
  ASSERT_EQ(faces.size(), GetParam().faces);

  std::vector<WideVector> sums(faces.size());
  std::vector<std::size_t> parts(faces.size(), 0);
  double planar_area = 0;
  for (const Surface& surface : scene.surfaces) {
    WholeFace part;
    for (const Point& p : surface.polygon) {
      ASSERT_EQ(p, scene.lattice.round(p));
      part.push_back(in_steps(p, scene.lattice));
    }
    ASSERT_TRUE(is_strictly_convex(surface.polygon));
    ASSERT_TRUE(is_planar(part));
    const WideVector area = vector_area(part);
    for (std::size_t k = 0; k < 3; ++k) sums[surface.source_face][k] += area[k];
    ++parts[surface.source_face];
    if (is_planar(faces[surface.source_face])) planar_area += area_in_file_units(area, scene);
  }
  std::size_t missing = 0, triangulated = 0, split = 0;
  double expected_area = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (parts[i] == 0) {
      ++missing;
      continue;
    }
    EXPECT_EQ(sums[i], vector_area(faces[i])) << "face " << i;
    if (is_planar(faces[i])) {
      split += parts[i] > 1;
      expected_area += area_in_file_units(vector_area(faces[i]), scene);
    } else {
      ++triangulated;
      EXPECT_GT(parts[i], 1u);
    }
  }
  const Repairs& repairs = scene.repairs;
  EXPECT_EQ(missing, repairs.degenerate_faces + repairs.duplicate_faces);
  EXPECT_EQ(triangulated, repairs.triangulated_faces);
  EXPECT_GE(triangulated, GetParam().at_least_triangulated);
  EXPECT_EQ(split, repairs.split_faces);
  EXPECT_NEAR(planar_area / expected_area, 1, 1e-12);
  EXPECT_LE(repairs.largest_move, scene.lattice.step() * std::sqrt(3.0) / 2);
  RecordProperty("repairs", repairs.summary());
}

TEST_P(SharedScenes, LoadedAgainChangeNothing) {
  const auto file = std::filesystem::path(VIEWCOVER_SHARED_SCENES) / GetParam().name;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is missing";
  const Scene scene = load_scene(file);
  const ScratchFolder folder;
  const Scene again = load_scene(folder.write("copy.obj", as_obj(scene)));
  EXPECT_EQ(again.repairs.largest_move, 0);
  EXPECT_FALSE(again.repairs.any()) << again.repairs.summary();
  ASSERT_EQ(again.surfaces.size(), scene.surfaces.size());
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    EXPECT_EQ(again.surfaces[i].polygon, scene.surfaces[i].polygon);
  }
}

TEST_P(SharedScenes, MergedKeepTheirArea) {
  const auto file = std::filesystem::path(VIEWCOVER_SHARED_SCENES) / GetParam().name;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is missing";
  SceneOptions options;
  options.merge_coplanar = true;
  const Scene apart = load_scene(file), merged = load_scene(file, options);
  EXPECT_EQ(merged.surfaces.size() + merged.repairs.merged_surfaces, apart.surfaces.size());
  EXPECT_NEAR(merged.area() / apart.area(), 1, 1e-12);
  for (const Surface& surface : merged.surfaces) {
    ASSERT_TRUE(is_strictly_convex(surface.polygon));
    ASSERT_TRUE(is_planar(surface.polygon));
  }
}

TEST(SharedOffice, FortyCornersAreSplit) {
  const auto file = std::filesystem::path(VIEWCOVER_SHARED_SCENES) / "radiance_office.obj";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << file << " is missing";
  const Scene scene = load_scene(file);
  const auto faces = faces_of_file(file, scene.lattice);
  std::vector<std::size_t> parts(faces.size(), 0);
  for (const Surface& surface : scene.surfaces) ++parts[surface.source_face];
  std::size_t found = 0;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces[i].size() != 40) continue;
    ++found;
    EXPECT_GT(parts[i], 1u);
    EXPECT_LE(parts[i], 38u);
  }
  EXPECT_EQ(found, 4u);
}

INSTANTIATE_TEST_SUITE_P(All, SharedScenes,
                         testing::Values(SharedScene{"bras_seminar_room.obj", 330, 0},
                                         SharedScene{"cornell_box.obj", 17, 1},
                                         SharedScene{"radiance_cabin_living.obj", 926, 0},
                                         SharedScene{"radiance_office.obj", 321, 0},
                                         SharedScene{"small_house.obj", 3444, 80},
                                         SharedScene{"veach_ajar.obj", 236, 0}),
                         [](const auto& scene) {
                           const std::string name = scene.param.name;
                           return name.substr(0, name.find('.'));
                         });

}  // namespace
}  // namespace viewcover
