#pragma once

#include <functional>
#include <vector>

#include "optim/scored_cover.h"
#include "optim/search_effort.h"
#include "scene/random_numbers.h"

namespace viewcover {

/// Row weighting local search for a smallest whole cover (Gao, Weise and Li 2015; their rows are
/// our columns).
///
/// From a whole cover the row whose loss is least is removed. As long as columns are uncovered, the
/// row of least loss is exchanged for the row of greatest gain among those that cover an uncovered
/// column picked at random, and every column still uncovered then gains weight: columns that are
/// hard to cover become those that matter. Of equal rows the one that was moved longest ago goes.
/// The row added last stays; a row that was removed comes back only after a column of its own was
/// covered or uncovered by others (configuration checking). When all columns are covered, there is
/// a cover with one row less than before.
/// Not safe for concurrent use.
class WholeCoverSearch {
 public:
  using Index = ScoredCover::Index;

  /// Begins with a greedy cover; ties are broken by chance.
  WholeCoverSearch(const Incidence& lists, RandomNumbers& random);

  /// Rows of the smallest cover so far.
  const std::vector<Index>& best() const { return best_; }
  /// Rows whose scores were compared.
  std::uint64_t evaluations() const { return evaluations_; }
  std::uint64_t work() const { return cover_.work() + evaluations_; }

  /// Searches until a cover of `lower_bound` rows is found or the effort is spent; calls on_better
  /// after each smaller cover.
  void run(SearchEffort& effort, std::size_t lower_bound, const std::function<void()>& on_better);

 private:
  void add_greedily();
  void exchange();
  Index row_to_add();

  ScoredCover cover_;
  RandomNumbers& random_;
  std::vector<Index> best_;
  std::uint64_t evaluations_ = 0;
};

}  // namespace viewcover
