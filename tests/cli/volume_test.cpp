#include <gmock/gmock.h>

#include <fstream>
#include <regex>

#include "bundle_files.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;

/// The living room and a slab of it at eye height, above the furniture, with a polygon below it.
class Volume : public ::testing::Test {
 protected:
  void SetUp() override {
    region_ =
        room_.write("slab.json", R"({"polygons": [[[1,1,1.25],[2,1,1.25],[2,2,1.25],[1,2,1.25]]],
      "boxes": [{"min": [0.75, 0.75, 1.4], "max": [5.25, 4.25, 1.8]}]})");
  }
  Outcome solve(const std::string& name, std::vector<std::string> more) const {
    more.insert(more.begin(), {"solve", room_.scene(), "--region", region_, "-o",
                               room_.bundle(name), "--quiet", "--element-area", "1"});
    return viewcover_run(more);
  }
  std::filesystem::path file(const std::string& bundle, const std::string& name) const {
    return std::filesystem::path(room_.bundle(bundle)) / name;
  }
  std::string path(const std::string& name) const { return (room_.path() / name).string(); }

  /// `verify` after the first match of a pattern in a file is replaced; the file is put back.
  Outcome verify_damaged(const std::string& name, const std::string& pattern,
                         const std::string& by) const {
    const std::string text = read_file(file("bundle", name));
    const std::string changed =
        std::regex_replace(text, std::regex(pattern), by, std::regex_constants::format_first_only);
    EXPECT_NE(text, changed);
    std::ofstream(file("bundle", name)) << changed;
    const Outcome outcome = viewcover_run({"verify", room_.bundle()});
    std::ofstream(file("bundle", name)) << text;
    return outcome;
  }

  RoomFolder room_;
  std::string region_;
};

TEST_F(Volume, ABundleOfBoxesIsAsGoodAsAnother) {
  const Outcome solved = solve("bundle", {"--regions", "4"});
  ASSERT_EQ(solved.exit_code, 0) << solved.error;
  const Json line = Json::parse(last_line(solved.out));
  EXPECT_EQ(line.at("regions"), 8);
  EXPECT_GE(line.at("viewpoints"), line.at("lower_bound"));
  EXPECT_GE(line.at("viewpoints"), line.at("optimal_regions"));

  const Table regions(file("bundle", "regions.csv"));
  ASSERT_EQ(regions.rows.size(), 8u);
  const std::size_t volume = regions.column("volume"), x7 = regions.column("x7");
  double total = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(regions.rows[i][volume].empty(), i < 4);
    EXPECT_EQ(regions.rows[i][x7].empty(), i < 4);
    if (i >= 4) total += std::stod(regions.rows[i][volume]);
  }
  EXPECT_NEAR(total, 4.5 * 3.5 * 0.4, 1e-4);
  // A link names the polygon or a face of one of 2 x 2 x 1 cells.
  const Table faces(file("bundle", "faces.csv"));
  EXPECT_EQ(faces.rows.size(), 24u);
  const Table links(file("bundle", "links.csv"));
  std::size_t from_faces = 0;
  for (const auto& link : links.rows) {
    const int part = std::stoi(link[0]);
    EXPECT_LE(part, 25);
    from_faces += part > 1;
  }
  EXPECT_GT(from_faces, 1000u);

  const Outcome verified = viewcover_run({"verify", room_.bundle()});
  EXPECT_EQ(verified.exit_code, 0) << verified.error;
  EXPECT_THAT(verified.out, HasSubstr("holds: random positions see no more than visibility.mtx"));
  const Outcome audited = viewcover_run({"audit", room_.bundle(), "--quiet"});
  EXPECT_EQ(audited.exit_code, 0) << audited.error;
  const Outcome shown = viewcover_run({"show", room_.bundle(), "--size", "320x240"});
  EXPECT_EQ(shown.exit_code, 0) << shown.error;
  const Outcome compared = viewcover_run({"compare", room_.bundle(), room_.bundle()});
  ASSERT_EQ(compared.exit_code, 0) << compared.error;
  EXPECT_EQ(Json::parse(last_line(compared.out)).at("Q_u").at("count"), 0.0);

  // A viewpoint above its box, a face of no region.
  EXPECT_THAT(
      verify_damaged("viewpoints.csv", "\n1,([^,]*),([^,]*),[^,]*,", "\n1,$1,$2,1.95,").error,
      HasSubstr("not true that each viewpoint lies in its region"));
  const std::string text = read_file(file("bundle", "faces.csv"));
  std::ofstream(file("bundle", "faces.csv")) << std::regex_replace(
      text, std::regex("\n2,[0-9 ]*,"), "\n2,99,", std::regex_constants::format_first_only);
  expect_refused(viewcover_run({"compare", room_.bundle(), room_.bundle()}),
                 "faces.csv:2: there is no region 99");

  // Polygons alone leave no faces behind.
  ASSERT_EQ(room_.solve("bundle", {"--regions", "4"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(file("bundle", "faces.csv")));
}

TEST_F(Volume, SameBytesForAnyThreadsAndRaysMissSome) {
  for (const char* threads : {"1", "3"}) {
    ASSERT_EQ(
        solve(threads, {"--regions", "4", "--backend", "rays", "--threads", threads}).exit_code, 0);
  }
  EXPECT_EQ(comparable_files(room_.bundle("1")), comparable_files(room_.bundle("3")));
  ASSERT_EQ(solve("exact", {"--regions", "4", "--viewpoints", "none"}).exit_code, 0);
  const Outcome compared = viewcover_run({"compare", room_.bundle("1"), room_.bundle("exact")});
  ASSERT_EQ(compared.exit_code, 0) << compared.error;
  const Json line = Json::parse(last_line(compared.out));
  EXPECT_GT(line.at("Q_u").at("count"), 0.0);
  EXPECT_EQ(line.at("Q_o").at("count"), 0.0);
}

TEST_F(Volume, FullCoverageFromBoxes) {
  const std::string box =
      room_.write("box.json", R"({"boxes": [{"min": [2, 2, 1.4], "max": [2.5, 2.5, 1.8]}]})");
  const Outcome solved =
      viewcover_run({"solve", room_.scene(), "--region", box, "--regions", "1", "--coverage",
                     "full", "--close-gap", "0", "--missed-share", "0.02", "--element-area", "1",
                     "-o", room_.bundle(), "--quiet"});
  ASSERT_EQ(solved.exit_code, 0) << solved.error;
  const Json line = Json::parse(last_line(solved.out));
  EXPECT_GE(line.at("viewpoints"), line.at("lower_bound"));
  const Outcome verified = viewcover_run({"verify", room_.bundle()});
  EXPECT_EQ(verified.exit_code, 0) << verified.error;
  EXPECT_THAT(verified.out, HasSubstr("holds: each witness is seen from a viewpoint"));
  EXPECT_THAT(verified.out, HasSubstr("holds: each viewpoint lies in its region"));
}

TEST_F(Volume, FreeBoxesOfTheRoomCanBeSolved) {
  const auto region = [&](std::vector<std::string> more, const std::string& name) {
    more.insert(more.begin(), {"region", room_.scene(), "-o", path(name)});
    return viewcover_run(more);
  };
  const std::vector<std::string> slab = {"--volume", "1.4,1.8", "--clearance", "0.1"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), slab.begin(), slab.end());
    return more;
  };
  const Outcome found = region(with({"--cells", "6,6,2"}), "boxes.json");
  ASSERT_EQ(found.exit_code, 0) << found.error;
  const Json line = Json::parse(last_line(found.out));
  EXPECT_GT(line.at("area"), 5.0);
  EXPECT_GT(line.at("left_out"), 0.0);
  const Json boxes = Json::parse(read_file(path("boxes.json"))).at("boxes");
  ASSERT_EQ(boxes.size(), line.at("boxes"));
  double area = 0;
  for (const Json& box : boxes) {
    EXPECT_GE(box.at("min").at(2), 1.4);
    EXPECT_LE(box.at("max").at(2), 1.8);
    area += (double(box.at("max").at(0)) - double(box.at("min").at(0))) *
            (double(box.at("max").at(1)) - double(box.at("min").at(1)));
  }
  EXPECT_NEAR(area / 2, line.at("area"), 1e-6);
  const Outcome solved = viewcover_run({"solve", room_.scene(), "--region", path("boxes.json"),
                                        "--clearance", "0.1", "--regions", "1", "--backend", "rays",
                                        "--viewpoints", "none", "-o", room_.bundle(), "--quiet"});
  EXPECT_EQ(solved.exit_code, 0) << solved.error;
  EXPECT_EQ(Json::parse(last_line(solved.out)).at("regions"), boxes.size());

  const std::string text = read_file(path("boxes.json"));
  ASSERT_EQ(region(with({"--cells", "6,6,2"}), "again.json").exit_code, 0);
  EXPECT_EQ(text, read_file(path("again.json")));

  const auto refused = [&](std::vector<std::string> options, const std::string& reason) {
    expect_refused(region(std::move(options), "none.json"), reason);
    EXPECT_FALSE(std::filesystem::exists(path("none.json")));
  };
  refused({"--volume", "1.4"}, "--volume: is no pair of heights");
  refused({"--volume", "1.4,high"}, "--volume");
  refused({"--volume", "1.8,1.4"}, "--volume: 1.4 is not above 1.8");
  refused({"--volume", "1.4,16"}, "--volume: 16 is outside the scene");
  refused({"--volume", "1.4,1.8", "--height", "1.5"}, "--height: comes with --volume");
  refused({"--height", "1.5", "--cells", "4,4,1"}, "--cells: is about boxes");
  refused(with({"--cells", "4,4"}), "--cells: is no grid");
  refused(with({"--cells", "4,4,0"}), "--cells");
  refused(with({"--cells", "1,1,1"}), "--cells: none of 1 x 1 x 1 is wholly free");
  refused({"--volume", "1.4,1.8", "--clearance", "5"}, "--volume: no free space is left");
}

}  // namespace
}  // namespace viewcover::testing
