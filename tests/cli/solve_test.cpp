#include <gmock/gmock.h>

#include <cmath>
#include <set>

#include "bundle_files.h"

namespace viewcover::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

TEST(Solve, LastLineIsTheSummary) {
  const RoomFolder room;
  const Outcome outcome = room.solve("bundle");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const Json summary = Json::parse(last_line(outcome.out));
  EXPECT_THAT(keys_of(summary),
              ElementsAre("scene", "backend", "polygons", "regions", "elements", "visible_elements",
                          "links", "optimal_regions", "proved", "lower_bound", "viewpoints",
                          "seconds", "peak_memory_kb"));
  EXPECT_THAT(keys_of(summary.at("seconds")),
              ElementsAre("visibility", "cover", "viewpoints", "total"));
  EXPECT_EQ(summary.at("scene"), "room");
  EXPECT_EQ(summary.at("backend"), "rays");
  EXPECT_EQ(summary.at("polygons"), 316);
  EXPECT_EQ(summary.at("regions"), 64);
  EXPECT_TRUE(summary.at("viewpoints").is_null());
  EXPECT_TRUE(summary.at("lower_bound").is_null());
  EXPECT_GT(summary.at("peak_memory_kb"), 0);
  EXPECT_TRUE(is_complete(room.bundle()));
  EXPECT_THAT(outcome.out, HasSubstr("visibility evaluations"));
  EXPECT_THAT(outcome.error, ::testing::Not(HasSubstr("viewcover:")));  // progress at most
}

TEST(Solve, FindsViewpointsAndTheirBoundByDefault) {
  const RoomFolder room;
  const Outcome outcome = viewcover_run({"solve", room.scene(), "--region", room.region(), "-o",
                                         room.bundle(), "--regions", "4", "--element-area", "2"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const Json summary = Json::parse(last_line(outcome.out));
  const std::size_t viewpoints = summary.at("viewpoints"), bound = summary.at("lower_bound");
  EXPECT_GE(viewpoints, bound);
  EXPECT_GE(bound, summary.at("optimal_regions"));
  EXPECT_THAT(outcome.out, HasSubstr("lower bound"));
  const Table table(room.bundle() + "/viewpoints.csv");
  ASSERT_EQ(table.rows.size(), viewpoints);
  EXPECT_EQ(table.rows.back()[table.column("covered_area_percent")], "100");
  EXPECT_EQ(run_json(room.bundle()).at("results").at("viewpoints"), viewpoints);
  EXPECT_EQ(run_json(room.bundle()).at("results").at("viewpoints_lower_bound"), bound);
  EXPECT_EQ(run_json(room.bundle()).at("options").at("viewpoints"), "sa");
  const Outcome verified = viewcover_run({"verify", room.bundle()});
  EXPECT_EQ(verified.exit_code, 0) << verified.error;
  EXPECT_THAT(verified.out, HasSubstr("holds: each viewpoint lies in its region"));
}

TEST(Solve, ViewpointsDependOnNoThreads) {
  const RoomFolder room;
  for (const char* threads : {"1", "2"}) {
    const Outcome outcome = room.solve(
        threads, {"--viewpoints", "sa", "--regions", "16", "--threads", threads, "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const Json summary = Json::parse(outcome.out);
    EXPECT_GT(summary.at("viewpoints"), 0);
    EXPECT_TRUE(summary.at("lower_bound").is_null());  // random rays prove none
  }
  const auto one = comparable_files(room.bundle("1")), two = comparable_files(room.bundle("2"));
  EXPECT_EQ(one.at("viewpoints.csv"), two.at("viewpoints.csv"));
  EXPECT_EQ(one.at("viewpoints.mtx"), two.at("viewpoints.mtx"));
}

TEST(Solve, QuietPrintsTheSummaryOnly) {
  const RoomFolder room;
  const Outcome outcome = room.solve("bundle", {"--quiet"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_EQ(outcome.out, last_line(outcome.out) + "\n");
  EXPECT_EQ(outcome.error, "");
}

TEST(Solve, BundleHasItsFilesAndColumns) {
  const RoomFolder room;
  ASSERT_EQ(room.solve("bundle").exit_code, 0);
  const std::filesystem::path bundle = room.bundle();
  EXPECT_EQ(names_in(bundle),
            (std::set<std::string>{"run.json", "regions.csv", "elements.csv", "links.csv",
                                   "visibility.mtx", "cover.csv", "cover.proof", "viewpoints.csv",
                                   "scene.vtp", "surface.ply", "surface.om"}));
  EXPECT_THAT(read_file(bundle / "regions.csv"),
              ::testing::StartsWith("region,part,level,path,cx,cy,cz,area,chosen,x0,y0,z0,"));
  EXPECT_THAT(read_file(bundle / "elements.csv"),
              ::testing::StartsWith("element,surface,group,level,path,cx,cy,cz,area,times_visible,"
                                    "x0,y0,z0,"));
  EXPECT_THAT(read_file(bundle / "links.csv"),
              ::testing::StartsWith("region,element,kind,occluders\n"));
  EXPECT_THAT(read_file(bundle / "cover.csv"),
              ::testing::StartsWith(
                  "k,covered_area_percent,upper_bound_percent,seconds,evaluations,regions\n"));
  EXPECT_EQ(read_file(bundle / "viewpoints.csv"),
            "viewpoint,x,y,z,region,covered_area_percent,seconds\n");
  for (const char* file : {"regions.csv", "elements.csv"}) {
    const Table table(bundle / file);
    for (const auto& row : table.rows) ASSERT_EQ(row.size(), table.titles.size());
  }
}

TEST(Solve, AreasOfElementsAddUpToTheScene) {
  const RoomFolder room;
  ASSERT_EQ(room.solve("bundle", {"--element-area", "0.05"}).exit_code, 0);
  const Table elements(room.path() / "bundle" / "elements.csv");
  const std::size_t area = elements.column("area");
  double sum = 0;
  for (const auto& row : elements.rows) sum += std::stod(row[area]);
  const double scene = run_json(room.bundle()).at("scene").at("area");
  EXPECT_GT(scene, 100);  // square metres: walls, floor and ceiling of a room, and furniture
  EXPECT_NEAR(sum, scene, 1e-9 * scene);
}

TEST(Solve, MatrixAgreesWithTheTables) {
  const RoomFolder room;
  const Outcome outcome = room.solve("bundle", {"--quiet"});
  ASSERT_EQ(outcome.exit_code, 0);
  const std::filesystem::path bundle = room.bundle();
  std::istringstream in(read_file(bundle / "visibility.mtx"));
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "%%MatrixMarket matrix coordinate pattern general");
  while (in.peek() == '%') std::getline(in, line);
  std::size_t rows = 0, columns = 0, entries = 0;
  in >> rows >> columns >> entries;
  std::vector<std::set<std::size_t>> seen(rows + 1);
  std::vector<std::size_t> times(columns + 1, 0);
  for (std::size_t i = 0; i < entries; ++i) {
    std::size_t row = 0, column = 0;
    ASSERT_TRUE(in >> row >> column);
    ASSERT_TRUE(row >= 1 && row <= rows && column >= 1 && column <= columns);
    ASSERT_TRUE(seen[row].insert(column).second);
    ++times[column];
  }

  const Table elements(bundle / "elements.csv");
  ASSERT_EQ(elements.rows.size(), columns);
  std::size_t visible = 0;
  double visible_area = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    ASSERT_EQ(elements.rows[i][0], std::to_string(i + 1));
    ASSERT_EQ(elements.rows[i][elements.column("times_visible")], std::to_string(times[i + 1]));
    if (times[i + 1] == 0) continue;
    ++visible;
    visible_area += std::stod(elements.rows[i][elements.column("area")]);
  }
  EXPECT_LT(visible, columns);  // something is under a piece of furniture
  const Json summary = Json::parse(last_line(outcome.out));
  EXPECT_EQ(summary.at("visible_elements"), visible);

  const Table regions(bundle / "regions.csv");
  ASSERT_EQ(regions.rows.size(), rows);
  std::set<std::size_t> covered;
  std::string chosen;
  for (std::size_t i = 0; i < rows; ++i) {
    if (regions.rows[i][regions.column("chosen")] != "1") continue;
    covered.insert(seen[i + 1].begin(), seen[i + 1].end());
    if (!chosen.empty()) chosen += ' ';
    chosen += std::to_string(i + 1);
  }
  EXPECT_EQ(covered.size(), visible);

  const Table cover(bundle / "cover.csv");
  ASSERT_EQ(cover.rows.size(), summary.at("optimal_regions"));
  EXPECT_EQ(cover.rows.back()[cover.column("regions")], chosen);
  EXPECT_EQ(cover.rows.back()[cover.column("covered_area_percent")], "100");
  for (const auto& row : cover.rows) {
    std::istringstream numbers(row[cover.column("regions")]);
    std::set<std::size_t> step;
    for (std::size_t region; numbers >> region;) {
      step.insert(seen.at(region).begin(), seen.at(region).end());
    }
    double area = 0;
    for (const std::size_t column : step) {
      area += std::stod(elements.rows[column - 1][elements.column("area")]);
    }
    EXPECT_NEAR(std::stod(row[cover.column("covered_area_percent")]), 100 * area / visible_area,
                1e-9);
  }
}

TEST(Solve, SameBytesForAnyThreadsAndEveryRun) {
  const RoomFolder room;
  ASSERT_EQ(room.solve("one", {"--threads", "1"}).exit_code, 0);
  ASSERT_EQ(room.solve("two", {"--threads", "2"}).exit_code, 0);
  ASSERT_EQ(room.solve("again", {"--threads", "2"}).exit_code, 0);
  const auto one = comparable_files(room.bundle("one"));
  EXPECT_EQ(one.size(), 11u);
  EXPECT_EQ(one, comparable_files(room.bundle("two")));
  EXPECT_EQ(one, comparable_files(room.bundle("again")));
}

TEST(Solve, OtherSeedOtherLinks) {
  const RoomFolder room;
  ASSERT_EQ(room.solve("one", {"--rays", "2"}).exit_code, 0);
  ASSERT_EQ(room.solve("two", {"--rays", "2", "--seed", "2"}).exit_code, 0);
  EXPECT_NE(read_file(room.bundle("one") + "/links.csv"),
            read_file(room.bundle("two") + "/links.csv"));
  EXPECT_EQ(run_json(room.bundle("two")).at("seed"), 2);
}

TEST(Solve, ExactIsTheDefaultAndGivesALowerBound) {
  const RoomFolder room;
  const std::string bundle = room.bundle();
  const Outcome outcome =
      viewcover_run({"solve", room.scene(), "--region", room.region(), "--regions", "16",
                     "--viewpoints", "none", "--quiet", "-o", bundle});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const Json summary = Json::parse(last_line(outcome.out));
  EXPECT_EQ(summary.at("backend"), "exact");
  EXPECT_GE(summary.at("lower_bound"), 1);
  // Raised above the cover by regions, never below it.
  EXPECT_GE(summary.at("lower_bound"), summary.at("optimal_regions"));
  EXPECT_EQ(summary.at("proved"), true);
  const Json run = run_json(bundle);
  EXPECT_EQ(run.at("verdicts").at("hidden_all_rays_blocked"), 0);
  EXPECT_EQ(run.at("verdicts").at("assumed_visible"), 0);
  EXPECT_GT(run.at("verdicts").at("hidden_by_set"), 0);
  EXPECT_GT(run.at("backend_statistics").at("witnesses_confirmed"), 0);
  EXPECT_EQ(run.at("backend_statistics").at("witnesses_not_found"), 0);
}

TEST(Solve, ExactVisibilityDependsOnNoSeedAndNoThreads) {
  const RoomFolder room;
  const auto matrix_with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> options = {"--backend", "exact", "--regions", "16", "--quiet"};
    options.insert(options.end(), more.begin(), more.end());
    EXPECT_EQ(room.solve("bundle", options).exit_code, 0);
    return read_file(room.bundle() + "/visibility.mtx");
  };
  const std::string one = matrix_with({"--threads", "1"});
  EXPECT_EQ(one, matrix_with({"--threads", "2"}));
  EXPECT_EQ(one, matrix_with({"--seed", "2"}));
}

TEST(Solve, OptionsReachTheRun) {
  const RoomFolder room;
  const Outcome outcome = room.solve("bundle", {"--regions",
                                                "16",
                                                "--rays",
                                                "4",
                                                "--sampling",
                                                "stratified",
                                                "--element-area",
                                                "0.5",
                                                "--one-sided",
                                                "--merge-coplanar",
                                                "--allow-outside",
                                                "--lattice",
                                                "16",
                                                "--time-limit",
                                                "1000",
                                                "--clearance",
                                                "0",
                                                "--heal",
                                                "1e-6",
                                                "--crop",
                                                "9,9,9,-9,-9,-9",
                                                "--target",
                                                "floor",
                                                "--aperture",
                                                "1e-6"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const Json options = run_json(room.bundle()).at("options");
  EXPECT_EQ(options, Json::parse(R"({"backend": "rays", "rays": 4, "sampling": "stratified",
      "regions": 16, "element_area": 0.5, "optimizer": "exact", "viewpoints": "none",
      "coverage": "elements", "missed_share": null, "one_sided": true, "clearance": 0.0, "time_limit": 1000.0, "close_gap": null, "lattice": 16,
      "merge_coplanar": true, "heal": 1e-6, "crop": [-9.0, -9.0, -9.0, 9.0, 9.0, 9.0], "targets": ["floor"], "aperture": 1e-6, "allow_outside": true})"));
  EXPECT_EQ(Table(room.bundle() + "/regions.csv").rows.size(), 16u);
  EXPECT_EQ(run_json(room.bundle()).at("scene").at("lattice_exponent"), 16);
}

TEST(Solve, TimeLimitGivesAWholeCoverAndExitCode1) {
  const RoomFolder room;
  const Outcome outcome = room.solve("bundle", {"--time-limit", "1e-9", "--quiet"});
  EXPECT_EQ(outcome.exit_code, 1);
  ASSERT_TRUE(is_complete(room.bundle()));
  EXPECT_EQ(run_json(room.bundle()).at("measured").at("time_limit_reached"), true);
  const Table cover(room.bundle() + "/cover.csv");
  EXPECT_EQ(cover.rows.back()[cover.column("covered_area_percent")], "100");
}

TEST(Solve, RepairsAreOneLine) {
  const RoomFolder room;
  const std::string scene = room.write("repaired.obj", read_file(room.scene()) + "f 1 1 2\n");
  const Outcome outcome =
      viewcover_run({"solve", scene, "--region", room.region(), "-o", room.bundle(), "--backend",
                     "rays", "--viewpoints", "none"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  // A slow machine shows progress as well.
  const std::string first_line = outcome.error.substr(0, outcome.error.find('\n'));
  EXPECT_THAT(first_line, ::testing::MatchesRegex("viewcover: .*repaired\\.obj: .*1 .*"));
  EXPECT_THAT(outcome.error.substr(first_line.size()),
              ::testing::MatchesRegex("\n((visibility|region cover|viewpoints): [^\n]*\n)*"));
  EXPECT_EQ(run_json(room.bundle()).at("scene").at("repairs").at("degenerate_faces"), 1);
}

TEST(Solve, InterruptLeavesAnIncompleteBundle) {
  const RoomFolder room;
  // A run of many minutes, so that it cannot end by itself before the signal.
  Process process({VIEWCOVER_BINARY, "solve", room.scene(), "--region", room.region(), "-o",
                   room.bundle(), "--regions", "4096", "--element-area", "0.001", "--rays",
                   "1000"});
  while (process.running() && !std::filesystem::exists(room.bundle() + "/run.json")) {
    ::usleep(1000);
  }
  ::usleep(100'000);
  ASSERT_TRUE(process.running()) << process.error();
  process.signal(SIGINT);
  EXPECT_EQ(process.wait(), 130);
  EXPECT_THAT(process.error(), ::testing::MatchesRegex("viewcover: interrupted[^\n]*\n"));
  EXPECT_EQ(process.out(), "");
  EXPECT_EQ(run_json(room.bundle()).at("complete"), false);
  EXPECT_EQ(run_json(room.bundle()).at("measured").at("ended"), "interrupted");
}

TEST(Solve, AKilledRunLeavesAnIncompleteBundle) {
  const RoomFolder room;
  ASSERT_EQ(room.solve("bundle").exit_code, 0);
  ASSERT_TRUE(is_complete(room.bundle()));
  Process process({VIEWCOVER_BINARY, "solve", room.scene(), "--region", room.region(), "-o",
                   room.bundle(), "--regions", "4096", "--element-area", "0.001", "--rays",
                   "1000"});
  while (process.running() && is_complete(room.bundle())) ::usleep(1000);
  ASSERT_TRUE(process.running()) << process.error();
  process.signal(SIGKILL);
  EXPECT_EQ(process.wait(), 128 + SIGKILL);
  EXPECT_FALSE(is_complete(room.bundle()));
}

}  // namespace
}  // namespace viewcover::testing
