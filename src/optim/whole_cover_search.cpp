#include "optim/whole_cover_search.h"

#include <optional>

namespace viewcover {

WholeCoverSearch::WholeCoverSearch(const Incidence& lists, RandomNumbers& random)
    : cover_(lists, std::vector<ScoredCover::Score>(lists.column_count(), 1)), random_(random) {
  while (!cover_.uncovered().empty()) add_greedily();
  const auto is_redundant = [&] {
    return cover_.can_remove() && cover_.score(cover_.easiest_to_remove()) == 0;
  };
  while (is_redundant()) cover_.remove(cover_.easiest_to_remove());
  best_.assign(cover_.chosen().begin(), cover_.chosen().end());
}

void WholeCoverSearch::add_greedily() {
  Index best = 0;
  ScoredCover::Score best_gain = 0;
  std::size_t equal = 0;
  for (Index row = 0; row < cover_.row_count(); ++row) {
    if (cover_.contains(row) || cover_.score(row) < best_gain) continue;
    if (cover_.score(row) > best_gain) equal = 0;
    best_gain = cover_.score(row);
    if (random_.below(++equal) == 0) best = row;
  }
  evaluations_ += cover_.row_count();
  cover_.add(best);
}

void WholeCoverSearch::run(SearchEffort& effort, std::size_t lower_bound,
                           const std::function<void()>& on_better) {
  while (best_.size() > lower_bound && !effort.spent(work())) {
    if (cover_.uncovered().empty()) {
      cover_.remove(cover_.easiest_to_remove());
      ++evaluations_;
    } else {
      exchange();
    }
    if (!cover_.uncovered().empty() || cover_.chosen().size() >= best_.size()) continue;
    best_.assign(cover_.chosen().begin(), cover_.chosen().end());
    effort.succeeded(work());
    on_better();
  }
}

void WholeCoverSearch::exchange() {
  // A single row is also the one added last.
  cover_.remove(cover_.can_remove() ? cover_.easiest_to_remove() : cover_.chosen().front());
  cover_.add(row_to_add());
  for (const Index column : cover_.uncovered()) cover_.raise(column, 1);
}

WholeCoverSearch::Index WholeCoverSearch::row_to_add() {
  const std::span<const Index> uncovered = cover_.uncovered();
  const std::span<const Index> rows = cover_.rows_of(uncovered[random_.below(uncovered.size())]);
  evaluations_ += rows.size();
  std::optional<Index> best;
  for (const Index row : rows) {
    if (!cover_.changed(row)) continue;
    if (!best || cover_.score(row) > cover_.score(*best) ||
        (cover_.score(row) == cover_.score(*best) &&
         cover_.moved_at(row) < cover_.moved_at(*best))) {
      best = row;
    }
  }
  // A column whose only row was removed last.
  return best.value_or(rows.front());
}

}  // namespace viewcover
