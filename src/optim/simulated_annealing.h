#pragma once

#include "optim/region_cover.h"

namespace viewcover {

/// How long and how hot annealing is; the paper names no numbers. What the defaults rest on:
/// experiments/optimizers.
struct AnnealingSchedule {
  /// Rounds for each k. Later ones start from the best set so far, cooler and with smaller changes;
  /// every third starts hot again, from a random set, against a bad start.
  int rounds = 12;
  /// Temperature levels a round. From one to the next the temperature falls by `cooling`: by
  /// default a factor of 1000 over the round, from differences between whole rows to single
  /// elements.
  int levels = 30;
  double cooling = 0.8;
  /// First temperature of a run, as a share of the total weight: exchanges near the optimum change
  /// the coverage by a few tenths of a percent to a few percent (paper, table 2).
  double temperature = 0.02;
};

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
  explicit SimulatedAnnealing(const AnnealingSchedule& schedule = {}) : schedule_(schedule) {}

  std::string_view name() const override { return "sa"; }
  RegionCover solve(const CoverInstance& instance, const CoverOptions& options) const override;

 private:
  AnnealingSchedule schedule_;
};

}  // namespace viewcover
