#include "optim/exact_cover.h"

#include <algorithm>

#include "optim/coverage_curve.h"
#include "optim/optimal_covers.h"
#include "optim/prove_cover.h"
#include "optim/search_limits.h"
#include "optim/stopwatch.h"

namespace viewcover {
namespace {

/// In the curve for every k. Asked for one k, the search goes on to the proof.
constexpr std::size_t kNodesForEachK = 2000;

/// The step of a set of rows that covers everything coverable.
CoverStep whole_step(const CoverInstance& instance, ProvedCover cover) {
  CoverStep step;
  step.k = cover.rows.size();
  step.chosen = std::move(cover.rows);
  step.evaluations = cover.nodes;
  step.covered_percent = instance.covered_percent(step.chosen);
  step.proved = true;
  return step;
}

}  // namespace

RegionCover ExactCover::solve(const CoverInstance& instance, const CoverOptions& options) const {
  RegionCover cover;
  const Stopwatch watch;
  SearchLimits limits(options);
  limits.expired();
  CoverOptions cover_options = options;
  if (options.goal != CoverGoal::kWholeCover) cover_options.time_limit_seconds /= 2;
  SearchLimits cover_limits(cover_options);
  ProvedCover proved = prove_cover(instance.rows(), cover_limits, options);
  cover.lower_bound = proved.proof.lower_bound;
  cover.proof = std::make_shared<const CoverProof>(std::move(proved.proof));
  if (proved.rows.empty()) return cover;
  CoverStep whole = whole_step(instance, std::move(proved));
  whole.seconds = watch.seconds();
  const std::size_t whole_size = whole.k;
  const auto add_step = [&](CoverStep step) {
    cover.steps.push_back(std::move(step));
    if (options.on_step) options.on_step(cover.steps.back());
  };
  const bool every_k = options.goal == CoverGoal::kEveryK, one_k = options.goal == CoverGoal::kOneK;
  cover.whole = !one_k || options.k >= whole_size;
  if (every_k || !cover.whole) {
    CoverageCurve coverage(instance, limits,
                           every_k ? kNodesForEachK : CoverageCurve::kAnyNumberOfNodes);
    const std::size_t first = every_k ? 1 : options.k, end = every_k ? whole_size : options.k + 1;
    for (std::size_t k = std::max(first, std::size_t{1}); k < end; ++k) add_step(coverage.step(k));
  }
  if (cover.whole) add_step(std::move(whole));
  if (options.solutions > 0 && cover.lower_bound == whole_size) {
    OptimalCovers found = covers_of_size(instance.rows(), whole_size, options.solutions, limits);
    cover.solutions = std::move(found.covers);
    cover.solutions_complete = found.complete;
  }
  cover.time_limit_reached = limits.has_expired() || cover_limits.has_expired();
  return cover;
}

}  // namespace viewcover
