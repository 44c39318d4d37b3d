#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "links/bit_rows.h"

namespace viewcover {

/// A sparse 0/1 matrix as lists: the columns of each row and the rows of each column, ascending.
/// Immutable; concurrent reads are safe.
class Incidence {
 public:
  using Index = std::uint32_t;

  Incidence() = default;  ///< no rows, no columns
  /// Cost: O(#rows x #columns / 64 + #ones).
  explicit Incidence(const BitRows& matrix);
  /// From the rows of each column, ascending. Cost: O(#rows + #columns + #ones).
  Incidence(std::size_t row_count, std::span<const std::vector<Index>> rows_of_columns);

  std::size_t row_count() const { return column_begin_.size() - 1; }
  std::size_t column_count() const { return row_begin_.size() - 1; }
  std::size_t ones() const { return columns_.size(); }
  std::span<const Index> columns_of(std::size_t row) const {
    return of(columns_, column_begin_, row);
  }
  std::span<const Index> rows_of(std::size_t column) const { return of(rows_, row_begin_, column); }

  BitRows bits() const;

 private:
  static std::span<const Index> of(const std::vector<Index>& entries,
                                   const std::vector<std::size_t>& begin, std::size_t list) {
    return {entries.data() + begin[list], begin[list + 1] - begin[list]};
  }

  std::vector<Index> columns_;  ///< one row after the other
  std::vector<std::size_t> column_begin_ = {0};
  std::vector<Index> rows_;  ///< one column after the other
  std::vector<std::size_t> row_begin_ = {0};
};

}  // namespace viewcover
