#include "viewpoints/candidate_pool.h"

#include <algorithm>
#include <numeric>

#include "viewpoints/column_bits.h"

namespace viewcover {
bool CandidatePool::add(Candidate candidate) {
  if (std::ranges::any_of(candidates_, [&](const Candidate& other) {
        return is_subset(candidate.seen, other.seen);
      })) {
    return false;
  }
  std::erase_if(candidates_,
                [&](const Candidate& other) { return is_subset(other.seen, candidate.seen); });
  candidates_.push_back(std::move(candidate));
  return true;
}

void CandidatePool::keep_best(std::size_t most, std::span<const double> scores) {
  if (candidates_.size() <= most) return;
  std::vector<std::size_t> order(candidates_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t i) { return scores[i]; });
  order.resize(most);
  std::ranges::sort(order);
  std::vector<Candidate> kept;
  for (const std::size_t i : order) kept.push_back(std::move(candidates_[i]));
  candidates_ = std::move(kept);
}

BitRows CandidatePool::rows() const {
  BitRows rows(candidates_.size(), columns_);
  for (std::size_t i = 0; i < candidates_.size(); ++i) {
    std::ranges::copy(candidates_[i].seen, rows.row(i).begin());
  }
  return rows;
}

std::vector<std::size_t> CandidatePool::viewers() const {
  std::vector<std::size_t> count(columns_, 0);
  for (const Candidate& candidate : candidates_) {
    for_each_bit(std::span<const BitRows::Word>(candidate.seen),
                 [&](std::size_t column) { ++count[column]; });
  }
  return count;
}

}  // namespace viewcover
