#include "viewpoints/refined_bound.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "optim/exact_cover.h"
#include "viewpoints/column_bits.h"
#include "viewpoints/pool_cover.h"

namespace viewcover {
namespace {

/// Cells split in a round.
constexpr std::size_t kSplits = 64;
constexpr std::size_t kNodes = 500;
/// Prices come from floating point.
constexpr double kPriceTolerance = 1e-6;

}  // namespace

BoundRefinement::BoundRefinement(const RegionViews& views, std::span<const std::uint32_t> columns,
                                 SearchLimits& limits, std::uint64_t seed)
    : views_(views), limits_(limits), seed_(seed) {
  const BitRows& bits = views.matrix().bits;
  std::vector<BitRows::Word> asked(bits.words_per_row(), 0);
  for (const std::uint32_t column : columns) add_column(asked, column);
  for (std::size_t region = 0; region < bits.rows(); ++region) {
    Cell& cell = cells_.emplace_back();
    cell.address = views.region().address(region);
    cell.region = region;
    cell.polygon = views.positions(region).region();
    cell.seen.assign(bits.row(region).begin(), bits.row(region).end());
    for (std::size_t w = 0; w < asked.size(); ++w) cell.seen[w] &= asked[w];
  }
}

bool BoundRefinement::refine() {
  const BitRows matrix = rows();
  PoolCover cover = cover_pool(matrix, kNodes, seed_, limits_);
  if (limits_.expired()) return false;
  cover_ = std::move(cover.chosen);
  prices_ = std::move(cover.prices);
  find_middles();
  if (cover.lower_bound > bound_.lower_bound) keep_proof(matrix);
  const std::vector<std::size_t> parents = cells_to_split();
  if (parents.empty() || limits_.expired()) return false;
  split(parents);
  return !limits_.expired();
}

BitRows BoundRefinement::rows() const {
  BitRows rows(cells_.size(), views_.column_count());
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    std::ranges::copy(cells_[i].seen, rows.row(i).begin());
  }
  return rows;
}

void BoundRefinement::keep_proof(const BitRows& rows) {
  CoverOptions options;
  options.goal = CoverGoal::kWholeCover;
  options.seed = seed_;
  // 0 would be none.
  options.time_limit_seconds = std::max(limits_.seconds_left(), 1e-3);
  const CoverInstance instance(rows, std::vector<double>(rows.columns(), 1.0));
  const RegionCover proved = ExactCover().solve(instance, options);
  if (proved.lower_bound <= bound_.lower_bound) return;
  bound_.lower_bound = proved.lower_bound;
  bound_.proof = proved.proof;
  bound_.seen = rows;
  bound_.cells.clear();
  for (const Cell& cell : cells_) bound_.cells.push_back(cell.address);
}

std::vector<std::size_t> BoundRefinement::cells_to_split() const {
  const ColumnWeights prices(prices_);
  std::vector<std::size_t> parents;
  const auto add = [&](std::size_t cell) {
    if (cells_[cell].address.level() < kMaxSubdivisionLevel) parents.push_back(cell);
  };
  std::ranges::for_each(cover_, add);
  const std::size_t first_other = parents.size();
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (std::ranges::binary_search(cover_, i)) continue;
    if (prices.of(cells_[i].seen) >= 1 - kPriceTolerance) add(i);
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
  std::vector<std::array<Cell, 4>> children(parents.size());
  tbb::parallel_for(std::size_t{0}, 4 * parents.size(), [&](std::size_t job) {
    const Cell& parent = cells_[parents[job / 4]];
    Cell& child = children[job / 4][job % 4];
    const int digit = static_cast<int>(job % 4);
    child = {parent.address.child(digit), parent.region, quarters(parent.polygon)[job % 4],
             std::vector<BitRows::Word>(parent.seen.size(), 0)};
    for_each_bit(std::span<const BitRows::Word>(parent.seen), [&](std::size_t column) {
      if (limits_.due() || views_.cell_sees(child.region, child.address, child.polygon, column)) {
        add_column(child.seen, column);
      }
    });
  });
  std::vector<Cell> cells;
  std::size_t next = 0;
  for (std::size_t i = 0; i < cells_.size(); ++i) {
    if (next < parents.size() && parents[next] == i) {
      for (Cell& child : children[next]) cells.push_back(std::move(child));
      ++next;
    } else {
      cells.push_back(std::move(cells_[i]));
    }
  }
  cells_ = std::move(cells);
}

void BoundRefinement::find_middles() {
  middles_.clear();
  for (const std::size_t i : cover_) {
    const Cell& cell = cells_[i];
    middles_.push_back(
        {cell.region, views_.positions(cell.region).nearest(centroid(cell.polygon))});
  }
}

}  // namespace viewcover
