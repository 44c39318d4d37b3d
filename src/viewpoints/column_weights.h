#pragma once

#include <bit>
#include <span>
#include <utility>
#include <vector>

#include "viewpoints/column_bits.h"

namespace viewcover {

/// What seeing each column is worth; columns worth nothing need not be looked at.
struct ColumnWeights {
  std::vector<double> weights;      ///< one a column, >= 0
  std::vector<BitRows::Word> mask;  ///< the columns with a weight > 0

  explicit ColumnWeights(std::vector<double> given)
      : weights(std::move(given)), mask((weights.size() + 63) / 64, 0) {
    for (std::size_t column = 0; column < weights.size(); ++column) {
      if (weights[column] > 0) add_column(mask, column);
    }
  }
  /// The weights of some columns, 0 for the others.
  ColumnWeights(std::span<const BitRows::Word> columns, std::span<const double> all)
      : weights(all.size(), 0.0), mask(columns.size(), 0) {
    for_each_bit(columns, [&](std::size_t column) {
      if (!(all[column] > 0)) return;
      weights[column] = all[column];
      add_column(mask, column);
    });
  }

  /// Of the columns of a row.
  double of(std::span<const BitRows::Word> row) const {
    double sum = 0;
    for (std::size_t w = 0; w < mask.size(); ++w) {
      for (BitRows::Word word = row[w] & mask[w]; word != 0; word &= word - 1) {
        sum += weights[w * 64 + static_cast<std::size_t>(std::countr_zero(word))];
      }
    }
    return sum;
  }
};

}  // namespace viewcover
