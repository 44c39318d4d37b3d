#include "links/cull.h"

namespace viewcover {

bool cull(const Shaft& shaft, std::span<const ShaftOccluder> candidates, std::size_t limit,
          ShaftOccluders& kept) {
  const auto nodes = shaft.occluder_set().clusters().nodes();
  kept.clear();
  ShaftOccluders pending;
  for (const ShaftOccluder& candidate : candidates) {
    pending.push_back(candidate);
    while (!pending.empty()) {
      ShaftOccluder occluder = pending.back();
      pending.pop_back();
      const ClusterTree::Node& node = nodes[occluder.node];
      if (!shaft.box_overlaps(node.box)) continue;
      if (node.is_leaf()) {
        const Shaft::Meets meets = shaft.meets(occluder);
        if (meets == Shaft::Meets::kBlocksAll) return true;
        if (meets == Shaft::Meets::kMaybe) kept.push_back(occluder);
      } else if (!shaft.may_meet(node.box)) {
        continue;
      } else if (kept.size() + pending.size() < limit) {
        pending.push_back({.node = node.right});
        pending.push_back({.node = occluder.node + 1});
      } else {
        kept.push_back(occluder);
      }
    }
  }
  return false;
}

}  // namespace viewcover
