#include "optim/simulated_annealing.h"

#include <algorithm>

#include "optim/growing_cover.h"
#include "scene/random_numbers.h"

namespace viewcover {
namespace {

using Benefit = CoverState::Benefit;

constexpr int kRoundsBetweenRestarts = 3;
/// Rounds for numbers of rows that the lower bound excludes: no cover can be missed there.
constexpr int kRoundsBelowBound = 4;
/// What a round's first temperature and first magnitude keep of those of the round before.
constexpr double kReheat = 0.5;
/// Proposals a level: a fixed part, and every row about once for each of the k places at most.
constexpr std::size_t kProposalsPerLevel = 100;
constexpr std::size_t kProposalsPerLevelAndRow = 2;
/// Share of proposals that jump to a row covering some uncovered column, wherever it lies: without
/// them the last few columns of a cover are found by chance only.
constexpr double kJumpShare = 0.25;
/// Share of proposals that go to any row at all.
constexpr double kAnywhereShare = 0.05;
/// Proposals between two looks at the limits; a fraction of a millisecond.
constexpr std::size_t kProposalsPerLook = 64;

/// Near exp(-x) for x >= 0, from products only: the standard library's exp may differ in the last
/// bit between platforms, and one differing decision would change the run.
double acceptance(double x) {
  if (x >= 256) return 0;
  double power = 1 - x / 256;
  for (int squared = 0; squared < 8; ++squared) power *= power;
  return power;
}

/// The search for one number of rows.
class Annealing {
 public:
  Annealing(const AnnealingSchedule& schedule, CoverState& state, RandomNumbers& random,
            SearchLimits& limits)
      : schedule_(schedule), state_(state), random_(random), limits_(limits) {
    start_from(state.chosen());
    keep_if_best();
  }

  /// Searches until the effort is spent or no better set can exist. `upper_bound`: no set of as
  /// many rows has a greater benefit.
  void run(int rounds, Benefit upper_bound) {
    local_search();
    // All sets of one row are exchanges of one row: the local search has seen them.
    if (vector_.size() == 1) return;
    double first_temperature = schedule_.temperature * static_cast<double>(state_.total());
    double first_magnitude = largest_magnitude();
    for (int round = 0; round < rounds && best_benefit_ < upper_bound; ++round) {
      if (limits_.expired()) return;
      if (round > 0 && round % kRoundsBetweenRestarts == 0) {
        start_anywhere();
        first_temperature = schedule_.temperature * static_cast<double>(state_.total());
        first_magnitude = largest_magnitude();
      } else {
        start_from(best_);
      }
      anneal(first_temperature, first_magnitude);
      local_search();
      first_temperature *= kReheat;
      first_magnitude = std::max(1.0, first_magnitude * kReheat);
    }
  }

  const std::vector<std::size_t>& best() const { return best_; }

 private:
  /// Half way round the row order is as far as a row can go.
  double largest_magnitude() const {
    return std::max(1.0, static_cast<double>(state_.row_count()) / 2);
  }

  void start_from(const std::vector<std::size_t>& rows) {
    state_.assign(rows);
    vector_ = rows;
    losses_.assign(vector_.size(), kUnknown);
  }

  void exchange(std::size_t place, std::size_t new_row) {
    state_.remove(vector_[place]);
    state_.add(new_row);
    vector_[place] = new_row;
    losses_.assign(vector_.size(), kUnknown);
    keep_if_best();
  }

  /// What the row at a place alone covers; most proposals are refused, so it is kept.
  Benefit loss_of(std::size_t place) {
    if (losses_[place] == kUnknown) losses_[place] = state_.loss(vector_[place]);
    return losses_[place];
  }

  void start_anywhere() {
    std::vector<std::size_t> rows(state_.row_count());
    for (std::size_t row = 0; row < rows.size(); ++row) rows[row] = row;
    for (std::size_t i = 0; i < vector_.size(); ++i) {
      std::swap(rows[i], rows[i + random_.below(rows.size() - i)]);
    }
    rows.resize(vector_.size());
    start_from(rows);
  }

  void anneal(double temperature, double magnitude) {
    const std::size_t proposals =
        kProposalsPerLevel + kProposalsPerLevelAndRow * state_.row_count();
    for (int level = 0; level < schedule_.levels; ++level) {
      for (std::size_t proposal = 0; proposal < proposals; ++proposal) {
        if (proposal % kProposalsPerLook == 0 && limits_.expired()) return;
        propose(temperature, magnitude);
        if (state_.covers_all()) return;
      }
      temperature *= schedule_.cooling;
      magnitude = std::max(1.0, magnitude * schedule_.cooling);
    }
  }

  void propose(double temperature, double magnitude) {
    const std::size_t place = random_.below(vector_.size());
    const std::size_t old_row = vector_[place];
    const std::size_t new_row = candidate(old_row, magnitude);
    if (state_.contains(new_row)) return;
    const Benefit change = state_.gain_without(new_row, old_row) - loss_of(place);
    if (change < 0 && random_.unit() >= acceptance(static_cast<double>(-change) / temperature)) {
      return;
    }
    exchange(place, new_row);
  }

  std::size_t candidate(std::size_t old_row, double magnitude) {
    const std::size_t rows = state_.row_count();
    const double kind = random_.unit();
    if (kind < kJumpShare && !state_.covers_all()) {
      const std::span<const std::uint32_t> uncovered = state_.uncovered();
      const std::span<const std::uint32_t> seen_from =
          state_.rows_of(uncovered[random_.below(uncovered.size())]);
      return seen_from[random_.below(seen_from.size())];
    }
    if (kind < kJumpShare + kAnywhereShare) return random_.below(rows);
    const std::size_t distance = 1 + random_.below(static_cast<std::size_t>(magnitude));
    return (old_row + (random_.bits() & 1 ? distance : rows - distance)) % rows;
  }

  void keep_if_best() {
    if (state_.benefit() <= best_benefit_) return;
    best_benefit_ = state_.benefit();
    best_ = vector_;
  }

  /// Exchanges one row at a time, always the exchange that helps most, until none helps.
  void local_search() {
    while (!state_.covers_all()) {
      std::size_t best_place = 0, best_row = 0;
      Benefit best_change = 0;
      for (std::size_t place = 0; place < vector_.size(); ++place) {
        if (limits_.expired()) return;
        for (std::size_t row = 0; row < state_.row_count(); ++row) {
          if (state_.contains(row)) continue;
          const Benefit change = state_.gain_without(row, vector_[place]) - loss_of(place);
          if (change > best_change) {
            best_change = change;
            best_place = place;
            best_row = row;
          }
        }
      }
      if (best_change == 0) return;
      exchange(best_place, best_row);
    }
  }

  const AnnealingSchedule& schedule_;
  CoverState& state_;
  RandomNumbers& random_;
  SearchLimits& limits_;
  static constexpr Benefit kUnknown = -1;

  std::vector<std::size_t> vector_;
  std::vector<Benefit> losses_;  ///< of the rows of vector_, or kUnknown
  std::vector<std::size_t> best_;
  Benefit best_benefit_ = -1;
};

}  // namespace

RegionCover SimulatedAnnealing::solve(const CoverInstance& instance,
                                      const CoverOptions& options) const {
  RandomNumbers random(options.seed);
  return grow_cover(instance, options,
                    [&](CoverState& state, const GrowthStage& stage, SearchLimits& limits) {
                      Annealing annealing(schedule_, state, random, limits);
                      const int rounds = stage.k < stage.lower_bound
                                             ? std::min(kRoundsBelowBound, schedule_.rounds)
                                             : schedule_.rounds;
                      annealing.run(rounds, stage.upper_bound);
                      state.assign(annealing.best());
                    });
}

}  // namespace viewcover
