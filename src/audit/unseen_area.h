#pragma once

#include <memory>
#include <span>
#include <vector>

#include "audit/audit.h"

namespace viewcover {

/// A part of an element that no viewpoint images.
struct UnseenPiece {
  std::size_t element = 0;  ///< as its place in the list given
  ConvexPolygon polygon;    ///< corners rounded
};

/// What is left of elements when what viewpoints image is taken away, one after the other; exact.
/// The same area as what audit_images finds imaged by none, in a fraction of the time, since only
/// what is left is cut further.
///
/// Not safe for concurrent use; uses all threads of the current TBB arena.
class UnseenArea {
 public:
  /// Borrows all; `elements` as for audit_images.
  UnseenArea(const Scene& scene, const ClusterTree& clusters,
             std::span<const ElementAddress> elements, const AuditOptions& options);
  ~UnseenArea();

  /// Errors: Interrupted.
  void subtract(const Point& viewpoint);

  /// Disjoint and convex, in the order of the elements.
  std::vector<UnseenPiece> pieces() const;
  /// Scene units squared, rounded.
  double area() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace viewcover
