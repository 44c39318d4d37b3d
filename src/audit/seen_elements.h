#pragma once

#include <span>

#include "links/bit_rows.h"
#include "scene/address.h"
#include "scene/cluster_tree.h"
#include "scene/scene.h"

namespace viewcover {

/// #viewpoints x #elements bits: who sees a part of positive area of what, exactly; by the audit's
/// way down the scene (audit/element_views.h), which knows of no regions, links, or cones.
///
/// Elements: ascending, none within another. Cost: that of an audit without its areas. Uses all
/// threads of the current TBB arena.
BitRows seen_elements(const Scene& scene, const ClusterTree& clusters,
                      std::span<const ElementAddress> elements, std::span<const Point> viewpoints,
                      bool one_sided);

}  // namespace viewcover
