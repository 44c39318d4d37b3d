#pragma once

#include <span>
#include <vector>

#include "links/bit_rows.h"
#include "scene/viewing_region.h"
#include "viewpoints/region_positions.h"

namespace viewcover {

/// A node at or below a region, with its points.
struct RegionCell {
  RegionAddress address;
  std::size_t region = 0;
  RegionShape shape;
};

/// What parts of regions see, by columns: what a lower bound is proved from. A part sees no more
/// than the whole. Concurrent calls are allowed.
class CellViews {
 public:
  virtual ~CellViews() = default;

  virtual const ViewingRegion& region() const = 0;
  virtual std::size_t column_count() const = 0;
  /// Where viewpoints of a region may be.
  virtual const RegionPositions& positions(std::size_t region) const = 0;
  virtual bool region_sees(std::size_t region, std::size_t column) const = 0;
  /// An exact backend's answer is a theorem.
  virtual bool cell_sees(const RegionCell& cell, std::size_t column) const = 0;

  /// Pairs (a, b) of cells such that viewpoints in the first may see, from places that both cells
  /// share, what only the second sees. None where viewpoints keep off all surfaces.
  virtual std::vector<std::pair<std::size_t, std::size_t>> lends(
      std::span<const RegionCell> cells) const {
    static_cast<void>(cells);
    return {};
  }

 protected:
  CellViews() = default;
  CellViews(const CellViews&) = default;
  CellViews& operator=(const CellViews&) = default;
};

}  // namespace viewcover
