#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/ray_table.h"

namespace viewcover::exact {

/// A pointed polyhedral cone of full dimension D, as its extreme rays and, for each ray, the set of
/// inequalities that it satisfies with equality. Those inequalities contain all facets; some may
/// touch the cone in less than a facet, which does no harm.
template <int D>
class Cell {
 public:
  using Vector = LazyVector<D>;
  using Word = std::uint64_t;

  std::size_t size() const { return rays_.size(); }
  const Vector* ray(std::size_t i) const { return rays_[i]; }
  std::span<const Vector* const> rays() const { return {rays_.data(), rays_.size()}; }
  /// The inequalities as functionals, nullptr where a place is free.
  std::span<const Vector* const> facets() const { return {facets_.data(), facets_.size()}; }

  std::span<const Word> tight(std::size_t i) const { return {tight_.data() + i * words_, words_}; }
  bool is_tight(std::size_t i, std::size_t facet) const {
    return tight_[i * words_ + facet / 64] >> (facet % 64) & 1;
  }
  /// Is the functional one of the inequalities on which the ray is 0?
  bool is_known_zero(std::size_t i, const Vector* functional) const {
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      if (facets_[f] == functional) return is_tight(i, f);
    }
    return false;
  }

  /// Adds an inequality that no ray satisfies with equality yet; returns its place.
  std::size_t add_facet(const Vector* functional) {
    const auto free = std::find(facets_.begin(), facets_.end(), nullptr);
    const auto place = static_cast<std::size_t>(free - facets_.begin());
    if (free != facets_.end()) {
      facets_[place] = functional;
      return place;
    }
    facets_.push_back(functional);
    if (facets_.size() > 64 * words_) widen();
    return place;
  }
  std::size_t add_ray(const Vector* ray) {
    rays_.push_back(ray);
    tight_.resize(tight_.size() + words_, 0);
    return rays_.size() - 1;
  }
  void set_tight(std::size_t i, std::size_t facet) {
    tight_[i * words_ + facet / 64] |= Word{1} << (facet % 64);
  }

  /// Rays i and j span a face of dimension 2: the inequalities tight at both are at least D - 2 and
  /// not all tight at a third ray (Motzkin et al. 1953; Fukuda and Prodon 1996).
  bool are_adjacent(std::size_t i, std::size_t j) const {
    if (words_ == 1) {
      const Word common = tight_[i] & tight_[j];
      if (!has_bits(common, D - 2)) return false;
      for (std::size_t k = 0; k < tight_.size(); ++k) {
        if ((common & ~tight_[k]) == 0 && k != i && k != j) return false;
      }
      return true;
    }
    int count = 0;
    for (std::size_t w = 0; w < words_; ++w) count += std::popcount(tight(i)[w] & tight(j)[w]);
    if (count < D - 2) return false;
    for (std::size_t k = 0; k < size(); ++k) {
      if (k == i || k == j) continue;
      bool contains = true;
      for (std::size_t w = 0; w < words_ && contains; ++w) {
        contains = (tight(i)[w] & tight(j)[w] & ~tight(k)[w]) == 0;
      }
      if (contains) return false;
    }
    return true;
  }

  /// Rays that appear where a functional crosses faces of dimension 2, and the inequalities tight
  /// at each. Two parts of a cell share them.
  struct CutRays {
    SmallList<const Vector*, kUsualRays> rays;
    SmallList<Word, kUsualRays> tight;
  };
  /// Requires `signs` of `cut` on the rays, some on either strict side.
  CutRays cut_rays(VectorPool<D>& pool, const Vector* cut,
                   std::span<const std::int8_t> signs) const {
    CutRays result;
    for (std::size_t i = 0; i < size(); ++i) {
      if (signs[i] <= 0) continue;
      for (std::size_t j = 0; j < size(); ++j) {
        if (signs[j] >= 0 || !are_adjacent(i, j)) continue;
        result.rays.push_back(pool.combine(rays_[i], rays_[j], cut));
        for (std::size_t w = 0; w < words_; ++w) {
          result.tight.push_back(tight_[i * words_ + w] & tight_[j * words_ + w]);
        }
      }
    }
    return result;
  }
  /// The part where `cut` has the sign `keep` or is 0: one step of double description.
  Cell part(const Vector* cut, std::span<const std::int8_t> signs, int keep,
            const CutRays& made) const {
    Cell result;
    result.words_ = words_;
    result.facets_ = facets_;
    const std::size_t most = size() + made.rays.size();
    result.rays_.reserve(most);
    result.tight_.reserve(most * words_);
    for (std::size_t i = 0; i < size(); ++i) {
      if (signs[i] == -keep) continue;
      result.rays_.push_back(rays_[i]);
      for (std::size_t w = 0; w < words_; ++w) result.tight_.push_back(tight_[i * words_ + w]);
    }
    result.rays_.insert(result.rays_.end(), made.rays.begin(), made.rays.end());
    result.tight_.insert(result.tight_.end(), made.tight.begin(), made.tight.end());
    const std::size_t place = result.add_facet(cut);
    std::size_t at = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      if (signs[i] == -keep) continue;
      if (signs[i] == 0) result.set_tight(at, place);
      ++at;
    }
    for (; at < result.size(); ++at) result.set_tight(at, place);
    result.drop_loose_facets();
    return result;
  }

  /// Keeps the extreme rays: those whose tight inequalities are not all tight at another ray.
  /// Requires that the inequalities include all facets.
  void drop_rays_that_are_not_extreme() {
    std::size_t kept = 0;
    std::vector<bool> extreme(size(), true);
    for (std::size_t i = 0; i < size(); ++i) {
      for (std::size_t k = 0; k < size() && extreme[i]; ++k) {
        if (k == i || !extreme[k]) continue;
        bool contains = true;
        for (std::size_t w = 0; w < words_ && contains; ++w) {
          contains = (tight(i)[w] & ~tight(k)[w]) == 0;
        }
        extreme[i] = !contains;
      }
    }
    for (std::size_t i = 0; i < size(); ++i) {
      if (!extreme[i]) continue;
      rays_[kept] = rays_[i];
      std::copy_n(tight_.begin() + static_cast<std::ptrdiff_t>(i * words_), words_,
                  tight_.begin() + static_cast<std::ptrdiff_t>(kept * words_));
      ++kept;
    }
    rays_.resize(kept);
    tight_.resize(kept * words_);
  }

 private:
  /// Inequalities tight at fewer than D - 1 rays are no facets.
  void drop_loose_facets() {
    for (std::size_t w = 0; w < words_; ++w) {
      // Bits seen at least 1, 2, ..., D - 1 times.
      std::array<Word, D - 1> seen{};
      for (std::size_t i = w; i < tight_.size(); i += words_) {
        const Word word = tight_[i];
        for (std::size_t times = D - 2; times > 0; --times) seen[times] |= seen[times - 1] & word;
        seen[0] |= word;
      }
      const Word kept = seen[D - 2];
      for (std::size_t f = 64 * w; f < std::min(64 * (w + 1), facets_.size()); ++f) {
        if (!(kept >> (f % 64) & 1)) facets_[f] = nullptr;
      }
      for (std::size_t i = w; i < tight_.size(); i += words_) tight_[i] &= kept;
    }
  }
  /// At least `least` bits set.
  static bool has_bits(Word word, int least) {
    for (int i = 1; i < least; ++i) word &= word - 1;
    return word != 0;
  }
  void widen() {
    SmallList<Word, kUsualRays> wider((words_ + 1) * size(), 0);
    for (std::size_t i = 0; i < size(); ++i) {
      std::copy(tight(i).begin(), tight(i).end(), wider.begin() + i * (words_ + 1));
    }
    tight_ = std::move(wider);
    ++words_;
  }

  std::size_t words_ = 1;
  SmallList<const Vector*, kUsualRays> rays_;
  SmallList<Word, kUsualRays> tight_;  // #rays x words_
  SmallList<const Vector*, 64> facets_;
};

}  // namespace viewcover::exact
