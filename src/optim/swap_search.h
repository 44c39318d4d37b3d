#pragma once

#include <vector>

#include "optim/incidence.h"
#include "optim/integer_weights.h"
#include "optim/search_effort.h"
#include "scene/random_numbers.h"

namespace viewcover {

/// Tabu search (Glover 1989) for the few rows that cover most, by the best of all exchanges.
///
/// The change that each exchange of one row would bring is kept in a table, as in the fast
/// interchange for medians (Resende and Werneck 2007): what the row coming in gains, less what the
/// row going out loses, plus what the first saves of the loss of the second. Every step makes the
/// best exchange, even if it is a loss, whose rows have not just moved the other way, unless it
/// gives a better set than any so far. When a number of exchanges gave none, the search goes back
/// to the best set, with some rows replaced at random.
/// Cost of an exchange: O(#rows x k + ones of the columns whose cover changes). Memory: #rows x k.
/// Not safe for concurrent use.
class SwapSearch {
 public:
  using Index = Incidence::Index;

  /// All must outlive the search.
  SwapSearch(const Incidence& lists, const IntegerWeights& weights, RandomNumbers& random);

  std::uint64_t evaluations() const { return evaluations_; }
  std::uint64_t work() const { return work_; }

  /// The best set of rows.size() rows found, starting from `rows`, until the effort is spent or a
  /// bound says that there is no better one; `rows` themselves if nothing better is found.
  /// Requires fewer rows than there are.
  std::vector<Index> improved(const std::vector<Index>& rows, SearchEffort& effort);

 private:
  struct Exchange {
    Index row = 0;    ///< that comes in
    Index place = 0;  ///< in chosen_, of the row that goes out
  };

  void start_from(const std::vector<Index>& rows);
  void replace_some_rows();
  Exchange best_exchange();
  void make(const Exchange& exchange);
  /// Enters what a column brings to the table, with its weight or, to take it out, the negative.
  void enter(Index column, Score weight);
  Score& saved(Index row, Index place) { return saved_[row * chosen_.size() + place]; }

  const Incidence& lists_;
  const IntegerWeights& weights_;
  RandomNumbers& random_;
  std::vector<Index> chosen_;
  std::vector<Index> times_covered_;
  std::vector<Index> place_mix_;  ///< exclusive or of the places of the rows that cover a column
  Score covered_ = 0;
  std::vector<Score> gains_;   ///< of all rows
  std::vector<Score> losses_;  ///< of the places
  std::vector<Score> saved_;
  std::vector<std::uint64_t> row_free_at_, place_free_at_;  ///< first exchange not tabu
  std::vector<char> is_chosen_;
  std::vector<char> marked_;  ///< columns of the row coming in, during an exchange
  std::vector<Index> best_;
  Score best_covered_ = 0;
  std::uint64_t exchanges_ = 0, evaluations_ = 0, work_ = 0;
};

}  // namespace viewcover
