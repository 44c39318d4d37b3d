// Scenes with answers known in closed form, solved the whole way by every backend. Each scene
// carries its answer and the argument for it (scene/generate/analytic.cpp).

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "conformance/backends.h"
#include "links/refine.h"
#include "links/visibility_matrix.h"
#include "optim/cover_methods.h"
#include "support/generated.h"

namespace viewcover {

void PrintTo(const AnalyticScene& scene, std::ostream* out) { *out << scene.name; }

namespace {

using testing::load_generated;
using testing::LoadedScene;
using testing::TestedBackend;

class AnalyticScenes : public ::testing::TestWithParam<std::tuple<TestedBackend, AnalyticScene>> {
 protected:
  TestedBackend backend_ = std::get<0>(GetParam());
  AnalyticScene analytic_ = std::get<1>(GetParam());
  LoadedScene loaded_ = load_generated(analytic_.scene, analytic_.regions);

  VisibilityMatrix solve(std::uint64_t seed) const {
    const ClusterTree clusters(loaded_.scene);
    const double element_area =
        analytic_.element_area.value_or(default_element_area(loaded_.scene));
    const LinkSet links = refine(loaded_.scene, clusters, loaded_.region, *backend_.make(seed),
                                 {.element_area = element_area});
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

INSTANTIATE_TEST_SUITE_P(Backends, AnalyticScenes,
                         ::testing::Combine(::testing::ValuesIn(testing::tested_backends()),
                                            ::testing::ValuesIn(analytic_scenes())),
                         [](const auto& instance) {
                           std::string name = std::get<0>(instance.param).name + "_" +
                                              std::get<1>(instance.param).name;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(AnalyticScenes, HaveTheirAnswerWhateverTheSeed) {
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

TEST(AnalyticSceneList, SaysSomethingOfEveryScene) {
  for (const AnalyticScene& scene : analytic_scenes()) {
    SCOPED_TRACE(scene.name);
    EXPECT_FALSE(scene.derivation.empty());
    EXPECT_TRUE(scene.optimal_regions || !scene.hidden_groups.empty() ||
                !scene.visible_groups.empty());
  }
}

}  // namespace
}  // namespace viewcover
