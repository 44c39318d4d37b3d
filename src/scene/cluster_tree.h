#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "scene/types.h"

namespace viewcover {

/// The scene as a binary hierarchy of bounding boxes (paper, section 2.2: interior nodes are
/// clusters, leaves are surfaces): groups first, then nearby surfaces within a group.
///
/// Nodes are stored in depth-first order, so the surfaces below any node are one run of the leaf
/// order. Deterministic. Cost: O(n log^2 n). Immutable, safe to share.
class ClusterTree {
 public:
  struct Node {
    Box box;
    std::uint32_t first = 0;  ///< first OccluderId below this node
    std::uint32_t count = 0;  ///< surfaces below; 1 for a leaf
    std::uint32_t right = 0;  ///< index of the second child; the first is the next node
    bool is_leaf() const { return count == 1; }
  };

  explicit ClusterTree(const Scene& scene);

  /// Depth-first; nodes()[0] is the whole scene.
  std::span<const Node> nodes() const { return nodes_; }
  SurfaceId surface(OccluderId place) const { return leaf_order_[place.value]; }
  OccluderId place(SurfaceId surface) const { return places_[surface.value]; }
  std::size_t size() const { return leaf_order_.size(); }

 private:
  std::vector<Node> nodes_;
  std::vector<SurfaceId> leaf_order_;
  std::vector<OccluderId> places_;
};

}  // namespace viewcover
