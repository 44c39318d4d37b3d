#include "optim/optimal_covers.h"

#include <algorithm>

#include "optim/cover_programme.h"
#include "optim/reductions.h"

namespace viewcover {
namespace {

using Row = CoverNodeState::Row;

class Enumeration {
 public:
  Enumeration(const Incidence& incidence, std::size_t size, std::size_t most, SearchLimits& limits)
      : incidence_(incidence),
        size_(size),
        most_(most),
        limits_(limits),
        programme_(incidence),
        state_(incidence) {}

  OptimalCovers run() && {
    result_.complete = visit();
    return std::move(result_);
  }

 private:
  /// False if the search was cut short.
  bool visit() {
    if (limits_.expired()) return false;
    std::vector<std::uint32_t> rows;
    switch (next_column(rows)) {
      case Next::kAllCovered:
        if (state_.chosen != size_) return true;  // nothing smaller there is, nothing to add
        if (result_.covers.size() == most_) return false;
        keep();
        return true;
      case Next::kHopeless:
        return true;
      case Next::kColumn:
        break;
    }
    if (needs_more_rows()) return true;
    bool complete = true;
    for (const std::uint32_t row : rows) {
      state_.choose(incidence_, row);
      complete = visit();
      state_.undo_choice(incidence_, row);
      if (!complete) break;
      state_.rows[row] = Row::kExcluded;
    }
    for (const std::uint32_t row : rows) state_.rows[row] = Row::kFree;
    return complete;
  }

  enum class Next { kAllCovered, kHopeless, kColumn };
  /// The free rows of the uncovered column that has the fewest.
  Next next_column(std::vector<std::uint32_t>& rows) const {
    bool found = false;
    std::vector<std::uint32_t> free_rows;
    for (std::size_t column = 0; column < incidence_.column_count(); ++column) {
      if (state_.times_covered[column] > 0) continue;
      free_rows.clear();
      for (const std::uint32_t row : incidence_.rows_of(column)) {
        if (state_.rows[row] == Row::kFree) free_rows.push_back(row);
      }
      if (!found || free_rows.size() < rows.size()) rows = free_rows;
      found = true;
    }
    if (!found) return Next::kAllCovered;
    return rows.empty() || state_.chosen == size_ ? Next::kHopeless : Next::kColumn;
  }

  bool needs_more_rows() {
    if (programme_.solve(state_, limits_) == LinearProgram::Status::kNone) return false;
    CoverDual dual;
    return programme_.improve(dual, state_).bound() > size_;
  }

  void keep() {
    std::vector<std::size_t>& cover = result_.covers.emplace_back();
    for (std::size_t row = 0; row < state_.rows.size(); ++row) {
      if (state_.rows[row] == Row::kChosen) cover.push_back(row);
    }
  }

  const Incidence& incidence_;
  std::size_t size_, most_;
  SearchLimits& limits_;
  CoverProgramme programme_;
  CoverNodeState state_;
  OptimalCovers result_;
};

}  // namespace

OptimalCovers covers_of_size(const BitRows& matrix, std::size_t size, std::size_t most,
                             SearchLimits& limits) {
  const std::vector<std::uint32_t> columns = columns_without_implied(matrix);
  std::vector<std::vector<std::uint32_t>> rows_of_columns;
  for (const std::uint32_t column : columns) {
    rows_of_columns.emplace_back();
    for (std::uint32_t row = 0; row < matrix.rows(); ++row) {
      if (matrix.test(row, column)) rows_of_columns.back().push_back(row);
    }
  }
  const Incidence incidence(matrix.rows(), rows_of_columns);
  return Enumeration(incidence, size, most, limits).run();
}

}  // namespace viewcover
