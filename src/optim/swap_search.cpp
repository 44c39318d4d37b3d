#include "optim/swap_search.h"

#include <algorithm>
#include <limits>

namespace viewcover {
namespace {

/// Exchanges for which a row brought in stays, at most as many as half of the rows.
constexpr std::size_t kMostStay = 6;
/// Entries of the table that are compared in the time of one entry of the matrix.
constexpr std::size_t kComparisonsPerWork = 4;

}  // namespace

SwapSearch::SwapSearch(const Incidence& lists, const IntegerWeights& weights, RandomNumbers& random)
    : lists_(lists),
      weights_(weights),
      random_(random),
      row_free_at_(lists.row_count(), 0),
      marked_(lists.column_count(), 0) {}

std::vector<SwapSearch::Index> SwapSearch::improved(const std::vector<Index>& rows,
                                                    SearchEffort& effort) {
  // Exchanges without a better set, for each of the k rows and in all, that end a start.
  constexpr std::size_t kExchanges = 40, kExchangesPerRow = 10;
  start_from(rows);
  best_ = rows;
  best_covered_ = covered_;
  const Score most = weights_.upper_bound(rows.size());
  const std::size_t patience = kExchanges + kExchangesPerRow * rows.size();
  std::size_t since_better = 0;
  while (best_covered_ < most && !effort.spent(work_)) {
    make(best_exchange());
    if (covered_ > best_covered_) {
      best_ = chosen_;
      best_covered_ = covered_;
      effort.succeeded(work_);
      since_better = 0;
    } else if (++since_better == patience) {
      start_from(best_);
      replace_some_rows();
      since_better = 0;
    }
  }
  return best_;
}

void SwapSearch::start_from(const std::vector<Index>& rows) {
  chosen_ = rows;
  is_chosen_.assign(lists_.row_count(), 0);
  times_covered_.assign(lists_.column_count(), 0);
  place_mix_.assign(lists_.column_count(), 0);
  for (Index place = 0; place < chosen_.size(); ++place) {
    is_chosen_[chosen_[place]] = 1;
    for (const Index column : lists_.columns_of(chosen_[place])) {
      ++times_covered_[column];
      place_mix_[column] ^= place;
    }
  }
  covered_ = weights_.total;
  gains_.assign(lists_.row_count(), 0);
  losses_.assign(chosen_.size(), 0);
  saved_.assign(lists_.row_count() * chosen_.size(), 0);
  place_free_at_.assign(chosen_.size(), 0);
  for (Index column = 0; column < lists_.column_count(); ++column) {
    enter(column, weights_.columns[column]);
  }
}

void SwapSearch::enter(Index column, Score weight) {
  const std::span<const Index> rows = lists_.rows_of(column);
  if (times_covered_[column] == 0) {
    covered_ -= weight;
    for (const Index row : rows) gains_[row] += weight;
  } else if (times_covered_[column] == 1) {
    const Index place = place_mix_[column];
    losses_[place] += weight;
    for (const Index row : rows) saved(row, place) += weight;
  } else {
    return;
  }
  work_ += rows.size();
}

SwapSearch::Exchange SwapSearch::best_exchange() {
  const std::size_t k = chosen_.size();
  evaluations_ += lists_.row_count() * k;
  work_ += lists_.row_count() * k / kComparisonsPerWork;
  Exchange best, best_free;
  Score change = std::numeric_limits<Score>::min(), free_change = change;
  for (Index row = 0; row < lists_.row_count(); ++row) {
    if (is_chosen_[row]) continue;
    const bool row_is_free = row_free_at_[row] <= exchanges_;
    for (Index place = 0; place < k; ++place) {
      const Score this_change = gains_[row] - losses_[place] + saved(row, place);
      if (this_change > change) {
        change = this_change;
        best = {row, place};
      }
      if (this_change > free_change && row_is_free && place_free_at_[place] <= exchanges_) {
        free_change = this_change;
        best_free = {row, place};
      }
    }
  }
  const bool some_are_free = free_change > std::numeric_limits<Score>::min();
  return covered_ + change > best_covered_ || !some_are_free ? best : best_free;
}

void SwapSearch::make(const Exchange& exchange) {
  // Exchanges for which a row taken out may not return: the least, and how many more by chance.
  constexpr std::size_t kLeastAbsence = 3, kMoreAbsence = 8;
  ++exchanges_;
  const Index out = chosen_[exchange.place], in = exchange.row;
  row_free_at_[out] = exchanges_ + kLeastAbsence + random_.below(kMoreAbsence + 1);
  place_free_at_[exchange.place] =
      exchanges_ + random_.below(std::min(chosen_.size() / 2, kMostStay) + 1);
  is_chosen_[out] = 0;
  is_chosen_[in] = 1;
  chosen_[exchange.place] = in;

  // Columns of both rows stay covered from the same place.
  const auto recount = [&](Index column, Index times) {
    enter(column, -weights_.columns[column]);
    times_covered_[column] = times;
    place_mix_[column] ^= exchange.place;
    enter(column, weights_.columns[column]);
  };
  for (const Index column : lists_.columns_of(in)) marked_[column] = 1;
  for (const Index column : lists_.columns_of(out)) {
    if (marked_[column] == 0) recount(column, times_covered_[column] - 1);
    marked_[column] = 0;
  }
  for (const Index column : lists_.columns_of(in)) {
    if (marked_[column] != 0) recount(column, times_covered_[column] + 1);
    marked_[column] = 0;
  }
  work_ += lists_.columns_of(in).size() + lists_.columns_of(out).size();
}

void SwapSearch::replace_some_rows() {
  for (std::size_t left = random_.below(chosen_.size() + 1); left > 0; --left) {
    Index row = 0;
    do {
      row = static_cast<Index>(random_.below(lists_.row_count()));
    } while (is_chosen_[row]);
    make({row, static_cast<Index>(random_.below(chosen_.size()))});
  }
}

}  // namespace viewcover
