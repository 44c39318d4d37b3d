#include "audit/audit.h"

#include <tbb/parallel_for.h>

#include <algorithm>

#include "audit/element_runs.h"
#include "audit/imaged_element.h"
#include "audit/viewpoint_scene.h"

namespace viewcover {
namespace {

/// Elements whose exact pieces are held at one time.
constexpr std::size_t kElementsAtOnce = 1024;

void audit_some(const PlanarScene& planar, std::span<const ElementAddress> elements,
                std::span<const Point> viewpoints, const AuditOptions& options,
                std::span<ElementAudit> results) {
  std::vector<ImagedElement> imaged;
  imaged.reserve(elements.size());
  for (const ElementAddress element : elements) {
    const SurfaceId surface = element.owner();
    imaged.emplace_back(planar.surface_plane(surface),
                        subdivided(planar.scene()[surface].polygon, element));
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
  tbb::parallel_for(std::size_t{0}, elements.size(),
                    [&](std::size_t i) { results[i] = imaged[i].result(); });
}

}  // namespace

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
  Audit audit{viewpoints.size(), std::vector<ElementAudit>(elements.size())};
  for (std::size_t first = 0; first < elements.size(); first += kElementsAtOnce) {
    const std::size_t count = std::min(kElementsAtOnce, elements.size() - first);
    audit_some(planar, elements.subspan(first, count), viewpoints, options,
               std::span(audit.elements).subspan(first, count));
    if (options.done != nullptr) *options.done += count;
  }
  return audit;
}

}  // namespace viewcover
