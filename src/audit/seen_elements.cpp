#include "audit/seen_elements.h"

#include <tbb/parallel_for.h>

#include "audit/element_views.h"
#include "audit/viewpoint_scene.h"

namespace viewcover {

BitRows seen_elements(const Scene& scene, const ClusterTree& clusters,
                      std::span<const ElementAddress> elements, std::span<const Point> viewpoints,
                      bool one_sided) {
  const PlanarScene planar(scene, clusters);
  BitRows seen(viewpoints.size(), elements.size());
  tbb::parallel_for(std::size_t{0}, viewpoints.size(), [&](std::size_t viewpoint) {
    const ViewpointScene from(planar, viewpoints[viewpoint]);
    for (std::size_t first = 0, end = 0; first < elements.size(); first = end) {
      const SurfaceId surface = elements[first].owner();
      while (end < elements.size() && elements[end].owner() == surface) ++end;
      view_elements(
          from, surface, elements.subspan(first, end - first), one_sided,
          [&](std::size_t index, const ElementView&) { seen.set(viewpoint, first + index); });
    }
  });
  return seen;
}

}  // namespace viewcover
