#include "optim/scored_cover.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace viewcover {
namespace {

/// Looking at all chosen rows is faster than telling the queue of more than this share of them.
constexpr std::size_t kScanShare = 8;

}  // namespace

ScoredCover::ScoredCover(const Incidence& lists, std::vector<Score> weights)
    : lists_(&lists),
      scores_(lists.row_count(), 0),
      changed_(lists.row_count(), 1),
      times_covered_(lists.column_count(), 0),
      row_mix_(lists.column_count(), 0),
      moved_at_(lists.row_count(), 0),
      removable_(lists.row_count()),
      is_stale_(lists.row_count(), 0),
      place_(lists.row_count(), kNowhere),
      uncovered_(lists.column_count()),
      uncovered_place_(lists.column_count()) {
  std::iota(uncovered_.begin(), uncovered_.end(), Index{0});
  std::iota(uncovered_place_.begin(), uncovered_place_.end(), Index{0});
  set_weights(std::move(weights));
}

void ScoredCover::score_changed(Index chosen_row) {
  ++changes_;
  if (is_stale_[chosen_row]) return;
  is_stale_[chosen_row] = 1;
  stale_.push_back(chosen_row);
}

ScoredCover::Index ScoredCover::easiest_to_remove() {
  assert(can_remove());
  const bool few_changes = changes_ * kScanShare < chosen_.size();
  changes_ = 0;
  if (few_changes) {
    for (const Index row : stale_) {
      is_stale_[row] = 0;
      removable_.change(row, scores_[row]);
    }
    stale_.clear();
    return removable_.top();
  }
  Index easiest = kNowhere;
  for (const Index row : chosen_) {
    if (row == newest_) continue;
    if (easiest == kNowhere || scores_[row] < scores_[easiest] ||
        (scores_[row] == scores_[easiest] && moved_at_[row] < moved_at_[easiest])) {
      easiest = row;
    }
  }
  return easiest;
}

void ScoredCover::add(Index row) {
  assert(!contains(row));
  place_[row] = static_cast<Index>(chosen_.size());
  chosen_.push_back(row);
  moved_at_[row] = ++moves_;
  if (newest_ != kNowhere) removable_.push(newest_, scores_[newest_], moved_at_[newest_]);
  newest_ = row;
  const Score gain = scores_[row];
  work_ += lists_->columns_of(row).size();
  for (const Index column : lists_->columns_of(row)) {
    const Index times = ++times_covered_[column];
    const Index other = row_mix_[column];
    row_mix_[column] ^= row;
    if (times > 2) continue;
    const Score weight = weights_[column];
    if (times == 2) {
      scores_[other] -= weight;
      score_changed(other);
      continue;
    }
    work_ += rows_of(column).size();
    for (const Index covering : rows_of(column)) {
      scores_[covering] -= weight;
      changed_[covering] = 1;
    }
    const Index moved = uncovered_.back();
    uncovered_[uncovered_place_[column]] = moved;
    uncovered_place_[moved] = uncovered_place_[column];
    uncovered_.pop_back();
  }
  // What the row gained is what it alone covers now.
  scores_[row] = gain;
  uncovered_weight_ -= gain;
}

void ScoredCover::remove(Index row) {
  assert(contains(row));
  const Index last = chosen_.back();
  chosen_[place_[row]] = last;
  place_[last] = place_[row];
  chosen_.pop_back();
  place_[row] = kNowhere;
  moved_at_[row] = ++moves_;
  if (newest_ == row) {
    newest_ = kNowhere;
  } else {
    removable_.erase(row);
  }
  const Score loss = scores_[row];
  work_ += lists_->columns_of(row).size();
  for (const Index column : lists_->columns_of(row)) {
    const Index times = --times_covered_[column];
    row_mix_[column] ^= row;
    if (times > 1) continue;
    const Score weight = weights_[column];
    if (times == 1) {
      const Index sole = row_mix_[column];
      scores_[sole] += weight;
      score_changed(sole);
      continue;
    }
    work_ += rows_of(column).size();
    for (const Index covering : rows_of(column)) {
      scores_[covering] += weight;
      changed_[covering] = 1;
    }
    uncovered_place_[column] = static_cast<Index>(uncovered_.size());
    uncovered_.push_back(column);
  }
  scores_[row] = loss;
  changed_[row] = 0;
  uncovered_weight_ += loss;
}

void ScoredCover::raise(Index column, Score by) {
  assert(times_covered_[column] == 0);
  weights_[column] += by;
  uncovered_weight_ += by;
  work_ += rows_of(column).size();
  for (const Index row : rows_of(column)) scores_[row] += by;
}

void ScoredCover::set_weights(std::vector<Score> weights) {
  assert(weights.size() == times_covered_.size());
  weights_ = std::move(weights);
  work_ += lists_->ones();
  uncovered_weight_ = 0;
  for (const Index column : uncovered_) uncovered_weight_ += weights_[column];
  for (Index row = 0; row < scores_.size(); ++row) {
    const Index alone = contains(row) ? 1 : 0;
    Score score = 0;
    for (const Index column : lists_->columns_of(row)) {
      if (times_covered_[column] == alone) score += weights_[column];
    }
    scores_[row] = score;
    if (contains(row)) score_changed(row);
  }
}

}  // namespace viewcover
