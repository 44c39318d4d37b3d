#pragma once

#include "optim/region_cover.h"

namespace viewcover {

/// Local search by column weights: the heuristic for instances that are too hard for the others.
///
/// First a whole cover as small as can be found (WholeCoverSearch). Where fewer rows are asked for,
/// then k = 1, 2, ...: the best set of k - 1 rows and the row that adds most, or the rows of the
/// whole cover that are given up last, start a search for the k rows that cover most
/// (SwapSearch, or ExchangeSearch where k and the rows are many). Coverage never decreases with k;
/// a search that happens on a smaller whole cover ends the steps there.
///
/// Without a time limit every search ends after a number of operations without success: the same
/// run for the same seed on any machine. With a time limit all of it is used: half for the whole
/// cover (all, if nothing else is asked for), the rest in equal parts for the k; only what is known
/// to be best ends before its time.
/// A minimum is not promised: proved() holds only where the lower bound is reached.
class LocalSearch : public CoverMethod {
 public:
  std::string_view name() const override { return "local"; }
  RegionCover solve(const CoverInstance& instance, const CoverOptions& options) const override;
};

}  // namespace viewcover
