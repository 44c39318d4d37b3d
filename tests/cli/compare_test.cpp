#include <gmock/gmock.h>

#include "bundle_files.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;

class Compare : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(room_.solve("exact", {"--regions", "16", "--backend", "exact"}).exit_code, 0);
    ASSERT_EQ(
        room_.solve("rays", {"--regions", "16", "--backend", "rays", "--rays", "16"}).exit_code, 0);
  }
  Outcome compare(const std::string& a, const std::string& b) const {
    return viewcover_run({"compare", room_.bundle(a), room_.bundle(b)});
  }
  Json compared(const std::string& a, const std::string& b) const {
    const Outcome outcome = compare(a, b);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return Json::parse(last_line(outcome.out));
  }

  RoomFolder room_;
};

TEST_F(Compare, RaysMissPairsAndAddNone) {
  const Json rays = compared("rays", "exact");
  EXPECT_GT(rays.at("Q_u").at("count"), 0.01);
  EXPECT_GT(rays.at("Q_u").at("area"), 0.01);
  EXPECT_LT(rays.at("Q_u").at("area"), 0.5);
  EXPECT_EQ(rays.at("Q_o"), Json({{"count", 0.0}, {"area", 0.0}}));
  EXPECT_EQ(rays.at("excess"), Json::object());
  double missed = 0;
  for (const auto& [verdict, pairs] : rays.at("missed").items()) missed += double(pairs.at("area"));
  EXPECT_NEAR(
      missed,
      double(rays.at("pairs").at("b").at("area")) - double(rays.at("pairs").at("a").at("area")),
      1e-9 * missed);
  EXPECT_EQ(rays.at("optimum").at("covered_percent_by_a"), 100.0);

  // The other way round what is missed is excess.
  const Json exact = compared("exact", "rays");
  EXPECT_EQ(exact.at("excess"), rays.at("missed"));
  EXPECT_EQ(exact.at("missed"), Json::object());
  EXPECT_GT(exact.at("Q_o").at("area"), rays.at("Q_u").at("area"));
  EXPECT_EQ(exact.at("optimum").at("covered_percent_by_a"), 100.0);
  EXPECT_EQ(exact.at("optimum").at("covered_percent_by_b") == 100.0,
            exact.at("optimum").at("elements_left_out_by_b") == 0);
}

TEST_F(Compare, ARunIsNotFarFromItself) {
  const Json same = compared("exact", "exact");
  EXPECT_EQ(same.at("Q_u"), Json({{"count", 0.0}, {"area", 0.0}}));
  EXPECT_EQ(same.at("Q_o"), same.at("Q_u"));
  EXPECT_EQ(same.at("pairs").at("a"), same.at("pairs").at("b"));
  EXPECT_EQ(same.at("optimum").at("elements_left_out_by_b"), 0);
  const Outcome quiet =
      viewcover_run({"compare", room_.bundle("exact"), room_.bundle("exact"), "--quiet"});
  EXPECT_EQ(quiet.out, last_line(compare("exact", "exact").out) + "\n");
}

TEST_F(Compare, RefusesOtherRegionsAndWhatIsNoRun) {
  ASSERT_EQ(room_.solve("coarse", {"--regions", "4"}).exit_code, 0);
  expect_refused(compare("coarse", "exact"),
                 room_.bundle("exact") + ": the runs have different regions; give two runs of one");
  expect_refused(compare("nowhere", "exact"), "give the folder of a finished run");
  expect_refused(viewcover_run({"compare", room_.bundle("exact")}), "give the folders of two runs");
}

}  // namespace
}  // namespace viewcover::testing
