#include "optim/incidence.h"

namespace viewcover {
namespace {

/// The same entries by their values: `lists` names where each list of `entries` begins, `begin`
/// gets where each of `count` lists of the result begins.
std::vector<Incidence::Index> transposed(const std::vector<Incidence::Index>& entries,
                                         const std::vector<std::size_t>& lists, std::size_t count,
                                         std::vector<std::size_t>& begin) {
  begin.assign(count + 1, 0);
  for (const Incidence::Index value : entries) ++begin[value + 1];
  for (std::size_t value = 0; value < count; ++value) begin[value + 1] += begin[value];
  std::vector<Incidence::Index> result(entries.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (Incidence::Index list = 0; list + 1 < lists.size(); ++list) {
    for (std::size_t i = lists[list]; i < lists[list + 1]; ++i) result[next[entries[i]]++] = list;
  }
  return result;
}

}  // namespace

Incidence::Incidence(const BitRows& matrix) {
  for (std::size_t row = 0; row < matrix.rows(); ++row) {
    for_each_bit(matrix.row(row),
                 [&](std::size_t column) { columns_.push_back(static_cast<Index>(column)); });
    column_begin_.push_back(columns_.size());
  }
  rows_ = transposed(columns_, column_begin_, matrix.columns(), row_begin_);
}

Incidence::Incidence(std::size_t row_count, std::span<const std::vector<Index>> rows_of_columns) {
  for (const std::vector<Index>& rows : rows_of_columns) {
    rows_.insert(rows_.end(), rows.begin(), rows.end());
    row_begin_.push_back(rows_.size());
  }
  columns_ = transposed(rows_, row_begin_, row_count, column_begin_);
}

BitRows Incidence::bits() const {
  BitRows matrix(row_count(), column_count());
  for (std::size_t row = 0; row < row_count(); ++row) {
    for (const Index column : columns_of(row)) matrix.set(row, column);
  }
  return matrix;
}

}  // namespace viewcover
