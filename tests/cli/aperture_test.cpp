// solve --aperture: what is visible only through narrow gaps, marked, and the optimum without it.

#include <gmock/gmock.h>

#include <fstream>
#include <regex>

#include "bundle_files.h"
#include "scene/scratch_folder.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;

/// A wall with a slit of 5 mm at eye height. Region 1 sees all: the wall, a target on its side and,
/// through the slit, a small one behind it. Region 2 sees the wall and the small target.
class Aperture : public ::testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(scene_)
        << "o wall\n"
           "v 0 0 0\nv 0 4 0\nv 0 4 1\nv 0 0 1\nf 1 2 3 4\n"
           "v 0 0 1.005\nv 0 4 1.005\nv 0 4 2\nv 0 0 2\nf 5 6 7 8\n"
           "o before\n"
           "v -2 1.5 .5\nv -2 2.5 .5\nv -2 2.5 1.5\nv -2 1.5 1.5\nf 9 10 11 12\n"
           "o behind\n"
           "v .5 1.9 .9\nv .5 2.1 .9\nv .5 2.1 1.1\nv .5 1.9 1.1\nf 13 14 15 16\n";
    std::ofstream(region_) << R"({"polygons": [
      [[-1.5, 1.5, 1.0025], [-1, 1.5, 1.0025], [-1, 2.5, 1.0025], [-1.5, 2.5, 1.0025]],
      [[0.1, 1.5, 1.3], [0.2, 1.5, 1.3], [0.2, 1.9, 1.3], [0.1, 1.9, 1.3]]]})";
  }
  Outcome solve(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments = {
        "solve",     scene_, "--region",       region_, "-o",           bundle_,
        "--regions", "1",    "--element-area", "100",   "--viewpoints", "none"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return viewcover_run(arguments);
  }
  std::size_t count_of(const std::string& file) const {
    const std::string text = read_file(std::filesystem::path(bundle_) / file);
    return static_cast<std::size_t>(std::ranges::count(text, '\n'));
  }

  ScratchFolder folder_;
  std::string scene_ = (folder_.path() / "scene.obj").string(),
              region_ = (folder_.path() / "region.json").string(),
              bundle_ = (folder_.path() / "bundle").string();
};

TEST_F(Aperture, TheOptimumWithAndWithoutNarrowGaps) {
  const Outcome outcome = solve({"--aperture", "0.01"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.out, HasSubstr("narrower than 0.01: 4 elements of 4, 2 regions."));
  const Json summary = Json::parse(last_line(outcome.out));
  EXPECT_EQ(summary.at("optimal_regions"), 1);
  EXPECT_EQ(summary.at("optimal_regions_wide"), 2);
  EXPECT_GT(summary.at("seconds").at("wide"), 0);
  const Json wide = run_json(bundle_).at("results").at("wide");
  EXPECT_EQ(wide.at("narrow_pairs"), 1);
  EXPECT_EQ(wide.at("gaps_entered"), 0);
  EXPECT_EQ(wide.at("chosen"), Json({1, 2}));
  EXPECT_EQ(wide.at("proved"), true);

  const Table gaps(bundle_ + "/gaps.csv");
  EXPECT_EQ(gaps.rows.size(), wide.at("gaps"));
  for (const auto& row : gaps.rows) {
    EXPECT_NEAR(std::stod(row[gaps.column("width")]), 0.005, 1e-6);
  }
  const Table links(bundle_ + "/links.csv");
  for (const auto& row : links.rows) {
    const bool through_slit =
        row[links.column("region")] == "1:0:0" && row[links.column("element")] == "4:0:0";
    EXPECT_EQ(row[links.column("narrow")], through_slit ? "1" : "0");
  }
  const Table elements(bundle_ + "/elements.csv");
  EXPECT_EQ(elements.rows[3][elements.column("times_visible")], "2");
  EXPECT_EQ(elements.rows[3][elements.column("times_visible_wide")], "1");
  EXPECT_EQ(count_of("visibility.mtx"), count_of("visibility-wide.mtx") + 1);

  const Outcome verified = viewcover_run({"verify", bundle_});
  EXPECT_EQ(verified.exit_code, 0) << verified.error;
  EXPECT_THAT(verified.out, HasSubstr("holds: cover-wide.proof proves that no 1 regions"));
  EXPECT_THAT(verified.out, HasSubstr("holds: random positions see no more than "
                                      "visibility-wide.mtx says of their regions"));
}

TEST_F(Aperture, AWiderSlitIsNoGap) {
  const Outcome outcome = solve({"--aperture", "0.0049"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(Json::parse(last_line(outcome.out)).at("optimal_regions_wide"), 1);
  EXPECT_EQ(count_of("visibility.mtx"), count_of("visibility-wide.mtx"));
}

TEST_F(Aperture, VerifyFindsDamage) {
  ASSERT_EQ(solve({"--aperture", "0.01", "--quiet"}).exit_code, 0);
  const std::filesystem::path matrix = std::filesystem::path(bundle_) / "visibility-wide.mtx";
  const std::string text = read_file(matrix);
  // Region 2 does not see the target before the wall, with or without gaps.
  std::ofstream(matrix) << std::regex_replace(text, std::regex("\n2 4\n"), "\n2 3\n");
  const Outcome outcome = viewcover_run({"verify", bundle_});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.error, HasSubstr("not true that visibility-wide.mtx has nothing"));
  EXPECT_THAT(outcome.error, HasSubstr("regions of visibility-wide.mtx that see each element"));
  EXPECT_THAT(outcome.error, HasSubstr("random positions see no more than visibility-wide.mtx"));
  EXPECT_THAT(outcome.error, HasSubstr("region 2 sees element 4, which it does not say"));
}

TEST_F(Aperture, ARunWithoutItLeavesNoFilesOfAnother) {
  ASSERT_EQ(solve({"--aperture", "0.01", "--quiet"}).exit_code, 0);
  ASSERT_EQ(solve({"--quiet"}).exit_code, 0);
  for (const char* name :
       {"gaps.csv", "visibility-wide.mtx", "cover-wide.csv", "cover-wide.proof"}) {
    EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(bundle_) / name)) << name;
  }
  EXPECT_EQ(viewcover_run({"verify", bundle_}).exit_code, 0);
}

TEST_F(Aperture, IsAWidth) {
  for (const char* width : {"0", "-1", "wide"}) {
    const Outcome outcome = solve({"--aperture", width});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.error, HasSubstr("viewcover: --aperture"));
  }
}

}  // namespace
}  // namespace viewcover::testing
