#pragma once

#include <cstdint>
#include <vector>

#include "full_coverage/witnesses.h"
#include "viewpoints/viewpoint_search.h"

namespace viewcover {

struct FullCoverageOptions {
  /// It ends when no further viewpoint that is found adds this share of the area imaged.
  double missed_share = 1e-4;
  std::uint64_t seed = 1;
  /// Rounds of looking for fewer viewpoints and of raising the bound without success, or the
  /// seconds until rounds end however many there were, where they are given.
  int patience = 12;
  double close_gap_seconds = 0;
  double time_limit_seconds = 0;            ///< 0: none
  const std::atomic<bool>* stop = nullptr;  ///< ends the search with Interrupted
  ViewpointProgress* progress = nullptr;
};

/// Few viewpoints whose images show all that can be imaged, but for a stated share.
///
/// Starts from viewpoints that see a part of every element (`parts`). What a set leaves unimaged is
/// found exactly (audit/unseen_area.h); positions that image most of it are looked for, and places
/// in it become witnesses that every later set has to see. A smallest cover of the witnesses by all
/// positions met is the next set. In turn with that, positions are looked for by the prices of the
/// cover's linear programme, snapped to crossings of extended surfaces, and the lower bound is
/// raised: the fewest cells of regions that see all witnesses, decided exactly
/// (papers/full-coverage.md).
///
/// Requires an exact backend. Uses all threads of the current TBB arena; without a time limit the
/// result depends on input and seed only. Errors: Interrupted.
ViewpointSet find_full_coverage(const RegionViews& views, const ViewpointSet& parts,
                                const FullCoverageOptions& options);

}  // namespace viewcover
