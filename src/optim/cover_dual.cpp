#include "optim/cover_dual.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace viewcover {

std::int64_t largest_denominator(const Incidence& incidence) {
  // |value| <= D #rows + D #columns + #rows (D #columns), each of the three below 2^60.
  const auto rows = static_cast<std::int64_t>(incidence.row_count()) + 1;
  const auto columns = static_cast<std::int64_t>(incidence.column_count()) + 1;
  return (std::int64_t{1} << 60) / (rows * columns);
}

CoverDual rounded_dual(std::span<const double> prices, const CoverNodeState& state,
                       std::int64_t denominator) {
  CoverDual dual{denominator, {}};
  for (std::uint32_t column = 0; column < prices.size(); ++column) {
    if (state.times_covered[column] > 0 || !(prices[column] > 0)) continue;
    const double price = std::min(prices[column], 1.0);
    const std::int64_t numerator =
        std::min<std::int64_t>(denominator, std::llround(price * static_cast<double>(denominator)));
    if (numerator > 0) dual.prices.emplace_back(column, numerator);
  }
  return dual;
}

CoverDualValue value_of(const CoverDual& dual, const Incidence& incidence,
                        const CoverNodeState& state) {
  assert(dual.denominator <= largest_denominator(incidence));
  CoverDualValue value;
  value.denominator = dual.denominator;
  value.row_prices.assign(incidence.row_count(), 0);
  value.value = dual.denominator * static_cast<std::int64_t>(state.chosen);
  for (const auto& [column, numerator] : dual.prices) {
    if (state.times_covered[column] > 0) continue;
    value.value += numerator;
    for (const std::uint32_t row : incidence.rows_of(column)) value.row_prices[row] += numerator;
  }
  for (std::size_t row = 0; row < incidence.row_count(); ++row) {
    if (state.rows[row] != CoverNodeState::Row::kFree) continue;
    value.value += std::min<std::int64_t>(0, dual.denominator - value.row_prices[row]);
  }
  return value;
}

}  // namespace viewcover
