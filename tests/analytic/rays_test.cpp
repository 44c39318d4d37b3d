// Scenes with answers known in closed form, solved the whole way with random rays. Each scene
// carries its answer and the argument for it (scene/generate/analytic.cpp).

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "approx/ray_backend.h"
#include "links/refine.h"
#include "links/visibility_matrix.h"
#include "optim/cover_methods.h"
#include "support/generated.h"

namespace viewcover {

void PrintTo(const AnalyticScene& scene, std::ostream* out) { *out << scene.name; }

namespace {

using testing::load_generated;
using testing::LoadedScene;

class AnalyticRays : public ::testing::TestWithParam<AnalyticScene> {
 protected:
  AnalyticScene analytic_ = GetParam();
  LoadedScene loaded_ = load_generated(analytic_.scene, analytic_.regions);

  VisibilityMatrix solve(std::uint64_t seed) const {
    const ClusterTree clusters(loaded_.scene);
    const RayBackend backend({.rays = 64, .seed = seed});
    const double element_area =
        analytic_.element_area.value_or(default_element_area(loaded_.scene));
    const LinkSet links =
        refine(loaded_.scene, clusters, loaded_.region, backend, {.element_area = element_area});
    return make_visibility_matrix(loaded_.scene, loaded_.region, links);
  }

  std::set<std::string> groups_of(const VisibilityMatrix& matrix, bool seen) const {
    const auto times = matrix.times_visible();
    std::set<std::string> groups;
    for (std::size_t i = 0; i < times.size(); ++i) {
      const Surface& surface = loaded_.scene[matrix.elements[i].owner()];
      if ((times[i] > 0) == seen) groups.insert(loaded_.scene.groups[surface.group.value]);
    }
    return groups;
  }
};

INSTANTIATE_TEST_SUITE_P(Scenes, AnalyticRays, ::testing::ValuesIn(analytic_scenes()),
                         [](const auto& instance) {
                           std::string name = instance.param.name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(AnalyticRays, GivesTheAnswerWhateverTheSeed) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    SCOPED_TRACE(seed);
    const VisibilityMatrix matrix = solve(seed);
    const auto seen = groups_of(matrix, true), unseen = groups_of(matrix, false);
    for (const std::string& group : analytic_.hidden_groups) {
      EXPECT_TRUE(unseen.contains(group)) << group << " is not in the scene";
      EXPECT_FALSE(seen.contains(group)) << group;
    }
    for (const std::string& group : analytic_.visible_groups) {
      EXPECT_TRUE(seen.contains(group)) << group << " is not in the scene";
      EXPECT_FALSE(unseen.contains(group)) << group;
    }
    if (analytic_.optimal_regions) {
      const CoverInstance instance(matrix.bits, matrix.areas);
      CoverOptions options;
      options.seed = seed;
      const RegionCover cover = make_cover_method("sa")->solve(instance, options);
      ASSERT_FALSE(cover.steps.empty());
      EXPECT_EQ(cover.steps.back().k, *analytic_.optimal_regions);
    }
  }
}

TEST_P(AnalyticRays, SaysSomething) {
  EXPECT_FALSE(analytic_.derivation.empty());
  EXPECT_TRUE(analytic_.optimal_regions || !analytic_.hidden_groups.empty() ||
              !analytic_.visible_groups.empty());
}

}  // namespace
}  // namespace viewcover
