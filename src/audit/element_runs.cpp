#include "audit/element_runs.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cassert>

#include "scene/error.h"

namespace viewcover {

ElementRuns::ElementRuns(std::span<const ElementAddress> elements) : elements_(elements) {
  assert(std::ranges::is_sorted(elements));
  constexpr std::size_t kMostElements = 64;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const SurfaceId surface = elements[i].owner();
    if (runs_.empty() || runs_.back().surface != surface ||
        runs_.back().last - runs_.back().first == kMostElements) {
      runs_.push_back({surface, i, i});
    }
    runs_.back().last = i + 1;
  }
}

void ElementRuns::view(const ViewpointScene& from, const AuditOptions& options,
                       const std::function<void(std::size_t, ElementView&&)>& visit) const {
  tbb::parallel_for(std::size_t{0}, runs_.size(), [&](std::size_t i) {
    const Run& run = runs_[i];
    if (options.stop != nullptr && *options.stop) return;
    view_elements(
        from, run.surface, elements_.subspan(run.first, run.last - run.first), options.one_sided,
        [&](std::size_t index, ElementView&& view) { visit(run.first + index, std::move(view)); });
  });
  if (options.stop != nullptr && *options.stop) throw Interrupted();
}

}  // namespace viewcover
