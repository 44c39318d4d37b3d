#include "scene/repair/crop.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "scene/error.h"
#include "scene/scene.h"
#include "scene/scratch_folder.h"

namespace viewcover {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// A bird far out, then a box of 4 x 4 x 3 without a ceiling, in eight corners and more.
std::string room_and_bird() {
  std::string text = "v 300000 0 0\nv 300001 0 0\nv 300000 1 0\n";
  for (const char* z : {"0", "3", "1.3"}) {
    for (const char* xy : {"0 0 ", "4 0 ", "4 4 ", "0 4 "})
      text += std::string("v ") + xy + z + "\n";
  }
  return text +
         "o bird\nf 1 2 3\no room\nf 4 5 6 7\nf 4 5 9 8\nf 5 6 10 9\nf 6 7 11 10\n"
         "f 7 4 8 11\nf 12 13 14\nf 13 14 15\n";
}

class Crop : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_.write("room.obj", room_and_bird()); }
  ScratchFolder folder_;
};

TEST_F(Crop, FarThingsAreFoundAndSaid) {
  const PolygonSoup soup = read_polygon_soup(file());
  const FarOut far = find_far_out(soup);
  EXPECT_THAT(far.vertices, ElementsAre(0, 1, 2));
  EXPECT_THAT(far.faces, ElementsAre(0));
  EXPECT_EQ(far.step_without, 0x1p-20);
  const Scene scene = make_scene(soup);
  EXPECT_EQ(scene.lattice.step(), 0x1p-4);
  EXPECT_THAT(scene.warning, HasSubstr("room.obj: face 1 ('bird') reaches 300001 from the origin"));
  EXPECT_THAT(scene.warning, HasSubstr("the lattice step is 0.062, and would be 9.5e-07 without"));
}

TEST_F(Crop, LeavesOutWhatIsOutsideAndKeepsNumbers) {
  SceneOptions options;
  options.crop = Box(Point(-1, -1, -1), Point(5, 5, 0.5));
  const Scene scene = load_scene(file(), options);
  EXPECT_EQ(scene.warning, "");
  EXPECT_EQ(scene.faces, 8u);
  EXPECT_EQ(scene.repairs.cropped_faces, 3u);  // the bird and two triangles at height 1.3
  EXPECT_THAT(scene.repairs.summary(), HasSubstr("3 faces left out by --crop"));
  EXPECT_EQ(scene.lattice.step(), 0x1p-20);
  ASSERT_EQ(scene.surfaces.size(), 5u);
  for (std::uint32_t i = 0; i < 5; ++i) {
    EXPECT_EQ(scene.surfaces[i].source_face, i + 1);
    EXPECT_EQ(scene.groups[scene.surfaces[i].group.value], "room");
  }
  EXPECT_EQ(scene.bounds.max(), Point(4, 4, 3));  // what stays is not cut
}

TEST_F(Crop, PlacesAreThoseOfTheFile) {
  PolygonSoup soup = read_polygon_soup(file());
  EXPECT_EQ(crop(soup, Box(Point(0, 0, 1.3), Point(4, 4, 1.3))), 2u);  // walls meet that plane
  EXPECT_EQ(soup.vertices.size(), 12u);
  EXPECT_THAT(soup.place_of_face(0), HasSubstr("room.obj:20"));
  EXPECT_THAT(soup.place_of_vertex(0), HasSubstr("room.obj:4"));
  EXPECT_EQ(soup.number_in_file(0), 2u);
  EXPECT_EQ(crop(soup, Box(Point(4, 4, 2), Point(4, 4, 9))), 4u);  // touching counts
  EXPECT_EQ(soup.number_in_file(0), 3u);
}

TEST_F(Crop, AnEmptyBoxIsRefused) {
  SceneOptions options;
  options.crop = Box(Point(10, 10, 10), Point(11, 11, 11));
  try {
    load_scene(file(), options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("--crop: no face of"));
    EXPECT_THAT(error.what(), HasSubstr("they lie from 0,0,0 to 300001,4,3"));
  }
}

}  // namespace
}  // namespace viewcover
