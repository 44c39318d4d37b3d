#include "optim/cover_state.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace viewcover {
namespace {

constexpr BitRows::Word bit(std::uint32_t column) { return BitRows::Word{1} << (column % 64); }

}  // namespace

CoverState::CoverState(const CoverInstance& instance)
    : instance_(&instance),
      rows_(instance.rows().rows()),
      columns_(instance.rows().columns()),
      times_covered_(instance.rows().columns(), 0),
      uncovered_bits_(instance.rows().union_of_all()),
      covered_once_bits_(instance.rows().words_per_row(), 0),
      chosen_(instance.rows().rows(), false),
      uncovered_(instance.rows().columns()),
      place_(instance.rows().columns()) {
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    for_each_bit(instance.rows().row(row), [&](std::size_t column) {
      rows_[row].push_back(static_cast<std::uint32_t>(column));
      columns_[column].push_back(static_cast<std::uint32_t>(row));
    });
  }
  // Fixed-point bits of the total weight. With the least unit for each of up to 2^32 columns added,
  // sums stay below 2^51, far from the limits of 64-bit integers.
  constexpr int kTotalBits = 50;
  weights_.reserve(columns_.size());
  for (const double weight : instance.weights()) {
    // A total of 0 leaves one unit a column: the number of columns is the benefit.
    const double share = instance.total_weight() > 0 ? weight / instance.total_weight() : 0;
    weights_.push_back(std::max<Benefit>(1, std::llround(std::ldexp(share, kTotalBits))));
  }
  total_ = std::accumulate(weights_.begin(), weights_.end(), Benefit{0});
  std::iota(uncovered_.begin(), uncovered_.end(), 0u);
  std::iota(place_.begin(), place_.end(), 0u);
}

void CoverState::add(std::size_t row) {
  assert(!chosen_[row]);
  chosen_[row] = true;
  for (const std::uint32_t column : rows_[row]) {
    const std::uint32_t times = ++times_covered_[column];
    if (times > 2) continue;
    covered_once_bits_[column / 64] ^= bit(column);
    if (times == 2) continue;
    uncovered_bits_[column / 64] ^= bit(column);
    benefit_ += weights_[column];
    const std::uint32_t moved = uncovered_.back();
    uncovered_[place_[column]] = moved;
    place_[moved] = place_[column];
    uncovered_.pop_back();
  }
}

void CoverState::remove(std::size_t row) {
  assert(chosen_[row]);
  chosen_[row] = false;
  for (const std::uint32_t column : rows_[row]) {
    const std::uint32_t times = --times_covered_[column];
    if (times > 1) continue;
    covered_once_bits_[column / 64] ^= bit(column);
    if (times == 1) continue;
    uncovered_bits_[column / 64] ^= bit(column);
    benefit_ -= weights_[column];
    place_[column] = static_cast<std::uint32_t>(uncovered_.size());
    uncovered_.push_back(column);
  }
}

void CoverState::assign(std::span<const std::size_t> rows) {
  for (const std::size_t row : chosen()) {
    if (std::ranges::find(rows, row) == rows.end()) remove(row);
  }
  for (const std::size_t row : rows) {
    if (!chosen_[row]) add(row);
  }
}

CoverState::Benefit CoverState::gain(std::size_t row) {
  ++evaluations_;
  const std::span<const BitRows::Word> words = instance_->rows().row(row);
  return weight_where([&](std::size_t w) { return words[w] & uncovered_bits_[w]; });
}

CoverState::Benefit CoverState::loss(std::size_t row) const {
  assert(chosen_[row]);
  const std::span<const BitRows::Word> words = instance_->rows().row(row);
  return weight_where([&](std::size_t w) { return words[w] & covered_once_bits_[w]; });
}

CoverState::Benefit CoverState::gain_without(std::size_t row, std::size_t without) {
  assert(!chosen_[row] && chosen_[without]);
  ++evaluations_;
  const std::span<const BitRows::Word> words = instance_->rows().row(row);
  const std::span<const BitRows::Word> left = instance_->rows().row(without);
  return weight_where([&](std::size_t w) {
    return words[w] & (uncovered_bits_[w] | (covered_once_bits_[w] & left[w]));
  });
}

template <class WordAt>
CoverState::Benefit CoverState::weight_where(WordAt&& word_at) const {
  Benefit sum = 0;
  for (std::size_t w = 0; w < uncovered_bits_.size(); ++w) {
    for (BitRows::Word word = word_at(w); word != 0; word &= word - 1) {
      sum += weights_[w * 64 + static_cast<std::size_t>(std::countr_zero(word))];
    }
  }
  return sum;
}

std::vector<std::size_t> CoverState::chosen() const {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < chosen_.size(); ++row) {
    if (chosen_[row]) rows.push_back(row);
  }
  return rows;
}

bool CoverState::check_consistency() const {
  const BitRows& matrix = instance_->rows();
  std::vector<std::uint32_t> times_covered(matrix.columns(), 0);
  for (std::size_t row = 0; row < matrix.rows(); ++row) {
    if (!chosen_[row]) continue;
    for_each_bit(matrix.row(row), [&](std::size_t column) { ++times_covered[column]; });
  }
  Benefit benefit = 0;
  std::size_t uncovered = 0;
  for (std::size_t column = 0; column < times_covered.size(); ++column) {
    const BitRows::Word mask = bit(static_cast<std::uint32_t>(column));
    if (((uncovered_bits_[column / 64] & mask) != 0) != (times_covered[column] == 0)) return false;
    if (((covered_once_bits_[column / 64] & mask) != 0) != (times_covered[column] == 1)) {
      return false;
    }
    if (times_covered[column] > 0) {
      benefit += weights_[column];
    } else {
      ++uncovered;
      if (place_[column] >= uncovered_.size() || uncovered_[place_[column]] != column) return false;
    }
  }
  return times_covered == times_covered_ && benefit == benefit_ && uncovered == uncovered_.size() &&
         covers_all() == (benefit_ == total_) && covers_all() == instance_->covers_all(chosen());
}

}  // namespace viewcover
