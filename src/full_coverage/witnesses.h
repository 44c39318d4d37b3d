#pragma once

#include <optional>
#include <span>
#include <vector>

#include "full_coverage/open_segments.h"
#include "viewpoints/region_views.h"

namespace viewcover {

/// Places on elements that images must show, and which regions see them: the columns of the cover
/// that full coverage asks for, and of its lower bound.
///
/// Each lies in its element exactly, on no other surface and in the plane of no polygon of the
/// region. So a
/// viewpoint that sees one sees it from all places near by, and every cell that the viewpoint lies
/// in sees it from a part that has area (papers/full-coverage.md).
/// Concurrent reads are safe.
class Witnesses : public CellViews {
 public:
  explicit Witnesses(const RegionViews& views);

  /// A place in a part of an element, near its centre; none where the part is too thin for exact
  /// positions, or the place would be on another surface.
  std::optional<ElementTarget> place_in(std::size_t column, std::span<const Point> part) const;
  /// Adds a place if some region sees it; the regions are asked exactly. In parallel. Returns how
  /// many were added. Cost: a decision from a point for each region that sees the element.
  std::size_t add(std::span<const ElementTarget> places);

  std::size_t size() const { return places_.size(); }
  const ElementTarget& operator[](std::size_t index) const { return places_[index]; }

  /// Is the place imaged from the position? Exact; about a microsecond.
  bool is_seen(const Point& position, const ElementTarget& place) const {
    return views_.is_facing(place.column, position) && segments_.is_free(position, place.place);
  }

  const ViewingRegion& region() const override { return views_.region(); }
  std::size_t column_count() const override { return places_.size(); }
  const RegionPositions& positions(std::size_t region) const override {
    return views_.positions(region);
  }
  bool region_sees(std::size_t region, std::size_t column) const override {
    return regions_[column][region];
  }
  bool cell_sees(const RegionCell& cell, std::size_t column) const override {
    return views_.cell_sees_place(cell, places_[column]);
  }
  std::vector<std::pair<std::size_t, std::size_t>> lends(
      std::span<const RegionCell> cells) const override;

 private:
  bool is_on_another_surface(const ElementTarget& place) const;
  std::vector<bool> regions_that_see(const ElementTarget& place) const;

  const RegionViews& views_;
  OpenSegments segments_;
  Box box_;                             ///< of scene and region
  double contact_ = 0;                  ///< nearer is touching
  std::vector<SurfaceId> near_region_;  ///< surfaces that touch the viewing region
  std::vector<ElementTarget> places_;
  std::vector<std::vector<bool>> regions_;  ///< by place
};

}  // namespace viewcover
