#pragma once

#include <cstdint>
#include <span>

#include "scene/cluster_tree.h"
#include "scene/scene.h"

namespace viewcover {

/// What random points of an element saw of the viewpoints.
struct SampleCounts {
  std::size_t samples = 0;
  std::size_t imaged = 0;  ///< samples that see at least one viewpoint
  std::size_t images = 0;  ///< pairs of a sample and a viewpoint that see each other
  std::size_t most = 0;    ///< most viewpoints that one sample sees
};

/// Judges pairs of a point and a viewpoint with no code of `audit` or `exact`: the open segment
/// between them is classified exactly (links/sight_line.h). Borrows. Safe to share.
class SightSampler {
 public:
  SightSampler(const Scene& scene, const ClusterTree& clusters, std::span<const Point> viewpoints,
               bool one_sided)
      : scene_(scene), clusters_(clusters), viewpoints_(viewpoints), one_sided_(one_sided) {}

  /// Independent points, uniform over a part of a surface. Cost: about 2 us a point and viewpoint
  /// in a room.
  SampleCounts sample(SurfaceId surface, const ConvexPolygon& part, std::size_t samples,
                      std::uint64_t seed) const;

 private:
  bool sees(SurfaceId surface, const ConvexPolygon& part, const std::vector<double>& weights,
            const Point& viewpoint) const;

  const Scene& scene_;
  const ClusterTree& clusters_;
  std::span<const Point> viewpoints_;
  bool one_sided_;
};

}  // namespace viewcover
