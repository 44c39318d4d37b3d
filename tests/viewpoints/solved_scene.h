#pragma once

#include <memory>
#include <vector>

#include "exact/exact_backend.h"
#include "links/refine.h"
#include "optim/exact_cover.h"
#include "support/scenes.h"
#include "viewpoints/region_views.h"
#include "viewpoints/viewpoint_search.h"

namespace viewcover::testing {

/// A scene all the way to its region cover and the views from its regions. Not copyable: the parts
/// refer to each other.
struct SolvedScene {
  Scene scene;
  ViewingRegion region;
  bool one_sided;
  std::unique_ptr<VisibilityBackend> backend;
  ClusterTree clusters{scene};
  LinkSet links;
  VisibilityMatrix matrix;
  RegionCover cover;
  RegionViews views;

  SolvedScene(Scene the_scene, ViewingRegion the_region, double element_area,
              std::unique_ptr<VisibilityBackend> the_backend = std::make_unique<ExactBackend>(1),
              bool only_fronts = false)
      : scene(std::move(the_scene)),
        region(std::move(the_region)),
        one_sided(only_fronts),
        backend(std::move(the_backend)),
        links(refine(scene, clusters, region, *backend,
                     {.element_area = element_area, .one_sided = one_sided})),
        matrix(make_visibility_matrix(scene, region, links)),
        cover(ExactCover().solve(CoverInstance(matrix.bits, matrix.areas), whole_cover())),
        views({scene, clusters, region, links, matrix, *backend, one_sided}) {}
  SolvedScene(const SolvedScene&) = delete;
  SolvedScene& operator=(const SolvedScene&) = delete;

  ViewpointOptions options() const {
    ViewpointOptions options;
    if (!cover.steps.empty()) options.chosen_regions = cover.steps.back().chosen;
    options.lower_bound = cover.lower_bound;
    return options;
  }

 private:
  static CoverOptions whole_cover() {
    CoverOptions options;
    options.goal = CoverGoal::kWholeCover;
    return options;
  }
};

/// The walls of a box, each one polygon.
inline std::vector<ConvexPolygon> box_walls(const Point& low, const Point& high) {
  const auto at = [&](int x, int y, int z) {
    return Point(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z());
  };
  return {{at(0, 0, 0), at(0, 1, 0), at(0, 1, 1), at(0, 0, 1)},
          {at(1, 0, 0), at(1, 1, 0), at(1, 1, 1), at(1, 0, 1)},
          {at(0, 0, 0), at(1, 0, 0), at(1, 0, 1), at(0, 0, 1)},
          {at(0, 1, 0), at(1, 1, 0), at(1, 1, 1), at(0, 1, 1)}};
}

/// A region [0, count] x [0, 1] at height 0 under `count` chimneys of width 1/4 that reach from
/// height 1 to height 9, each closed by a lid.
///
/// A lid is seen from (x, y) only along a line that stays in its chimney for 8 units of height: its
/// slope is below 1/32, so one unit further down it is less than 1/32 beside the chimney. Chimneys
/// are 3/4 apart: no viewpoint sees two lids. From under the middle of a chimney its lid and the
/// insides of its walls are seen. So the fewest viewpoints are `count`.
inline std::vector<ConvexPolygon> chimneys(int count) {
  std::vector<ConvexPolygon> polygons;
  for (int i = 0; i < count; ++i) {
    const Point low(i + 0.375, 0.375, 1), high(i + 0.625, 0.625, 9);
    for (const ConvexPolygon& wall : box_walls(low, high)) polygons.push_back(wall);
    polygons.push_back(horizontal(low.x(), low.y(), high.x(), high.y(), 9));
  }
  return polygons;
}

inline ViewingRegion under_chimneys(int count, int level) {
  return region_of(horizontal(0, 0, count, 1, 0), level);
}

}  // namespace viewcover::testing
