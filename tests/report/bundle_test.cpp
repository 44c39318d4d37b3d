#include "report/bundle.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "optim/simulated_annealing.h"
#include "report/build_info.h"
#include "scene/error.h"
#include "scene/scratch_folder.h"
#include "support/process.h"
#include "support/scenes.h"

namespace viewcover {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::horizontal;
using testing::read_file;

std::vector<std::string> lines_of(const std::filesystem::path& file) {
  std::istringstream in(read_file(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// A unit square split once and a triangle, seen from four regions; nothing sees the last quarter.
class BundleTest : public ::testing::Test {
 protected:
  BundleTest()
      : scene_(testing::scene_of(std::vector<ConvexPolygon>{
            horizontal(0, 0, 1, 1, 0), {{2, 0, 0}, {2.5, 0, 0}, {2, 0.5, 0}}})),
        clusters_(scene_),
        region_(testing::region_of(horizontal(0, 0, 4, 4, 2), 1)) {
    scene_.groups = {"floor, \"old\"", "<b>"};
    scene_.surfaces[1].group = GroupId(1);
    const ElementAddress square{SurfaceId(0)}, triangle{SurfaceId(1)};
    const RegionAddress all{PartId(0)};
    const OccluderId of_square = clusters_.place(SurfaceId(0));
    const OccluderId of_triangle = clusters_.place(SurfaceId(1));
    std::vector<OccluderId> both = {std::min(of_square, of_triangle),
                                    std::max(of_square, of_triangle)};
    links_.add({all, square.child(0), Verdict::kFullyVisible}, {});
    links_.add({all.child(1), square.child(1), Verdict::kVisibleWitness}, both);
    links_.add({all.child(2), square.child(2), Verdict::kAssumedVisible}, std::vector{of_triangle});
    links_.add({all.child(2), triangle, Verdict::kFullyVisible}, {});
    links_.count(Verdict::kHiddenByOne);
    matrix_ = make_visibility_matrix(scene_, region_, links_);
    cover_ = SimulatedAnnealing().solve(CoverInstance(matrix_.bits, matrix_.areas), {});
    scene_file_ = folder_.write("scene.obj", "scene");
    region_file_ = folder_.write("scene.region.json", "region");
  }

  Solution solution() const { return {scene_, clusters_, region_, links_, matrix_, cover_}; }
  Json record() const {
    return make_run_record(scene_file_, region_file_, scene_, 5, {{"rays", 16}}, 2);
  }
  Json run_json() const { return Json::parse(read_file(bundle_ / "run.json")); }

  ScratchFolder folder_;
  std::filesystem::path scene_file_, region_file_;
  std::filesystem::path bundle_ = folder_.path() / "new" / "bundle";
  Scene scene_;
  ClusterTree clusters_;
  ViewingRegion region_;
  LinkSet links_;
  VisibilityMatrix matrix_;
  RegionCover cover_;
};

TEST_F(BundleTest, TablesAreToTheLetter) {
  Bundle(bundle_, record()).write(solution());
  EXPECT_THAT(lines_of(bundle_ / "regions.csv"),
              ElementsAre("region,part,level,path,cx,cy,cz,area,chosen,"
                          "x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3",
                          "1,1,1,0,1,1,2,4,0,0,0,2,2,0,2,2,2,2,0,2,2",
                          ::testing::StartsWith("2,1,1,1,3,1,2,4,1,"),
                          ::testing::StartsWith("3,1,1,2,3,3,2,4,1,"),
                          ::testing::StartsWith("4,1,1,3,1,3,2,4,0,")));
  const std::vector<std::string> elements = lines_of(bundle_ / "elements.csv");
  ASSERT_EQ(elements.size(), 6u);
  EXPECT_EQ(elements[0],
            "element,surface,group,level,path,cx,cy,cz,area,times_visible,"
            "x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3");
  EXPECT_THAT(elements[1], ::testing::StartsWith(
                               "1,1,\"floor, \"\"old\"\"\",1,0,0.25,0.25,0,0.25,4,0,0,0,0.5,0,0,"));
  EXPECT_THAT(elements[4], HasSubstr(",0.25,0,"));
  EXPECT_THAT(elements[5], ::testing::MatchesRegex("5,2,<b>,0,0,2\\.16.*,0,0\\.125,1,"
                                                   "2,0,0,2\\.5,0,0,2,0\\.5,0,,,"));
  EXPECT_THAT(lines_of(bundle_ / "links.csv"),
              ElementsAre("region,element,kind,occluders", "1:0:0,1:1:0,fully_visible,",
                          "1:1:1,1:1:1,visible_witness,1 2", "1:1:2,1:1:2,assumed_visible,2",
                          "1:1:2,2:0:0,fully_visible,"));
  std::vector<std::string> matrix = lines_of(bundle_ / "visibility.mtx");
  EXPECT_EQ(matrix.front(), "%%MatrixMarket matrix coordinate pattern general");
  std::erase_if(matrix, [](const std::string& line) { return line.starts_with('%'); });
  EXPECT_THAT(matrix, ElementsAre("4 5 7", "1 1", "2 1", "2 2", "3 1", "3 3", "3 5", "4 1"));
  const std::vector<std::string> cover = lines_of(bundle_ / "cover.csv");
  ASSERT_EQ(cover.size(), 3u);
  EXPECT_EQ(cover[0], "k,covered_area_percent,upper_bound_percent,seconds,evaluations,regions");
  EXPECT_THAT(cover[1], ::testing::EndsWith(",3"));
  EXPECT_THAT(cover[2], ::testing::StartsWith("2,100,100,"));
  EXPECT_THAT(cover[2], ::testing::EndsWith(",2 3"));
  EXPECT_THAT(lines_of(bundle_ / "viewpoints.csv"),
              ElementsAre("viewpoint,x,y,z,region,covered_area_percent,seconds"));
}

TEST_F(BundleTest, SceneVtpHoldsAllCells) {
  Bundle(bundle_, record()).write(solution());
  const std::string vtp = read_file(bundle_ / "scene.vtp");
  EXPECT_THAT(vtp, HasSubstr("NumberOfPoints=\"35\""));  // 4 quarters, a triangle, 4 regions
  EXPECT_THAT(vtp, HasSubstr("NumberOfPolys=\"9\""));
  const auto array = [&](const std::string& name) {
    const std::size_t tag = vtp.find("Name=\"" + name + "\"");
    const std::size_t begin = vtp.find('\n', tag) + 1;
    std::istringstream in(vtp.substr(begin, vtp.find('<', begin) - begin));
    std::vector<int> numbers;
    for (int number; in >> number;) numbers.push_back(number);
    return numbers;
  };
  EXPECT_THAT(array("kind"), ElementsAre(0, 0, 0, 0, 0, 1, 1, 1, 1));
  EXPECT_THAT(array("times_visible"), ElementsAre(4, 1, 1, 0, 1, 0, 0, 0, 0));
  EXPECT_THAT(array("covered_by"), ElementsAre(2, 1, 1, 0, 1, 0, 0, 0, 0));
  EXPECT_THAT(array("chosen"), ElementsAre(0, 0, 0, 0, 0, 0, 1, 1, 0));
  EXPECT_THAT(array("surface"), ElementsAre(1, 1, 1, 1, 2, 0, 0, 0, 0));
  EXPECT_THAT(array("group"), ElementsAre(1, 1, 1, 1, 2, 0, 0, 0, 0));
  EXPECT_THAT(array("offsets"), ElementsAre(4, 8, 12, 16, 19, 23, 27, 31, 35));
  EXPECT_EQ(array("connectivity").size(), 35u);
}

TEST_F(BundleTest, MeshesAreThere) {
  Bundle(bundle_, record()).write(solution());
  EXPECT_THAT(read_file(bundle_ / "surface.ply"), ::testing::StartsWith("ply"));
  EXPECT_GT(std::filesystem::file_size(bundle_ / "surface.om"), 0u);
}

TEST_F(BundleTest, IsIncompleteUntilTheEnd) {
  Bundle bundle(bundle_, record());
  EXPECT_EQ(run_json().at("complete"), false);
  bundle.write(solution());
  EXPECT_EQ(run_json().at("complete"), false);
  bundle.complete(solution(), Guarantee::kExact,
                  {.visibility = 1, .cover = 2, .viewpoints = 0, .total = 3});
  const Json run = run_json();
  EXPECT_EQ(run.at("complete"), true);
  EXPECT_EQ(run.at("version"), build_info().version);
  EXPECT_EQ(run.at("seed"), 5);
  EXPECT_EQ(run.at("options"), Json({{"rays", 16}}));
  // SHA-256 of "scene".
  EXPECT_EQ(run.at("inputs").at("scene").at("sha256").get<std::string>().size(), 64u);
  EXPECT_EQ(run.at("verdicts").at("fully_visible"), 2);
  EXPECT_EQ(run.at("verdicts").at("hidden_by_one"), 1);
  EXPECT_EQ(run.at("results").at("visible_elements"), 4);
  EXPECT_EQ(run.at("results").at("chosen"), Json({2, 3}));
  EXPECT_EQ(run.at("measured").at("seconds").at("cover"), 2);
  EXPECT_EQ(run.at("measured").at("threads"), 2);
}

TEST_F(BundleTest, ASecondRunMakesTheFirstIncomplete) {
  {
    Bundle bundle(bundle_, record());
    bundle.write(solution());
    bundle.complete(solution(), Guarantee::kExact, {});
  }
  Bundle bundle(bundle_, record());
  EXPECT_EQ(run_json().at("complete"), false);
  bundle.abandon("interrupted");
  EXPECT_EQ(run_json().at("complete"), false);
  EXPECT_EQ(run_json().at("measured").at("ended"), "interrupted");
}

TEST_F(BundleTest, RefusesAFolderThatCannotBeMade) {
  EXPECT_THROW(Bundle(scene_file_ / "bundle", record()), InputError);
  EXPECT_THROW(Bundle(scene_file_, record()), InputError);
}

TEST_F(BundleTest, NamesThatAreNoUtf8DoNotMatter) {
  scene_.name = "caf\xe9";
  Bundle bundle(bundle_, record());
  EXPECT_EQ(run_json().at("complete"), false);
}

TEST_F(BundleTest, SummaryHasItsKeysInOrder) {
  const auto line_of = [&](const char* backend, Guarantee guarantee) {
    Json run = record();
    run["options"]["backend"] = backend;
    Bundle bundle(bundle_, run);
    bundle.complete(solution(), guarantee, {});
    return summary_line(bundle.record());
  };
  const Json line = line_of("rays", Guarantee::kVisibleIsCertain);
  std::vector<std::string> keys;
  for (const auto& [key, value] : line.items()) keys.push_back(key);
  EXPECT_THAT(keys, ElementsAre("scene", "backend", "polygons", "regions", "elements",
                                "visible_elements", "links", "optimal_regions", "proved",
                                "lower_bound", "viewpoints", "seconds", "peak_memory_kb"));
  EXPECT_TRUE(line.at("lower_bound").is_null());
  EXPECT_TRUE(line.at("viewpoints").is_null());
  EXPECT_EQ(line.at("optimal_regions"), 2);
  EXPECT_EQ(line.at("proved"), true);
  EXPECT_EQ(line.at("backend"), "rays");
  EXPECT_EQ(line_of("exact", Guarantee::kExact).at("lower_bound"), 2);
}

}  // namespace
}  // namespace viewcover
