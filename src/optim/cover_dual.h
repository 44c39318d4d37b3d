#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "optim/incidence.h"

namespace viewcover {

/// Prices of columns as fractions n_c / D, from which a lower bound follows in integers.
///
/// Let F1 be rows that are chosen, F0 rows that are not, and U the columns that no row of F1
/// covers. For any integers n_c >= 0 and D > 0 every cover x in that part of the tree satisfies
///
///   D sum_r x_r >= D sum_r x_r + sum_{c in U} n_c (1 - sum_{r covers c} x_r)
///               >= D |F1| + sum_{c in U} n_c + sum_{free r} min(0, D - s_r),
///
/// s_r the sum of n_c over the columns of U that r covers: the Lagrangian bound (Geoffrion 1974).
/// It needs no feasible dual: prices too high for a row are paid for in the last sum, so prices
/// rounded from floating point in any way give a theorem. Any dual may be used anywhere in the
/// tree.
struct CoverDual {
  std::int64_t denominator = 1;
  std::vector<std::pair<std::uint32_t, std::int64_t>>
      prices;  ///< column, n_c > 0; columns ascending
};

/// A part of the tree: what is decided about every row, and the columns that chosen rows cover.
struct CoverNodeState {
  enum class Row : std::uint8_t { kFree, kChosen, kExcluded };

  explicit CoverNodeState(const Incidence& incidence)
      : rows(incidence.row_count(), Row::kFree), times_covered(incidence.column_count(), 0) {}
  void choose(const Incidence& incidence, std::uint32_t row) {
    rows[row] = Row::kChosen;
    ++chosen;
    for (const std::uint32_t column : incidence.columns_of(row)) ++times_covered[column];
  }
  /// Requires a chosen row; it is free again.
  void undo_choice(const Incidence& incidence, std::uint32_t row) {
    rows[row] = Row::kFree;
    --chosen;
    for (const std::uint32_t column : incidence.columns_of(row)) --times_covered[column];
  }

  std::vector<Row> rows;
  std::vector<std::uint32_t> times_covered;  ///< by chosen rows
  std::size_t chosen = 0;
};

/// What a dual proves about a part of the tree, in units of 1 / denominator.
struct CoverDualValue {
  std::int64_t value = 0;  ///< no cover has fewer than value / denominator rows
  std::int64_t denominator = 1;
  std::vector<std::int64_t> row_prices;  ///< s_r

  std::size_t bound() const {  ///< rounded up to whole rows
    return value <= 0 ? 0 : static_cast<std::size_t>((value + denominator - 1) / denominator);
  }
  /// What it proves once the free row is chosen too.
  std::int64_t value_with(std::size_t row) const {
    return value + (denominator > row_prices[row] ? denominator - row_prices[row] : 0);
  }
};

/// Largest denominator for which no sum in value_of() can leave 64-bit integers.
std::int64_t largest_denominator(const Incidence& incidence);

/// The prices nearest to `prices` (one a column; not finite or below 0 counts as 0, above 1 as 1)
/// with a denominator; columns that are covered already get none.
CoverDual rounded_dual(std::span<const double> prices, const CoverNodeState& state,
                       std::int64_t denominator);

/// Exact. Requires a denominator of at most largest_denominator() and prices of at most 1.
/// Cost: O(ones of the columns with a price + #rows).
CoverDualValue value_of(const CoverDual& dual, const Incidence& incidence,
                        const CoverNodeState& state);

}  // namespace viewcover
