#pragma once

#include <vector>

#include "viewpoints/looks.h"
#include "viewpoints/pool_cover.h"

namespace viewcover {

/// Fewer viewpoints by candidates from all regions (viewpoints/viewpoint_search.h): cover, price,
/// look where prices are high, again.
class CandidateSearch {
 public:
  /// `best`: viewpoints that see all that can be; `pool` sees as much. All must outlive the search.
  CandidateSearch(Looks& looks, const ViewpointOptions& options, CandidatePool& pool,
                  std::vector<Candidate> best);

  /// Ends at `lower_bound` viewpoints, when `patience` rounds have not helped, or when the limits
  /// expire. May be called again. Errors: Interrupted.
  void run(std::size_t lower_bound, int patience);
  /// Random positions in all regions, and starts of sight lines to elements that few see.
  void gather();
  /// Adds candidates from elsewhere.
  void add(std::vector<Candidate> candidates);

  const std::vector<Candidate>& best() const { return best_; }
  /// Of the last cover of the pool.
  const PoolCover& cover() const { return cover_; }

 private:
  void cover_candidates();
  bool look_by_prices();
  void look_for_one_in_place_of_two();
  AnnealingJob job(std::size_t region, const ColumnWeights& weights);
  const Candidate* best_in(std::size_t region, const ColumnWeights& weights) const;
  void report() const;

  Looks& looks_;
  const ViewpointOptions& options_;
  CandidatePool& pool_;
  std::vector<Candidate> best_;
  PoolCover cover_;
  std::uint64_t jobs_ = 0;  ///< made so far: each has a seed of its own
};

}  // namespace viewcover
