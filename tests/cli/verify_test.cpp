#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <utility>

#include "bundle_files.h"
#include "scene/scratch_folder.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;

template <class... Parts>
std::string joined(const Parts&... parts) {
  std::ostringstream out;
  (out << ... << parts);
  return out.str();
}

class Verify : public ::testing::Test {
 protected:
  void SetUp() override { solve({"--backend", "rays", "--regions", "16", "--viewpoints", "none"}); }

  /// The living room into bundle().
  void solve(std::vector<std::string> options) const {
    const std::string scene = (folder_.path() / "scene.obj").string();
    ASSERT_EQ(
        viewcover_run({"generate", "living-room", "--detail", "simple", "-o", scene}).exit_code, 0);
    options.insert(options.begin(),
                   {"solve", scene, "--region", (folder_.path() / "scene.region.json").string(),
                    "-o", bundle().string(), "--quiet"});
    const Outcome outcome = viewcover_run(options);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  }
  std::filesystem::path bundle() const { return folder_.path() / "bundle"; }
  Outcome verify() const { return viewcover_run({"verify", bundle().string()}); }

  /// Replaces the first match of a pattern in a file of the bundle.
  void damage(const std::string& name, const std::string& pattern, const std::string& by) const {
    const std::string text = read_file(bundle() / name);
    const std::string changed =
        std::regex_replace(text, std::regex(pattern), by, std::regex_constants::format_first_only);
    ASSERT_NE(text, changed);
    std::ofstream(bundle() / name) << changed;
  }
  void expect_contradiction(const std::string& claim) const { expect_contradictions({claim}); }
  void expect_contradictions(const std::vector<std::string>& claims) const {
    const Outcome outcome = verify();
    EXPECT_EQ(outcome.exit_code, 3);
    for (const std::string& claim : claims) {
      EXPECT_THAT(outcome.error, HasSubstr("not true that " + claim));
    }
  }
  void expect_only_contradiction(const std::string& claim) const {
    const Outcome outcome = verify();
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_THAT(outcome.error, HasSubstr("not true that " + claim));
    EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1) << outcome.error;
  }

  ScratchFolder folder_;
};

TEST_F(Verify, HoldsForARunWithTargets) {
  solve({"--target", "floor", "--target", "rug", "--regions", "16"});
  const Json run = run_json(bundle());
  EXPECT_EQ(run.at("options").at("targets"), Json({"floor", "rug"}));
  const Table elements(bundle() / "elements.csv");
  std::set<std::string> seen;
  for (const auto& row : elements.rows) {
    if (row[elements.column("times_visible")] != "0") seen.insert(row[elements.column("group")]);
  }
  EXPECT_EQ(seen, (std::set<std::string>{"floor", "rug"}));
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
}

TEST_F(Verify, AnUntouchedBundleHolds) {
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(outcome.error, "");
  EXPECT_THAT(outcome.out, HasSubstr("holds: cover.proof proves"));
}

TEST_F(Verify, FindsAWrongCount) {
  damage("run.json", "\"optimal_regions\": \\d+", "\"optimal_regions\": 1");
  expect_contradiction("run.json agrees");
}
TEST_F(Verify, FindsAWrongShare) {
  damage("cover.csv", "\n1,\\d+", "\n1,99");
  expect_contradiction("cover.csv states");
}
TEST_F(Verify, FindsAMissingEntry) {
  // The entry moves to a place that is taken.
  damage("visibility.mtx", "\n1 1\n1 2\n", "\n1 2\n1 2\n");
  expect_contradiction("elements.csv counts");
}
TEST_F(Verify, FindsAWrongMark) {
  const Table regions(bundle() / "regions.csv");
  std::string before, after;
  for (std::size_t i = 0; i <= regions.column("chosen"); ++i) {
    const std::string& field = regions.rows[0][i];
    before += field + ",";
    after += (i < regions.column("chosen") ? field : field == "0" ? "1" : "0") + ",";
  }
  std::string text = read_file(bundle() / "regions.csv");
  text.replace(text.find(before), before.size(), after);
  std::ofstream(bundle() / "regions.csv") << text;
  expect_contradiction("regions.csv marks");
}
TEST_F(Verify, FindsAWrongProof) {
  damage("cover.proof", "\nbound (\\d+)", "\nbound 99");
  expect_contradiction("cover.proof proves");
}

TEST_F(Verify, AnIncompleteRunIsNoBundle) {
  damage("run.json", "\"complete\": true", "\"complete\": false");
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error, HasSubstr("not complete"));
}

/// An exact bundle with viewpoints, whose lower bound took cells smaller than regions.
class VerifyViewpoints : public Verify {
 protected:
  void SetUp() override {
    solve({"--regions", "4", "--element-area", "2"});
    const Json results = run_json(bundle()).at("results");
    ASSERT_GT(results.at("viewpoints_lower_bound"), results.at("regions_lower_bound"));
    const Outcome outcome = verify();
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    ASSERT_THAT(outcome.out, HasSubstr("holds: each viewpoint sees no elements but those"));
    std::filesystem::rename(bundle(), folder_.path() / "untouched");
  }

  /// One solved room for all: it takes longer than all that is done to its copies.
  void on_a_copy(const char* damage, const std::function<void()>& damage_and_verify) const {
    SCOPED_TRACE(damage);
    std::filesystem::remove_all(bundle());
    std::filesystem::copy(folder_.path() / "untouched", bundle());
    damage_and_verify();
  }

  using Pair = std::pair<std::size_t, std::size_t>;
  std::set<Pair> pairs_of(const std::string& name) const {
    std::istringstream in(read_file(bundle() / name));
    std::string line;
    while (in.peek() == '%') std::getline(in, line);
    std::getline(in, line);  // sizes
    std::set<Pair> pairs;
    for (Pair pair; in >> pair.first >> pair.second;) pairs.insert(pair);
    return pairs;
  }
  void write_pairs(const std::string& name, const std::set<Pair>& pairs) const {
    std::istringstream in(read_file(bundle() / name));
    std::string line;
    while (in.peek() == '%') std::getline(in, line);
    std::size_t rows = 0, columns = 0;
    in >> rows >> columns;
    std::ofstream out(bundle() / name);
    out << "%%MatrixMarket matrix coordinate pattern general\n"
        << rows << ' ' << columns << ' ' << pairs.size() << '\n';
    for (const auto& [row, column] : pairs) out << row << ' ' << column << '\n';
  }
  /// Sets or clears an entry of viewpoints.mtx.
  void toggle(Pair pair) const {
    std::set<Pair> pairs = pairs_of("viewpoints.mtx");
    if (!pairs.insert(pair).second) pairs.erase(pair);
    write_pairs("viewpoints.mtx", pairs);
  }
  /// Leaves one row alone with the element that most rows see.
  void hide_the_most_seen(const std::string& name) const {
    std::set<Pair> pairs = pairs_of(name);
    std::map<std::size_t, int> viewers;
    for (const auto& [row, column] : pairs) ++viewers[column];
    const std::size_t most = std::ranges::max_element(viewers, {}, [](const auto& entry) {
                               return entry.second;
                             })->first;
    bool is_first = true;
    std::erase_if(pairs, [&](const Pair& pair) {
      return pair.second == most && !std::exchange(is_first, false);
    });
    write_pairs(name, pairs);
  }
  /// A pair of a viewpoint and an element that its region and another viewpoint see, so that no
  /// other claim tells whether the viewpoint sees it.
  Pair pair_that(bool is_seen) const {
    const std::set<Pair> visible = pairs_of("visibility.mtx"), seen = pairs_of("viewpoints.mtx");
    const Table viewpoints(bundle() / "viewpoints.csv");
    for (std::size_t i = 1; i <= viewpoints.rows.size(); ++i) {
      const auto region = std::stoul(viewpoints.rows[i - 1][viewpoints.column("region")]);
      for (const auto& [other, element] : seen) {
        if (other != i && visible.contains({region, element}) &&
            seen.contains({i, element}) == is_seen && other < i) {
          return {i, element};
        }
      }
    }
    ADD_FAILURE() << "no such pair";
    return {1, 1};
  }
};

TEST_F(VerifyViewpoints, FindsEachDamage) {
  on_a_copy(
      "a viewpoint outside its region; one that sees more than its region; a wrong share; a wrong "
      "proof; a missing cell; a bound that is too high",
      [&] {
        {
          // As little as one unit in the last place beside the region's plane.
          const Table viewpoints(bundle() / "viewpoints.csv");
          const std::string z = viewpoints.rows[0][viewpoints.column("z")];
          std::ostringstream beside;
          beside.precision(17);
          beside << std::nextafter(std::stod(z), 10.0);
          damage("viewpoints.csv", "," + z + ",", "," + beside.str() + ",");
        }
        {
          // The viewpoint's first element becomes one that its region does not see.
          const Table viewpoints(bundle() / "viewpoints.csv");
          const std::string region = viewpoints.rows[0][viewpoints.column("region")];
          const std::string visibility = read_file(bundle() / "visibility.mtx");
          int unseen = 1;
          while (visibility.find("\n" + region + " " + std::to_string(unseen) + "\n") !=
                 std::string::npos) {
            ++unseen;
          }
          damage("viewpoints.mtx", "\n1 \\d+\n", "\n1 " + std::to_string(unseen) + "\n");
        }
        damage("viewpoints.csv", ",100,", ",99,");
        damage("run.json", "\"viewpoints_lower_bound\": \\d+", "\"viewpoints_lower_bound\": 99");
        damage("bound.proof", "\nbound (\\d+)", "\nbound 99");
        damage("bound.csv", "\n2,1,", "\n2,2,");
        expect_contradictions({"each viewpoint lies in its region",
                               "each viewpoint sees no more than its region",
                               "the lower bound is at most", "viewpoints.csv states",
                               "bound.proof proves", "the cells of the bound tile the regions"});
      });
  on_a_copy("a region that sees more than it says; a cell that sees more than it says", [&] {
    hide_the_most_seen("visibility.mtx");
    hide_the_most_seen("bound.mtx");
    expect_contradictions({"random positions see no more than visibility.mtx says of their regions",
                           "random positions see no more than bound.mtx says of their cells"});
  });
  on_a_copy("a missing viewpoint", [&] {
    damage("run.json", "\"viewpoints\": \\d+,(\\s*\"viewpoints_by)", "\"viewpoints\": 1,$1");
    expect_contradiction("viewpoints.csv, viewpoints.mtx and run.json agree");
  });
  on_a_copy("an element that a viewpoint does not see", [&] {
    const auto [viewpoint, element] = pair_that(false);
    toggle({viewpoint, element});
    expect_only_contradiction(
        joined("each viewpoint sees the elements that viewpoints.mtx says: viewpoint ", viewpoint,
               " does not see element ", element));
  });
  on_a_copy("an element that a viewpoint sees unsaid", [&] {
    const auto [viewpoint, element] = pair_that(true);
    toggle({viewpoint, element});
    expect_only_contradiction(
        joined("each viewpoint sees no elements but those that viewpoints.mtx says: viewpoint ",
               viewpoint, " sees element ", element));
  });
}

/// Full coverage of a comb of three teeth, its bound from witnesses.
class VerifyFullCoverage : public Verify {
 protected:
  void SetUp() override {
    const auto plan =
        folder_.write("plan.txt",
                      "0 0\n12 0\n12 1\n11 1\n11 4\n9 4\n9 1\n7 1\n7 4\n5 4\n5 1\n3 1\n"
                      "3 4\n1 4\n1 1\n0 1\n");
    const std::string scene = (folder_.path() / "scene.obj").string();
    ASSERT_EQ(viewcover_run({"generate", "gallery", plan.string(), "--height", "2", "-o", scene})
                  .exit_code,
              0);
    const Outcome outcome =
        viewcover_run({"solve", scene, "--region", (folder_.path() / "scene.region.json").string(),
                       "-o", bundle().string(), "--quiet", "--coverage", "full", "--regions", "4",
                       "--element-area", "4", "--close-gap", "0"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    const Json results = run_json(bundle()).at("results");
    ASSERT_EQ(results.at("viewpoints"), 3);
    ASSERT_EQ(results.at("bound_columns"), "witnesses");
  }
};

TEST_F(VerifyFullCoverage, HoldsUntilAWitnessIsMoved) {
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(outcome.out, HasSubstr("holds: each witness is seen from a viewpoint"));
  EXPECT_THAT(outcome.out, HasSubstr("holds: cells of the bound do not see"));
  damage("witnesses.csv", "\n1,(\\d+),([^,]+),", "\n1,$1,63,");
  expect_contradiction("each witness lies in its element");
}

TEST_F(VerifyFullCoverage, FindsAWitnessWhereSurfacesMeetOrInTheRegionsPlane) {
  // The regions lie at z = 1, the first wall at y = 0: the nearest witness moves there.
  const std::string whole = read_file(bundle() / "witnesses.csv");
  const auto move_nearest = [&](const std::string& axis, double to, const std::string& pattern) {
    std::string nearest, moved;
    double least = INFINITY;
    std::istringstream in(whole);
    for (std::string line; std::getline(in, line);) {
      std::smatch found;
      if (!std::regex_match(line, found, std::regex(pattern))) continue;
      const double away = std::abs(std::stod(found[2]) - to);
      if (away >= least) continue;
      least = away;
      nearest = line;
      moved = found[1].str() + axis + found[3].str();
    }
    ASSERT_FALSE(nearest.empty());
    std::string text = whole;
    text.replace(text.find(nearest), nearest.size(), moved);
    std::ofstream(bundle() / "witnesses.csv") << text;
  };
  const std::string claim =
      "no witness lies on another surface or in the plane of a region: witness";
  move_nearest("0", 0, R"((\d+,\d+,[34][^,]*,)([^,]+)(,0))");  // of the floor
  expect_contradiction(claim);
  move_nearest("1", 1, R"((\d+,\d+,[^,]+,[^,]+,)([01]\.[^,]+)(.*))");  // of a wall
  expect_contradiction(claim);
}

TEST_F(VerifyFullCoverage, FindsAWitnessThatIsNotSeen) {
  // One viewpoint goes where another is.
  const Table viewpoints(bundle() / "viewpoints.csv");
  std::string text = read_file(bundle() / "viewpoints.csv");
  const std::size_t second = text.find("\n2,") + 3, third = text.find("\n3,") + 3;
  const std::string place = text.substr(second, text.find('\n', second) - second);
  text.replace(third, text.find('\n', third) - third, place);
  std::ofstream(bundle() / "viewpoints.csv") << text;
  expect_contradiction("each witness is seen from a viewpoint");
}

TEST_F(VerifyFullCoverage, FindsACellThatSeesMore) {
  // Each cell claims to see only the first of its witnesses; other cells keep the others asked.
  std::istringstream in(read_file(bundle() / "bound.mtx"));
  std::string kept, line;
  std::set<std::string> cells;
  std::size_t dropped = 0;
  while (std::getline(in, line)) {
    std::smatch entry;
    const bool is_entry = std::regex_match(line, entry, std::regex("(\\d+) \\d+"));
    if (is_entry && !cells.insert(entry[1]).second) {
      ++dropped;
      continue;
    }
    kept += line + '\n';
  }
  ASSERT_GT(dropped, 0u);
  const std::regex sizes("\n(\\d+) (\\d+) (\\d+)\n");
  std::smatch found;
  ASSERT_TRUE(std::regex_search(kept, found, sizes));
  kept = std::regex_replace(kept, sizes,
                            "\n$1 $2 " + std::to_string(std::stoul(found[3]) - dropped) + "\n",
                            std::regex_constants::format_first_only);
  std::ofstream(bundle() / "bound.mtx") << kept;
  expect_contradiction("cells of the bound do not see what bound.mtx says they do not");
}

}  // namespace
}  // namespace viewcover::testing
