#include "audit/audit.h"

#include <tbb/parallel_for.h>

#include "audit/element_runs.h"
#include "audit/imaged_element.h"
#include "audit/viewpoint_scene.h"

namespace viewcover {
double ElementAudit::images_mean() const {
  double sum = 0, whole = 0;
  for (std::size_t k = 0; k < area_by_images.size(); ++k) {
    sum += static_cast<double>(k) * area_by_images[k];
    whole += area_by_images[k];
  }
  return sum / whole;
}

Audit audit_images(const Scene& scene, const ClusterTree& clusters,
                   std::span<const ElementAddress> elements, std::span<const Point> viewpoints,
                   const AuditOptions& options) {
  const PlanarScene planar(scene, clusters);
  std::vector<ImagedElement> imaged;
  imaged.reserve(elements.size());
  for (const ElementAddress element : elements) {
    const SurfaceId surface = element.owner();
    imaged.emplace_back(planar.surface_plane(surface), subdivided(scene[surface].polygon, element));
  }
  const ElementRuns runs(elements);
  for (const Point& viewpoint : viewpoints) {
    runs.view(ViewpointScene(planar, viewpoint), options,
              [&](std::size_t index, ElementView&& view) {
                if (view.seen == ElementView::Seen::kWholly) {
                  imaged[index].add_whole();
                } else {
                  imaged[index].add_parts(view.parts);
                }
              });
  }
  Audit audit{viewpoints.size(), std::vector<ElementAudit>(elements.size())};
  tbb::parallel_for(std::size_t{0}, elements.size(),
                    [&](std::size_t i) { audit.elements[i] = imaged[i].result(); });
  return audit;
}

}  // namespace viewcover
