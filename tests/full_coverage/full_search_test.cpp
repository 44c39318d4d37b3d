#include "full_coverage/full_search.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "audit/unseen_area.h"
#include "full_coverage/full_coverage.h"
#include "full_coverage/gallery_polygons.h"
#include "scene/scratch_folder.h"
#include "support/sanitized.h"
#include "viewpoints/refined_bound.h"
#include "viewpoints/solved_scene.h"

namespace viewcover::testing {
namespace {

constexpr double kHeight = 2;

/// A gallery as `generate gallery` writes it and `solve` reads it.
std::unique_ptr<SolvedScene> solved_gallery(const GalleryCase& gallery_case,
                                            std::size_t regions_per_part, double element_area) {
  const ScratchFolder folder;
  const auto plan = folder.path() / "plan.txt", file = folder.path() / "gallery.obj";
  write_floor_plan(gallery_case, plan);
  write_generated_scene(gallery(plan, read_floor_plan(plan), kHeight), file);
  Scene scene = load_scene(file);
  ViewingRegion region =
      load_viewing_region(region_file_beside(file), scene.lattice, regions_per_part);
  return std::make_unique<SolvedScene>(std::move(scene), std::move(region), element_area);
}

ViewpointSet full_coverage_of(const SolvedScene& solved, const FullCoverageOptions& options = {}) {
  return find_full_coverage(solved.views, find_viewpoints(solved.views, solved.options()), options);
}

double unseen_area(const SolvedScene& solved, std::span<const Viewpoint> viewpoints) {
  UnseenArea unseen(solved.scene, solved.clusters, solved.matrix.elements, {});
  for (const Viewpoint& viewpoint : viewpoints) unseen.subtract(viewpoint.position);
  return unseen.area();
}

class Galleries : public ::testing::TestWithParam<GalleryCase> {};

TEST_P(Galleries, BoundAndViewpointsMeetAtTheArtGalleryNumber) {
  const GalleryCase& gallery_case = GetParam();
  const auto solved = solved_gallery(gallery_case, 4, 4);
  const ViewpointSet set = full_coverage_of(*solved);
  EXPECT_LE(set.lower_bound, gallery_case.optimum);
  EXPECT_GE(set.viewpoints.size(), gallery_case.optimum);
  EXPECT_EQ(set.lower_bound, gallery_case.optimum);
  EXPECT_EQ(set.viewpoints.size(), gallery_case.optimum);
  EXPECT_EQ(set.missing, std::vector<std::size_t>());
  const double whole = unseen_area(*solved, {}),
               missed = unseen_area(*solved, set.viewpoints);
  EXPECT_LE(missed, 1e-3 * whole);
  EXPECT_NEAR(set.full->imaged_percent.back(), 100 * (1 - missed / whole), 1e-6);
}

std::string name_of(const ::testing::TestParamInfo<GalleryCase>& info) {
  std::string name;
  for (const char c : info.param.name) {
    if (std::isalnum(static_cast<unsigned char>(c))) name += c;
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Known, Galleries, ::testing::ValuesIn(gallery_cases()), name_of);

}  // namespace
}  // namespace viewcover::testing
