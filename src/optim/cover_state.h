#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "optim/region_cover.h"

namespace viewcover {

/// A set of chosen rows with the number of times every column is covered: what all methods that
/// change a cover row by row work on.
///
/// Benefits are integers, so that they do not depend on the order of changes: a column's weight in
/// units of 2^-50 of the total weight, rounded, and at least one unit. Two sets that differ by less
/// than (#columns / 2) units may compare either way; columns without weight decide between sets of
/// equal weight, and total() is reached iff every column is covered.
/// Not safe for concurrent use; a copy costs O(#ones).
class CoverState {
 public:
  using Benefit = std::int64_t;

  /// No row is chosen. The instance must outlive the state.
  explicit CoverState(const CoverInstance& instance);

  /// Requires a row that is not chosen. Cost: O(ones of the row).
  void add(std::size_t row);
  /// Requires a chosen row.
  void remove(std::size_t row);
  /// Makes exactly these rows, without duplicates, the chosen ones.
  void assign(std::span<const std::size_t> rows);

  /// What adding a row would add to benefit(); counts as one evaluation. Cost: O(#columns / 64 +
  /// columns it would add), in the manner of what follows.
  Benefit gain(std::size_t row);
  /// What removing a chosen row would take from benefit().
  Benefit loss(std::size_t row) const;
  /// What adding `row` would add to benefit() once the chosen row `without` is removed; counts as
  /// one evaluation. The exchange changes the benefit by this less loss(without).
  Benefit gain_without(std::size_t row, std::size_t without);

  bool contains(std::size_t row) const { return chosen_[row]; }
  std::vector<std::size_t> chosen() const;  ///< ascending
  Benefit benefit() const { return benefit_; }
  Benefit total() const { return total_; }
  std::span<const Benefit> weights() const { return weights_; }  ///< benefit of each column
  bool covers_all() const { return uncovered_.empty(); }
  /// In no particular order, but the same order after the same calls.
  std::span<const std::uint32_t> uncovered() const { return uncovered_; }
  std::uint64_t evaluations() const { return evaluations_; }

  std::size_t row_count() const { return chosen_.size(); }
  std::span<const std::uint32_t> rows_of(std::size_t column) const { return columns_[column]; }

  /// True iff everything kept incrementally equals what the chosen rows and the instance's bits
  /// give when recomputed from scratch.
  bool check_consistency() const;

 private:
  /// Sum of the weights of the bits of word_at(0), word_at(1), ...
  template <class WordAt>
  Benefit weight_where(WordAt&& word_at) const;

  const CoverInstance* instance_;
  std::vector<std::vector<std::uint32_t>> rows_;     ///< columns of each row
  std::vector<std::vector<std::uint32_t>> columns_;  ///< rows of each column
  std::vector<Benefit> weights_;
  std::vector<std::uint32_t> times_covered_;
  std::vector<BitRows::Word> uncovered_bits_;     ///< columns covered by no chosen row
  std::vector<BitRows::Word> covered_once_bits_;  ///< columns covered by exactly one
  std::vector<bool> chosen_;
  std::vector<std::uint32_t> uncovered_;
  std::vector<std::uint32_t> place_;  ///< of a column in uncovered_, if it is there
  Benefit benefit_ = 0;
  Benefit total_ = 0;
  std::uint64_t evaluations_ = 0;
};

}  // namespace viewcover
