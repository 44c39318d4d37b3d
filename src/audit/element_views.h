#pragma once

#include <functional>
#include <span>

#include "audit/viewpoint_scene.h"
#include "scene/address.h"

namespace viewcover {

/// What a viewpoint sees of an element, exactly.
struct ElementView {
  enum class Seen { kNot, kInPart, kWholly };
  Seen seen = Seen::kNot;
  /// Disjoint, in the surface's plane; only where seen in part.
  std::vector<flat::FlatPolygon> parts{};
};

/// Calls `visit(index, view)` for each of the elements that the viewpoint sees anything of, in
/// order: the points of an element whose open segment to the viewpoint meets no occluder. An
/// element whose plane holds the viewpoint is not seen; with `one_sided`, nor is one from behind.
///
/// `elements` are ascending nodes of the quadtree over one surface, none below another. The
/// occluders are culled on the way down that quadtree: what no occluder can shade, or one alone
/// hides, takes no arithmetic (papers/audit.md).
void view_elements(const ViewpointScene& from, SurfaceId surface,
                   std::span<const ElementAddress> elements, bool one_sided,
                   const std::function<void(std::size_t, ElementView&&)>& visit);

}  // namespace viewcover
