#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "links/bit_rows.h"

namespace viewcover {

// Single rows of bits, in words as BitRows has them.

inline bool has_column(std::span<const BitRows::Word> row, std::size_t column) {
  return row[column / 64] >> (column % 64) & 1;
}
inline void add_column(std::span<BitRows::Word> row, std::size_t column) {
  row[column / 64] |= BitRows::Word{1} << (column % 64);
}
inline void remove_columns(std::span<BitRows::Word> row, std::span<const BitRows::Word> columns) {
  for (std::size_t w = 0; w < row.size(); ++w) row[w] &= ~columns[w];
}
inline bool is_subset(std::span<const BitRows::Word> inner, std::span<const BitRows::Word> outer) {
  return std::equal(inner.begin(), inner.end(), outer.begin(), outer.end(),
                    [](BitRows::Word a, BitRows::Word b) { return (a & ~b) == 0; });
}

}  // namespace viewcover
