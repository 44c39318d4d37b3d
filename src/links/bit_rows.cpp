#include "links/bit_rows.h"

#include <cassert>

namespace viewcover {

void BitRows::set_range(std::size_t row, std::size_t first, std::size_t count) {
  assert(row < rows_ && first + count <= columns_);
  if (count == 0) return;
  Word* const words = bits_.data() + row * words_;
  const std::size_t last = first + count - 1;
  const std::size_t first_word = first / 64, last_word = last / 64;
  const Word from_first = ~Word{0} << (first % 64);
  const Word up_to_last = ~Word{0} >> (63 - last % 64);
  if (first_word == last_word) {
    words[first_word] |= from_first & up_to_last;
    return;
  }
  words[first_word] |= from_first;
  for (std::size_t w = first_word + 1; w < last_word; ++w) words[w] = ~Word{0};
  words[last_word] |= up_to_last;
}

std::vector<BitRows::Word> BitRows::union_of(std::span<const std::size_t> rows) const {
  std::vector<Word> united(words_, 0);
  for (const std::size_t r : rows) {
    const std::span<const Word> words = row(r);
    for (std::size_t w = 0; w < words_; ++w) united[w] |= words[w];
  }
  return united;
}

std::vector<BitRows::Word> BitRows::union_of_all() const {
  std::vector<Word> united(words_, 0);
  for (std::size_t r = 0; r < rows_; ++r) {
    const std::span<const Word> words = row(r);
    for (std::size_t w = 0; w < words_; ++w) united[w] |= words[w];
  }
  return united;
}

std::vector<std::uint32_t> count_in_columns(const BitRows& bits) {
  std::vector<std::uint32_t> counts(bits.columns());
  for (std::size_t row = 0; row < bits.rows(); ++row) {
    for_each_bit(bits.row(row), [&](std::size_t column) { ++counts[column]; });
  }
  return counts;
}

std::size_t count_bits(std::span<const BitRows::Word> words) {
  std::size_t count = 0;
  for (const BitRows::Word word : words) count += static_cast<std::size_t>(std::popcount(word));
  return count;
}

double weight_of(std::span<const BitRows::Word> words, std::span<const double> weights) {
  double sum = 0;
  for_each_bit(words, [&](std::size_t column) { sum += weights[column]; });
  return sum;
}

}  // namespace viewcover
