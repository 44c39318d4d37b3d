#pragma once

#include "optim/region_cover.h"

namespace viewcover {

/// The fewest rows, proved, and for each k the most that k rows cover, proved.
///
/// The cover: optim/prove_cover.h. RegionCover::proof holds a proof of lower_bound, also where the
/// time limit struck. Maximum coverage: branch and bound for each k (optim/coverage_tree.h). With a
/// time limit the whole cover has half of the time where steps for every k are wanted. Several
/// smallest covers: an enumeration that keeps all of them, in lexicographic order of the search, so
/// that the same instance always gives the same ones (optim/optimal_covers.h).
class ExactCover : public CoverMethod {
 public:
  std::string_view name() const override { return "exact"; }
  RegionCover solve(const CoverInstance& instance, const CoverOptions& options) const override;
};

}  // namespace viewcover
