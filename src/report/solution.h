#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "links/link_set.h"
#include "links/visibility_matrix.h"
#include "optim/region_cover.h"
#include "scene/cluster_tree.h"
#include "scene/scene.h"
#include "scene/viewing_region.h"

namespace viewcover {

/// All that a run found and found it from: what a bundle's tables are written from. Borrowed.
struct Solution {
  const Scene& scene;
  const ClusterTree& clusters;
  const ViewingRegion& region;
  const LinkSet& links;
  const VisibilityMatrix& matrix;
  const RegionCover& cover;
  std::vector<std::pair<std::string, std::uint64_t>> backend_statistics{};

  /// Row numbers of the cover, ascending.
  std::vector<std::size_t> chosen() const {
    return cover.steps.empty() ? std::vector<std::size_t>() : cover.steps.back().chosen;
  }
};

}  // namespace viewcover
