#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "links/link_set.h"
#include "links/visibility_backend.h"
#include "links/visibility_matrix.h"
#include "links/wide_visibility.h"
#include "optim/region_cover.h"
#include "scene/cluster_tree.h"
#include "scene/scene.h"
#include "scene/viewing_region.h"
#include "viewpoints/viewpoint_search.h"

namespace viewcover {

/// What is seen otherwise than through narrow gaps, and the cover for it.
struct WideSolution {
  WideVisibility visibility;
  RegionCover cover;
};

/// All that a run found and found it from: what a bundle's tables are written from. Borrowed.
struct Solution {
  const Scene& scene;
  const ClusterTree& clusters;
  const ViewingRegion& region;
  const LinkSet& links;
  const VisibilityMatrix& matrix;
  const RegionCover& cover;
  BackendStatistics backend_statistics{};
  const ViewpointSet* viewpoints = nullptr;  ///< none if they were not looked for
  const WideSolution* wide = nullptr;        ///< none if not asked for

  /// Row numbers of the cover, ascending.
  std::vector<std::size_t> chosen() const {
    return cover.steps.empty() ? std::vector<std::size_t>() : cover.steps.back().chosen;
  }
  bool time_limit_reached() const {
    return cover.time_limit_reached || (viewpoints != nullptr && viewpoints->time_limit_reached) ||
           (wide != nullptr && wide->cover.time_limit_reached);
  }
  /// A lower bound on the number of viewpoints, if the backend is exact.
  std::size_t lower_bound() const {
    return viewpoints != nullptr ? viewpoints->lower_bound : cover.lower_bound;
  }
};

}  // namespace viewcover
