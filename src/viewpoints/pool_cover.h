#pragma once

#include <cstdint>
#include <vector>

#include "links/bit_rows.h"
#include "optim/cover_proof.h"
#include "optim/search_limits.h"

namespace viewcover {

/// Few rows of a pool that see all that the pool sees, and what columns are worth.
struct PoolCover {
  /// What a sum of prices may be off by: they come from floating point.
  static constexpr double kPriceTolerance = 1e-6;

  std::vector<std::size_t> chosen;  ///< ascending
  std::size_t lower_bound = 0;      ///< proved: no fewer rows of the pool do
  /// Prices of columns from the linear programme of the cover: no row's columns cost more than 1
  /// together, but for rounding, and all columns as much as possible. A row from outside the pool
  /// can only help to a smaller fractional cover if its columns cost more than 1 (column
  /// generation; here the columns of the programme are rows).
  std::vector<double> prices;
  double relaxation = 0;  ///< the sum of the prices
  /// Of lower_bound, if it was asked for.
  CoverProof proof;
};

/// How hard a smallest cover is looked for, in each component.
struct PoolCoverEffort {
  std::size_t nodes = 500;             ///< of branch and bound
  std::uint64_t patience = 3'000'000;  ///< of local search, where that many do not end
  bool proof = false;                  ///< keep the proof; for canonical rows (CoverInstance::rows)
};

/// Reductions, the linear programme, branch and bound, with a local search where that does not end.
/// Deterministic unless the limits expire. Errors: Interrupted.
PoolCover cover_pool(const BitRows& rows, const PoolCoverEffort& effort, std::uint64_t seed,
                     SearchLimits& limits);

}  // namespace viewcover
