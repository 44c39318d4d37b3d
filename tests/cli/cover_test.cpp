#include <gmock/gmock.h>

#include <sstream>

#include "bundle_files.h"
#include "scene/random_numbers.h"
#include "scene/scratch_folder.h"

namespace viewcover::testing {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Three choices, five things to cover of which nobody covers the last: 1 and 3 are the cover.
constexpr const char* kMatrix =
    "%%MatrixMarket matrix coordinate pattern general\n"
    "3 5 6\n1 1\n1 2\n2 2\n2 3\n3 3\n3 4\n";
/// The same in the manner of OR-Library: columns are chosen. (The last thing to cover has none.)
constexpr const char* kScp = "5 3\n1 1 1\n1\n1\n2\n1 2\n2\n2 3\n1\n3\n0\n";

class Cover : public ::testing::Test {
 protected:
  Json ask(std::vector<std::string> options, int exit_code = 0) {
    options.insert(options.begin(), "cover");
    const Outcome outcome = viewcover_run(options);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.error;
    EXPECT_EQ(outcome.error, "");
    return Json::parse(outcome.out);
  }
  std::string complaint(std::vector<std::string> options) {
    options.insert(options.begin(), "cover");
    const Outcome outcome = viewcover_run(options);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(std::count(outcome.error.begin(), outcome.error.end(), '\n'), 1);
    return outcome.error;
  }
  std::string file(const std::string& name, std::string_view text) {
    return folder_.write(name, text).string();
  }

  ScratchFolder folder_;
};

TEST_F(Cover, IsProvedByDefault) {
  const Json json = ask({file("m.mtx", kMatrix)});
  EXPECT_EQ(json.at("size"), 2);
  EXPECT_EQ(json.at("lower_bound"), 2);
  EXPECT_EQ(json.at("proved"), true);
  EXPECT_THAT(json.at("chosen").get<std::vector<int>>(), ElementsAre(1, 3));
  EXPECT_THAT(json.at("uncoverable").get<std::vector<int>>(), ElementsAre(5));
  EXPECT_EQ(json.at("covered_weight"), 4);
  EXPECT_EQ(json.at("method"), "exact");
  EXPECT_GE(json.at("seconds"), 0);
  EXPECT_TRUE(json.contains("evaluations"));
}

TEST_F(Cover, AnnealingTakesAScheduleAndRefusesOthers) {
  // 60 choices of a few out of 150 things: annealing has work to do.
  RandomNumbers random(1);
  std::ostringstream matrix;
  matrix << "%%MatrixMarket matrix coordinate pattern general\n60 150 720\n";
  for (int choice = 1; choice <= 60; ++choice) {
    for (int i = 0; i < 12; ++i) matrix << choice << ' ' << 1 + random.below(150) << '\n';
  }
  const std::string m = file("m.mtx", matrix.str());
  const auto annealed = [&](const std::string& schedule) {
    return ask({m, "--method", "sa", "--annealing", schedule});
  };
  const auto evaluations = [](const Json& json) { return json.at("evaluations").get<double>(); };
  const Json usual = ask({m, "--method", "sa"}),
             named = annealed("rounds=12,levels=30,cooling=0.8,temperature=0.02");
  EXPECT_EQ(usual.at("chosen"), named.at("chosen"));
  EXPECT_EQ(evaluations(usual), evaluations(named));
  EXPECT_LT(evaluations(annealed("levels=3")), evaluations(usual));
  EXPECT_GT(evaluations(annealed("levels=90")), evaluations(usual));
  EXPECT_NE(evaluations(annealed("temperature=0.5")), evaluations(usual));
  EXPECT_NE(evaluations(annealed("cooling=0.5")), evaluations(usual));

  const auto refused = [&](const std::string& schedule) {
    return complaint({m, "--method", "sa", "--annealing", schedule});
  };
  EXPECT_THAT(refused("speed=1"), HasSubstr("--annealing: \"speed=1\" is none of the schedule's"));
  for (const char* bad : {"rounds", "rounds=", "rounds=0", "levels=x", "cooling=1.5", ","}) {
    EXPECT_THAT(refused(bad), HasSubstr("--annealing: ")) << bad;
  }
  EXPECT_THAT(complaint({m, "--annealing", "rounds=1"}), HasSubstr("use --method sa"));
}

TEST_F(Cover, EveryMethodAndFormatAgrees) {
  for (const char* method : {"exact", "local", "sa", "tabu", "greedy"}) {
    const Json json = ask({file("m.txt", kScp), "--format", "scp", "--method", method});
    EXPECT_THAT(json.at("chosen").get<std::vector<int>>(), ElementsAre(1, 3)) << method;
    EXPECT_EQ(json.at("method"), method);
  }
  const Json sets = ask({file("m.hgr", "c comment\np hs 3 4\n1\n1 2\n2 3\n3\n")});
  EXPECT_THAT(sets.at("chosen").get<std::vector<int>>(), ElementsAre(1, 3));
}

TEST_F(Cover, WeightsDecideWhatOneChoiceCovers) {
  const std::string matrix = file("m.mtx", kMatrix), weights = file("w", "1 1 5 1 7\n");
  const Json json = ask({matrix, "--weights", weights, "--k", "1"});
  EXPECT_EQ(json.at("size"), 1);
  EXPECT_THAT(json.at("chosen").get<std::vector<int>>(), ElementsAre(::testing::AnyOf(2, 3)));
  EXPECT_EQ(json.at("covered_weight"), 6);
  EXPECT_EQ(json.at("covered_percent"), 75);
  EXPECT_GE(json.at("upper_bound_percent"), 75);
  EXPECT_LT(json.at("upper_bound_percent"), 75.000001);
  EXPECT_EQ(json.at("proved"), true);
  EXPECT_EQ(ask({matrix, "--k", "9"}).at("size"), 2);
}

TEST_F(Cover, ProofIsWrittenAndHolds) {
  const std::string matrix = file("m.mtx", kMatrix), proof = (folder_.path() / "p").string();
  ask({matrix, "--proof", proof});
  EXPECT_THAT(read_file(proof), HasSubstr("bound 2"));
}

TEST_F(Cover, ListsSolutions) {
  // Two of three choices, each pair covers.
  const Json json = ask({file("m.mtx",
                              "%%MatrixMarket matrix coordinate pattern general\n"
                              "3 3 6\n1 1\n1 2\n2 2\n2 3\n3 3\n3 1\n"),
                         "--solutions", "10"});
  EXPECT_EQ(json.at("solutions"), Json::parse("[[1,2],[1,3],[2,3]]"));
  EXPECT_EQ(json.at("solutions_complete"), true);
}

/// Random: optimal covers are out of reach for hours.
std::string hard_matrix() {
  constexpr std::size_t kRows = 600, kColumns = 3000, kEntries = 90'000;
  RandomNumbers random(1);
  std::ostringstream text;
  text << "%%MatrixMarket matrix coordinate pattern general\n"
       << kRows << ' ' << kColumns << ' ' << kEntries << '\n';
  for (std::size_t i = 0; i < kEntries; ++i) {
    text << 1 + random.below(kRows) << ' ' << 1 + random.below(kColumns) << '\n';
  }
  return text.str();
}

TEST_F(Cover, TimeLimitAndInterruptGiveTheBestSoFar) {
  const std::string matrix = file("m.mtx", hard_matrix());
  const Json limited = ask({matrix, "--time-limit", "0.5", "--quiet"}, 1);
  EXPECT_EQ(limited.at("proved"), false);
  EXPECT_GE(limited.at("lower_bound"), 1);
  EXPECT_GE(limited.at("size"), 17);

  Process process({VIEWCOVER_BINARY, "cover", matrix, "--quiet"});
  ::usleep(1'500'000);
  ASSERT_TRUE(process.running()) << process.error();
  process.signal(SIGINT);
  EXPECT_EQ(process.wait(), 130);
  EXPECT_GE(Json::parse(process.out()).at("size"), 17);
}

TEST_F(Cover, NothingToCover) {
  const Json json = ask({file("m.txt", "0 3\n1 1 1\n"), "--format", "scp"});
  EXPECT_EQ(json.at("size"), 0);
  EXPECT_EQ(json.at("proved"), true);
  EXPECT_EQ(ask({file("n.txt", "2 0\n0\n0\n"), "--format", "scp"}).at("uncoverable").size(), 2u);
}

TEST_F(Cover, BadInputIsOneLine) {
  const std::string matrix = file("m.mtx", kMatrix);
  EXPECT_THAT(complaint({"/nowhere.mtx"}), HasSubstr("/nowhere.mtx: no such file"));
  EXPECT_THAT(complaint({file("m.txt", kScp)}), HasSubstr("--format scp"));
  EXPECT_THAT(complaint({matrix, "--format", "xls"}), HasSubstr("--format xls"));
  EXPECT_THAT(complaint({matrix, "--method", "magic"}), HasSubstr("--method magic"));
  EXPECT_THAT(complaint({matrix, "--k", "0"}), HasSubstr("--k"));
  EXPECT_THAT(complaint({matrix, "--weights", file("w", "1 2\n")}), HasSubstr("the file ends"));
  EXPECT_THAT(complaint({matrix, "--method", "greedy", "--proof", "p"}), HasSubstr("--proof"));
  EXPECT_THAT(complaint({matrix, "--proof", "/nowhere/p"}), HasSubstr("/nowhere"));
}

}  // namespace
}  // namespace viewcover::testing
