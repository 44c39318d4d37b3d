#include "optim/tabu_search.h"

#include <algorithm>

#include "optim/growing_cover.h"
#include "scene/random_numbers.h"

namespace viewcover {
namespace {

using Benefit = CoverState::Benefit;

/// The walk for one number of rows.
class TabuWalk {
 public:
  TabuWalk(CoverState& state, RandomNumbers& random, SearchLimits& limits)
      : state_(state),
        random_(random),
        limits_(limits),
        chosen_(state.chosen()),
        best_(chosen_),
        best_benefit_(state.benefit()),
        free_at_(state.row_count(), 0) {}

  /// `upper_bound`: no set of as many rows has a greater benefit.
  void run(std::size_t patience, Benefit upper_bound) {
    std::size_t last_better = 0;
    for (now_ = 1; now_ - last_better <= patience; ++now_) {
      if (best_benefit_ >= upper_bound || limits_.expired()) break;
      if (now_ - last_better == patience / 2) start_from_best();
      if (exchange()) last_better = now_;
    }
    state_.assign(best_);
  }

 private:
  struct Exchange {
    std::size_t place = 0;  ///< in chosen_, of the row that leaves
    std::size_t row = 0;    ///< that enters
    Benefit change = std::numeric_limits<Benefit>::min();
  };

  void start_from_best() {
    state_.assign(best_);
    chosen_ = best_;
  }

  /// True iff the set is better than any before.
  bool exchange() {
    // Exchanges for which a row taken out may not return: the least, and how many more by chance.
    constexpr std::size_t kLeastAbsence = 5, kMoreAbsence = 10;
    // Those for which a row brought in may not leave; at most half of the k rows are held.
    constexpr std::size_t kLeastStay = 1, kMoreStay = 8;
    const Exchange move = best_exchange();
    if (move.change == Exchange{}.change) return false;
    const std::size_t leaving = chosen_[move.place];
    state_.remove(leaving);
    state_.add(move.row);
    chosen_[move.place] = move.row;
    free_at_[leaving] = now_ + kLeastAbsence + random_.below(kMoreAbsence + 1);
    free_at_[move.row] =
        now_ + std::min(chosen_.size() / 2, kLeastStay + random_.below(kMoreStay + 1));
    if (state_.benefit() <= best_benefit_) return false;
    best_benefit_ = state_.benefit();
    best_ = chosen_;
    return true;
  }

  bool is_free(std::size_t row) const { return free_at_[row] < now_; }

  /// The first of several; no change at all if every exchange is tabu.
  Exchange best_exchange() {
    const std::span<const std::uint32_t> uncovered = state_.uncovered();
    const std::uint32_t column = uncovered[random_.below(uncovered.size())];
    std::vector<std::pair<Benefit, std::size_t>> entering;
    for (const std::uint32_t row : state_.rows_of(column)) {
      entering.emplace_back(state_.gain(row), row);
    }
    std::ranges::stable_sort(entering, std::greater<>(), &std::pair<Benefit, std::size_t>::first);
    losses_.clear();
    for (const std::size_t row : chosen_) losses_.push_back(state_.loss(row));

    Exchange best;
    for (const auto& [gain, row] : entering) {
      // What a row adds without another one is at most what it adds beside it and the other's loss.
      if (gain <= best.change) break;
      for (std::size_t place = 0; place < chosen_.size(); ++place) {
        const Benefit change = state_.gain_without(row, chosen_[place]) - losses_[place];
        if (change <= best.change) continue;
        const bool is_better = state_.benefit() + change > best_benefit_;
        if (is_better || (is_free(row) && is_free(chosen_[place]))) best = {place, row, change};
      }
    }
    return best;
  }

  CoverState& state_;
  RandomNumbers& random_;
  SearchLimits& limits_;
  std::vector<std::size_t> chosen_;
  std::vector<std::size_t> best_;
  Benefit best_benefit_;
  std::vector<std::size_t> free_at_;  ///< last exchange in which a row is tabu
  std::vector<Benefit> losses_;       ///< of the rows of chosen_
  std::size_t now_ = 0;               ///< number of the exchange
};

}  // namespace

RegionCover TabuSearch::solve(const CoverInstance& instance, const CoverOptions& options) const {
  // Exchanges without a better set that end the walk of a k: a fixed part and more for each row.
  constexpr std::size_t kPatience = 2000, kPatiencePerRow = 40;
  // The part of it for numbers of rows that the lower bound excludes: no cover can be missed there.
  constexpr std::size_t kLessBelowBound = 4;
  RandomNumbers random(options.seed);
  return grow_cover(instance, options,
                    [&](CoverState& state, const GrowthStage& stage, SearchLimits& limits) {
                      const std::size_t patience = kPatience + kPatiencePerRow * stage.k;
                      TabuWalk(state, random, limits)
                          .run(stage.k < stage.lower_bound ? patience / kLessBelowBound : patience,
                               stage.upper_bound);
                    });
}

}  // namespace viewcover
