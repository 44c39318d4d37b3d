#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "scene/cluster_tree.h"
#include "scene/plane.h"
#include "scene/scene.h"
#include "scene/viewing_region.h"

namespace viewcover {

/// The surfaces of a scene as occluders, in the leaf order of its cluster tree, with their planes.
/// Keeps a reference to the tree. Immutable, safe to share.
class OccluderSet {
 public:
  /// `region`: where shafts may start.
  OccluderSet(const Scene& scene, const ClusterTree& clusters, const ViewingRegion& region);

  const ClusterTree& clusters() const { return clusters_; }
  /// No two coordinates of scene and region differ by more.
  double reach() const { return reach_; }

  std::span<const Point> polygon(OccluderId id) const {
    return {corners_.data() + first_corner_[id.value],
            first_corner_[id.value + 1] - first_corner_[id.value]};
  }
  const Plane& plane(OccluderId id) const { return planes_[id.value]; }

 private:
  const ClusterTree& clusters_;
  // Copied in leaf order: neighbours in a shaft are neighbours in memory.
  std::vector<Point> corners_;
  std::vector<std::uint32_t> first_corner_{0};
  std::vector<Plane> planes_;
  double reach_ = 0;
};

/// A node of the cluster tree: a leaf is one surface, an inner node stands for all surfaces below.
using ClusterNode = std::uint32_t;

/// What may block a shaft: a surface, or a cluster that was not opened.
struct ShaftOccluder {
  /// On which side of a surface's plane the region lies, with the element on the other side.
  enum class Separates : std::uint8_t { kNotKnown, kRegionInFront, kRegionBehind };

  ClusterNode node = 0;
  Separates separates = Separates::kNotKnown;  ///< handed down: it holds for every smaller shaft
};

}  // namespace viewcover
