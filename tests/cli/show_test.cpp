#include <gmock/gmock.h>

#include "bundle_files.h"

namespace viewcover::testing {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// Width and height as the head of a PNG file states them.
std::pair<unsigned, unsigned> png_size(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  if (!bytes.starts_with("\x89PNG\r\n\x1a\n") || bytes.size() < 24) return {0, 0};
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = at; i < at + 4; ++i) {
      value = value << 8 | static_cast<unsigned char>(bytes[i]);
    }
    return value;
  };
  return {number(16), number(20)};
}

class Show : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(room_.solve("bundle", {"--regions", "16"}).exit_code, 0); }
  Outcome show(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"show", room_.bundle()});
    more.insert(more.end(), {"--size", "320x240"});
    return viewcover_run(more);
  }
  std::filesystem::path file(const std::string& name) const {
    return std::filesystem::path(room_.bundle()) / name;
  }

  RoomFolder room_;
};

TEST_F(Show, WritesAPictureAndAPage) {
  const Outcome outcome = show({"--threads", "1"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  const Json line = Json::parse(last_line(outcome.out));
  EXPECT_EQ(line.at("figure"), file("figure.png").string());
  EXPECT_EQ(line.at("page"), file("report.html").string());
  EXPECT_EQ(png_size(file("figure.png")), (std::pair<unsigned, unsigned>(320, 240)));
  EXPECT_THAT(read_file(file("report.html")), StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(read_file(file("report.html")), EndsWith("</html>\n"));
  EXPECT_EQ(viewcover_run({"verify", room_.bundle()}).exit_code, 0);

  const auto one = comparable_files(room_.bundle());
  ASSERT_EQ(show({"--threads", "3"}).exit_code, 0);
  EXPECT_EQ(one, comparable_files(room_.bundle()));

  // Another run takes the pictures of this one away.
  ASSERT_EQ(room_.solve("bundle", {"--regions", "4"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(file("figure.png")));
  EXPECT_FALSE(std::filesystem::exists(file("report.html")));
}

TEST_F(Show, ColoursByEachMeaning) {
  std::vector<std::string> pictures;
  for (const char* what : {"times_visible", "covered_by", "group", "unseen"}) {
    ASSERT_EQ(show({"--no-page", "--view", "235,38", "--colour-by", what}).exit_code, 0) << what;
    pictures.push_back(read_file(file("figure.png")));
    for (std::size_t i = 0; i + 1 < pictures.size(); ++i) EXPECT_NE(pictures[i], pictures.back());
  }
  EXPECT_FALSE(std::filesystem::exists(file("report.html")));
}

TEST_F(Show, ComparesTwoRuns) {
  ASSERT_EQ(room_.solve("few", {"--regions", "16", "--rays", "1", "--seed", "2"}).exit_code, 0);
  const Outcome outcome = show({"--against", room_.bundle("few"), "--colour-by", "difference"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_THAT(read_file(file("report.html")), HasSubstr("\"other_name\":\"few\""));
  ASSERT_EQ(room_.solve("other", {"--regions", "64"}).exit_code, 0);
  expect_refused(show({"--against", room_.bundle("other")}), "different regions");
}

TEST_F(Show, DrawsWhatAViewpointSees) {
  expect_refused(show({"--camera", "1"}), "--camera 1: there are 0 viewpoints");
  std::ofstream(file("viewpoints.csv"))
      << "viewpoint,x,y,z,region,covered_area_percent,seconds\n1,1.5,1.25,1.6,1,50,0.1\n";
  std::filesystem::copy_file(file("visibility.mtx"), file("viewpoints.mtx"));
  expect_refused(show({"--camera", "1"}), "has 16 rows, not 1");
  const Table elements(file("elements.csv"));
  std::ofstream(file("viewpoints.mtx")) << "%%MatrixMarket matrix coordinate pattern general\n1 "
                                        << elements.rows.size() << " 1\n1 1\n";
  const Outcome outcome = show({"--camera", "1", "--no-page", "--colour-by", "viewpoints"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(png_size(file("camera_1.png")), (std::pair<unsigned, unsigned>(320, 240)));
  expect_refused(show({"--camera", "2"}), "there are 1 viewpoints");
}

TEST_F(Show, RefusesBadOptions) {
  expect_refused(viewcover_run({"show"}), "DIR");
  expect_refused(viewcover_run({"show", "nowhere"}), "run.json");
  expect_refused(show({"--view", "north"}), "--view");
  expect_refused(show({"--view", "0,91"}), "--view");
  expect_refused(show({"--up", "w"}), "--up");
  expect_refused(show({"--colour-by", "taste"}), "covered_by");
  expect_refused(show({"--colour-by", "difference"}), "--against");
  expect_refused(viewcover_run({"show", room_.bundle(), "--size", "320"}), "--size");
  expect_refused(viewcover_run({"show", room_.bundle(), "--size", "1x1"}), "--size");
  expect_refused(show({"--camera", "0"}), "--camera");
}

TEST_F(Show, DrawsQueries) {
  const std::string squares =
      R"("region": [[0,0,0],[1,0,0],[1,1,0],[0,1,0]], "element": [[0,0,2],[1,0,2],[1,1,2],[0,1,2]])";
  const std::string queries = room_.write(
      "queries.jsonl",
      R"({"id": "a", )" + squares + R"(, "occluders": [[[0,0,1],[0.5,0,1],[0.5,1,1]]]})" + "\n" +
          R"({"id": "b", "viewpoint": [0,0,0], "element": [[0,0,1],[1,0,1],[0,1,1]]})" + "\n" +
          R"({"id": "c", "element": 7})" + "\n");
  const Outcome outcome =
      viewcover_run({"show", "--query", queries, "--skeleton", "--size", "320x240"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.error, "");
  EXPECT_EQ(Json::parse(last_line(outcome.out)).at("id"), "c");
  EXPECT_TRUE(Json::parse(last_line(outcome.out)).contains("error"));
  for (const char* name : {"query_1.png", "query_2.png"}) {
    EXPECT_EQ(png_size(room_.path() / name), (std::pair<unsigned, unsigned>(320, 240))) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(room_.path() / "query_3.png"));
  expect_refused(viewcover_run({"show", "--query", "nowhere.jsonl"}), "nowhere.jsonl");
}

}  // namespace
}  // namespace viewcover::testing
