#include "optim/exchange_search.h"

#include <algorithm>
#include <optional>

namespace viewcover {
namespace {

/// One exchange in so many takes out a row picked at random.
constexpr std::size_t kExchangesPerRandomRow = 8;

}  // namespace

ExchangeSearch::ExchangeSearch(const Incidence& lists, const IntegerWeights& weights,
                               RandomNumbers& random)
    : weights_(weights), cover_(lists, weights.columns), random_(random) {}

std::vector<ExchangeSearch::Index> ExchangeSearch::grown(const std::vector<Index>& rows,
                                                         std::size_t k) {
  assign(rows);
  while (cover_.chosen().size() < k) {
    std::optional<Index> best;
    for (Index row = 0; row < cover_.row_count(); ++row) {
      if (cover_.contains(row)) continue;
      if (!best || cover_.score(row) > cover_.score(*best)) best = row;
    }
    evaluations_ += cover_.row_count();
    cover_.add(*best);
  }
  return {cover_.chosen().begin(), cover_.chosen().end()};
}

std::vector<ExchangeSearch::Index> ExchangeSearch::in_order_of_loss(std::vector<Index> rows) {
  // The row added last stays to the end.
  assign(rows);
  std::ranges::stable_sort(rows, {}, [&](Index row) { return cover_.score(row); });
  assign(rows);
  std::vector<Index> order;
  while (cover_.can_remove()) {
    order.push_back(cover_.easiest_to_remove());
    cover_.remove(order.back());
  }
  order.insert(order.end(), cover_.chosen().begin(), cover_.chosen().end());
  return order;
}

std::vector<ExchangeSearch::Index> ExchangeSearch::improved(const std::vector<Index>& rows,
                                                            SearchEffort& effort) {
  // Exchanges without a better set, for each of the k rows and in all, after which the search goes
  // back to the best set and the columns' own weights.
  constexpr std::size_t kExchanges = 1000, kExchangesPerRow = 20;
  assign(rows);
  best_ = rows;
  best_missed_ = missed();
  const Score least_missed = weights_.total - weights_.upper_bound(rows.size());
  const std::size_t exchanges = kExchanges + kExchangesPerRow * rows.size();
  std::size_t since_better = 0;
  while (best_missed_ > least_missed && !effort.spent(work())) {
    exchange();
    ++since_better;
    if (missed() < best_missed_) {
      best_.assign(cover_.chosen().begin(), cover_.chosen().end());
      best_missed_ = missed();
      effort.succeeded(work());
      since_better = 0;
    } else if (since_better == exchanges) {
      assign(best_);
      replace_some_rows();
      since_better = 0;
    } else {
      raise_uncovered();
    }
  }
  return best_;
}

void ExchangeSearch::assign(const std::vector<Index>& rows) {
  cover_.set_weights(weights_.columns);
  const std::vector<Index> before(cover_.chosen().begin(), cover_.chosen().end());
  for (const Index row : before) cover_.remove(row);
  for (const Index row : rows) cover_.add(row);
}

void ExchangeSearch::replace_some_rows() {
  for (std::size_t left = random_.below(cover_.chosen().size() + 1); left > 0; --left) {
    cover_.remove(cover_.chosen()[random_.below(cover_.chosen().size())]);
    Index row = 0;
    do {
      row = static_cast<Index>(random_.below(cover_.row_count()));
    } while (cover_.contains(row));
    cover_.add(row);
  }
}

void ExchangeSearch::exchange() {
  const std::uint64_t before = cover_.work();
  if (random_.below(2) == 0) {
    cover_.remove(row_to_remove());
    cover_.add(row_to_add());
  } else {
    cover_.add(row_to_add());
    cover_.remove(row_to_remove());
  }
  exchange_work_ += cover_.work() - before;
}

ExchangeSearch::Index ExchangeSearch::row_to_remove() {
  if (cover_.can_remove() && random_.below(kExchangesPerRandomRow) != 0) {
    return cover_.easiest_to_remove();
  }
  return cover_.chosen()[random_.below(cover_.chosen().size())];
}

ExchangeSearch::Index ExchangeSearch::row_to_add() {
  // Exchanges in which a removed row may not come back: the least, and how many more by chance.
  constexpr std::size_t kLeastAbsence = 2, kMoreAbsence = 8;
  // Every exchange moves two rows.
  const std::uint64_t absence = 2 * (kLeastAbsence + random_.below(kMoreAbsence + 1));
  evaluations_ += cover_.row_count();
  std::optional<Index> best, best_free;
  const auto is_better = [&](Index row, const std::optional<Index>& than) {
    return !than || cover_.score(row) > cover_.score(*than) ||
           (cover_.score(row) == cover_.score(*than) &&
            cover_.moved_at(row) < cover_.moved_at(*than));
  };
  for (Index row = 0; row < cover_.row_count(); ++row) {
    if (cover_.contains(row)) continue;
    const bool is_free =
        cover_.moved_at(row) == 0 || cover_.moved_at(row) + absence < cover_.moves();
    if (is_free && is_better(row, best_free)) best_free = row;
    if (is_better(row, best)) best = row;
  }
  return best_free.value_or(*best);
}

Score ExchangeSearch::missed() const {
  Score sum = 0;
  for (const Index column : cover_.uncovered()) sum += weights_.columns[column];
  return sum;
}

void ExchangeSearch::raise_uncovered() {
  if (raise_work_ > exchange_work_) return;
  const std::uint64_t before = cover_.work();
  for (const Index column : cover_.uncovered()) cover_.raise(column, weights_.columns[column]);
  raise_work_ += cover_.work() - before;
}

}  // namespace viewcover
