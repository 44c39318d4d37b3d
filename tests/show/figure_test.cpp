#include "show/figure.h"

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include "read_picture.h"
#include "scene/error.h"
#include "scene/scratch_folder.h"
#include "show/raster.h"
#include "support/made_run.h"
#include "support/process.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr ViewDirection kFromSouth{-90, 0};

/// Seen straight from the south, a wall 8 wide and 6 high, centre at the origin's height.
TEST(Raster, APlateHidesExactlyHalfOfAWall) {
  const ConvexPolygon wall = upright(-4, 4, -3, 3, 2);
  // The plane through the camera and the wall's middle line holds the plate's right edge.
  const ConvexPolygon plate = upright(-9, 0, -9, 9, 1);
  constexpr PixelSize kSize{400, 320};
  const auto camera = make_outside_camera(wall, Frame::with_up(2), kFromSouth, kSize);
  const auto count = [&](const std::vector<ConvexPolygon>& polygons) {
    const RasterScene scene(polygons, std::vector<Colour>(polygons.size()), {0, 1}, {}, {},
                            Point::UnitY());
    std::array<int, 2> met{};
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        const Sample sample = scene.sample(*camera, x + 0.5, y + 0.5);
        if (sample.element != RayScene::kNone) ++met[sample.element];
      }
    }
    return met;
  };
  const int whole = count({wall, {}})[0];
  EXPECT_EQ(whole, 376 * 282);  // all but 3 % of the width on each side; 6/8 of that high
  EXPECT_EQ(count({wall, plate})[0], whole / 2);
}

TEST(Raster, RegionsAreSeenOnlyBeforeElements) {
  const ConvexPolygon wall = upright(-4, 4, -3, 3, 2), before = upright(-4, 0, -3, 3, 1),
                      behind = upright(0, 4, -3, 3, 3);
  constexpr PixelSize kSize{100, 80};
  const auto camera = make_outside_camera(wall, Frame::with_up(2), kFromSouth, kSize);
  const std::vector<ConvexPolygon> walls = {wall}, regions = {before, behind};
  const RasterScene scene(walls, {Colour{}}, {0}, regions, {false, false}, Point::UnitY());
  EXPECT_EQ(scene.sample(*camera, 25, 40), (Sample{0, 0}));
  EXPECT_EQ(scene.sample(*camera, 75, 40), (Sample{0, RayScene::kNone}));
}

/// A wall whose left half no region sees: what a plate before it would do.
RunData half_seen_wall() {
  return made_run({upright(-4, 0, -3, 3, 2), upright(0, 4, -3, 3, 2)}, {"wall"},
                  {level(-1, 1, -1, 1, 0)}, {{1}});
}

FigureOptions small_figure() {
  FigureOptions options;
  options.size = {400, 400};
  options.view = kFromSouth;
  return options;
}

TEST(Figure, HalfOfTheWallIsBlackAndHalfIsNot) {
  const ScratchFolder folder;
  const RunData run = half_seen_wall();
  draw_figure(run, common_elements(run), small_figure(), folder.path() / "figure.png");
  const ReadPicture picture(folder.path() / "figure.png");
  EXPECT_EQ(picture.width(), 400);
  EXPECT_EQ(picture.height(), 400);
  const int wall_rows = 400 - 27 - 1;
  int black = 0, light = 0;
  for (int y = 0; y < wall_rows; ++y) {
    for (int x = 0; x < 400; ++x) {
      const std::uint32_t red = picture.pixel(x, y) >> 16, blue = picture.pixel(x, y) & 0xFF;
      black += picture.pixel(x, y) == 0;
      light += red > 150 && red > blue + 20;
    }
  }
  // A line of at most a pixel on each side goes round both halves, and the region, seen edge-on,
  // may take two rows.
  const int half = 188 * 282, border = 2 * (188 + 282) + 2 * 188;
  EXPECT_LE(black, half);
  EXPECT_GE(black, half - border);
  EXPECT_LE(light, half);
  EXPECT_GE(light, half - border);
}

TEST(Figure, ThreadsChangeNoByte) {
  const ScratchFolder folder;
  const RunData run = half_seen_wall();
  const auto draw = [&](std::size_t threads, const std::string& name) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    draw_figure(run, common_elements(run), small_figure(), folder.path() / name);
    return read_file(folder.path() / name);
  };
  const std::string one = draw(1, "one.png");
  EXPECT_FALSE(one.empty());
  EXPECT_EQ(one, draw(3, "three.png"));
}

TEST(Figure, RefusesAViewpointThatIsNotThere) {
  const ScratchFolder folder;
  const RunData run = half_seen_wall();
  FigureOptions options = small_figure();
  options.viewpoint = 0;
  EXPECT_THAT(
      [&] { draw_figure(run, common_elements(run), options, folder.path() / "camera.png"); },
      ThrowsMessage<InputError>(HasSubstr("--camera 1: there are 0 viewpoints")));
}

TEST(Camera, ProjectsWhereItLooks) {
  const std::vector<Point> corners = {{0, 0, 0}, {4, 3, 2}};
  constexpr PixelSize kSize{300, 200};
  const auto outside = make_outside_camera(corners, Frame::with_up(1), {30, 20}, kSize);
  const auto panorama = make_panorama_camera({1, 1, 1}, Frame::with_up(2), kSize);
  for (const Camera* camera : {outside.get(), panorama.get()}) {
    for (const double x : {20.0, 150.0, 290.0}) {
      const Point point = camera->position() + 3 * camera->direction(x, 70);
      const auto place = camera->project(point);
      ASSERT_TRUE(place);
      EXPECT_NEAR(place->x(), x, 1e-9);
      EXPECT_NEAR(place->y(), 70, 1e-9);
    }
  }
  EXPECT_TRUE(panorama->direction(150, 100).isApprox(Point::UnitY()));  // north, level
}

}  // namespace
}  // namespace viewcover::testing
