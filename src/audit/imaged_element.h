#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "audit/audit.h"
#include "audit/surface_plane.h"
#include "scene/convex_polygon.h"

namespace viewcover {

/// An element cut into disjoint convex pieces, each with the number of viewpoints that see it.
/// Pieces are exact; they are cut along edges of shadows and nowhere else.
class ImagedElement {
 public:
  /// `plane`: of the element's surface; kept by reference.
  ImagedElement(const SurfacePlane& plane, ConvexPolygon element);

  /// One more viewpoint sees the whole element.
  void add_whole() { ++whole_; }
  /// One more viewpoint sees these parts of it: disjoint polygons in its plane.
  void add_parts(std::span<const flat::FlatPolygon> parts);

  /// Cost: linear in the pieces, and for sums of areas see `flat::twice_area`.
  ElementAudit result() const;

  struct Piece {
    flat::FlatPolygon polygon;
    std::uint32_t images = 0;  ///< viewpoints that see part of the element and this piece
  };
  /// Exact; none while the element is in one piece.
  std::span<const Piece> pieces() const { return pieces_; }
  /// Viewpoints that see the whole element.
  std::uint32_t whole() const { return whole_; }

 private:
  /// [k]: exact share of the area that exactly k viewpoints see.
  std::vector<flat::Rational> shares_by_images() const;

  const SurfacePlane* plane_;
  ConvexPolygon element_;
  std::vector<Piece> pieces_;
  std::uint32_t whole_ = 0;
};

}  // namespace viewcover
