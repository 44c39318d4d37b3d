#include <algorithm>
#include <cassert>
#include <limits>
#include <numeric>
#include <unordered_map>

#include "optim/region_cover.h"

namespace viewcover {
namespace {

/// Rows of every column, ascending, packed one column after the other.
struct ColumnLists {
  std::vector<std::uint32_t> rows;
  std::vector<std::size_t> begin;  ///< #columns + 1

  explicit ColumnLists(const BitRows& matrix) : begin(matrix.columns() + 1, 0) {
    for (std::size_t r = 0; r < matrix.rows(); ++r) {
      for_each_bit(matrix.row(r), [&](std::size_t column) { ++begin[column + 1]; });
    }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    rows.resize(begin.back());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    for (std::size_t r = 0; r < matrix.rows(); ++r) {
      for_each_bit(matrix.row(r), [&](std::size_t column) {
        rows[next[column]++] = static_cast<std::uint32_t>(r);
      });
    }
  }

  std::span<const std::uint32_t> operator[](std::size_t column) const {
    return std::span(rows).subspan(begin[column], begin[column + 1] - begin[column]);
  }
  std::size_t size() const { return begin.size() - 1; }
};

/// FNV-1a over the row numbers; only spreads columns over buckets, equality is checked.
std::uint64_t hash_of(std::span<const std::uint32_t> rows) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const std::uint32_t row : rows) hash = (hash ^ row) * 0x100000001b3;
  return hash;
}

}  // namespace

CoverInstance::CoverInstance(const BitRows& matrix, std::span<const double> weights) {
  assert(weights.size() == matrix.columns());
  const ColumnLists columns(matrix);
  std::vector<std::size_t> representatives;  // column of `matrix` for each merged column
  std::unordered_multimap<std::uint64_t, std::size_t> merged_by_hash;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    const std::span<const std::uint32_t> rows = columns[column];
    if (rows.empty()) continue;
    assert(weights[column] >= 0);
    const std::uint64_t hash = hash_of(rows);
    const auto [first, last] = merged_by_hash.equal_range(hash);
    const auto same = std::find_if(first, last, [&](const auto& entry) {
      return std::ranges::equal(columns[representatives[entry.second]], rows);
    });
    if (same != last) {
      weights_[same->second] += weights[column];
    } else {
      merged_by_hash.emplace(hash, representatives.size());
      representatives.push_back(column);
      weights_.push_back(weights[column]);
    }
  }

  rows_ = BitRows(matrix.rows(), representatives.size());
  for (std::size_t merged = 0; merged < representatives.size(); ++merged) {
    for (const std::uint32_t row : columns[representatives[merged]]) rows_.set(row, merged);
  }
  total_weight_ = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  for (std::size_t r = 0; r < rows_.rows(); ++r) {
    heaviest_.push_back(weight_of(rows_.row(r), weights_));
  }
  std::ranges::sort(heaviest_, std::greater<>());
}

bool CoverInstance::covers_all(std::span<const std::size_t> chosen) const {
  return count_bits(rows_.union_of(chosen)) == rows_.columns();
}

double CoverInstance::covered_weight(std::span<const std::size_t> chosen) const {
  return weight_of(rows_.union_of(chosen), weights_);
}

double CoverInstance::covered_percent(std::span<const std::size_t> chosen) const {
  if (total_weight_ == 0 || covers_all(chosen)) return 100;
  return std::min(100.0, 100 * (covered_weight(chosen) / total_weight_));
}

std::size_t CoverInstance::lower_bound() const {
  const ColumnLists columns(rows_);
  std::vector<std::size_t> order(columns.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t column) { return columns[column].size(); });
  std::vector<bool> row_taken(rows_.rows(), false);
  std::size_t independent = 0;
  for (const std::size_t column : order) {
    const std::span<const std::uint32_t> rows = columns[column];
    if (std::ranges::any_of(rows, [&](std::uint32_t row) { return row_taken[row]; })) continue;
    for (const std::uint32_t row : rows) row_taken[row] = true;
    ++independent;
  }
  return independent;
}

double CoverInstance::upper_bound_percent(std::size_t k) const {
  if (total_weight_ == 0) return 100;
  const std::size_t count = std::min(k, heaviest_.size());
  const double sum = std::accumulate(heaviest_.begin(), heaviest_.begin() + count, 0.0);
  // A sum of m terms >= 0 has a relative error below m u / (1 - m u), u = 2^-53 (Higham, Accuracy
  // and Stability of Numerical Algorithms, section 4.2). The row weights and the total have at most
  // #columns terms, the sum over rows k more, quotient and product three roundings; epsilon = 2 u
  // leaves room for the denominators and for rounding the factor itself.
  const double terms = 2 * static_cast<double>(weights_.size()) + static_cast<double>(count) + 8;
  const double factor = 1 + terms * std::numeric_limits<double>::epsilon();
  return std::min(100.0, 100 * (sum / total_weight_) * factor);
}

}  // namespace viewcover
