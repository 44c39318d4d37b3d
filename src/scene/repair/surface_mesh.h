#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "scene/scene.h"
#include "scene/types.h"

namespace viewcover {

/// Which surfaces meet at which edges: the connectivity of the welded surfaces (OpenMesh inside).
///
/// Corners at the same place are one vertex. An edge of a surface is cut at every vertex that lies
/// on it exactly, so a T-junction, or a corner that was left out because it was straight, does not
/// tear the surfaces apart. Every surface has exactly one face in the mesh; what a halfedge mesh
/// cannot hold (an edge of three faces, a Moebius strip) is cut there and joined again here.
/// Immutable, safe to share. Cost of making: O(n log n) typical.
class SurfaceMesh {
 public:
  explicit SurfaceMesh(std::span<const Surface> surfaces);
  ~SurfaceMesh();
  SurfaceMesh(SurfaceMesh&&) noexcept;
  SurfaceMesh& operator=(SurfaceMesh&&) noexcept;

  /// The surfaces that share an edge with this one, in order, itself left out.
  std::vector<SurfaceId> neighbours(SurfaceId surface) const;
  /// Those neighbours that lie in the same plane, decided exactly, whichever way they face.
  std::vector<SurfaceId> coplanar_neighbours(SurfaceId surface) const;

  /// Faces of the mesh; one a surface.
  std::size_t faces() const;
  /// Edges between vertices next to each other, each counted once however many surfaces meet there.
  std::size_t edges() const;
  /// Edges of one surface.
  std::size_t boundary_edges() const;
  /// Edges of three surfaces or more.
  std::size_t non_manifold_edges() const;

  /// Surfaces are in one component iff a chain of shared edges joins them.
  std::size_t components() const;
  /// In [0, components()), numbered by the first surface.
  std::size_t component_of(SurfaceId surface) const;
  /// True iff at every edge of the component an even number of its surfaces meet: then each point
  /// off the component is either inside or outside by the parity of crossings.
  bool is_closed(std::size_t component) const;

  /// True iff the mesh face runs the other way round than the surface: neighbours that share a
  /// manifold edge face the same side of the mesh, whatever the file says, where that is possible.
  bool is_reversed(SurfaceId surface) const;

 private:
  struct Mesh;
  std::unique_ptr<const Mesh> mesh_;
};

/// Joins neighbours of one group that lie exactly in one plane and face the same way, over edges
/// they share whole, while the union is strictly convex (scene/repair/convex_merge.h). The union
/// stands where its first surface stood and keeps that one's source face. Area is preserved
/// exactly. Returns the number of surfaces that went into others.
std::size_t merge_coplanar(std::vector<Surface>& surfaces);

}  // namespace viewcover
