#pragma once

#include <cstdint>
#include <vector>

#include "optim/incidence.h"
#include "optim/search_limits.h"
#include "optim/whole_cover_search.h"
#include "scene/random_numbers.h"

namespace viewcover {

/// Local search for covers of a component beside its branch and bound; each run goes on where the
/// one before it ended. Deterministic unless the limits strike. Not safe for concurrent use.
class HeuristicCover {
 public:
  /// Both are kept by reference.
  HeuristicCover(const Incidence& incidence, SearchLimits& limits, std::uint64_t seed);
  HeuristicCover(const HeuristicCover&) = delete;
  HeuristicCover& operator=(const HeuristicCover&) = delete;

  /// Until so much work (optim/search_effort.h) brought nothing better, with or without a time
  /// limit. Returns the best cover so far, ascending. Errors: Interrupted.
  const std::vector<std::uint32_t>& run(std::uint64_t patience);
  /// The same, but with a time limit for that share of the time left.
  const std::vector<std::uint32_t>& run_for_share(double share, std::uint64_t patience);

 private:
  const std::vector<std::uint32_t>& run(SearchEffort effort);

  SearchLimits& limits_;
  RandomNumbers random_;
  WholeCoverSearch search_;
  std::vector<std::uint32_t> best_;
};

}  // namespace viewcover
