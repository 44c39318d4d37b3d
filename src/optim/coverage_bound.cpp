#include "optim/coverage_bound.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "optim/reductions.h"

namespace viewcover {

using Benefit = CoverState::Benefit;
using Row = CoverNodeState::Row;

namespace {

/// Columns by the rows that cover them; weights of equal ones are summed.
class MergedColumns {
 public:
  void add(std::vector<std::uint32_t> rows, Benefit weight) {
    const auto [same, is_new] = place_.emplace(rows, rows_.size());
    if (is_new) {
      rows_.push_back(std::move(rows));
      weights_.push_back(0);
    }
    weights_[same->second] += weight;
  }
  void move_to(CoverageProblem& problem) && {
    problem.incidence = Incidence(problem.row_numbers.size(), rows_);
    problem.weights = std::move(weights_);
  }

 private:
  std::map<std::vector<std::uint32_t>, std::size_t> place_;
  std::vector<std::vector<std::uint32_t>> rows_;
  std::vector<Benefit> weights_;
};

}  // namespace

CoverageProblem::CoverageProblem(const CoverInstance& instance) {
  const CoverState state(instance);
  const std::vector<std::uint32_t> rows = rows_without_dominated(instance.rows());
  row_numbers.assign(rows.begin(), rows.end());
  MergedColumns columns;
  for (std::size_t column = 0; column < instance.rows().columns(); ++column) {
    std::vector<std::uint32_t> covering;
    for (std::uint32_t row = 0; row < rows.size(); ++row) {
      if (instance.rows().test(rows[row], column)) covering.push_back(row);
    }
    columns.add(std::move(covering), state.weights()[column]);
  }
  std::move(columns).move_to(*this);
}

CoverageProblem::CoverageProblem(const CoverageProblem& whole,
                                 std::span<const std::uint32_t> rows) {
  constexpr auto kGone = static_cast<std::uint32_t>(-1);
  std::vector<std::uint32_t> number(whole.incidence.row_count(), kGone);
  for (std::uint32_t row = 0; row < rows.size(); ++row) {
    number[rows[row]] = row;
    row_numbers.push_back(whole.row_numbers[rows[row]]);
  }
  MergedColumns columns;
  for (std::size_t column = 0; column < whole.weights.size(); ++column) {
    std::vector<std::uint32_t> covering;
    for (const std::uint32_t row : whole.incidence.rows_of(column)) {
      if (number[row] != kGone) covering.push_back(number[row]);
    }
    if (!covering.empty()) columns.add(std::move(covering), whole.weights[column]);
  }
  std::move(columns).move_to(*this);
}

Benefit CoverageProblem::total() const {
  return std::accumulate(weights.begin(), weights.end(), Benefit{0});
}

Benefit CoverageProblem::covered(std::span<const std::uint32_t> rows) const {
  std::vector<bool> is_covered(weights.size(), false);
  Benefit sum = 0;
  for (const std::uint32_t row : rows) {
    for (const std::uint32_t column : incidence.columns_of(row)) {
      if (!is_covered[column]) sum += weights[column];
      is_covered[column] = true;
    }
  }
  return sum;
}

CoverageValue coverage_value(const CoverageProblem& problem, std::span<const double> prices,
                             double unit, const CoverNodeState& state, std::size_t k) {
  assert(state.chosen <= k);
  CoverageValue result;
  result.row_prices.assign(problem.incidence.row_count(), 0);
  Benefit sum = 0;
  for (std::size_t column = 0; column < problem.weights.size(); ++column) {
    const Benefit weight = problem.weights[column];
    if (state.times_covered[column] > 0) {
      sum += weight;
      continue;
    }
    const double units = prices[column] * unit;
    const Benefit price = !(units > 0)                           ? 0
                          : units >= static_cast<double>(weight) ? weight
                                                                 : std::llround(units);
    sum += weight - price;
    for (const std::uint32_t row : problem.incidence.rows_of(column)) {
      result.row_prices[row] += price;
    }
  }
  std::vector<Benefit> free_prices;
  for (std::size_t row = 0; row < result.row_prices.size(); ++row) {
    if (state.rows[row] == Row::kFree) free_prices.push_back(result.row_prices[row]);
  }
  std::ranges::sort(free_prices, std::greater<>());
  const std::size_t count = std::min(k - state.chosen, free_prices.size());
  const Benefit total = problem.total();
  for (std::size_t i = 0; i < count && sum <= total; ++i) sum += free_prices[i];
  result.value = std::min(sum, total);
  if (sum > total) return result;
  if (count > 0) result.least_counted = free_prices[count - 1];
  result.next = count < free_prices.size() ? free_prices[count] : 0;
  return result;
}

double percent_at_most(const CoverInstance& instance, Benefit benefit) {
  if (instance.total_weight() == 0) return 100;
  // CoverState rounds fl(w_c / T) 2^50, T the computed total, to the nearest integer and at least
  // 1: the share is at most half a unit more than the benefit of the column, but for a relative
  // 2^-53.
  const double columns = static_cast<double>(instance.weights().size());
  const double share = std::ldexp(static_cast<double>(benefit) + columns / 2, -50);
  // As in upper_bound_percent(): T and the covered weight are sums of at most #columns terms.
  const double factor = 1 + (2 * columns + 16) * std::numeric_limits<double>::epsilon();
  return std::min(100.0, 100 * share * factor);
}

}  // namespace viewcover
