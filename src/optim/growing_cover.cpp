#include "optim/growing_cover.h"

#include <algorithm>
#include <cassert>

namespace viewcover {
namespace {

using Benefit = CoverState::Benefit;

/// The k largest row benefits together, at most the total.
Benefit benefit_bound(const std::vector<Benefit>& heaviest, std::size_t k, Benefit total) {
  Benefit sum = 0;
  for (std::size_t i = 0; i < k && sum < total; ++i) sum += heaviest[i];
  return std::min(sum, total);
}

}  // namespace

std::size_t best_addition(CoverState& state) {
  std::size_t best = 0;
  Benefit best_gain = -1;
  for (std::size_t row = 0; row < state.row_count(); ++row) {
    if (state.contains(row)) continue;
    const Benefit gain = state.gain(row);
    if (gain > best_gain) {
      best_gain = gain;
      best = row;
    }
  }
  return best;
}

void remove_redundant_rows(CoverState& state) {
  for (const std::size_t row : state.chosen()) {
    if (state.loss(row) == 0) state.remove(row);
  }
}

CoverStep make_step(const CoverInstance& instance, std::vector<std::size_t> chosen) {
  CoverStep step;
  step.k = chosen.size();
  step.chosen = std::move(chosen);
  std::ranges::sort(step.chosen);
  step.covered_percent = instance.covered_percent(step.chosen);
  step.upper_bound_percent = instance.upper_bound_percent(step.k);
  return step;
}

RegionCover grow_cover(const CoverInstance& instance, const CoverOptions& options,
                       const ImproveCover& improve) {
  SearchLimits limits(options);
  RegionCover cover;
  cover.lower_bound = instance.lower_bound();
  CoverState state(instance);
  std::vector<Benefit> heaviest;
  for (std::size_t row = 0; row < state.row_count(); ++row) heaviest.push_back(state.gain(row));
  std::ranges::sort(heaviest, std::greater<>());

  std::uint64_t evaluations_before = 0;
  double seconds_before = 0;
  for (std::size_t k = 1; !state.covers_all(); ++k) {
    if (options.goal == CoverGoal::kOneK && k > options.k) break;
    state.add(best_addition(state));
    if (!limits.expired()) {
      improve(state, {k, cover.lower_bound, benefit_bound(heaviest, k, state.total())}, limits);
    }
    if (state.covers_all()) remove_redundant_rows(state);
    assert(state.check_consistency());
    CoverStep step = make_step(instance, state.chosen());
    step.evaluations = state.evaluations() - evaluations_before;
    step.seconds = limits.seconds() - seconds_before;
    if (options.goal == CoverGoal::kEveryK) {
      evaluations_before = state.evaluations();
      seconds_before = limits.seconds();
    }
    std::erase_if(cover.steps, [&](const CoverStep& earlier) {
      return options.goal != CoverGoal::kEveryK || earlier.k >= step.k;
    });
    cover.steps.push_back(std::move(step));
    if (options.on_step) options.on_step(cover.steps.back());
  }
  cover.whole = state.covers_all();
  cover.time_limit_reached = limits.has_expired();
  if (options.on_better && cover.whole && !cover.steps.empty()) {
    options.on_better({cover.steps.back().chosen, limits.seconds()});
  }
  return cover;
}

}  // namespace viewcover
