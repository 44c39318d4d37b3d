#pragma once

#include "optim/region_cover.h"

namespace viewcover {

/// The row that adds most to what the rows before it cover, again and again; of several the one of
/// the lowest number. Redundant rows of a whole cover are removed, lowest first.
///
/// A cover has at most 1 + ln(columns of the longest row) times as many rows as the smallest one
/// (Chvatal 1979), and k rows cover at least 1 - 1/e of what the best k rows cover (Nemhauser,
/// Wolsey and Fisher 1978). Neither seed nor time limit matters.
/// Cost: O(k x #rows x #columns / 64) and the columns that the rows would add.
class GreedyCover : public CoverMethod {
 public:
  std::string_view name() const override { return "greedy"; }
  RegionCover solve(const CoverInstance& instance, const CoverOptions& options) const override;
};

}  // namespace viewcover
