#include "viewpoints/refined_bound.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "optim/region_cover.h"
#include "viewpoints/column_bits.h"
#include "viewpoints/pool_cover.h"

namespace viewcover {
namespace {

/// Cells split in a round.
constexpr std::size_t kSplits = 64;

}  // namespace

BoundRefinement::BoundRefinement(const CellViews& views, std::span<const std::uint32_t> columns,
                                 SearchLimits& limits, std::uint64_t seed,
                                 const PoolCoverEffort& effort)
    : views_(views), limits_(limits), seed_(seed), effort_(effort) {
  const ViewingRegion& region = views.region();
  for (std::size_t i = 0; i < region.region_count(); ++i) {
    cells_.push_back({region.address(i), i, views.positions(i).region()});
  }
  seen_.resize(cells_.size());
  lends_ = views_.lends(cells_);
  ask(columns);
}

void BoundRefinement::ask(std::span<const std::uint32_t> columns) {
  const std::size_t words = (views_.column_count() + 63) / 64;
  asked_.resize(words, 0);
  std::vector<std::uint32_t> fresh;
  for (const std::uint32_t column : columns) {
    if (has_column(asked_, column)) continue;
    add_column(asked_, column);
    fresh.push_back(column);
  }
  tbb::parallel_for(std::size_t{0}, cells_.size(), [&](std::size_t i) {
    const RegionCell& cell = cells_[i];
    const bool is_region = cell.address.level() == views_.region().level;
    seen_[i].resize(words, 0);
    for (const std::uint32_t column : fresh) {
      if (views_.region_sees(cell.region, column) &&
          (is_region || limits_.due() || views_.cell_sees(cell, column))) {
        add_column(seen_[i], column);
      }
    }
  });
}

bool BoundRefinement::refine() {
  const BitRows matrix = rows();
  PoolCover cover = cover_pool(matrix, effort_, seed_, limits_);
  if (limits_.expired()) return false;
  cover_ = std::move(cover.chosen);
  prices_ = std::move(cover.prices);
  find_middles();
  if (cover.lower_bound > bound_.lower_bound) keep_proof(matrix);
  const std::vector<std::size_t> parents = cells_to_split(matrix);
  if (parents.empty() || limits_.expired()) return false;
  split(parents);
  return !limits_.expired();
}

BitRows BoundRefinement::rows() const {
  BitRows rows(cells_.size(), views_.column_count());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    std::ranges::copy(seen_[i], rows.row(i).begin());
  }
  for (const auto& [borrower, lender] : lends_) {
    for (std::size_t w = 0; w < rows.words_per_row(); ++w) {
      rows.row(borrower)[w] |= seen_[lender][w];
    }
  }
  return rows;
}

void BoundRefinement::keep_proof(const BitRows& rows) {
  const CoverInstance canonical(rows, std::vector<double>(rows.columns(), 1.0));
  PoolCoverEffort effort = effort_;
  effort.proof = true;
  PoolCover cover = cover_pool(canonical.rows(), effort, seed_, limits_);
  if (cover.lower_bound <= bound_.lower_bound) return;
  bound_.lower_bound = cover.lower_bound;
  bound_.proof = std::make_shared<const CoverProof>(std::move(cover.proof));
  bound_.seen = rows;
  bound_.cells.clear();
  for (const RegionCell& cell : cells_) bound_.cells.push_back(cell.address);
}

std::vector<std::size_t> BoundRefinement::cells_to_split(const BitRows& rows) const {
  const ColumnWeights prices(prices_);
  std::vector<bool> is_taken(cells_.size(), false);
  std::vector<std::size_t> parents;
  const auto add = [&](std::size_t cell) {
    if (is_taken[cell] || cells_[cell].address.level() >= kMaxSubdivisionLevel) return;
    is_taken[cell] = true;
    parents.push_back(cell);
  };
  std::ranges::for_each(cover_, add);
  for (const auto& [borrower, lender] : lends_) {
    if (std::ranges::binary_search(cover_, borrower)) add(lender);
  }
  const std::size_t first_other = parents.size();
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (prices.of(rows.row(i)) >= 1 - PoolCover::kPriceTolerance) add(i);
  }
  // Large ones first.
  std::stable_sort(parents.begin() + static_cast<std::ptrdiff_t>(first_other), parents.end(),
                   [&](std::size_t a, std::size_t b) {
                     return cells_[a].address.level() < cells_[b].address.level();
                   });
  if (parents.size() > kSplits) parents.resize(std::max(kSplits, first_other));
  std::ranges::sort(parents);
  return parents;
}

void BoundRefinement::split(std::span<const std::size_t> parents) {
  std::vector<RegionCell> children(4 * parents.size());
  std::vector<std::vector<BitRows::Word>> seen(children.size());
  tbb::parallel_for(std::size_t{0}, children.size(), [&](std::size_t job) {
    const RegionCell& parent = cells_[parents[job / 4]];
    RegionCell& child = children[job];
    child = {parent.address.child(static_cast<int>(job % 4)), parent.region,
             parent.shape.quarters()[job % 4]};
    const std::vector<BitRows::Word>& of_parent = seen_[parents[job / 4]];
    seen[job].assign(of_parent.size(), 0);
    for_each_bit(std::span<const BitRows::Word>(of_parent), [&](std::size_t column) {
      if (limits_.due() || views_.cell_sees(child, column)) add_column(seen[job], column);
    });
  });
  std::vector<RegionCell> cells;
  std::vector<std::vector<BitRows::Word>> seen_by_cell;
  std::size_t next = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    const bool is_parent = next < 4 * parents.size() && parents[next / 4] == i;
    const std::size_t count = is_parent ? 4 : 1;
    for (std::size_t k = 0; k < count; ++k) {
      cells.push_back(std::move(is_parent ? children[next + k] : cells_[i]));
      seen_by_cell.push_back(std::move(is_parent ? seen[next + k] : seen_[i]));
    }
    if (is_parent) next += 4;
  }
  cells_ = std::move(cells);
  seen_ = std::move(seen_by_cell);
  lends_ = views_.lends(cells_);
}

void BoundRefinement::find_middles() {
  middles_.clear();
  for (const std::size_t i : cover_) {
    const RegionCell& cell = cells_[i];
    middles_.push_back({cell.region, views_.positions(cell.region).nearest(cell.shape.middle())});
  }
}

}  // namespace viewcover
