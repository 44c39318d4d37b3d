#include "audit/unseen_area.h"

#include <algorithm>

#include "audit/element_runs.h"
#include "audit/element_views.h"
#include "audit/viewpoint_scene.h"

namespace viewcover {
namespace {

using flat::FlatPolygon;

/// Takes the parts, disjoint convex polygons, away from the pieces.
void take_away(std::span<const FlatPolygon> parts, std::vector<FlatPolygon>& pieces) {
  std::vector<FlatPolygon> before;
  for (const FlatPolygon& part : parts) {
    before.clear();
    before.swap(pieces);
    for (FlatPolygon& piece : before) {
      if (piece.is_apart_from(part)) {
        pieces.push_back(std::move(piece));
        continue;
      }
      for (const flat::FlatLine& line : part.lines()) {
        if (piece.is_empty()) break;
        if (auto outside = piece.cut(line)) pieces.push_back(std::move(*outside));
      }
    }
    if (pieces.empty()) return;
  }
}

}  // namespace

struct UnseenArea::State {
  PlanarScene planar;
  std::span<const ElementAddress> elements;
  AuditOptions options;
  ElementRuns runs;
  std::vector<std::vector<FlatPolygon>> unseen;
};

UnseenArea::UnseenArea(const Scene& scene, const ClusterTree& clusters,
                       std::span<const ElementAddress> elements, const AuditOptions& options)
    : state_(
          new State{PlanarScene(scene, clusters), elements, options, ElementRuns(elements), {}}) {
  for (const ElementAddress element : elements) {
    const SurfaceId surface = element.owner();
    state_->unseen.emplace_back().push_back(
        state_->planar.surface_plane(surface).flat(subdivided(scene[surface].polygon, element)));
  }
}

UnseenArea::~UnseenArea() = default;

void UnseenArea::subtract(const Point& viewpoint) {
  state_->runs.view(ViewpointScene(state_->planar, viewpoint), state_->options,
                    [&](std::size_t index, ElementView&& view) {
                      std::vector<FlatPolygon>& pieces = state_->unseen[index];
                      if (view.seen == ElementView::Seen::kWholly) {
                        pieces.clear();
                      } else {
                        take_away(view.parts, pieces);
                      }
                    });
}

std::vector<UnseenPiece> UnseenArea::pieces() const {
  std::vector<UnseenPiece> pieces;
  for (std::size_t i = 0; i < state_->unseen.size(); ++i) {
    const SurfacePlane& plane = state_->planar.surface_plane(state_->elements[i].owner());
    for (const FlatPolygon& polygon : state_->unseen[i]) {
      pieces.push_back({i, plane.lifted(polygon)});
    }
  }
  return pieces;
}

double UnseenArea::area() const {
  double sum = 0;
  for (const UnseenPiece& piece : pieces()) sum += viewcover::area(piece.polygon);
  return sum;
}

}  // namespace viewcover
