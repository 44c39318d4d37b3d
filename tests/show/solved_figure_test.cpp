#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "read_picture.h"
#include "report/csv_table.h"
#include "support/process.h"

namespace viewcover::testing {
namespace {

/// A wall of 8 x 6 at y = 2 whose front is turned away from the region, an open box 4 wide whose
/// rim stands on the wall's right half (x > 0), and a speck beyond the wall, without which the wall
/// would be cut away as the outermost surface.
constexpr const char* kHalfHiddenWall =
    "v -4 2 -3\nv 4 2 -3\nv 4 2 3\nv -4 2 3\n"
    "v 0 2 -3\nv 0 2 3\nv 0 1.5 -3\nv 4 1.5 -3\nv 4 1.5 3\nv 0 1.5 3\n"
    "v 0 3 0\nv 0.001 3 0\nv 0 3 0.001\n"
    "g wall\nf 4 3 2 1\n"
    "g box\nf 7 8 9 10\nf 7 10 6 5\nf 8 2 3 9\nf 7 5 2 8\nf 10 9 3 6\n"
    "g speck\nf 11 12 13\n";

TEST(SolvedFigure, ExactlyHalfOfTheWallIsBlack) {
  const ScratchFolder folder;
  const std::string scene = folder.write("scene.obj", kHalfHiddenWall).string(),
                    region = folder
                                 .write("region.json",
                                        R"({"polygons": [[[-1,-1,0],[1,-1,0],[1,1,0],[-1,1,0]]]})")
                                 .string(),
                    bundle = (folder.path() / "bundle").string();
  const Outcome solved =
      viewcover_run({"solve", scene, "--region", region, "-o", bundle, "--regions", "4",
                     "--element-area", "1", "--allow-outside", "--quiet"});
  ASSERT_EQ(solved.exit_code, 0) << solved.error;

  // Behind the box nothing is seen, beside it a part of everything: 24 of 48.
  const CsvTable elements(folder.path() / "bundle/elements.csv");
  double seen = 0, unseen = 0;
  for (std::size_t row = 0; row < elements.size(); ++row) {
    if (elements.text(row, "group") != "wall") continue;
    (elements.count(row, "times_visible") > 0 ? seen : unseen) += elements.number(row, "area");
  }
  EXPECT_EQ(seen, 24);
  EXPECT_EQ(unseen, 24);

  // From behind, where the box hides nothing.
  const Outcome shown =
      viewcover_run({"show", bundle, "--view", "90,0", "--size", "400x400", "--no-page"});
  ASSERT_EQ(shown.exit_code, 0) << shown.error;
  const ReadPicture picture(folder.path() / "bundle/figure.png");
  const auto is_black = [](std::uint32_t pixel) { return pixel == 0; };
  const auto is_coloured = [](std::uint32_t pixel) {
    const std::uint32_t red = pixel >> 16, blue = pixel & 0xFF;
    return red > 150 && red > blue + 20;
  };
  const int black = picture.count(is_black), coloured = picture.count(is_coloured);
  EXPECT_GT(black, 30'000);
  // The halves differ by lines round them, a pixel wide, and by the legend.
  EXPECT_NEAR(black, coloured, 1'500) << black << " and " << coloured;
}

}  // namespace
}  // namespace viewcover::testing
