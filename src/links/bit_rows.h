#pragma once

#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace viewcover {

/// A dense 0/1 matrix, one bit row after the other: #rows x #columns bits, rows padded to whole
/// 64-bit words with zeros. Concurrent reads are safe.
class BitRows {
 public:
  using Word = std::uint64_t;

  BitRows() = default;
  BitRows(std::size_t rows, std::size_t columns)
      : rows_(rows), columns_(columns), words_((columns + 63) / 64), bits_(rows * words_) {}

  std::size_t rows() const { return rows_; }
  std::size_t columns() const { return columns_; }
  std::size_t words_per_row() const { return words_; }

  bool test(std::size_t row, std::size_t column) const {
    return bits_[row * words_ + column / 64] >> (column % 64) & 1;
  }
  void set(std::size_t row, std::size_t column) {
    bits_[row * words_ + column / 64] |= Word{1} << (column % 64);
  }
  /// Sets the columns [first, first + count) of a row.
  void set_range(std::size_t row, std::size_t first, std::size_t count);

  std::span<const Word> row(std::size_t row) const { return {bits_.data() + row * words_, words_}; }
  std::span<Word> row(std::size_t row) { return {bits_.data() + row * words_, words_}; }

  /// Bits set in any of the given rows.
  std::vector<Word> union_of(std::span<const std::size_t> rows) const;
  /// Bits set in any row: the total set.
  std::vector<Word> union_of_all() const;

 private:
  std::size_t rows_ = 0, columns_ = 0, words_ = 0;
  std::vector<Word> bits_;
};

/// Calls visit(column) for every set bit, ascending.
template <class Visit>
void for_each_bit(std::span<const BitRows::Word> words, Visit&& visit) {
  for (std::size_t w = 0; w < words.size(); ++w) {
    for (BitRows::Word word = words[w]; word != 0; word &= word - 1) {
      visit(w * 64 + static_cast<std::size_t>(std::countr_zero(word)));
    }
  }
}

std::size_t count_bits(std::span<const BitRows::Word> words);
/// How many rows have each column set.
std::vector<std::uint32_t> count_in_columns(const BitRows& bits);
/// Sum of weights[column] over the set bits, in column order.
double weight_of(std::span<const BitRows::Word> words, std::span<const double> weights);

}  // namespace viewcover
