#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

#include "links/bit_rows.h"
#include "viewpoints/region_views.h"
#include "viewpoints/viewpoint.h"

namespace viewcover {

struct FullCoverage;
struct RefinedBound;

/// How far a search has come, readable from another thread while it runs.
struct ViewpointProgress {
  std::atomic<std::size_t> viewpoints = 0;  ///< of the best set so far; 0 before there is one
  std::atomic<std::size_t> lower_bound = 0;
  std::atomic<std::uint64_t> positions = 0;  ///< looked from
};

struct ViewpointOptions {
  std::vector<std::size_t> chosen_regions;  ///< a region cover, ascending
  std::size_t lower_bound = 0;              ///< fewer viewpoints are not looked for
  std::uint64_t seed = 1;
  double time_limit_seconds = 0;  ///< 0: none
  /// After the search, while there are more viewpoints than lower_bound: rounds of raising the
  /// bound and looking for fewer in turn, so many at most or, if seconds are given, for so long.
  /// Requires an exact backend.
  std::size_t gap_rounds = 0;
  double close_gap_seconds = 0;
  const std::atomic<bool>* stop = nullptr;  ///< ends the search with Interrupted
  ViewpointProgress* progress = nullptr;
};

/// Viewpoints that see all that any region sees.
struct ViewpointSet {
  /// In the order in which they add most area; of equal ones, by number.
  std::vector<Viewpoint> viewpoints;
  BitRows seen;                         ///< #viewpoints x #elements
  std::vector<double> covered_percent;  ///< area seen by the first i + 1, of all that is visible
  std::vector<double> seconds;  ///< into the search, when the viewpoint was first looked from
  /// Elements that a region sees, but none of the positions that were tried: too little is seen
  /// for positions on their lattice, or for random rays. Empty but for extreme slivers.
  std::vector<std::size_t> missing;

  /// Fewer viewpoints do not see everything, if fewer regions than options.lower_bound do not and
  /// the backend is exact.
  std::size_t lower_bound = 0;
  /// Why, where it was raised above options.lower_bound.
  std::shared_ptr<const RefinedBound> refined_bound;

  /// For viewpoints that image all but a share (full_coverage/full_search.h); then the columns of
  /// refined_bound are witnesses.
  std::shared_ptr<const FullCoverage> full;

  std::size_t paper_viewpoints = 0;  ///< found by the paper's search alone
  std::size_t candidates = 0;        ///< in the pool at the end
  std::vector<Viewpoint> tried;      ///< positions of the pool at the end
  std::uint64_t positions = 0;       ///< looked from, in full or for some elements
  double relaxation = 0;             ///< the least fractional cover by candidates
  bool time_limit_reached = false;
};

/// The search for few viewpoints that see everything (paper, section 2.4, and beyond it).
///
/// First figure 5: cycle through the chosen regions, simulated annealing for the position in each,
/// benefit = area newly seen. Then fewer: all positions met are candidates, those of other regions
/// too, and those that sight lines from regions to elements seen by few candidates begin in. A
/// smallest cover by candidates is found, and new candidates are looked for by annealing where the
/// prices of the linear programme say that they help (column generation), and where a single
/// position may take the place of two. It ends at the lower bound, when that has helped no more
/// for some rounds, or at the time limit. Uses all threads of the current TBB arena; without a time
/// limit the result depends on input and seed only. Errors: Interrupted.
ViewpointSet find_viewpoints(const RegionViews& views, const ViewpointOptions& options);

}  // namespace viewcover
