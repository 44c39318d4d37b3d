#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <utility>
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

/// A set of sample vectors, as bits.
class SampleSet {
 public:
  static constexpr std::size_t kMost = 256;

  void insert(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
  bool empty() const {
    return std::all_of(words_.begin(), words_.end(), [](std::uint64_t word) { return word == 0; });
  }
  SampleSet intersected(SampleSet other) const {
    for (std::size_t w = 0; w < words_.size(); ++w) other.words_[w] &= words_[w];
    return other;
  }
  SampleSet without(SampleSet other) const {
    for (std::size_t w = 0; w < words_.size(); ++w) other.words_[w] = words_[w] & ~other.words_[w];
    return other;
  }
  int size_with(const SampleSet& other) const {
    int count = 0;
    for (std::size_t w = 0; w < words_.size(); ++w) {
      count += std::popcount(words_[w] & other.words_[w]);
    }
    return count;
  }

 private:
  std::array<std::uint64_t, kMost / 64> words_{};
};

/// Subtracts blocking cones from a cell, exactly: depth first, the blocker that holds the most of
/// the cell first (papers/exact.md, section 4). How much it holds is judged by samples, where the
/// cell has some, else by its rays; the answer does not depend on it.
///
/// `Rules` says what counts:
///   bool holds_anything(const Cell<D>&): false for a cell that may be forgotten
///   bool on_free(const Cell<D>&): called for a part that no blocker meets; true ends the search
template <int D, class Rules>
class Subtraction {
 public:
  /// `samples`: at most SampleSet::kMost vectors spread over the root.
  Subtraction(VectorPool<D>& pool, std::span<const Blocker<D>> blockers, Rules& rules,
              std::span<const std::array<double, D>> samples = {},
              std::uint64_t most_cells = std::numeric_limits<std::uint64_t>::max())
      : pool_(pool),
        blockers_(blockers),
        rules_(rules),
        samples_(samples),
        cells_left_(most_cells) {
    for (std::size_t i = 0; i < samples.size(); ++i) all_samples_.insert(i);
    for (std::size_t k = 0; k < D; ++k) {
      for (const auto& sample : samples) sample_columns_.push_back(sample[k]);
    }
    for (const Blocker<D>& blocker : blockers) {
      first_side_.push_back(side_rows_.size());
      for (const Side<D>& side : blocker.sides) side_rows_.push_back(row_of_side(side));
      held_.push_back(samples_within(blocker));
    }
  }

  SubtractionOutcome run(const Cell<D>& root) {
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < blockers_.size(); ++i) {
      candidates.push_back({static_cast<std::uint32_t>(i), all_sides(blockers_[i])});
    }
    // The largest first: they are the likeliest to cover a cell.
    std::stable_sort(candidates.begin(), candidates.end(), [&](Candidate a, Candidate b) {
      return held_[a.blocker].size_with(all_samples_) > held_[b.blocker].size_with(all_samples_);
    });
    bool ended = visit(root, all_samples_, candidates);
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

  /// The samples on which a side is >= 0, as far as doubles tell.
  SampleSet samples_on(const Side<D>& side) const {
    SampleSet on;
    const std::size_t n = samples_.size();
    std::array<double, SampleSet::kMost> values{};
    for (std::size_t k = 0; k < D; ++k) {
      const double factor = side.sign * side.functional->approximate().x[k];
      const double* const column = sample_columns_.data() + k * n;
      for (std::size_t i = 0; i < n; ++i) values[i] += factor * column[i];
    }
    for (std::size_t i = 0; i < n; ++i) {
      if (values[i] >= 0) on.insert(i);
    }
    return on;
  }
  SampleSet samples_within(const Blocker<D>& blocker) const {
    SampleSet within = all_samples_;
    for (const Side<D>& side : blocker.sides) {
      within = within.intersected(samples_on(side));
      if (within.empty()) break;
    }
    return within;
  }

  /// What the loops over signs read of a ray or a side, together in memory: the components, and the
  /// two factors of the error bound (`VectorPool::bound`).
  struct Row {
    std::array<double, D> x;
    double size, error;
  };
  static Row row_of_ray(const LazyVector<D>& ray) {
    using Pool = VectorPool<D>;
    const auto& a = ray.approximate();
    return {a.x, Pool::bound(1, 0, a.size, a.error, Pool::kUnit),
            Pool::bound(0, 1, a.size, a.error, Pool::kUnit)};
  }
  static Row row_of_side(const Side<D>& side) {
    const auto& a = side.functional->approximate();
    Row row{a.x, VectorPool<D>::kRoundUp * a.size, VectorPool<D>::kRoundUp * a.error};
    for (double& x : row.x) x *= side.sign;
    return row;
  }
  void read_rays(const Cell<D>& cell) {
    ray_rows_.clear();
    for (const LazyVector<D>* ray : cell.rays()) ray_rows_.push_back(row_of_ray(*ray));
  }

  /// Exact sign of a blocker's side on one ray of the cell that was read last.
  int sign_of(const Cell<D>& cell, std::size_t i, std::uint32_t blocker, std::size_t k) {
    const Row& a = side_rows_[first_side_[blocker] + k];
    const Row& b = ray_rows_[i];
    double product = a.x[0] * b.x[0];
    for (std::size_t c = 1; c < D; ++c) product += a.x[c] * b.x[c];
    const double bound = a.size * b.size + a.error * b.error;
    ++pool_.statistics().filtered_signs;
    if (product > bound) return 1;
    if (product < -bound) return -1;
    --pool_.statistics().filtered_signs;
    return unsure_sign(cell, i, blockers_[blocker].sides[k]);
  }
  int unsure_sign(const Cell<D>& cell, std::size_t i, const Side<D>& side) {
    const LazyVector<D>& ray = *cell.ray(i);
    if (cell.is_known_zero(i, side.functional) ||
        VectorPool<D>::is_known_zero(ray, *side.functional)) {
      return 0;
    }
    const bool sharper = pool_.sharpen(ray);
    if (sharper) ray_rows_[i] = row_of_ray(ray);
    const int sign = sharper ? pool_.sign_of_product(*side.functional, ray)
                             : pool_.exact_sign(*side.functional, ray);
    if (sign == 0) pool_.note_zero(ray, *side.functional);
    return side.sign * sign;
  }

  /// The strict signs of a side on the rays, as far as it takes to know which occur.
  struct Occurring {
    bool positive = false, negative = false;
  };
  Occurring occurring_signs(const Cell<D>& cell, std::uint32_t blocker, std::size_t k) {
    Occurring signs;
    for (std::size_t i = 0; i < cell.size() && !(signs.positive && signs.negative); ++i) {
      const int sign = sign_of(cell, i, blocker, k);
      signs.positive |= sign > 0;
      signs.negative |= sign < 0;
    }
    return signs;
  }

  /// Rays that lie on no outer side of the candidate's blocker.
  std::size_t rays_within(const Cell<D>& cell, Candidate candidate) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      bool within = true;
      for (std::uint64_t sides = candidate.sides; sides != 0 && within; sides &= sides - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(sides));
        within = sign_of(cell, i, candidate.blocker, k) >= 0;
      }
      count += within;
    }
    return count;
  }

  /// A cell from which one blocker is being subtracted, and what else may meet its parts.
  struct Frame {
    Cell<D> cell;
    SampleSet samples;
    Candidate chosen;
    std::vector<Candidate> others;
  };

  /// Looks at a cell: it is forgotten, free, covered, or becomes a frame. True to end the search.
  bool visit(const Cell<D>& cell, const SampleSet& samples, std::span<const Candidate> candidates) {
    if (cells_left_ == 0) return gave_up_ = true;
    --cells_left_;
    ++pool_.statistics().cells;
    if (!rules_.holds_anything(cell)) return false;
    read_rays(cell);
    std::vector<Candidate> left;
    left.reserve(candidates.size());
    for (Candidate candidate : candidates) {
      const Relation relation = relation_of(cell, candidate);
      if (relation == Relation::kCovers) {
        if (!cut_) covering_blocker_ = candidate.blocker;
        return false;
      }
      if (relation == Relation::kCuts) left.push_back(candidate);
    }
    if (left.empty()) return rules_.on_free(cell);

    const std::size_t best = choose(cell, samples, left);
    const Candidate chosen = left[best];
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
    frames_.push_back(std::make_unique<Frame>(Frame{cell, samples, chosen, std::move(left)}));
    return false;
  }

  enum class Relation { kMisses, kCovers, kCuts };
  /// Finds out which sides cut the cell, and notes it in the candidate.
  Relation relation_of(const Cell<D>& cell, Candidate& candidate) {
    for (std::uint64_t sides = candidate.sides; sides != 0; sides &= sides - 1) {
      const int k = std::countr_zero(sides);
      const Occurring signs = occurring_signs(cell, candidate.blocker, static_cast<std::size_t>(k));
      if (!signs.positive) return Relation::kMisses;
      if (!signs.negative) candidate.sides &= ~(std::uint64_t{1} << k);
    }
    return candidate.sides == 0 ? Relation::kCovers : Relation::kCuts;
  }

  /// The place of the candidate that holds the most of the samples, and how many.
  std::pair<std::size_t, int> most_samples(const SampleSet& samples,
                                           std::span<const Candidate> candidates) const {
    std::pair<std::size_t, int> best{0, 0};
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const int count = held_[candidates[i].blocker].size_with(samples);
      if (count > best.second) best = {i, count};
    }
    return best;
  }

  /// The place of the candidate that holds the most of the cell.
  std::size_t choose(const Cell<D>& cell, const SampleSet& samples,
                     std::span<const Candidate> candidates) {
    auto [best, samples_held] = most_samples(samples, candidates);
    if (samples_held >= kEnoughSamples) return best;
    // By rays that lie within; those first that the cell crosses on the fewest sides.
    std::size_t most_rays = 0;
    int looks = 0;
    for (int sides = 1; sides <= 64 && looks < kMostLooks; ++sides) {
      for (std::size_t i = 0; i < candidates.size() && looks < kMostLooks; ++i) {
        if (std::popcount(candidates[i].sides) != sides) continue;
        ++looks;
        const std::size_t count = rays_within(cell, candidates[i]);
        if (count > most_rays || looks == 1) {
          best = i;
          most_rays = count;
        }
      }
      if (looks == static_cast<int>(candidates.size())) break;
    }
    return best;
  }

  /// Cuts off the frame's cell what lies outside one side of the chosen blocker, the one with most
  /// rays outside; what is inside all sides is blocked. True to end the search.
  bool advance() {
    Frame& frame = *frames_.back();
    const Blocker<D>& blocker = blockers_[frame.chosen.blocker];
    const std::size_t n = frame.cell.size();
    read_rays(frame.cell);
    const Side<D>* best = nullptr;
    std::size_t most = 0;
    SmallList<std::int8_t, kUsualRays> signs(n), best_signs;
    for (std::uint64_t sides = frame.chosen.sides; sides != 0; sides &= sides - 1) {
      const int k = std::countr_zero(sides);
      const Side<D>& side = blocker.sides[static_cast<std::size_t>(k)];
      std::size_t inside = 0, outside = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const int sign = sign_of(frame.cell, i, frame.chosen.blocker, static_cast<std::size_t>(k));
        signs[i] = static_cast<std::int8_t>(side.sign * sign);  // of the functional
        inside += sign > 0;
        outside += sign < 0;
      }
      if (inside == 0) {  // all that is left lies outside
        const std::unique_ptr<Frame> last = std::move(frames_.back());
        frames_.pop_back();
        return visit(last->cell, last->samples, last->others);
      }
      if (outside == 0) {
        frame.chosen.sides &= ~(std::uint64_t{1} << k);
        continue;
      }
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
    const auto made = frame.cell.cut_rays(pool_, best->functional, best_signs);
    const Cell<D> outside = frame.cell.part(best->functional, best_signs, -best->sign, made);
    frame.cell = frame.cell.part(best->functional, best_signs, best->sign, made);
    const SampleSet on_inside = samples_on(*best);
    const SampleSet samples_outside = frame.samples.without(on_inside);
    frame.samples = frame.samples.intersected(on_inside);
    return visit(outside, samples_outside, frame.others);
  }

  static constexpr int kEnoughSamples = 2, kMostLooks = 24;

  VectorPool<D>& pool_;
  std::span<const Blocker<D>> blockers_;
  Rules& rules_;
  std::span<const std::array<double, D>> samples_;
  std::vector<double> sample_columns_;  // D x #samples
  SampleSet all_samples_;
  std::vector<SampleSet> held_;  // samples within each blocker
  std::vector<Row> side_rows_;   // of all blockers in turn
  std::vector<std::size_t> first_side_;
  std::vector<Row> ray_rows_;  // of the cell that was read last
  // Depth first, without recursion: as deep as there are blockers.
  std::vector<std::unique_ptr<Frame>> frames_;
  std::uint64_t cells_left_;
  bool gave_up_ = false;
  bool cut_ = false;  // the root was cut
  std::optional<std::size_t> covering_blocker_;
};

}  // namespace viewcover::exact
