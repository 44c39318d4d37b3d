#pragma once

#include <functional>

#include "optim/cover_state.h"
#include "optim/region_cover.h"
#include "optim/search_limits.h"

namespace viewcover {

/// One number of rows on the way of grow_cover().
struct GrowthStage {
  std::size_t k = 0;
  std::size_t lower_bound = 0;          ///< proven, on the rows of a whole cover
  CoverState::Benefit upper_bound = 0;  ///< no k rows have a greater benefit
};

/// Leaves a set of as many rows, of no less benefit, in the state.
using ImproveCover = std::function<void(CoverState&, const GrowthStage&, SearchLimits&)>;

/// The loop over k of the paper, section 2.3: to the best set of k - 1 rows the row that adds most
/// is added (of several the first), and `improve` searches on from there, until the goal of
/// `options` is reached. Once the time limit has passed, nothing is improved any more. A whole
/// cover is freed of redundant rows. Coverage never decreases with k. Errors: Interrupted if
/// options.stop is set.
RegionCover grow_cover(const CoverInstance& instance, const CoverOptions& options,
                       const ImproveCover& improve);

/// What is reported of a set of rows, in any order, but for evaluations and time.
CoverStep make_step(const CoverInstance& instance, std::vector<std::size_t> chosen);

/// Removes rows without which as much is covered, lowest first, until there is none.
void remove_redundant_rows(CoverState& state);

/// The row, not chosen yet, that adds most; the first of several. Requires one not chosen.
std::size_t best_addition(CoverState& state);

}  // namespace viewcover
