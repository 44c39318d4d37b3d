#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "audit/sight_plane.h"
#include "audit/surface_plane.h"
#include "scene/cluster_tree.h"
#include "scene/plane.h"
#include "scene/scene.h"

namespace viewcover {

/// The surfaces of a scene with their planes. Borrows scene and tree. Immutable, safe to share.
class PlanarScene {
 public:
  PlanarScene(const Scene& scene, const ClusterTree& clusters);

  const Scene& scene() const { return scene_; }
  const ClusterTree& clusters() const { return clusters_; }
  const Plane& plane(SurfaceId id) const { return planes_[id.value]; }
  const SurfacePlane& surface_plane(SurfaceId id) const { return surface_planes_[id.value]; }
  /// In which all corners of surfaces are integers.
  const IntegerFrame& frame() const { return frame_; }

 private:
  const Scene& scene_;
  const ClusterTree& clusters_;
  std::vector<Plane> planes_;
  std::vector<SurfacePlane> surface_planes_;
  IntegerFrame frame_;
};

/// A convex polygon in the plane of a surface as a viewpoint sees it: the open cone of directions
/// toward its interior. Requires a viewpoint off that plane.
class ViewedPolygon {
 public:
  /// `side`: of the viewpoint to the polygon's plane, 1 in front, -1 behind.
  ViewedPolygon(const Point& viewpoint, int side, std::span<const Point> polygon, double reach);

  std::span<const SightPlane> edges() const { return edges_; }
  /// False only if nothing in the box is seen in a direction of the cone.
  bool may_meet(const Box& box) const;
  /// Do all points lie on the outer side of one edge, or on its border?
  bool has_outside(std::span<const Point> points) const;

 private:
  SmallList<SightPlane, 4> edges_;  // inside is in front
};

/// A surface that may hide things from a viewpoint.
struct ViewedOccluder {
  SurfaceId id;
  ViewedPolygon view;
};

/// How an occluder stands between a viewpoint and an element.
enum class Blocks {
  kNothing,     ///< it blocks no open set of sight lines
  kPart,        ///< it may block some
  kEverything,  ///< it blocks all
};

/// A scene from one viewpoint. Borrows. Safe to share: all that changes is what is tried first.
class ViewpointScene {
 public:
  ViewpointScene(const PlanarScene& planar, const Point& viewpoint);

  const PlanarScene& planar() const { return planar_; }
  const Point& viewpoint() const { return viewpoint_; }
  /// Of the viewpoint to the plane of a surface: 1 in front, -1 behind, 0 in it; exact.
  int side(SurfaceId id) const { return sides_[id.value]; }
  ViewedPolygon view_of(SurfaceId id, std::span<const Point> part) const {
    return {viewpoint_, side(id), part, reach_};
  }

  /// The surfaces that may block sight lines to a surface, none that certainly do not; nothing if
  /// one alone blocks all of them. Exact predicates decide, and boxes with a margin that rounding
  /// cannot use up. Requires a viewpoint off its plane. Cost: logarithmic in the scene where it is
  /// sparse.
  std::optional<std::vector<ViewedOccluder>> occluders(SurfaceId id,
                                                       const ViewedPolygon& view) const;
  /// kNothing and kEverything are exact. `part` lies in the surface's plane and `view` is its view.
  Blocks blocks(const ViewedOccluder& occluder, std::span<const Point> part,
                const ViewedPolygon& view) const;

  /// The plane through the viewpoint and an occluder's edge, inside in front, and the occluder's
  /// own plane, the viewpoint behind it; in the scene's frame.
  SpacePlane edge_plane(SurfaceId occluder, std::size_t edge) const;
  SpacePlane own_plane(SurfaceId occluder) const;

 private:
  template <class Number>
  IntegerPoint edge_normal(const Point& from, const Point& to) const;

  const PlanarScene& planar_;
  Point viewpoint_;
  double reach_;
  std::vector<int> sides_;
  IntegerFrame frame_;   // the scene's, finer where the viewpoint needs it
  IntegerPoint origin_;  // the viewpoint
  BigInteger finer_;     // units of this frame in one of the scene's
  // The last surface that hid another one whole: in a room the same wall hides all that is beyond.
  mutable std::atomic<std::uint32_t> last_hider_ = 0;
};

}  // namespace viewcover
