#pragma once

#include <atomic>
#include <cstdint>
#include <functional>

#include "links/link_set.h"
#include "links/visibility_backend.h"
#include "scene/cluster_tree.h"
#include "scene/scene.h"
#include "scene/viewing_region.h"

namespace viewcover {

/// How far refinement has come, readable from another thread while it runs.
struct RefineProgress {
  std::atomic<double> share_done = 0;  ///< in [0, 1]
  std::atomic<std::uint64_t> links = 0;
  std::atomic<bool> stop = false;  ///< set it to end refinement with `Interrupted`
};

struct RefineOptions {
  double element_area = 0;  ///< elements are subdivided while larger than this, scene units squared
  bool one_sided = false;   ///< only the front of a surface counts as visible
};

/// Makes a long refinement one that can be ended at any moment and continued: it goes through
/// batches in an order that does not depend on what happens, and tells from time to time how many
/// are done and what links they have.
struct RefineCheckpoints {
  std::size_t batches_done = 0;  ///< to start after
  LinkSet links;                 ///< of these batches
  double seconds = 10;           ///< from one call of `save` to the next, about
  std::function<void(std::size_t batches_done, const LinkSet& links)> save;
};

/// Hierarchical visibility (paper, section 2.2, figure 4): all links between the viewing region and
/// the scene's targets, from polygons and from the faces of boxes. Uses all threads of the current
/// TBB arena; the result does not depend on their number, nor on whether and where it was
/// continued. Errors: InputError if element_area asks for more than kMaxSubdivisionLevel levels;
/// Interrupted; what `save` throws.
LinkSet refine(const Scene& scene, const ClusterTree& clusters, const ViewingRegion& region,
               const VisibilityBackend& backend, const RefineOptions& options,
               RefineProgress* progress = nullptr, RefineCheckpoints* checkpoints = nullptr);

/// 1 % of the mean surface area of the faces of the scene's bounding box (a sixth of its surface).
double default_element_area(const Scene& scene);

}  // namespace viewcover
