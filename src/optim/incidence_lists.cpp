#include "optim/incidence_lists.h"

#include <numeric>

namespace viewcover {

IncidenceLists::IncidenceLists(const BitRows& matrix)
    : column_begin_(1, 0), row_begin_(matrix.columns() + 1, 0) {
  for (std::size_t row = 0; row < matrix.rows(); ++row) {
    for_each_bit(matrix.row(row), [&](std::size_t column) {
      columns_.push_back(static_cast<Index>(column));
      ++row_begin_[column + 1];
    });
    column_begin_.push_back(columns_.size());
  }
  std::partial_sum(row_begin_.begin(), row_begin_.end(), row_begin_.begin());
  rows_.resize(columns_.size());
  std::vector<std::size_t> next(row_begin_.begin(), row_begin_.end() - 1);
  for (Index row = 0; row < row_count(); ++row) {
    for (const Index column : columns_of(row)) rows_[next[column]++] = row;
  }
}

}  // namespace viewcover
