#pragma once

#include <cstdint>
#include <vector>

#include "links/bit_rows.h"
#include "optim/search_limits.h"

namespace viewcover {

/// Different covers of the same size, found in the order of a search that is always the same.
struct OptimalCovers {
  std::vector<std::vector<std::size_t>> covers;  ///< each ascending
  bool complete = false;                         ///< there are no others of that size
};

/// Up to `most` covers of `size` rows, none of which has a redundant row: with `size` the fewest
/// rows of a cover, the smallest covers.
///
/// Only columns implied by others are left out, which loses no cover; rows that others dominate
/// stay, as they make different covers. The search takes the uncovered column of the fewest rows
/// (the first of several) and tries its rows in ascending order; a row that was tried is ruled out
/// for those after it, so no cover comes twice. Parts of the tree end when integer prices from the
/// linear programme (optim/cover_dual.h) prove that more than `size` rows are needed: "complete" is
/// a theorem. Errors: Interrupted. Cost: exponential; linear programmes of the whole matrix.
OptimalCovers covers_of_size(const BitRows& matrix, std::size_t size, std::size_t most,
                             SearchLimits& limits);

}  // namespace viewcover
