#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "links/bit_rows.h"

namespace viewcover {

/// A 0/1 matrix as lists: the columns of every row and the rows of every column, ascending.
struct Incidence {
  std::vector<std::vector<std::uint32_t>> rows;     ///< columns of each row
  std::vector<std::vector<std::uint32_t>> columns;  ///< rows of each column

  Incidence() = default;
  /// Cost: O(#rows x #columns / 64 + #ones).
  explicit Incidence(const BitRows& matrix) : rows(matrix.rows()), columns(matrix.columns()) {
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for_each_bit(matrix.row(row), [&](std::size_t column) {
        rows[row].push_back(static_cast<std::uint32_t>(column));
        columns[column].push_back(static_cast<std::uint32_t>(row));
      });
    }
  }

  BitRows bits() const {
    BitRows matrix(rows.size(), columns.size());
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (const std::uint32_t column : rows[row]) matrix.set(row, column);
    }
    return matrix;
  }
};

}  // namespace viewcover
