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

/// Vectors spread over a cell: sets of them, as bits, tell how much a blocker holds.
template <int D>
class Samples {
 public:
  static constexpr std::size_t kMost = 256;
  static constexpr std::size_t kWords = kMost / 64;
  using Set = std::array<std::uint64_t, kWords>;

  explicit Samples(std::span<const std::array<double, D>> samples) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
      Approximation<D, double> sample{samples[i]};
      for (const double x : sample.x) sample.size += std::fabs(x);
      tables_[i / 64].set(i % 64, sample);
      all_[i / 64] |= std::uint64_t{1} << (i % 64);
    }
  }

  const Set& all() const { return all_; }
  /// Those of a set on which a functional is positive, as far as single precision tells.
  Set on(const SingleRow<D>& side, Set set) const {
    for (std::size_t w = 0; w < kWords; ++w) {
      if (set[w] != 0) set[w] &= tables_[w].signs(side).at_least_0;
    }
    return set;
  }
  static Set without(Set set, const Set& others) {
    for (std::size_t w = 0; w < kWords; ++w) set[w] &= ~others[w];
    return set;
  }
  static int common(const Set& a, const Set& b) {
    int count = 0;
    for (std::size_t w = 0; w < kWords; ++w) {
      const std::uint64_t both = a[w] & b[w];
      if (both != 0) count += std::popcount(both);
    }
    return count;
  }

 private:
  std::array<RayTable<D>, kWords> tables_;
  Set all_{};
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
  /// `samples`: at most Samples<D>::kMost vectors spread over the root.
  Subtraction(VectorPool<D>& pool, std::span<const Blocker<D>> blockers, Rules& rules,
              std::span<const std::array<double, D>> samples = {},
              std::uint64_t most_cells = std::numeric_limits<std::uint64_t>::max())
      : pool_(pool),
        blockers_(blockers),
        rules_(rules),
        samples_(samples),
        cells_left_(most_cells) {
    for (const Blocker<D>& blocker : blockers) {
      first_side_.push_back(side_rows_.size());
      SampleSet held = samples_.all();
      for (const Side<D>& side : blocker.sides) {
        side_rows_.push_back(row_of_side(side));
        single_rows_.push_back(RayTable<D>::row(*side.functional, side.sign));
        held = samples_.on(single_rows_.back(), held);
      }
      held_.push_back(held);
    }
  }

  SubtractionOutcome run(const Cell<D>& root) {
    Candidates candidates;
    for (std::size_t i = 0; i < blockers_.size(); ++i) {
      candidates.list.push_back({static_cast<std::uint32_t>(i),
                                 static_cast<std::uint32_t>(first_side_[i]),
                                 all_sides(blockers_[i])});
    }
    candidates.known.resize(side_rows_.size());
    // The largest first: they are the likeliest to cover a cell.
    std::vector<int> counts;
    for (const SampleSet& held : held_) counts.push_back(Samples<D>::common(held, held));
    std::stable_sort(candidates.list.begin(), candidates.list.end(), [&](Candidate a, Candidate b) {
      return counts[a.blocker] > counts[b.blocker];
    });
    bool ended = visit(root, RayPlaces(root.size()), 0, samples_.all(), candidates);
    while (!ended && depth_ > 0) ended = advance();
    depth_ = 0;
    return gave_up_ ? SubtractionOutcome::kGaveUp
           : ended  ? SubtractionOutcome::kEnded
                    : SubtractionOutcome::kDone;
  }
  /// The blocker that covers the whole root, where one was found to.
  std::optional<std::size_t> covering_blocker() const { return covering_blocker_; }

 private:
  using Word = RayPlaces::Word;
  using SampleSet = typename Samples<D>::Set;

  /// A blocker that may meet a cell, and the sides that may cut it: on the others it is >= 0.
  struct Candidate {
    std::uint32_t blocker;
    std::uint32_t first_known;  // of its sides, one after the other
    std::uint64_t sides;
  };
  struct Candidates {
    std::vector<Candidate> list;
    std::vector<KnownSigns> known;
  };
  static std::uint64_t all_sides(const Blocker<D>& blocker) {
    return ~std::uint64_t{0} >> (64 - blocker.sides.size());
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
  void read_rays(const Cell<D>& cell, const RayPlaces& places) {
    ray_rows_.clear();
    rays_without_place_.clear();
    table_.clear();
    places_ = &places;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      ray_rows_.push_back(row_of_ray(*cell.ray(i)));
      if (places[i] < RayPlaces::kMost) {
        ray_at_[places[i]] = static_cast<std::uint8_t>(i);
        table_.set(places[i], cell.ray(i)->approximate());
      } else {
        rays_without_place_.push_back(i);
      }
    }
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

  /// The same, from what is known if it is.
  int sign_of(const Cell<D>& cell, std::size_t i, std::uint32_t blocker, std::size_t k,
              KnownSigns& known) {
    const std::size_t place = (*places_)[i];
    if (place >= RayPlaces::kMost) return sign_of(cell, i, blocker, k);
    if ((known.known() >> place & 1) == 0) known.note(place, sign_of(cell, i, blocker, k));
    return known.at(place);
  }

  /// Adds what single precision tells at once.
  KnownSigns with_certain(const KnownSigns& known, std::uint32_t blocker, std::size_t k) {
    const KnownSigns more = table_.signs(single_rows_[first_side_[blocker] + k]);
    pool_.statistics().single_signs +=
        static_cast<std::uint64_t>(std::popcount(more.known() & ~known.known()));
    return known.with(more);
  }

  /// The strict signs of a side on the rays, as far as it takes to know which occur.
  struct Occurring {
    bool positive = false, negative = false;
  };
  Occurring occurring_signs(const Cell<D>& cell, std::uint32_t blocker, std::size_t k,
                            KnownSigns& known) {
    Occurring signs{known.any_positive(), known.any_negative()};
    const auto note = [&](int sign) {
      signs.positive |= sign > 0;
      signs.negative |= sign < 0;
      return signs.positive && signs.negative;
    };
    if (signs.positive && signs.negative) return signs;
    known = with_certain(known, blocker, k);
    signs = {known.any_positive(), known.any_negative()};
    if (signs.positive && signs.negative) return signs;
    for (Word open = places_->used() & ~known.known(); open != 0; open &= open - 1) {
      const auto place = static_cast<std::size_t>(std::countr_zero(open));
      const int sign = sign_of(cell, ray_at_[place], blocker, k);
      known.note(place, sign);
      if (note(sign)) return signs;
    }
    for (const std::size_t i : rays_without_place_) {
      if (note(sign_of(cell, i, blocker, k))) break;
    }
    return signs;
  }

  /// Rays that lie on no outer side of the candidate's blocker.
  std::size_t rays_within(const Cell<D>& cell, Candidate candidate, Candidates& all) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < cell.size(); ++i) {
      bool within = true;
      KnownSigns* known = all.known.data() + candidate.first_known;
      for (std::uint64_t sides = candidate.sides; sides != 0 && within; sides &= sides - 1) {
        const auto k = static_cast<std::size_t>(std::countr_zero(sides));
        within = sign_of(cell, i, candidate.blocker, k, *known++) >= 0;
      }
      count += within;
    }
    return count;
  }

  /// A cell from which one blocker is being subtracted, and what else may meet its parts.
  struct Frame {
    Cell<D> cell;
    RayPlaces places;
    Word known_places = 0;  // of rays that the cell had when `others` was made
    SampleSet samples;
    Candidate chosen;
    std::uint64_t passed_sides = 0;  // of the chosen blocker: the cell lies on their inner sides
    Candidates others;
  };
  // Frames are used again: what they hold stays allocated.
  Frame& next_frame() {
    if (depth_ == frames_.size()) frames_.push_back(std::make_unique<Frame>());
    return *frames_[depth_++];
  }

  /// Looks at a cell: it is forgotten, free, covered, or becomes a frame. True to end the search.
  /// What is known of the candidates' signs counts at `known_places`. All but the candidates may be
  /// of the frame that is next.
  bool visit(const Cell<D>& cell, const RayPlaces& places, Word known_places,
             const SampleSet& samples, const Candidates& candidates) {
    if (cells_left_ == 0) return gave_up_ = true;
    --cells_left_;
    ++pool_.statistics().cells;
    if (!rules_.holds_anything(cell)) return false;
    read_rays(cell, places);
    left_.list.clear();
    left_.known.clear();
    left_.list.reserve(candidates.list.size());
    left_.known.reserve(candidates.known.size());
    for (const Candidate candidate : candidates.list) {
      if (!add_if_it_cuts(cell, candidate, candidates, known_places)) {
        if (!cut_) covering_blocker_ = candidate.blocker;
        return false;
      }
    }
    if (left_.list.empty()) return rules_.on_free(cell);

    const std::size_t best = choose(cell, samples, left_);
    Frame& frame = next_frame();
    frame.chosen = left_.list[best];
    left_.list.erase(left_.list.begin() + static_cast<std::ptrdiff_t>(best));
    frame.cell = cell;
    frame.places = places;
    frame.known_places = places.used();
    frame.samples = samples;
    frame.passed_sides = 0;
    std::swap(frame.others, left_);
    return false;
  }

  /// Adds a candidate to those left, with the sides that cut the cell, unless it misses the cell.
  /// False if it covers the cell.
  bool add_if_it_cuts(const Cell<D>& cell, Candidate candidate, const Candidates& candidates,
                      Word known_places) {
    const KnownSigns* before = candidates.known.data() + candidate.first_known;
    const std::size_t first = left_.known.size();
    std::uint64_t cutting = 0;
    for (std::uint64_t sides = candidate.sides; sides != 0; sides &= sides - 1) {
      const int k = std::countr_zero(sides);
      KnownSigns known = (before++)->only_at(known_places);
      const Occurring signs =
          occurring_signs(cell, candidate.blocker, static_cast<std::size_t>(k), known);
      if (!signs.positive) {
        left_.known.resize(first);
        return true;
      }
      if (!signs.negative) continue;
      cutting |= std::uint64_t{1} << k;
      left_.known.push_back(known);
    }
    if (cutting == 0) return false;
    left_.list.push_back({candidate.blocker, static_cast<std::uint32_t>(first), cutting});
    return true;
  }

  /// The place of the candidate that holds the most of the samples, and how many.
  std::pair<std::size_t, int> most_samples(const SampleSet& samples,
                                           std::span<const Candidate> candidates) const {
    std::pair<std::size_t, int> best{0, 0};
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const int count = Samples<D>::common(held_[candidates[i].blocker], samples);
      if (count > best.second) best = {i, count};
    }
    return best;
  }

  /// The place of the candidate that holds the most of the cell.
  std::size_t choose(const Cell<D>& cell, const SampleSet& samples, Candidates& all) {
    const std::vector<Candidate>& candidates = all.list;
    auto [best, samples_held] = most_samples(samples, candidates);
    if (samples_held >= kEnoughSamples) return best;
    // By rays that lie within; those first that the cell crosses on the fewest sides.
    std::size_t most_rays = 0;
    int looks = 0;
    for (int sides = 1; sides <= 64 && looks < kMostLooks; ++sides) {
      for (std::size_t i = 0; i < candidates.size() && looks < kMostLooks; ++i) {
        if (std::popcount(candidates[i].sides) != sides) continue;
        ++looks;
        const std::size_t count = rays_within(cell, candidates[i], all);
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
    Frame& frame = *frames_[depth_ - 1];
    const Blocker<D>& blocker = blockers_[frame.chosen.blocker];
    const std::size_t n = frame.cell.size();
    read_rays(frame.cell, frame.places);
    const Side<D>* best = nullptr;
    std::size_t most = 0;
    SmallList<std::int8_t, kUsualRays> signs(n), best_signs;
    const KnownSigns* before = frame.others.known.data() + frame.chosen.first_known;
    for (std::uint64_t sides = frame.chosen.sides; sides != 0; sides &= sides - 1) {
      KnownSigns known = (before++)->only_at(frame.known_places);
      const auto k = static_cast<std::size_t>(std::countr_zero(sides));
      if ((frame.passed_sides >> k & 1) != 0) continue;
      known = with_certain(known, frame.chosen.blocker, k);
      const Side<D>& side = blocker.sides[k];
      std::size_t inside = 0, outside = 0;
      for (std::size_t i = 0; i < n; ++i) {
        const int sign = sign_of(frame.cell, i, frame.chosen.blocker, k, known);
        signs[i] = static_cast<std::int8_t>(side.sign * sign);  // of the functional
        inside += sign > 0;
        outside += sign < 0;
      }
      if (inside == 0) {  // all that is left lies outside
        --depth_;
        return visit(frame.cell, frame.places, frame.known_places, frame.samples, frame.others);
      }
      if (outside == 0) {
        frame.passed_sides |= std::uint64_t{1} << k;
        continue;
      }
      if (best == nullptr || outside > most) {
        best = &side;
        most = outside;
        best_signs = signs;
      }
    }
    if (best == nullptr) {
      --depth_;
      return false;
    }
    ++pool_.statistics().splits;
    cut_ = true;
    const auto made = frame.cell.cut_rays(pool_, best->functional, best_signs);
    const Cell<D> outside = frame.cell.part(best->functional, best_signs, -best->sign, made);
    frame.cell = frame.cell.part(best->functional, best_signs, best->sign, made);
    Word kept_outside = frame.known_places, kept_inside = frame.known_places;
    for (std::size_t i = 0; i < n; ++i) {
      if (best_signs[i] == 0 || frame.places[i] >= RayPlaces::kMost) continue;
      (best_signs[i] == best->sign ? kept_outside : kept_inside) &= ~(Word{1} << frame.places[i]);
    }
    const RayPlaces outside_places =
        frame.places.of_part(best_signs, -best->sign, made.rays.size());
    frame.places = frame.places.of_part(best_signs, best->sign, made.rays.size());
    frame.known_places = kept_inside;
    const SampleSet all = frame.samples;
    frame.samples = samples_.on(RayTable<D>::row(*best->functional, best->sign), all);
    const SampleSet samples_outside = Samples<D>::without(all, frame.samples);
    return visit(outside, outside_places, kept_outside, samples_outside, frame.others);
  }

  static constexpr int kEnoughSamples = 2, kMostLooks = 24;

  VectorPool<D>& pool_;
  std::span<const Blocker<D>> blockers_;
  Rules& rules_;
  Samples<D> samples_;
  std::vector<SampleSet> held_;  // samples within each blocker
  std::vector<Row> side_rows_;   // of all blockers in turn
  std::vector<SingleRow<D>> single_rows_;
  std::vector<std::size_t> first_side_;
  // Of the cell that was read last.
  std::vector<Row> ray_rows_;
  const RayPlaces* places_ = nullptr;
  std::array<std::uint8_t, RayPlaces::kMost> ray_at_{};
  RayTable<D> table_;
  std::vector<std::size_t> rays_without_place_;
  Candidates left_;  // by the cell that is visited
  // Depth first, without recursion: as deep as there are blockers.
  std::vector<std::unique_ptr<Frame>> frames_;
  std::size_t depth_ = 0;  // frames in use
  std::uint64_t cells_left_;
  bool gave_up_ = false;
  bool cut_ = false;  // the root was cut
  std::optional<std::size_t> covering_blocker_;
};

}  // namespace viewcover::exact
