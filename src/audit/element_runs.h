#pragma once

#include <functional>
#include <span>
#include <vector>

#include "audit/audit.h"
#include "audit/element_views.h"

namespace viewcover {

/// Elements in runs of one surface, for threads to share. Borrows.
class ElementRuns {
 public:
  /// `elements`: ascending, none within another.
  explicit ElementRuns(std::span<const ElementAddress> elements);

  /// Calls `visit(index, view)` for each element that the viewpoint sees anything of, from all
  /// threads, but never twice for one element. Errors: Interrupted.
  void view(const ViewpointScene& from, const AuditOptions& options,
            const std::function<void(std::size_t, ElementView&&)>& visit) const;

 private:
  struct Run {
    SurfaceId surface;
    std::size_t first = 0, last = 0;
  };
  std::span<const ElementAddress> elements_;
  std::vector<Run> runs_;
};

}  // namespace viewcover
