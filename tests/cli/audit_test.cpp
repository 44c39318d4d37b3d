#include <gmock/gmock.h>

#include <fstream>
#include <regex>

#include "bundle_files.h"

namespace viewcover::testing {
namespace {

using ::testing::HasSubstr;

/// A solved room and three viewpoints at eye height.
class Audit : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(room_.solve("bundle", {"--regions", "16"}).exit_code, 0);
    viewpoints_ = room_.write("points.csv", "x,y,z\n1.5,1.25,1.6\n3.7,2.9,1.6\n4.1,0.7,1.6\n");
  }
  Outcome audit(std::vector<std::string> more = {}) const { return audit_of(viewpoints_, more); }
  Outcome audit_of(const std::string& viewpoints, std::vector<std::string> more = {}) const {
    std::vector<std::string> arguments = {"audit", room_.bundle(), "--viewpoints", viewpoints};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return viewcover_run(arguments);
  }
  Outcome verify() const { return viewcover_run({"verify", room_.bundle()}); }
  std::filesystem::path file(const std::string& name) const {
    return std::filesystem::path(room_.bundle()) / name;
  }

  RoomFolder room_;
  std::string viewpoints_;
};

TEST_F(Audit, MeasuresAndHolds) {
  const Outcome outcome = audit();
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const Json line = Json::parse(last_line(outcome.out));
  const Table elements(file("elements.csv")), audited(file("audit.csv"));
  EXPECT_EQ(line.at("viewpoints"), 3);
  EXPECT_EQ(line.at("elements"), elements.rows.size());
  EXPECT_EQ(audited.rows.size(), elements.rows.size());
  double imaged = 0;
  for (const auto& row : audited.rows) imaged += std::stod(row[audited.column("imaged_area")]);
  EXPECT_NEAR(line.at("imaged_area").get<double>(), imaged, 1e-9 * imaged);
  EXPECT_GT(line.at("imaged_percent"), 50);
  EXPECT_LT(line.at("imaged_percent"), 100);
  EXPECT_THAT(read_file(file("audit.vtp")), HasSubstr("Name=\"images\""));

  const Outcome verified = verify();
  EXPECT_EQ(verified.exit_code, 0) << verified.error;
  EXPECT_THAT(verified.out, HasSubstr("holds: audit.csv states how much of each element"));
}

TEST_F(Audit, ThreadsChangeNoByte) {
  ASSERT_EQ(audit({"--threads", "1"}).exit_code, 0);
  const auto one = comparable_files(room_.bundle());
  ASSERT_EQ(audit({"--threads", "3"}).exit_code, 0);
  EXPECT_EQ(one, comparable_files(room_.bundle()));
}

TEST_F(Audit, TakesTheViewpointsOfTheBundle) {
  std::ofstream(file("viewpoints.csv"))
      << "viewpoint,x,y,z,region,covered_area_percent,seconds\n1,1.5,1.25,1.6,1,50,0.1\n";
  const Outcome outcome = viewcover_run({"audit", room_.bundle()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(Json::parse(last_line(outcome.out)).at("viewpoints"), 1);
  EXPECT_EQ(verify().exit_code, 0);
  // Another viewpoint, the same audit.
  std::ofstream(file("viewpoints.csv"))
      << "viewpoint,x,y,z,region,covered_area_percent,seconds\n1,1.5,1.5,1.6,1,50,0.1\n";
  const Outcome stale = verify();
  EXPECT_EQ(stale.exit_code, 3);
  EXPECT_THAT(stale.error, HasSubstr("audit.json has the viewpoints"));
}

TEST_F(Audit, VerifyFindsOtherViewpoints) {
  ASSERT_EQ(audit().exit_code, 0);
  std::string text = read_file(file("audit.json"));
  ASSERT_NE(text.find("2.9"), std::string::npos);
  text.replace(text.find("2.9"), 3, "2.2");
  std::ofstream(file("audit.json")) << text;
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.error, HasSubstr("not true that audit.csv states how much of each element"));
}

TEST_F(Audit, VerifyFindsWrongSums) {
  ASSERT_EQ(audit().exit_code, 0);
  const std::string text = read_file(file("audit.json"));
  std::ofstream(file("audit.json"))
      << std::regex_replace(text, std::regex("\"missed_area\": \\d+"), "\"missed_area\": 1000");
  const Outcome outcome = verify();
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.error, HasSubstr("audit.json adds up audit.csv"));
}

TEST_F(Audit, RefusesWhatIsNotTheRun) {
  expect_refused(viewcover_run({"audit", room_.bundle()}), "holds no viewpoints");
  expect_refused(viewcover_run({"audit", (room_.path() / "nowhere").string()}), "run.json");
  expect_refused(viewcover_run({"audit"}), "DIR");
  expect_refused(audit_of(room_.write("bad.csv", "x,y\n1,2\n")), "bad.csv:2");
  expect_refused(audit_of(room_.write("inf.csv", "x,y,z\n1,2,inf\n")), "inf.csv:2");
  expect_refused(audit({"--scene", room_.write("other.obj", "v 0 0 0\n")}), "SHA-256");
  std::filesystem::rename(room_.scene(), room_.path() / "moved.obj");
  expect_refused(audit(), "--scene FILE");
  EXPECT_EQ(audit({"--scene", (room_.path() / "moved.obj").string()}).exit_code, 0);
}

TEST_F(Audit, RefusesElementsOfAnotherScene) {
  std::string text = read_file(file("elements.csv"));
  const auto second = text.find('\n', text.find('\n') + 1);
  std::ofstream(file("elements.csv")) << text.substr(0, second + 1);
  expect_refused(audit(), "do not tile");
  const auto first = text.find('\n') + 1;
  text.replace(first, text.find(',', text.find(',', first) + 1) - first, "1,2");
  std::ofstream(file("elements.csv")) << text;
  expect_refused(audit(), "elements.csv:2");
}

}  // namespace
}  // namespace viewcover::testing
