#include "optim/cover_programme.h"

#include <array>
#include <cmath>

namespace viewcover {
namespace {

using Row = CoverNodeState::Row;

/// Denominators tried for rounded prices, least first: small ones give short proofs, and many basic
/// solutions are fractions over small numbers.
constexpr std::array<std::int64_t, 4> kDenominators = {60, 2520, 1 << 20, std::int64_t{1} << 36};
/// What rounding in the programme's value may hide of a whole number; a hint, nothing depends on
/// it.
constexpr double kTolerance = 1e-6;

LinearProgram make_programme(const Incidence& incidence) {
  std::vector<LinearProgram::Variable> variables;
  for (std::size_t row = 0; row < incidence.row_count(); ++row) {
    const std::span<const std::uint32_t> columns = incidence.columns_of(row);
    variables.push_back({.cost = 1,
                         .rows = {columns.begin(), columns.end()},
                         .coefficients = std::vector<double>(columns.size(), 1.0)});
  }
  return LinearProgram(variables, std::vector<double>(incidence.column_count(), 1.0));
}

}  // namespace

CoverProgramme::CoverProgramme(const Incidence& incidence)
    : incidence_(incidence),
      programme_(make_programme(incidence)),
      rows_(incidence.row_count(), Row::kFree) {}

CoverProgramme::Status CoverProgramme::solve(const CoverNodeState& state, SearchLimits& limits,
                                             double limit) {
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    if (rows_[row] == state.rows[row]) continue;
    rows_[row] = state.rows[row];
    const double lower = rows_[row] == Row::kChosen ? 1 : 0;
    programme_.set_bounds(row, lower, rows_[row] == Row::kFree ? LinearProgram::kInfinity : lower);
  }
  Status status = programme_.solve_dual(limits, limit);
  if (status == Status::kNone && !limits.expired()) status = programme_.solve_primal(limits);
  return status;
}

CoverDualValue CoverProgramme::improve(CoverDual& dual, const CoverNodeState& state) const {
  const std::int64_t largest = largest_denominator(incidence_);
  const double hoped = std::ceil(programme_.objective() - kTolerance);
  CoverDualValue best_value = value_of(dual, incidence_, state);
  for (const std::int64_t denominator : kDenominators) {
    if (denominator > largest) break;
    CoverDual rounded = rounded_dual(programme_.prices(), state, denominator);
    CoverDualValue value = value_of(rounded, incidence_, state);
    const bool enough = static_cast<double>(value.bound()) >= hoped;
    if (value.bound() >= best_value.bound()) {
      dual = std::move(rounded);
      best_value = std::move(value);
    }
    if (enough) break;
  }
  return best_value;
}

}  // namespace viewcover
