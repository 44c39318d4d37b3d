#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "viewpoints/column_weights.h"
#include "viewpoints/region_views.h"

namespace viewcover {

struct AnnealingOptions {
  std::uint64_t seed = 1;
  std::size_t evaluations = 48;  ///< positions looked from, at most
  std::optional<Point> start{};  ///< default: a random position
};

struct AnnealedPosition {
  /// Free positions that were better than all before, ascending in benefit.
  std::vector<Point> records;
  double benefit = 0;  ///< of the last of them
  std::size_t evaluations = 0;
};

/// What a position is worth; none if no viewpoint may be there.
using PositionBenefit = std::function<std::optional<double>(const Point&)>;

/// Simulated annealing for the position of most benefit (paper, section 2.4). Steps shrink from
/// half the region to a hundredth, the temperature falls with them. Ends early at a benefit of
/// `most`. Without a free position there are no records. Same seed, same positions. Thread-safe.
AnnealedPosition anneal_position(const RegionPositions& positions, double most,
                                 const PositionBenefit& benefit_of,
                                 const AnnealingOptions& options);

/// The same for the weight of the columns seen from the position. Only columns with a weight are
/// looked at.
AnnealedPosition anneal_position(const RegionViews& views, std::size_t region,
                                 const ColumnWeights& weights, const AnnealingOptions& options);

}  // namespace viewcover
