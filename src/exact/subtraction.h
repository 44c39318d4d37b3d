#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "exact/cell.h"

namespace viewcover::exact {

/// A functional or its opposite.
template <int D>
struct Side {
  const LazyVector<D>* functional = nullptr;
  int sign = 1;
};

/// A blocking cone: where all sides are >= 0. At most 64 of them.
template <int D>
struct Blocker {
  std::vector<Side<D>> sides;
};

enum class SubtractionOutcome {
  kDone,    ///< everything was looked at
  kEnded,   ///< `on_free` ended the search
  kGaveUp,  ///< more cells than allowed
};

/// Subtracts blocking cones from a cell, exactly: depth first, the blocker that holds the most rays
/// first (papers/exact.md, section 4).
///
/// `Rules` says what counts:
///   bool holds_anything(const Cell<D>&): false for a cell that may be forgotten
///   bool on_free(const Cell<D>&): called for a part that no blocker meets; true ends the search
template <int D, class Rules>
class Subtraction {
 public:
  Subtraction(VectorPool<D>& pool, std::span<const Blocker<D>> blockers, Rules& rules,
              std::uint64_t most_cells = std::numeric_limits<std::uint64_t>::max())
      : pool_(pool), blockers_(blockers), rules_(rules), cells_left_(most_cells) {}

  SubtractionOutcome run(const Cell<D>& root) {
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < blockers_.size(); ++i) {
      candidates.push_back({static_cast<std::uint32_t>(i), all_sides(blockers_[i])});
    }
    const bool ended = visit(root, candidates);
    return gave_up_ ? SubtractionOutcome::kGaveUp
           : ended  ? SubtractionOutcome::kEnded
                    : SubtractionOutcome::kDone;
  }
  /// The blocker that covers the whole root, where one was found to.
  std::optional<std::size_t> covering_blocker() const { return covering_blocker_; }

 private:
  /// A blocker that may meet a cell, and the sides that may cut it: on the others it is >= 0.
  struct Candidate {
    std::uint32_t blocker;
    std::uint64_t sides;
  };
  static std::uint64_t all_sides(const Blocker<D>& blocker) {
    return ~std::uint64_t{0} >> (64 - blocker.sides.size());
  }

  /// The rays of a cell, component by component, and the two factors of the error bound on their
  /// products (`VectorPool::bound`): what the loop over them reads.
  class Table {
   public:
    explicit Table(const Cell<D>& cell) : n_(cell.size()), values_((D + 2) * n_) {
      for (std::size_t i = 0; i < n_; ++i) {
        const auto& ray = cell.ray(i)->approximate();
        for (std::size_t k = 0; k < D; ++k) values_[k * n_ + i] = ray.x[k];
        values_[D * n_ + i] = VectorPool<D>::bound(1, 0, ray.size, ray.error, VectorPool<D>::kUnit);
        values_[(D + 1) * n_ + i] =
            VectorPool<D>::bound(0, 1, ray.size, ray.error, VectorPool<D>::kUnit);
      }
    }
    /// Scalar products of a vector with all rays, and bounds on their errors.
    void multiply(const Approximation<D, double>& f, double* __restrict products,
                  double* __restrict bounds) const {
      const double* const x = values_.data();
      const std::size_t n = n_;
      for (std::size_t i = 0; i < n; ++i) products[i] = f.x[0] * x[i];
      for (std::size_t k = 1; k < D; ++k) {
        const double factor = f.x[k];
        const double* const xk = x + k * n;
        for (std::size_t i = 0; i < n; ++i) products[i] += factor * xk[i];
      }
      const double* const per_size = x + D * n;
      const double* const per_error = x + (D + 1) * n;
      const double size = VectorPool<D>::kRoundUp * f.size,
                   error = VectorPool<D>::kRoundUp * f.error;
      for (std::size_t i = 0; i < n; ++i) bounds[i] = size * per_size[i] + error * per_error[i];
    }

   private:
    std::size_t n_;
    SmallList<double, (D + 2) * kUsualRays> values_;
  };

  struct Signs {
    SmallList<std::int8_t, kUsualRays> of_ray;
    bool positive = false, negative = false;
  };

  /// Signs of a side on all rays.
  void evaluate(const Cell<D>& cell, const Table& table, const Side<D>& side, Signs& signs) {
    const std::size_t n = cell.size();
    products_.resize(n);
    bounds_.resize(n);
    table.multiply(side.functional->approximate(), products_.data(), bounds_.data());
    signs.of_ray.resize(n);
    std::int8_t* const of_ray = signs.of_ray.data();
    bool positive = false, negative = false, unsure = false;
    for (std::size_t i = 0; i < n; ++i) {
      const double product = side.sign * products_[i];
      const bool above = product > bounds_[i], below = product < -bounds_[i];
      of_ray[i] = static_cast<std::int8_t>(above - below);
      positive |= above;
      negative |= below;
      unsure |= !(above | below);
    }
    pool_.statistics().filtered_signs += n;
    if (unsure) {
      for (std::size_t i = 0; i < n; ++i) {
        if (signs.of_ray[i] != 0) continue;
        --pool_.statistics().filtered_signs;
        if (cell.is_known_zero(i, side.functional)) continue;
        const int sign = side.sign * pool_.exact_sign(*side.functional, *cell.ray(i));
        signs.of_ray[i] = static_cast<std::int8_t>(sign);
        positive |= sign > 0;
        negative |= sign < 0;
      }
    }
    signs.positive = positive;
    signs.negative = negative;
  }

  /// True to end the search.
  bool visit(const Cell<D>& cell, std::span<const Candidate> candidates) {
    if (cells_left_ == 0) return gave_up_ = true;
    --cells_left_;
    ++pool_.statistics().cells;
    if (!rules_.holds_anything(cell)) return false;
    const std::size_t n = cell.size();
    const Table table(cell);
    SmallList<Candidate, 64> left;
    std::size_t best = 0, most = 0;
    Signs signs;
    SmallList<std::int8_t, kUsualRays> outside;
    for (Candidate candidate : candidates) {
      const Blocker<D>& blocker = blockers_[candidate.blocker];
      outside.assign(n, 0);
      bool meets = true;
      for (std::uint64_t sides = candidate.sides; sides != 0 && meets; sides &= sides - 1) {
        const int k = std::countr_zero(sides);
        evaluate(cell, table, blocker.sides[static_cast<std::size_t>(k)], signs);
        meets = signs.positive;
        if (!signs.negative) candidate.sides &= ~(std::uint64_t{1} << k);
        for (std::size_t i = 0; i < n; ++i) outside[i] = std::min(outside[i], signs.of_ray[i]);
      }
      if (!meets) continue;
      if (candidate.sides == 0) {  // it covers the cell
        if (!cut_) covering_blocker_ = candidate.blocker;
        return false;
      }
      const auto inside =
          static_cast<std::size_t>(std::count(outside.begin(), outside.end(), std::int8_t{0}));
      if (left.empty() || inside > most) {
        best = left.size();
        most = inside;
      }
      left.push_back(candidate);
    }
    if (left.empty()) return rules_.on_free(cell);

    const Candidate chosen = left[best];
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    return subtract(cell, chosen, left);
  }

  /// Visits what the chosen blocker leaves of the cell: one part for each side that cuts it.
  bool subtract(Cell<D> cell, Candidate chosen, std::span<const Candidate> others) {
    const Blocker<D>& blocker = blockers_[chosen.blocker];
    Signs signs, best_signs;
    while (true) {
      const Table table(cell);
      const Side<D>* best = nullptr;
      std::size_t most = 0;
      for (std::uint64_t sides = chosen.sides; sides != 0; sides &= sides - 1) {
        const int k = std::countr_zero(sides);
        const Side<D>& side = blocker.sides[static_cast<std::size_t>(k)];
        evaluate(cell, table, side, signs);
        if (!signs.positive) return visit(cell, others);  // what is left lies outside
        if (!signs.negative) {
          chosen.sides &= ~(std::uint64_t{1} << k);
          continue;
        }
        const auto outside = static_cast<std::size_t>(
            std::count(signs.of_ray.begin(), signs.of_ray.end(), std::int8_t{-1}));
        if (best == nullptr || outside > most) {
          best = &side;
          most = outside;
          best_signs = signs;
        }
      }
      if (best == nullptr) return false;  // the rest is blocked
      ++pool_.statistics().splits;
      cut_ = true;
      auto& s = best_signs.of_ray;
      if (best->sign < 0) {
        for (std::int8_t& sign : s) sign = static_cast<std::int8_t>(-sign);
      }
      const auto made = cell.cut_rays(pool_, best->functional, s);
      const Cell<D> outside = cell.part(best->functional, s, -best->sign, made);
      cell = cell.part(best->functional, s, best->sign, made);
      if (visit(outside, others)) return true;
    }
  }

  VectorPool<D>& pool_;
  std::span<const Blocker<D>> blockers_;
  Rules& rules_;
  std::vector<double> products_, bounds_;
  std::uint64_t cells_left_;
  bool gave_up_ = false;
  bool cut_ = false;  // the root was cut
  std::optional<std::size_t> covering_blocker_;
};

}  // namespace viewcover::exact
