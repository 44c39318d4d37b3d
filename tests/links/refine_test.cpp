#include "links/refine.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <random>

#include "links/shaft.h"
#include "links/visibility_matrix.h"
#include "scene/error.h"
#include "support/exact_judge.h"
#include "support/scenes.h"

namespace viewcover {
namespace {

using testing::horizontal;

/// Refinement asks from regions only.
class RegionBackend : public VisibilityBackend {
 public:
  bool sees_part(const PointShaft& /*shaft*/) const override {
    ADD_FAILURE() << "asked from a point";
    return false;
  }
  std::optional<SightLine> find_sight_line(const Shaft& /*shaft*/) const override {
    ADD_FAILURE() << "asked for a sight line";
    return std::nullopt;
  }
};

/// Never finds a shaft hidden: what is left is what refinement itself decides.
class AssumeVisible : public RegionBackend {
 public:
  std::string_view name() const override { return "assume-visible"; }
  Guarantee guarantee() const override { return Guarantee::kVisibleIsCertain; }
  Verdict decide(const Shaft& shaft, Effort /*effort*/) const override {
    EXPECT_FALSE(shaft.occluders().empty());
    return Verdict::kAssumedVisible;
  }
};

/// Says hidden for shafts by their addresses, at any level.
class HideAtRandom : public RegionBackend {
 public:
  std::string_view name() const override { return "hide-at-random"; }
  Guarantee guarantee() const override { return Guarantee::kVisibleIsCertain; }
  Verdict decide(const Shaft& shaft, Effort /*effort*/) const override {
    const std::uint64_t bits =
        (shaft.region_address().bits() * 31 + shaft.element_address().bits()) * 0x9e3779b97f4a7c15u;
    return bits >> 61 == 0 ? Verdict::kHiddenBySet : Verdict::kVisibleWitness;
  }
};

/// As it may be said of occluders that sight lines only start on.
class SayFullyVisible : public RegionBackend {
 public:
  std::string_view name() const override { return "say-fully-visible"; }
  Guarantee guarantee() const override { return Guarantee::kVisibleIsCertain; }
  Verdict decide(const Shaft& /*shaft*/, Effort /*effort*/) const override {
    return Verdict::kFullyVisible;
  }
};

struct RefineCase {
  Scene scene;
  ClusterTree clusters;
  ViewingRegion region;
  RefineOptions options;

  RefineCase(const std::vector<ConvexPolygon>& polygons, int level, double element_area)
      : scene(testing::scene_of(polygons)),
        clusters(scene),
        region(testing::region_of(horizontal(0.25, 0.25, 0.75, 0.75, 0), level)) {
    options.element_area = element_area;
  }
};

std::vector<ConvexPolygon> soup_under_a_ceiling(std::size_t count, double radius,
                                                std::uint64_t seed) {
  std::mt19937_64 random(seed);
  auto polygons = testing::random_triangles(count, radius, 0.25, 0.75, random);
  polygons.push_back(horizontal(0, 0, 1, 1, 1));
  return polygons;
}

/// What refinement with AssumeVisible must find, without hierarchy: a finest pair is visible iff
/// region and element face each other and no single surface blocks the shaft.
bool judged_visible(const RefineCase& setup, const OccluderSet& occluders,
                    RegionAddress region_address, ElementAddress element_address, bool* is_clear) {
  const ConvexPolygon r = setup.region.polygon(region_address);
  const ConvexPolygon e = subdivided(setup.scene[element_address.owner()].polygon, element_address);
  const PlanarPolygon region{r, Plane(r)}, element{e, Plane(e)};
  const Shaft shaft(occluders, region_address, region, element_address, element, false);
  if (!shaft.is_facing()) return false;
  *is_clear = true;
  for (ClusterNode node = 0; node < setup.clusters.nodes().size(); ++node) {
    const auto& at = setup.clusters.nodes()[node];
    if (!at.is_leaf() || !shaft.box_overlaps(at.box)) continue;
    ShaftOccluder occluder{.node = node};
    const Shaft::Meets meets = shaft.meets(occluder);
    if (meets == Shaft::Meets::kBlocksAll) return false;
    if (meets == Shaft::Meets::kMaybe) *is_clear = false;
  }
  return true;
}

TEST(Refine, AgreesWithEveryFinestPairDecidedAlone) {
  std::size_t visible = 0, hidden = 0, clear = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const RefineCase setup(soup_under_a_ceiling(60, 0.3, seed), 2, 0.02);
    const LinkSet links =
        refine(setup.scene, setup.clusters, setup.region, AssumeVisible(), setup.options);
    const VisibilityMatrix matrix = make_visibility_matrix(setup.scene, setup.region, links);
    const OccluderSet occluders(setup.scene, setup.clusters, setup.region);
    for (std::size_t column = 0; column < matrix.elements.size(); ++column) {
      const ElementAddress element = matrix.elements[column];
      // Finest descendants of the leaf, down to the threshold.
      std::vector<ElementAddress> finest;
      const auto descend = [&](const auto& self, ElementAddress node) -> void {
        const ConvexPolygon polygon = subdivided(setup.scene[node.owner()].polygon, node);
        if (area(polygon) <= setup.options.element_area) {
          finest.push_back(node);
        } else {
          for (int digit = 0; digit < 4; ++digit) self(self, node.child(digit));
        }
      };
      descend(descend, element);
      for (std::size_t row = 0; row < setup.region.region_count(); ++row) {
        bool any = false;
        for (const ElementAddress node : finest) {
          bool is_clear = false;
          any |= judged_visible(setup, occluders, setup.region.address(row), node, &is_clear);
          clear += is_clear;
        }
        ASSERT_EQ(matrix.bits.test(row, column), any) << "seed " << seed << " element " << column;
        (any ? visible : hidden)++;
      }
    }
  }
  EXPECT_GT(visible, 500u);
  EXPECT_GT(hidden, 100u);
  EXPECT_GT(clear, 100u);
}

std::vector<int> random_weights(const ConvexPolygon& polygon, std::mt19937_64& random) {
  std::vector<int> list(polygon.size());
  for (int& w : list) w = 1 + static_cast<int>(random() % 8 == 0 ? 1000 : random() % 5);
  return list;
}

TEST(Refine, LinksTileEachFinestPairAtMostOnceAndKeepTheOccludersOfTheirShaft) {
  const RefineCase setup(soup_under_a_ceiling(80, 0.2, 5), 2, 0.01);
  const LinkSet links =
      refine(setup.scene, setup.clusters, setup.region, AssumeVisible(), setup.options);
  const OccluderSet occluders(setup.scene, setup.clusters, setup.region);
  std::size_t with_list = 0, clear = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const Link link = links[i];
    for (std::size_t j = 0; j < i; ++j) {
      const Link other = links[j];
      ASSERT_FALSE((link.region.contains(other.region) || other.region.contains(link.region)) &&
                   (link.element.contains(other.element) || other.element.contains(link.element)))
          << i << " and " << j;
    }
    bool is_clear = false;
    ASSERT_TRUE(judged_visible(setup, occluders, link.region, link.element, &is_clear));
    const auto list = links.occluders(i);
    EXPECT_EQ(list.empty(), link.verdict == Verdict::kFullyVisible);
    EXPECT_EQ(list.empty(), is_clear);  // culling is complete
    EXPECT_TRUE(std::is_sorted(list.begin(), list.end()));
    with_list += !list.empty();
    clear += is_clear;
    if (link.verdict != Verdict::kFullyVisible) {
      EXPECT_EQ(link.region.level(), setup.region.level);
      const ConvexPolygon polygon =
          subdivided(setup.scene[link.element.owner()].polygon, link.element);
      EXPECT_LE(area(polygon), setup.options.element_area);
    }
  }
  EXPECT_GT(with_list, 200u);
  EXPECT_GT(clear, 50u);
}

TEST(Refine, ListsOfCrowdedShaftsHoldEverySurfaceThatBlocksASegment) {
  const RefineCase setup(soup_under_a_ceiling(600, 0.04, 8), 0, 0.3);
  const LinkSet links =
      refine(setup.scene, setup.clusters, setup.region, AssumeVisible(), setup.options);
  std::mt19937_64 random(2);
  std::size_t crowded = 0, hits = 0;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto list = links.occluders(i);
    if (list.size() <= 64) continue;  // more than refinement keeps one by one
    ++crowded;
    std::vector<bool> listed(setup.scene.surfaces.size());
    for (const OccluderId id : list) listed[setup.clusters.surface(id).value] = true;
    const ConvexPolygon to =
        subdivided(setup.scene[links[i].element.owner()].polygon, links[i].element);
    const ConvexPolygon from = setup.region.polygon(links[i].region);
    for (int ray = 0; ray < 16; ++ray) {
      const auto p = testing::combination(from, random_weights(from, random));
      const auto q = testing::combination(to, random_weights(to, random));
      for (std::size_t s = 0; s < listed.size(); ++s) {
        if (!testing::segment_meets(p, q, setup.scene.surfaces[s].polygon)) continue;
        ++hits;
        EXPECT_TRUE(listed[s]);
      }
    }
    // What a list holds is near the shaft, not a cluster's worth of neighbours.
    EXPECT_LT(list.size(), setup.scene.surfaces.size() / 2);
  }
  EXPECT_GT(crowded, 3u);
  EXPECT_GT(hits, 10u);
}

TEST(Refine, ASurfaceInTheOccludersOwnPlaneIsSeenThoughItsClusterIsBehind) {
  // The plate hides all of the cluster but the small square that lies in its own plane.
  const RefineCase setup({horizontal(-2, -2, 3, 3, 0.5), horizontal(0.5, 0.5, 0.625, 0.625, 0.5),
                          horizontal(0.5, 0.5, 0.625, 0.625, 0.5625)},
                         1, 1);
  const LinkSet links =
      refine(setup.scene, setup.clusters, setup.region, AssumeVisible(), setup.options);
  const VisibilityMatrix matrix = make_visibility_matrix(setup.scene, setup.region, links);
  const auto times = matrix.times_visible();
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_EQ(times[i], matrix.elements[i].owner() == SurfaceId(2) ? 0u : 4u) << i;
  }
}

bool same(const LinkSet& a, const LinkSet& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i].region != b[i].region || a[i].element != b[i].element ||
        a[i].verdict != b[i].verdict || a.occluders(i) != b.occluders(i)) {
      return false;
    }
  }
  for (std::size_t v = 0; v < kVerdictCount; ++v) {
    if (a.verdicts(static_cast<Verdict>(v)) != b.verdicts(static_cast<Verdict>(v))) return false;
  }
  return true;
}

TEST(Refine, GivesTheSameLinksForAnyNumberOfThreads) {
  const RefineCase setup(soup_under_a_ceiling(400, 0.1, 2), 3, 0.002);
  const HideAtRandom backend;
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return refine(setup.scene, setup.clusters, setup.region, backend, setup.options);
  };
  const LinkSet one = with_threads(1);
  EXPECT_GT(one.size(), 5000u);
  EXPECT_GT(one.verdicts(Verdict::kHiddenBySet), 100u);
  EXPECT_TRUE(same(one, with_threads(2)));
  EXPECT_TRUE(same(one, with_threads(4)));
}

TEST(Refine, GivesTheSameLinksWhereverItIsContinued) {
  const RefineCase setup(soup_under_a_ceiling(400, 0.1, 2), 2, 0.01);
  const HideAtRandom backend;
  const auto with = [&](RefineCheckpoints* checkpoints, RefineProgress* progress = nullptr) {
    return refine(setup.scene, setup.clusters, setup.region, backend, setup.options, progress,
                  checkpoints);
  };
  const LinkSet whole = with(nullptr);
  std::vector<std::pair<std::size_t, LinkSet>> saves;
  RefineCheckpoints often{.batches_done = 0, .links = {}, .seconds = 0, .save = {}};
  often.save = [&](std::size_t batches, const LinkSet& links) {
    saves.emplace_back(batches, links);
  };
  EXPECT_TRUE(same(with(&often), whole));
  ASSERT_GT(saves.size(), 100u);
  EXPECT_TRUE(same(saves.back().second, whole));
  for (std::size_t i = 0; i < saves.size(); i += 67) {
    SCOPED_TRACE(i);
    RefineProgress progress;
    RefineCheckpoints later{
        .batches_done = saves[i].first, .links = saves[i].second, .seconds = 1e9, .save = {}};
    EXPECT_TRUE(same(with(&later, &progress), whole));
    EXPECT_NEAR(progress.share_done, 1, 1e-9);
    EXPECT_EQ(progress.links, whole.size());
  }
}

TEST(Refine, ProgressEndsAtOneAndStopInterrupts) {
  const RefineCase setup(soup_under_a_ceiling(100, 0.2, 2), 2, 0.01);
  RefineProgress progress;
  const LinkSet links =
      refine(setup.scene, setup.clusters, setup.region, AssumeVisible(), setup.options, &progress);
  EXPECT_NEAR(progress.share_done, 1, 1e-9);
  EXPECT_EQ(progress.links, links.size());
  progress.stop = true;
  EXPECT_THROW(
      refine(setup.scene, setup.clusters, setup.region, AssumeVisible(), setup.options, &progress),
      Interrupted);
}

TEST(Refine, RefusesElementsBeyondTheDeepestLevel) {
  const RefineCase setup({horizontal(0, 0, 1, 1, 1)}, 0, 1e-9);
  EXPECT_THROW(refine(setup.scene, setup.clusters, setup.region, AssumeVisible(), setup.options),
               InputError);
}

// A box on a plate and a strip beside it that goes down past the plate.
TEST(Refine, AFaceOnASurfaceDoesNotVouchForWhatIsBehind) {
  const ConvexPolygon strip{{0, 4, -2}, {1, 4, -2}, {1, 4, 2}, {0, 4, 2}};
  for (const bool is_plate_there : {false, true}) {
    std::vector<ConvexPolygon> polygons{strip};
    if (is_plate_there) polygons.push_back(horizontal(-9, -9, 9, 9, 0));
    const Scene scene = testing::scene_of(polygons);
    const ViewingRegion region = make_viewing_region({}, {Box(Point(0, 0, 0), Point(1, 1, 1))}, 0);
    const LinkSet links =
        refine(scene, ClusterTree(scene), region, SayFullyVisible(), {.element_area = 1});
    constexpr std::size_t kBottom = 4;
    std::size_t from_bottom = 0;
    for (std::size_t i = 0; i < links.size(); ++i) {
      const auto [face, element, verdict] = links[i];
      if (face.owner().value != kBottom || element.owner().value != 0) continue;
      ++from_bottom;
      const Box extent = bounding_box(subdivided(strip, element));
      if (is_plate_there) {
        EXPECT_GE(extent.min().z(), 0);
      } else {
        EXPECT_EQ(element.level(), 0) << "nothing is in the way";
      }
    }
    EXPECT_GT(from_bottom, 0u);
  }
}

TEST(DefaultElementArea, IsOnePercentOfAMeanFaceOfTheBox) {
  // Box 2 x 3 x 4: faces of 6, 8, 12 twice each, mean 26 / 3.
  const Scene scene = testing::scene_of(
      std::vector<ConvexPolygon>{horizontal(0, 0, 2, 3, 0), horizontal(0, 0, 2, 3, 4)});
  EXPECT_DOUBLE_EQ(default_element_area(scene), 0.26 / 3);
}

TEST(VisibilityMatrix, ElementsTileTheSurfacesAndInheritFromCoarseLinks) {
  const Scene scene = testing::scene_of(std::vector<ConvexPolygon>{
      horizontal(0, 0, 4, 4, 1), {{0, 0, 2}, {2, 0, 2}, {0, 2, 3}}, horizontal(0, 0, 1, 1, 4)});
  const ViewingRegion region = testing::region_of(horizontal(0, 0, 1, 1, 0), 2);
  const ElementAddress square{SurfaceId(0)}, triangle{SurfaceId(1)};
  const RegionAddress all{PartId(0)};
  LinkSet links;
  links.add({all, square.child(1), Verdict::kFullyVisible}, {});
  links.add({all.child(2), square.child(0).child(3), Verdict::kFullyVisible}, {});
  links.add({all.child(3).child(0), square.child(0), Verdict::kFullyVisible}, {});
  links.add({all.child(0).child(1), triangle, Verdict::kFullyVisible}, {});
  const VisibilityMatrix matrix = make_visibility_matrix(scene, region, links);

  // Surface 0: child 0 in four, children 1, 2, 3; surfaces 1 and 2 whole.
  ASSERT_EQ(matrix.elements.size(), 9u);
  EXPECT_EQ(matrix.elements[0], square.child(0).child(0));
  EXPECT_EQ(matrix.elements[4], square.child(1));
  EXPECT_EQ(matrix.elements[7], triangle);
  double sum = 0;
  for (const double area : matrix.areas) sum += area;
  EXPECT_DOUBLE_EQ(sum, scene.area());

  const auto times = matrix.times_visible();
  EXPECT_EQ(times, (std::vector<std::uint32_t>{1, 1, 1, 5, 16, 0, 0, 1, 0}));
  EXPECT_TRUE(matrix.bits.test(12, 0));  // region 3-0 sees all of child 0
  EXPECT_TRUE(matrix.bits.test(8, 3));   // regions 2-* see the quarter 0-3
  EXPECT_FALSE(matrix.bits.test(8, 2));
  EXPECT_TRUE(matrix.bits.test(1, 7));
}

}  // namespace
}  // namespace viewcover
