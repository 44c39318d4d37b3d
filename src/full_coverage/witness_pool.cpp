#include "full_coverage/witness_pool.h"

#include <tbb/parallel_for.h>

#include <algorithm>
namespace viewcover {

bool WitnessPool::add(const Viewpoint& viewpoint) {
  const bool is_here = std::ranges::any_of(
      viewpoints_, [&](const Viewpoint& other) { return other.position == viewpoint.position; });
  if (is_here) return false;
  viewpoints_.push_back(viewpoint);
  seen_.emplace_back();
  seen_elements_.emplace_back();
  looked_.push_back(0);
  return true;
}

void WitnessPool::look() {
  std::vector<BitRows::Word> wanted(views_.matrix().bits.words_per_row(), 0);
  for (const std::size_t column : elements_) add_column(wanted, column);
  tbb::parallel_for(std::size_t{0}, viewpoints_.size(), [&](std::size_t i) {
    seen_[i].resize((witnesses_.size() + 63) / 64, 0);
    for (std::size_t w = looked_[i]; w < witnesses_.size(); ++w) {
      if (witnesses_.is_seen(viewpoints_[i].position, witnesses_[w])) add_column(seen_[i], w);
    }
    looked_[i] = witnesses_.size();
    if (!elements_.empty() && seen_elements_[i].empty()) {
      seen_elements_[i].resize(wanted.size(), 0);
      views_.look(viewpoints_[i].region, viewpoints_[i].position, seen_elements_[i], wanted);
    }
  });
}

void WitnessPool::keep(std::span<const std::size_t> rows) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i] == i) continue;
    viewpoints_[i] = viewpoints_[rows[i]];
    seen_[i] = std::move(seen_[rows[i]]);
    seen_elements_[i] = std::move(seen_elements_[rows[i]]);
    looked_[i] = looked_[rows[i]];
  }
  viewpoints_.resize(rows.size());
  seen_.resize(rows.size());
  seen_elements_.resize(rows.size());
  looked_.resize(rows.size());
}

BitRows WitnessPool::rows() const {
  BitRows rows(viewpoints_.size(), witnesses_.size());
  for (std::size_t i = 0; i < viewpoints_.size(); ++i) {
    std::ranges::copy(seen_[i], rows.row(i).begin());
  }
  return rows;
}

}  // namespace viewcover
