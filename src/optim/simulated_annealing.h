#pragma once

#include "optim/region_cover.h"

namespace viewcover {

/// Simulated annealing as in the paper, sections 2.3 and 3.
///
/// For k = 1, 2, ...: the best set of k - 1 rows and the row that adds most to it start several
/// rounds of annealing over vectors of k rows. A proposal changes one row of the vector; how far in
/// row order (near numbers are near places: quadtree order) decreases within a round and starts
/// again, lower, in the next: the magnitude of changes decreases non-monotonically, and so does the
/// temperature. Each round ends with a local search: the best exchange of one row, while there is
/// one that helps. The search of a k ends early when a bound or a whole cover says that it is
/// best. Coverage therefore never decreases with k.
///
/// A minimum is not promised: proved() holds only where the lower bound is reached.
class SimulatedAnnealing : public CoverMethod {
 public:
  std::string_view name() const override { return "sa"; }
  RegionCover solve(const CoverInstance& instance, const CoverOptions& options) const override;
};

}  // namespace viewcover
