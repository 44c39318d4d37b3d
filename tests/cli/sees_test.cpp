#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "bundle_files.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;

constexpr const char* kSquares =
    R"("region": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "element": [[0,0,2],[1,0,2],[1,1,2],[0,1,2]])";

std::string query(const std::string& id, const std::string& rest) {
  return R"({"id": )" + id + ", " + rest + "}\n";
}

class Sees : public ::testing::Test {
 protected:
  /// One JSON object a line of output.
  std::vector<Json> ask(const std::string& lines, int exit_code,
                        std::vector<std::string> options = {}) {
    std::ofstream(folder_.path() / "queries.jsonl") << lines;
    options.insert(options.begin(), {"sees", (folder_.path() / "queries.jsonl").string()});
    const Outcome outcome = viewcover_run(options);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    std::vector<Json> answers;
    std::istringstream in(outcome.out);
    for (std::string line; std::getline(in, line);) answers.push_back(Json::parse(line));
    return answers;
  }

  ScratchFolder folder_;
};

TEST_F(Sees, AnswersInOrderWithTheKeysOfTheInterface) {
  const auto answers =
      ask(query("1", kSquares) +
              query("\"two\"", std::string(kSquares) +
                                   R"(, "occluders": [[[-9,-9,1],[9,-9,1],[9,9,1],[-9,9,1]]])") +
              query("3", std::string(kSquares) +
                             R"(, "occluders": [[[-9,-9,1],[0.5,-9,1],[0.5,9,1],[-9,9,1]]])"),
          0);
  ASSERT_EQ(answers.size(), 3u);
  EXPECT_EQ(answers[0].at("id"), 1);
  EXPECT_EQ(answers[0].at("visible"), true);
  EXPECT_EQ(answers[0].at("fully"), true);
  EXPECT_EQ(answers[0].at("by"), "fully_visible");
  EXPECT_EQ(answers[1].at("id"), "two");
  EXPECT_EQ(answers[1].at("visible"), false);
  EXPECT_EQ(answers[1].at("fully"), false);
  EXPECT_EQ(answers[1].at("by"), "hidden_by_one");
  EXPECT_FALSE(answers[1].contains("witness"));
  EXPECT_EQ(answers[2].at("visible"), true);
  EXPECT_EQ(answers[2].at("fully"), false);
  EXPECT_EQ(answers[2].at("by"), "visible_witness");
  const Json& witness = answers[2].at("witness");
  EXPECT_EQ(witness.at("from").size(), 3u);
  EXPECT_EQ(witness.at("to").size(), 3u);
  for (const char* weights : {"region_weights", "element_weights"}) {
    ASSERT_EQ(witness.at(weights).size(), 4u);
    for (const double weight : witness.at(weights)) EXPECT_GT(weight, 0);
  }
  EXPECT_GT(double(witness.at("from")[0]) + double(witness.at("to")[0]), 1);  // past x = 1/2
  EXPECT_GE(answers[2].at("ms"), 0);
}

TEST_F(Sees, ViewpointsGetTheVisibleFraction) {
  const auto answers =
      ask(R"({"id": 1, "viewpoint": [0,0,0], "element": [[-1,-1,2],[1,-1,2],[1,1,2],[-1,1,2]],)"
          R"( "occluders": [[[-9,-9,1],[-0.25,-9,1],[-0.25,9,1],[-9,9,1]]]})"
          "\n",
          0);
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_EQ(answers[0].at("visible_fraction"), 0.75);
  EXPECT_FALSE(answers[0].at("witness").contains("region_weights"));
  EXPECT_EQ(answers[0].at("witness").at("from"), (Json{0.0, 0.0, 0.0}));
}

TEST_F(Sees, CornersWithinEdgesAreAllowedAndWeighted) {
  const auto answers =
      ask(R"({"id": 1, "region": [[0,0,0],[0.5,0,0],[1,0,0],[1,1,0],[0,1,0]],)"
          R"( "element": [[0,0,2],[1,0,2],[1,1,2]], "occluders": [[[0,0,1],[1,0,1],[1,0.5,1]]]})"
          "\n",
          0);
  EXPECT_EQ(answers[0].at("visible"), true);
  EXPECT_EQ(answers[0].at("witness").at("region_weights").size(), 5u);
}

TEST_F(Sees, BadQueriesAreNamedAndTheRestGoesOn) {
  const std::vector<std::pair<std::string, std::string>> bad = {
      {query("1", R"("region": [[0,0,0],[1,0,0]], "element": [[0,0,1],[1,0,1],[0,1,1]])"),
       "region"},
      {query("2", R"("element": [[0,0,1],[1,0,1],[0,1,1]])"), "viewpoint"},
      {query("3", R"("viewpoint": [0,0,0])"), "element"},
      {query("4", R"("viewpoint": [0,0,0], "element": [[0,0,1],[1,0,1],[1,1,2],[0,1,1]])"),
       "planar"},
      {query("5", R"("viewpoint": [0,0,0], "element": [[0,0,1],[2,0,1],[1,1,1],[2,2,1],[0,2,1]])"),
       "convex"},
      {query("6", R"("viewpoint": [0,0,0], "element": [[0,0,1],[1,0,1],[2,0,1]])"), "area"},
      {query("7", R"("viewpoint": [0,0,0], "element": [[0,0,1],[0,0,1],[2,0,1],[0,1,1]])"),
       "repeats"},
      {query("8", R"("viewpoint": [0,0], "element": [[0,0,1],[1,0,1],[0,1,1]])"), "viewpoint"},
      {query("9", R"("viewpoint": [0,0,"0"], "element": [[0,0,1],[1,0,1],[0,1,1]])"), "number"},
      {query("10", R"("viewpoint": [0,0,9007199254740993], "element": [[0,0,1],[1,0,1],[0,1,1]])"),
       "exactly"},
      {query("11", R"("viewpoint": [0,0,1e-200], "element": [[0,0,1],[1,0,1],[0,1,1]])"), "small"},
      {query("12", std::string(kSquares) + R"(, "occluder": [])"), "occluder"},
      {query("13", std::string(kSquares) + R"(, "occluders": 7)"), "occluders"},
      {query("14", std::string(kSquares) + R"(, "occluders": [[[0,0,1],[1,0,1]]])"), "occluder 1"},
      {"{\"id\": 15,\n", "JSON"},
      {"[]\n", "object"},
      {query("17", R"("viewpoint": [0,0,1e999], "element": [[0,0,1],[1,0,1],[0,1,1]])"), "JSON"},
  };
  std::string lines;
  for (const auto& [line, mentioned] : bad) lines += line + "\n";
  lines += query("99", kSquares);
  const auto answers = ask(lines, 2);
  ASSERT_EQ(answers.size(), bad.size() + 1);
  for (std::size_t i = 0; i < bad.size(); ++i) {
    SCOPED_TRACE(bad[i].first);
    EXPECT_THAT(std::string(answers[i].at("error")), HasSubstr(bad[i].second));
    EXPECT_FALSE(answers[i].contains("visible"));
  }
  EXPECT_EQ(answers[0].at("id"), 1);
  EXPECT_EQ(answers.back().at("visible"), true);
}

TEST_F(Sees, RaysMayMissWhatExactSees) {
  const std::string slit = query(
      "1", std::string(kSquares) +
               R"(, "occluders": [[[-9,-9,1],[0.5,-9,1],[0.5,9,1],[-9,9,1]],)"
               R"([[0.50000095367431640625,-9,1],[9,-9,1],[9,9,1],[0.50000095367431640625,9,1]]])");
  EXPECT_EQ(ask(slit, 0)[0].at("visible"), true);
  const auto by_rays = ask(slit, 0, {"--backend", "rays"});
  EXPECT_EQ(by_rays[0].at("visible"), false);
  EXPECT_EQ(by_rays[0].at("by"), "hidden_all_rays_blocked");
  const auto open = ask(query("1", kSquares), 0, {"--backend", "rays", "--rays", "1"});
  EXPECT_EQ(open[0].at("visible"), true);
  EXPECT_EQ(open[0].at("witness").at("region_weights").size(), 4u);
}

TEST_F(Sees, OneSidedElementsAreSeenFromTheFrontOnly) {
  EXPECT_EQ(ask(query("1", kSquares), 0, {"--one-sided"})[0].at("by"), "hidden_not_facing");
  EXPECT_EQ(
      ask(R"({"viewpoint": [0,0,3], "element": [[0,0,2],[1,0,2],[0,1,2]]})", 0, {"--one-sided"})[0]
          .at("visible"),
      true);
}

TEST_F(Sees, AMissingFileIsRefused) {
  const Outcome outcome = viewcover_run({"sees", (folder_.path() / "none.jsonl").string()});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.error, HasSubstr("none.jsonl"));
  EXPECT_EQ(std::ranges::count(outcome.error, '\n'), 1);
}

/// Two squares without occluder: every pair of corners is a node, and each corner with each edge of
/// the other square an arc.
TEST_F(Sees, SkeletonIsAGraph) {
  const auto answers = ask(query("7", kSquares), 0, {"--skeleton"});
  ASSERT_EQ(answers.size(), 1u);
  const Json& graph = answers[0];
  EXPECT_EQ(graph.at("id"), 7);
  EXPECT_GE(graph.at("ms"), 0);
  ASSERT_EQ(graph.at("nodes").size(), 16u);
  ASSERT_EQ(graph.at("arcs").size(), 32u);
  for (const Json& node : graph.at("nodes")) {
    EXPECT_EQ(node.at("kind"), "VV");
    ASSERT_EQ(node.at("line").size(), 6u);
    ASSERT_EQ(node.at("rounded").size(), 6u);
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_EQ(std::stod(node.at("line")[k].get<std::string>()), node.at("rounded")[k]);
    }
    const Json &start = node.at("generators").at(0), &end = node.at("generators").at(1);
    EXPECT_EQ(start.at("polygon"), "region");
    EXPECT_EQ(end.at("polygon"), "element");
    EXPECT_EQ(
        node.at("from"),
        Json::parse("[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]").at(start.at("vertex").get<std::size_t>()));
  }
  for (const Json& arc : graph.at("arcs")) {
    EXPECT_EQ(arc.at("kind"), "VE");
    for (const std::size_t end : arc.at("nodes")) EXPECT_LT(end, 16u);
  }
}

TEST_F(Sees, SkeletonNamesOccluders) {
  const auto answers =
      ask(query("1", std::string(kSquares) +
                         R"(, "occluders": [[[-9,-9,1],[0.5,-9,1],[0.5,9,1],[-9,9,1]]])") +
              query("2", std::string(kSquares) +
                             R"(, "occluders": [[[-9,-9,1],[9,-9,1],[9,9,1],[-9,9,1]]])"),
          0, {"--skeleton"});
  ASSERT_EQ(answers.size(), 2u);
  bool any = false;
  for (const Json& node : answers[0].at("nodes")) {
    for (const Json& generator : node.at("generators")) {
      if (generator.at("polygon") != "occluder") continue;
      any = true;
      EXPECT_EQ(generator.at("occluder"), 0);
      EXPECT_EQ(generator.at("edge"), 1);
    }
  }
  EXPECT_TRUE(any);
  EXPECT_TRUE(answers[1].at("nodes").empty());
}

/// Four edges in general position have transversals with roots in their coordinates.
TEST_F(Sees, SkeletonWritesRoots) {
  const auto answers = ask(
      R"({"id": 1, "region": [[-64,-64,0],[64,-64,0],[0,64,0]], "element": [[-64,-64,8],[64,-64,8],[0,64,8]],)"
      R"( "occluders": [[[-8,0,1],[8,0,1],[8,-8,1]], [[0,-8,2],[0,8,2],[-8,8,2]],)"
      R"( [[-8,-8,3],[8,8,3],[8,-8,3]], [[-8,1,-4],[8,1,12],[8,9,12]]]})"
      "\n",
      0, {"--skeleton"});
  ASSERT_EQ(answers.size(), 1u);
  bool any = false;
  for (const Json& node : answers[0].at("nodes")) {
    for (const std::string component : node.at("line")) {
      if (component.find("sqrt(") != std::string::npos) any = true;
    }
  }
  EXPECT_TRUE(any);
}

TEST_F(Sees, SkeletonNeedsARegion) {
  const auto answers =
      ask(R"({"id": 1, "viewpoint": [0,0,0], "element": [[-1,-1,2],[1,-1,2],[1,1,2]]})"
          "\n",
          2, {"--skeleton"});
  ASSERT_EQ(answers.size(), 1u);
  EXPECT_THAT(answers[0].at("error").get<std::string>(), HasSubstr("viewpoint: has no skeleton"));
}

}  // namespace
}  // namespace viewcover::testing
