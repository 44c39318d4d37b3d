#include "optim/greedy_cover.h"

#include "optim/growing_cover.h"

namespace viewcover {

RegionCover GreedyCover::solve(const CoverInstance& instance, const CoverOptions& options) const {
  CoverOptions without_limit = options;
  without_limit.time_limit_seconds = 0;
  return grow_cover(instance, without_limit,
                    [](CoverState&, const GrowthStage&, const SearchLimits&) {});
}

}  // namespace viewcover
