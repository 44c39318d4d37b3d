#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
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
    bool ended = visit(root, candidates);
    while (!ended && !frames_.empty()) ended = advance();
    frames_.clear();
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
      for (std::size_t i = 0; i < n_; ++i) set(i, cell.ray(i)->approximate());
    }
    void set(std::size_t i, const Approximation<D, double>& ray) {
      for (std::size_t k = 0; k < D; ++k) values_[k * n_ + i] = ray.x[k];
      values_[D * n_ + i] = VectorPool<D>::bound(1, 0, ray.size, ray.error, VectorPool<D>::kUnit);
      values_[(D + 1) * n_ + i] =
          VectorPool<D>::bound(0, 1, ray.size, ray.error, VectorPool<D>::kUnit);
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
  void evaluate(const Cell<D>& cell, Table& table, const Side<D>& side, Signs& signs) {
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
        const LazyVector<D>& ray = *cell.ray(i);
        if (cell.is_known_zero(i, side.functional) ||
            VectorPool<D>::is_known_zero(ray, *side.functional)) {
          continue;
        }
        const bool sharper = pool_.sharpen(ray);
        if (sharper) table.set(i, ray.approximate());
        const int sign = side.sign * (sharper ? pool_.sign_of_product(*side.functional, ray)
                                              : pool_.exact_sign(*side.functional, ray));
        if (sign == 0) pool_.note_zero(ray, *side.functional);
        signs.of_ray[i] = static_cast<std::int8_t>(sign);
        positive |= sign > 0;
        negative |= sign < 0;
      }
    }
    signs.positive = positive;
    signs.negative = negative;
  }

  /// A cell from which one blocker is being subtracted, and what else may meet its parts.
  struct Frame {
    Cell<D> cell;
    Candidate chosen;
    SmallList<Candidate, 16> others;
  };

  /// Looks at a cell: it is forgotten, free, covered, or becomes a frame. True to end the search.
  bool visit(const Cell<D>& cell, std::span<const Candidate> candidates) {
    if (cells_left_ == 0) return gave_up_ = true;
    --cells_left_;
    ++pool_.statistics().cells;
    if (!rules_.holds_anything(cell)) return false;
    const std::size_t n = cell.size();
    Table table(cell);
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
    frames_.push_back(std::make_unique<Frame>(Frame{cell, chosen, {left.begin(), left.end()}}));
    return false;
  }

  /// Cuts off the frame's cell what lies outside one side of the chosen blocker, the one with most
  /// rays outside; what is inside all sides is blocked. True to end the search.
  bool advance() {
    Frame& frame = *frames_.back();
    const Blocker<D>& blocker = blockers_[frame.chosen.blocker];
    Table table(frame.cell);
    Signs signs, best_signs;
    const Side<D>* best = nullptr;
    std::size_t most = 0;
    for (std::uint64_t sides = frame.chosen.sides; sides != 0; sides &= sides - 1) {
      const int k = std::countr_zero(sides);
      const Side<D>& side = blocker.sides[static_cast<std::size_t>(k)];
      evaluate(frame.cell, table, side, signs);
      if (!signs.positive) {  // all that is left lies outside
        const std::unique_ptr<Frame> last = std::move(frames_.back());
        frames_.pop_back();
        return visit(last->cell, last->others);
      }
      if (!signs.negative) {
        frame.chosen.sides &= ~(std::uint64_t{1} << k);
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
    if (best == nullptr) {
      frames_.pop_back();
      return false;
    }
    ++pool_.statistics().splits;
    cut_ = true;
    auto& of_functional = best_signs.of_ray;
    if (best->sign < 0) {
      for (std::int8_t& sign : of_functional) sign = static_cast<std::int8_t>(-sign);
    }
    const auto made = frame.cell.cut_rays(pool_, best->functional, of_functional);
    const Cell<D> outside = frame.cell.part(best->functional, of_functional, -best->sign, made);
    frame.cell = frame.cell.part(best->functional, of_functional, best->sign, made);
    return visit(outside, frame.others);
  }

  VectorPool<D>& pool_;
  std::span<const Blocker<D>> blockers_;
  Rules& rules_;
  // Depth first, without recursion: as deep as there are blockers.
  std::vector<std::unique_ptr<Frame>> frames_;
  std::vector<double> products_, bounds_;
  std::uint64_t cells_left_;
  bool gave_up_ = false;
  bool cut_ = false;  // the root was cut
  std::optional<std::size_t> covering_blocker_;
};

}  // namespace viewcover::exact
