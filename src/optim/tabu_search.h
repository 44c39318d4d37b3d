#pragma once

#include "optim/region_cover.h"

namespace viewcover {

/// Tabu search (Glover 1989), which the paper names as future work, for each k of its loop.
///
/// For k = 1, 2, ...: the best set of k - 1 rows and the row that adds most to it start a walk of
/// exchanges of one row. Each exchange brings in some row that covers a column picked at random
/// among the uncovered ones, the best such exchange, even if it is a loss. A row taken out may not
/// return, a row brought in may not leave, for a number of exchanges drawn anew each time, unless
/// the exchange gives a better set than any before (aspiration). Half the walk after the last
/// better set goes on from where it is, half starts again from that set.
///
/// A minimum is not promised. Cost: an exchange computes at most (rows of a column) x k benefits.
class TabuSearch : public CoverMethod {
 public:
  std::string_view name() const override { return "tabu"; }
  RegionCover solve(const CoverInstance& instance, const CoverOptions& options) const override;
};

}  // namespace viewcover
