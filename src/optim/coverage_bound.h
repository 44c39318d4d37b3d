#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "optim/cover_dual.h"
#include "optim/cover_state.h"

namespace viewcover {

/// Choose k rows that cover as much weight as possible. Weights are integers in the units of
/// CoverState, so that values and bounds compare exactly.
struct CoverageProblem {
  using Benefit = CoverState::Benefit;

  Incidence incidence;
  std::vector<Benefit> weights;          ///< one a column, > 0; the sum is below 2^52
  std::vector<std::size_t> row_numbers;  ///< of each row in the instance, ascending

  /// The instance without dominated rows, columns that have become equal merged.
  explicit CoverageProblem(const CoverInstance& instance);
  /// The problem with these rows (ascending) only; columns that have become equal merged, columns
  /// that no row is left for gone.
  CoverageProblem(const CoverageProblem& whole, std::span<const std::uint32_t> rows);

  Benefit total() const;
  Benefit covered(std::span<const std::uint32_t> rows) const;
};

/// What prices u_c of columns, 0 <= u_c <= w_c, prove about a part of the tree (decisions about
/// rows as in optim/cover_dual.h): with x_r in {0, 1} the chosen rows and z_c <= sum_{r covers c}
/// x_r,
///
///   sum_c w_c z_c <= sum_c (w_c - u_c) z_c + sum_c u_c sum_{r covers c} x_r
///                 <= (weight of covered columns) + sum_{c in U} (w_c - u_c) + sum_{free r} x_r
///                 s_r,
///
/// U the columns that no chosen row covers, s_r the sum of u_c over those of them that r covers. At
/// most k - |chosen| free rows follow, so the last sum is at most that of as many largest s_r.
/// Integer prices of any origin give an exact bound.
struct CoverageValue {
  CoverState::Benefit value = 0;                ///< no k rows in this part cover more
  std::vector<CoverState::Benefit> row_prices;  ///< s_r
  /// Least price among the rows that count, and greatest among the free rows that do not: choosing
  /// another free row costs the one, excluding one that counts brings in the other. Where the bound
  /// is no more than the total weight they say nothing: 0 and the greatest number.
  CoverState::Benefit least_counted = 0;
  CoverState::Benefit next = std::numeric_limits<CoverState::Benefit>::max();
};

/// Prices are cut to [0, w_c]. Requires state.chosen <= k. Cost: O(#ones + #rows log #rows).
CoverageValue coverage_value(const CoverageProblem& problem, std::span<const double> prices,
                             double unit, const CoverNodeState& state, std::size_t k);

/// A benefit in percent of the total weight, rounded upward: no set of rows whose benefit is at
/// most that covers a greater share of the weight, in exact arithmetic or as covered_percent()
/// computes it.
double percent_at_most(const CoverInstance& instance, CoverState::Benefit benefit);

}  // namespace viewcover
