#pragma once

#include <utility>
#include <vector>

#include "links/cull.h"
#include "links/shaft.h"
#include "support/scenes.h"

namespace viewcover::testing {

/// One shaft, from `from` to `to`, in a scene of what is between them. Not copyable: the parts
/// refer to each other.
struct ShaftCase {
  ConvexPolygon from, to;
  Scene scene;
  ClusterTree clusters{scene};
  ViewingRegion viewing{region_of(from, 0)};
  OccluderSet occluders{scene, clusters, viewing};
  PlanarPolygon region{from, Plane(from)};
  PlanarPolygon element{to, Plane(to)};

  ShaftCase(ConvexPolygon region_polygon, ConvexPolygon element_polygon,
            const std::vector<ConvexPolygon>& between)
      : from(std::move(region_polygon)), to(std::move(element_polygon)), scene(scene_of(between)) {}
  ShaftCase(const ShaftCase&) = delete;
  ShaftCase& operator=(const ShaftCase&) = delete;

  /// `number` stands for an address: it only matters to random backends.
  Shaft shaft(bool one_sided = false, std::size_t number = 0) const {
    return {occluders, RegionAddress(PartId(number)), region, ElementAddress(SurfaceId(0)), element,
            one_sided};
  }

  Shaft::Meets meets(SurfaceId surface) const {
    const Shaft here = shaft();
    ShaftOccluder occluder{.node = leaf(surface)};
    if (!here.box_overlaps(clusters.nodes()[occluder.node].box)) return Shaft::Meets::kNo;
    return here.meets(occluder);
  }

  ClusterNode leaf(SurfaceId surface) const {
    ClusterNode node = 0;
    while (!clusters.nodes()[node].is_leaf() ||
           clusters.surface(OccluderId(clusters.nodes()[node].first)) != surface) {
      ++node;
    }
    return node;
  }
};

}  // namespace viewcover::testing
