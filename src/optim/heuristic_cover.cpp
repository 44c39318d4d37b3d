#include "optim/heuristic_cover.h"

#include <algorithm>

namespace viewcover {

HeuristicCover::HeuristicCover(const Incidence& incidence, SearchLimits& limits, std::uint64_t seed)
    : limits_(limits), random_(seed), search_(incidence, random_) {}

const std::vector<std::uint32_t>& HeuristicCover::run(std::uint64_t patience) {
  return run(SearchEffort(limits_, patience, search_.work()));
}

const std::vector<std::uint32_t>& HeuristicCover::run_for_share(double share,
                                                                std::uint64_t patience) {
  return run(SearchEffort(limits_, share, patience, search_.work()));
}

const std::vector<std::uint32_t>& HeuristicCover::run(SearchEffort effort) {
  search_.run(effort, 1, [] {});
  best_.assign(search_.best().begin(), search_.best().end());
  std::ranges::sort(best_);
  return best_;
}

}  // namespace viewcover
