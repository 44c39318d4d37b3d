#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "optim/incidence.h"
#include "optim/loss_queue.h"

namespace viewcover {

/// A set of chosen rows with a score for every row, kept up to date while rows and column weights
/// change: what a local search by weights looks at thousands of times for each row it moves.
///
/// score(row) is the weight of the columns that would change sides with the row: of those that no
/// chosen row covers, if the row is not chosen; of those that it alone covers, if it is.
/// Sparse: rows and columns as lists, the sole row of a column found in constant time.
/// Not safe for concurrent use.
class ScoredCover {
 public:
  using Index = Incidence::Index;
  using Score = std::int64_t;

  /// No row is chosen. The lists must outlive the cover. Cost: O(#ones).
  ScoredCover(const Incidence& lists, std::vector<Score> weights);

  std::size_t row_count() const { return scores_.size(); }
  std::span<const Index> rows_of(Index column) const { return lists_->rows_of(column); }

  bool contains(Index row) const { return place_[row] != kNowhere; }
  /// In no particular order, but the same order after the same calls.
  std::span<const Index> chosen() const { return chosen_; }
  std::span<const Index> uncovered() const { return uncovered_; }
  Score score(Index row) const { return scores_[row]; }
  Score weight(Index column) const { return weights_[column]; }
  /// Sum of the weights of the uncovered columns.
  Score uncovered_weight() const { return uncovered_weight_; }
  /// True iff some chosen row can be removed; the one added last cannot, it has just been asked
  /// for.
  bool can_remove() const { return !removable_.empty(); }
  /// Of the rows that can be removed the one of least score, of several the one chosen first.
  /// Cost: O(log #chosen) for each chosen row whose score changed since, at most O(#chosen).
  Index easiest_to_remove();
  /// Additions and removals so far.
  std::uint64_t moves() const { return moves_; }
  /// Number of additions and removals when the row was last added or removed; 0: never.
  std::uint64_t moved_at(Index row) const { return moved_at_[row]; }
  /// True iff the score of the row changed, but for a raise, since it was last removed.
  bool changed(Index row) const { return changed_[row] != 0; }
  /// Entries of the matrix touched so far: time on any machine.
  std::uint64_t work() const { return work_; }

  /// Cost: O(ones of the row + ones of the columns that become covered or uncovered).
  void add(Index row);
  void remove(Index row);
  /// Adds to the weight of an uncovered column. Cost: O(ones of the column).
  void raise(Index column, Score by);
  /// Replaces all weights. Cost: O(#ones).
  void set_weights(std::vector<Score> weights);

 private:
  static constexpr Index kNowhere = ~Index{0};

  void score_changed(Index chosen_row);

  const Incidence* lists_;
  std::vector<Score> weights_;
  std::vector<Score> scores_;
  std::vector<char> changed_;
  std::vector<Index> times_covered_;
  std::vector<Index> row_mix_;  ///< exclusive or of the chosen rows that cover a column
  std::vector<std::uint64_t> moved_at_;
  std::uint64_t moves_ = 0;
  LossQueue removable_;         ///< every chosen row but the newest
  std::vector<Index> stale_;    ///< rows whose score the queue may not know yet
  std::vector<char> is_stale_;  ///< whether a row is in stale_
  std::size_t changes_ = 0;     ///< of scores of chosen rows since the last easiest_to_remove()
  Index newest_ = kNowhere;     ///< the row added last, if it is still chosen
  std::vector<Index> chosen_;
  std::vector<Index> place_;  ///< of a row in chosen_, or kNowhere
  std::vector<Index> uncovered_;
  std::vector<Index> uncovered_place_;  ///< of a column in uncovered_, if it is there
  Score uncovered_weight_ = 0;
  std::uint64_t work_ = 0;
};

}  // namespace viewcover
