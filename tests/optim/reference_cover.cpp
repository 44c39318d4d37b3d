#include "reference_cover.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <random>

namespace viewcover::reference {
namespace {

using Set = std::vector<std::uint64_t>;

bool is_subset(const Set& a, const Set& b) {
  for (std::size_t w = 0; w < a.size(); ++w) {
    if ((a[w] & ~b[w]) != 0) return false;
  }
  return true;
}
bool intersects(const Set& a, const Set& b) {
  for (std::size_t w = 0; w < a.size(); ++w) {
    if ((a[w] & b[w]) != 0) return true;
  }
  return false;
}
bool has(const Set& set, std::size_t member) { return set[member / 64] >> (member % 64) & 1; }
void put(Set& set, std::size_t member) { set[member / 64] |= std::uint64_t{1} << (member % 64); }
std::size_t size(const Set& set) { return count_bits(set); }

/// Keeps the sets of which no other one (the first of equal ones) is a subset.
std::vector<Set> minimal_sets(std::vector<Set> sets) {
  std::ranges::stable_sort(sets, {}, [](const Set& set) { return size(set); });
  std::vector<Set> kept;
  for (const Set& set : sets) {
    if (std::ranges::none_of(kept, [&](const Set& other) { return is_subset(other, set); })) {
      kept.push_back(set);
    }
  }
  return kept;
}

class BranchAndBound {
 public:
  /// `columns`: the rows of each column, few first.
  BranchAndBound(std::vector<Set> columns, std::size_t rows) : columns_(std::move(columns)) {
    // A row whose columns another row has too is not needed.
    std::vector<Set> row_columns(rows, Set((columns_.size() + 63) / 64, 0));
    for (std::size_t c = 0; c < columns_.size(); ++c) {
      for (std::size_t r = 0; r < rows; ++r) {
        if (has(columns_[c], r)) put(row_columns[r], c);
      }
    }
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t s = 0; s < rows; ++s) {
        if (s == r || !is_subset(row_columns[r], row_columns[s])) continue;
        if (row_columns[r] == row_columns[s] && s > r) continue;
        for (Set& column : columns_) column[r / 64] &= ~(std::uint64_t{1} << (r % 64));
        break;
      }
    }
    columns_ = minimal_sets(std::move(columns_));
    row_limit_ = rows;
  }

  std::size_t solve() {
    best_ = row_limit_ + 1;
    branch(columns_, 0);
    return best_;
  }

 private:
  void branch(const std::vector<Set>& open, std::size_t chosen) {
    if (open.empty()) {
      best_ = std::min(best_, chosen);
      return;
    }
    if (chosen + bound(open) >= best_) return;
    // The column with the fewest rows; its rows in the order of how much they cover.
    const Set& rarest = *std::ranges::min_element(open, {}, [](const Set& s) { return size(s); });
    std::vector<std::pair<std::size_t, std::size_t>> rows;
    for_each_bit(rarest, [&](std::size_t r) {
      rows.emplace_back(std::ranges::count_if(open, [&](const Set& s) { return has(s, r); }), r);
    });
    std::ranges::sort(rows, std::greater<>());
    std::vector<Set> rest = open;
    for (const auto& [count, r] : rows) {
      std::vector<Set> left;
      for (const Set& column : rest) {
        if (!has(column, r)) left.push_back(column);
      }
      branch(left, chosen + 1);
      // From here on row r is not chosen.
      for (Set& column : rest) column[r / 64] &= ~(std::uint64_t{1} << (r % 64));
      if (std::ranges::any_of(rest, [](const Set& s) { return size(s) == 0; })) return;
    }
  }

  /// Columns no two of which share a row, few rows first.
  static std::size_t bound(std::vector<Set> open) {
    std::ranges::stable_sort(open, {}, [](const Set& s) { return size(s); });
    Set taken(open.front().size(), 0);
    std::size_t count = 0;
    for (const Set& column : open) {
      if (intersects(column, taken)) continue;
      for (std::size_t w = 0; w < taken.size(); ++w) taken[w] |= column[w];
      ++count;
    }
    return count;
  }

  std::vector<Set> columns_;
  std::size_t row_limit_ = 0;
  std::size_t best_ = 0;
};

/// Place number `index` on a square grid along the Z-shaped order of a quadtree.
std::pair<std::size_t, std::size_t> quadtree_place(std::size_t index) {
  std::size_t x = 0, y = 0;
  for (std::size_t bit = 0; bit < 16; ++bit) {
    x |= (index >> (2 * bit) & 1) << bit;
    y |= (index >> (2 * bit + 1) & 1) << bit;
  }
  return {x, y};
}

}  // namespace

std::size_t minimum_cover(const BitRows& matrix) {
  std::vector<Set> columns;
  for (std::size_t c = 0; c < matrix.columns(); ++c) {
    Set rows((matrix.rows() + 63) / 64, 0);
    for (std::size_t r = 0; r < matrix.rows(); ++r) {
      if (matrix.test(r, c)) put(rows, r);
    }
    if (size(rows) > 0) columns.push_back(std::move(rows));
  }
  if (columns.empty()) return 0;
  return BranchAndBound(minimal_sets(std::move(columns)), matrix.rows()).solve();
}

double maximum_coverage(const BitRows& matrix, std::span<const double> weights, std::size_t k) {
  assert(matrix.rows() <= 16);
  double best = 0;
  for (std::uint32_t set = 0; set < 1u << matrix.rows(); ++set) {
    if (static_cast<std::size_t>(std::popcount(set)) != k) continue;
    double covered = 0;
    for (std::size_t c = 0; c < matrix.columns(); ++c) {
      for (std::size_t r = 0; r < matrix.rows(); ++r) {
        if ((set >> r & 1) != 0 && matrix.test(r, c)) {
          covered += weights[c];
          break;
        }
      }
    }
    best = std::max(best, covered);
  }
  return best;
}

Room furnished_room(std::size_t side, std::size_t elements, int pieces, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  const auto unit = [&] { return static_cast<double>(generator() >> 11) * 0x1p-53; };
  struct Disc {
    double x, y, radius;
  };
  std::vector<Disc> furniture;
  for (int i = 0; i < pieces; ++i) {
    furniture.push_back({0.08 + 0.84 * unit(), 0.08 + 0.84 * unit(), 0.02 + 0.06 * unit()});
  }
  Room room{BitRows(side * side, elements), {}};
  for (std::size_t e = 0; e < elements; ++e) {
    // A point on a wall (one in three) or on a disc, its normal, and how flat it can be seen.
    double x, y, normal;
    if (generator() % 3 == 0) {
      const double along = unit();
      const std::size_t wall = generator() % 4;
      x = wall == 0 ? 0 : wall == 1 ? 1 : along;
      y = wall == 2 ? 0 : wall == 3 ? 1 : along;
      normal = std::atan2(0.5 - y, 0.5 - x);
      if (wall < 2) normal = wall == 0 ? 0 : std::numbers::pi;
      if (wall >= 2) normal = wall == 2 ? std::numbers::pi / 2 : -std::numbers::pi / 2;
    } else {
      const Disc& disc = furniture[generator() % furniture.size()];
      normal = 2 * std::numbers::pi * unit();
      x = disc.x + 1.001 * disc.radius * std::cos(normal);
      y = disc.y + 1.001 * disc.radius * std::sin(normal);
    }
    const double least_cosine = unit() < 0.2 ? 0.8 * unit() : 0;
    room.weights.push_back(0.1 * std::pow(unit(), 3) + 1e-4);
    for (std::size_t r = 0; r < side * side; ++r) {
      const auto [column, line] = quadtree_place(r);
      const double dx = (static_cast<double>(column) + 0.5) / static_cast<double>(side) - x;
      const double dy = (static_cast<double>(line) + 0.5) / static_cast<double>(side) - y;
      const double distance = std::hypot(dx, dy);
      const double cosine = (dx * std::cos(normal) + dy * std::sin(normal)) / distance;
      if (cosine <= least_cosine) continue;
      const bool blocked = std::ranges::any_of(furniture, [&](const Disc& disc) {
        const double t =
            std::clamp(((disc.x - x) * dx + (disc.y - y) * dy) / (distance * distance), 0.0, 1.0);
        return std::hypot(x + t * dx - disc.x, y + t * dy - disc.y) < disc.radius;
      });
      if (!blocked) room.matrix.set(r, e);
    }
  }
  return room;
}

}  // namespace viewcover::reference
