#include "audit/audit.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>

#include "audit/element_views.h"
#include "audit/imaged_element.h"
#include "audit/viewpoint_scene.h"
#include "scene/error.h"

namespace viewcover {
namespace {

/// Consecutive elements of one surface: what one thread looks at at a time.
struct Run {
  SurfaceId surface;
  std::size_t first = 0, last = 0;
};

std::vector<Run> runs_of(std::span<const ElementAddress> elements) {
  constexpr std::size_t kMostElements = 64;
  std::vector<Run> runs;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const SurfaceId surface = elements[i].owner();
    if (runs.empty() || runs.back().surface != surface ||
        runs.back().last - runs.back().first == kMostElements) {
      runs.push_back({surface, i, i});
    }
    runs.back().last = i + 1;
  }
  return runs;
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
  assert(std::ranges::is_sorted(elements));
  const PlanarScene planar(scene, clusters);
  const std::vector<Run> runs = runs_of(elements);
  std::vector<ImagedElement> imaged;
  imaged.reserve(elements.size());
  for (const ElementAddress element : elements) {
    const SurfaceId surface = element.owner();
    imaged.emplace_back(planar.surface_plane(surface), subdivided(scene[surface].polygon, element));
  }
  for (const Point& viewpoint : viewpoints) {
    const ViewpointScene from(planar, viewpoint);
    tbb::parallel_for(std::size_t{0}, runs.size(), [&](std::size_t i) {
      const Run& run = runs[i];
      if (options.stop != nullptr && *options.stop) return;
      view_elements(from, run.surface, elements.subspan(run.first, run.last - run.first),
                    options.one_sided, [&](std::size_t index, ElementView&& view) {
                      ImagedElement& element = imaged[run.first + index];
                      if (view.seen == ElementView::Seen::kWholly) {
                        element.add_whole();
                      } else {
                        element.add_parts(view.parts);
                      }
                    });
    });
    if (options.stop != nullptr && *options.stop) throw Interrupted();
    if (options.done != nullptr) ++*options.done;
  }
  Audit audit{viewpoints.size(), std::vector<ElementAudit>(elements.size())};
  tbb::parallel_for(std::size_t{0}, elements.size(),
                    [&](std::size_t i) { audit.elements[i] = imaged[i].result(); });
  return audit;
}

}  // namespace viewcover
