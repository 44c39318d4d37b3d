#pragma once

#include <vector>

#include "optim/integer_weights.h"
#include "optim/scored_cover.h"
#include "optim/search_effort.h"
#include "scene/random_numbers.h"

namespace viewcover {

/// Local search by weights for the many rows that cover most (maximum coverage).
///
/// Exchanges of one row: out goes the row of least loss, now and then one picked at random; in
/// comes the row of greatest gain that was not removed in the exchanges just before (tabu search,
/// Glover 1989); which of the two goes first is left to chance. Gains and losses are those under
/// weights that start as the columns' own and grow on columns left uncovered, as in
/// WholeCoverSearch; growing is paused where it would cost more than the exchanges themselves. When
/// a number of exchanges gave no better set, the search goes back to the columns' own weights and
/// to the best set, with some rows replaced at random. Not safe for concurrent use.
class ExchangeSearch {
 public:
  using Index = ScoredCover::Index;

  /// All must outlive the search.
  ExchangeSearch(const Incidence& lists, const IntegerWeights& weights, RandomNumbers& random);

  std::uint64_t evaluations() const { return evaluations_; }
  std::uint64_t work() const { return cover_.work() + evaluations_; }

  /// `rows` and, one after the other, the row that adds most, until there are k.
  std::vector<Index> grown(const std::vector<Index>& rows, std::size_t k);
  /// The same rows; taking them away from the front, each is about the one whose loss is least.
  std::vector<Index> in_order_of_loss(std::vector<Index> rows);
  /// The best set of rows.size() rows found, starting from `rows`, until the effort is spent or a
  /// bound says that there is no better one; `rows` themselves if nothing better is found.
  std::vector<Index> improved(const std::vector<Index>& rows, SearchEffort& effort);

 private:
  /// Columns have their own weights afterwards.
  void assign(const std::vector<Index>& rows);
  /// Random rows come in for random ones: for none up to about all.
  void replace_some_rows();
  void exchange();
  Index row_to_remove();
  Index row_to_add();
  /// Of the uncovered columns, by their own weights.
  Score missed() const;
  void raise_uncovered();

  const IntegerWeights& weights_;
  ScoredCover cover_;
  RandomNumbers& random_;
  std::vector<Index> best_;
  Score best_missed_ = 0;
  std::uint64_t raise_work_ = 0, exchange_work_ = 0;
  std::uint64_t evaluations_ = 0;
};

}  // namespace viewcover
