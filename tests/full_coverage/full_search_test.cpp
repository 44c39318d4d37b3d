#include "full_coverage/full_search.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "audit/unseen_area.h"
#include "full_coverage/full_coverage.h"
#include "full_coverage/gallery_polygons.h"
#include "scene/error.h"
#include "scene/scratch_folder.h"
#include "support/sanitized.h"
#include "viewpoints/column_bits.h"
#include "viewpoints/refined_bound.h"
#include "viewpoints/solved_scene.h"

namespace viewcover::testing {
namespace {

constexpr double kHeight = 2;

/// A gallery as `generate gallery` writes it and `solve` reads it.
std::unique_ptr<SolvedScene> solved_gallery(const GalleryCase& gallery_case,
                                            std::size_t regions_per_part, double element_area,
                                            std::vector<std::string> targets = {}) {
  const ScratchFolder folder;
  const auto plan = folder.path() / "plan.txt", file = folder.path() / "gallery.obj";
  write_floor_plan(gallery_case, plan);
  write_generated_scene(gallery(plan, read_floor_plan(plan), kHeight), file);
  Scene scene = load_scene(file, {.lattice_exponent = {}, .targets = std::move(targets)});
  ViewingRegion region =
      load_viewing_region(region_file_beside(file), scene.lattice, regions_per_part);
  return std::make_unique<SolvedScene>(std::move(scene), std::move(region), element_area);
}

ViewpointSet full_coverage_of(const SolvedScene& solved, const FullCoverageOptions& options = {}) {
  return find_full_coverage(solved.views, find_viewpoints(solved.views, solved.options()), options);
}

double unseen_area(const SolvedScene& solved, std::span<const Viewpoint> viewpoints) {
  std::vector<ElementAddress> targets = solved.matrix.elements;
  std::erase_if(targets,
                [&](ElementAddress element) { return !solved.scene[element.owner()].is_target; });
  UnseenArea unseen(solved.scene, solved.clusters, targets, {});
  for (const Viewpoint& viewpoint : viewpoints) unseen.subtract(viewpoint.position);
  return unseen.area();
}

class Galleries : public ::testing::TestWithParam<GalleryCase> {};

TEST_P(Galleries, BoundAndViewpointsMeetAtTheArtGalleryNumber) {
  const GalleryCase& gallery_case = GetParam();
  // A guard in line with a wall sees the floor, but not that wall.
  const std::vector<std::string> targets =
      gallery_case.walls_too ? std::vector<std::string>() : std::vector<std::string>{"floor"};
  const auto solved = solved_gallery(gallery_case, 4, 4, targets);
  const ViewpointSet set = full_coverage_of(*solved);
  EXPECT_EQ(set.lower_bound, gallery_case.optimum);
  EXPECT_EQ(set.viewpoints.size(), gallery_case.optimum);
  EXPECT_EQ(set.missing, std::vector<std::size_t>());
  const double whole = unseen_area(*solved, {}), missed = unseen_area(*solved, set.viewpoints);
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

/// A few small ones with sanitizers, which take ten times as long.
std::vector<GalleryCase> galleries() {
  std::vector<GalleryCase> cases = gallery_cases();
  if (sanitized()) {
    std::erase_if(cases, [](const GalleryCase& gallery_case) {
      return gallery_case.optimum > 2 || gallery_case.outer.size() > 6 || !gallery_case.walls_too;
    });
  }
  return cases;
}

INSTANTIATE_TEST_SUITE_P(Known, Galleries, ::testing::ValuesIn(galleries()), name_of);

// A comb whose teeth are too narrow to be looked into from beside; boxes up to its walls.
TEST(FullSearch, BoxesNeedAsManyAsTheArtGalleryNumber) {
  const GalleryCase comb{.name = "comb of boxes",
                         .outer = {{0, 0},
                                   {10, 0},
                                   {10, 6},
                                   {9, 6},
                                   {9, 1},
                                   {6, 1},
                                   {6, 6},
                                   {5, 6},
                                   {5, 1},
                                   {1, 1},
                                   {1, 6},
                                   {0, 6}},
                         .holes = {},
                         .optimum = 3,
                         .guards = {},
                         .witnesses = {}};
  const auto gallery = solved_gallery(comb, 1, 4);
  std::vector<Box> boxes = {Box(Point(0, 0, 0.5), Point(10, 1, 1.5))};
  for (const double x : {0, 5, 9}) boxes.emplace_back(Point(x, 1, 0.5), Point(x + 1, 6, 1.5));
  for (const int level : {0, 1}) {
    if (level > 0 && sanitized()) continue;
    const SolvedScene solved(gallery->scene, make_viewing_region({}, boxes, level), 4);
    const ViewpointSet set = full_coverage_of(solved);
    EXPECT_EQ(set.lower_bound, 3u) << "level " << level;
    EXPECT_EQ(set.viewpoints.size(), 3u) << "level " << level;
    EXPECT_TRUE(set.missing.empty());
    EXPECT_LE(unseen_area(solved, set.viewpoints), 1e-3 * unseen_area(solved, {}));
    for (const Viewpoint& viewpoint : set.viewpoints) {
      EXPECT_TRUE(solved.views.positions(viewpoint.region).region().contains(viewpoint.position));
    }
  }
}

GalleryCase gallery_named(const std::string& name) {
  const std::vector<GalleryCase> cases = gallery_cases();
  return *std::ranges::find(cases, name, &GalleryCase::name);
}

TEST(FullSearch, ViewpointsSeeAllWitnessesAndTheCellsTooFewToSeeThemAreProved) {
  const auto solved = solved_gallery(gallery_named("comb, 3 upright teeth"), 4, 4);
  const ViewpointSet set = full_coverage_of(*solved);
  const OpenSegments segments(solved->views.occluders());
  for (const ElementTarget& witness : set.full->witnesses) {
    EXPECT_TRUE(std::ranges::any_of(set.viewpoints, [&](const Viewpoint& viewpoint) {
      return solved->views.is_facing(witness.column, viewpoint.position) &&
             segments.is_free(viewpoint.position, witness.place);
    }));
  }
  ASSERT_EQ(set.lower_bound, 3u);
  ASSERT_GT(set.lower_bound, solved->cover.lower_bound) << "else there is nothing to raise";
  ASSERT_NE(set.refined_bound, nullptr);
  EXPECT_TRUE(set.full->bound_is_of_witnesses);
  EXPECT_EQ(set.refined_bound->lower_bound, 3u);
  EXPECT_LE(set.refined_bound->seen.columns(), set.full->witnesses.size());
}

// Elements as large as a wall of a corridor: a part of each is seen from one end already.
TEST(FullSearch, AsksForMoreThanAPartOfEachElement) {
  const auto solved = solved_gallery(gallery_named("grid of 1 x 1 holes"), 4, 64);
  const ViewpointSet parts = find_viewpoints(solved->views, solved->options());
  const ViewpointSet full = find_full_coverage(solved->views, parts, {});
  EXPECT_LE(unseen_area(*solved, full.viewpoints), unseen_area(*solved, parts.viewpoints));
  EXPECT_GE(full.lower_bound, parts.lower_bound);
  EXPECT_EQ(full.viewpoints.size(), 2u);
}

TEST(FullSearch, TheSameForAnyNumberOfThreads) {
  const auto solved = solved_gallery(gallery_named("a triangular pillar"), 4, 4);
  std::optional<ViewpointSet> first;
  for (const std::size_t threads : {1, 2, 3}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const ViewpointSet set = full_coverage_of(*solved);
    if (!first) first = set;
    EXPECT_EQ(set.viewpoints, first->viewpoints);
    EXPECT_EQ(set.full->imaged_percent, first->full->imaged_percent);
    EXPECT_EQ(set.full->witnesses.size(), first->full->witnesses.size());
    EXPECT_EQ(set.lower_bound, first->lower_bound);
  }
}

TEST(FullSearch, EachViewpointAddsImagedAreaUpToTheShare) {
  const auto solved = solved_gallery(gallery_named("two pillars"), 4, 4);
  for (const double share : {0.2, 1e-2, 1e-5}) {
    FullCoverageOptions options;
    options.missed_share = share;
    const ViewpointSet set = full_coverage_of(*solved, options);
    const std::vector<double>& percent = set.full->imaged_percent;
    EXPECT_TRUE(std::ranges::is_sorted(percent));
    EXPECT_LE(percent.back(), 100 + 1e-9);
    EXPECT_LE(set.full->further_gain_percent, 100 * share);
    for (std::size_t i = 0; i < set.viewpoints.size(); ++i) {
      EXPECT_TRUE(is_subset(set.seen.row(i), solved->matrix.bits.row(set.viewpoints[i].region)));
    }
  }
}

// A floor on both sides of a screen: from either side a part of both is seen, and no more than half
// of the floor.
TEST(FullSearch, GoesOnWhileAFurtherViewpointAddsMoreThanTheShare) {
  const std::vector<ConvexPolygon> polygons = {horizontal(0, 0, 10, 10, 0),
                                               {{5, 0, 0}, {5, 10, 0}, {5, 10, 2}, {5, 0, 2}}};
  ViewingRegion region = region_of(horizontal(1, 1, 4, 9, 1), 1);
  region.parts.push_back(horizontal(6, 1, 9, 9, 1));
  const SolvedScene solved(scene_of(polygons), region, 1000);
  const ViewpointSet parts = find_viewpoints(solved.views, solved.options());
  ASSERT_EQ(parts.viewpoints.size(), 1u);
  FullCoverageOptions options;
  options.missed_share = 6e-3;
  const ViewpointSet full = find_full_coverage(solved.views, parts, options);
  EXPECT_EQ(full.viewpoints.size(), 2u);
  EXPECT_EQ(full.lower_bound, 2u);
  EXPECT_LT(unseen_area(solved, full.viewpoints), 1e-2 * unseen_area(solved, {}));
}

TEST(FullSearch, InterruptedAndOutOfTime) {
  const auto solved = solved_gallery(gallery_named("two pillars"), 4, 4);
  FullCoverageOptions options;
  options.time_limit_seconds = 1e-6;
  const ViewpointSet set = full_coverage_of(*solved, options);
  EXPECT_TRUE(set.time_limit_reached);
  EXPECT_FALSE(set.viewpoints.empty());
  EXPECT_LE(set.lower_bound, set.viewpoints.size());
  const std::atomic<bool> stop = true;
  options = {};
  options.stop = &stop;
  EXPECT_THROW(full_coverage_of(*solved, options), Interrupted);
}

TEST(UnseenArea, IsWhatAnAuditFindsImagedByNone) {
  const auto solved = solved_gallery(gallery_named("a pillar"), 4, 4);
  const ViewpointSet parts = find_viewpoints(solved->views, solved->options());
  std::vector<Point> positions;
  UnseenArea unseen(solved->scene, solved->clusters, solved->matrix.elements, {});
  double before = unseen.area();
  for (const Viewpoint& viewpoint : parts.viewpoints) {
    positions.push_back(viewpoint.position);
    unseen.subtract(viewpoint.position);
    const Audit audit =
        audit_images(solved->scene, solved->clusters, solved->matrix.elements, positions);
    double not_imaged = 0;
    for (const ElementAudit& element : audit.elements) {
      not_imaged += element.area - element.imaged_area;
    }
    EXPECT_NEAR(unseen.area(), not_imaged, 1e-9 * before);
    EXPECT_LT(unseen.area(), before);
    before = unseen.area();
  }
}

TEST(OpenSegments, AgreeWithTheAudit) {
  const auto solved = solved_gallery(gallery_named("two pillars"), 1, 1);
  const OpenSegments segments(solved->views.occluders());
  const Witnesses witnesses(solved->views);
  RandomNumbers random(3);
  for (int i = 0; i < (sanitized() ? 50 : 300); ++i) {
    // A place in the middle of a piece is imaged iff the segment is free.
    const std::size_t region = random.below(solved->views.region_count());
    const Point from = solved->views.positions(region).random(random);
    if (!solved->views.is_free(region, from)) continue;
    const std::size_t column = random.below(solved->matrix.elements.size());
    const std::array<ElementAddress, 1> element = {solved->matrix.elements[column]};
    const std::array<Point, 1> viewpoint = {from};
    const Audit audit = audit_images(solved->scene, solved->clusters, element, viewpoint);
    for (const ImagedPiece& piece : audit.elements[0].pieces) {
      const auto place = witnesses.place_in(column, piece.polygon);
      if (!place || !solved->views.is_facing(column, from)) continue;
      EXPECT_EQ(segments.is_free(from, place->place), piece.images > 0);
    }
  }
}

}  // namespace
}  // namespace viewcover::testing
