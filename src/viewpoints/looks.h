#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "optim/search_limits.h"
#include "viewpoints/candidate_pool.h"
#include "viewpoints/position_annealing.h"
#include "viewpoints/region_views.h"
#include "viewpoints/viewpoint_search.h"

namespace viewcover {

/// A position to look from.
struct Look {
  std::size_t region = 0;
  Point position = Point::Zero();
  std::optional<ElementTarget> target{};
};

/// An annealing run.
struct AnnealingJob {
  std::size_t region = 0;
  const ColumnWeights* weights = nullptr;
  AnnealingOptions options{};
};

/// Looks from many positions, in parallel; results come in the order of the jobs, so that what is
/// made of them does not depend on the number of threads. Jobs that the limits end give nothing.
class Looks {
 public:
  Looks(const RegionViews& views, SearchLimits& limits, ViewpointProgress* progress)
      : views_(views), limits_(limits), progress_(progress) {}

  const RegionViews& views() const { return views_; }
  SearchLimits& limits() { return limits_; }
  std::uint64_t positions() const { return positions_; }

  /// What is seen from each position that is free. Errors: Interrupted.
  std::vector<Candidate> from(std::span<const Look> jobs);
  /// What is seen from the records of each run, jobs in turn. Errors: Interrupted.
  std::vector<Candidate> anneal(std::span<const AnnealingJob> jobs);

 private:
  std::optional<Candidate> look(const Look& job) const;
  void count(std::uint64_t positions);

  const RegionViews& views_;
  SearchLimits& limits_;
  ViewpointProgress* progress_;
  std::uint64_t positions_ = 0;
};

}  // namespace viewcover
