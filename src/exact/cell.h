#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/vector_pool.h"

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
  std::span<const Vector* const> rays() const { return rays_; }
  /// The inequalities as functionals, nullptr where a place is free.
  std::span<const Vector* const> facets() const { return facets_; }

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
    int common = 0;
    for (std::size_t w = 0; w < words_; ++w) common += std::popcount(tight(i)[w] & tight(j)[w]);
    if (common < D - 2) return false;
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

  /// The part where `cut` has the sign `keep` or is 0, given the sign of `cut` on each ray: one
  /// step of double description. Requires rays on both strict sides. `new_rays` holds the rays on
  /// the cut from `cut_rays`, so that both parts share them.
  struct CutRay {
    const Vector* ray;
    std::vector<Word> tight;
  };
  /// The rays that appear where `cut` crosses faces of dimension 2.
  std::vector<CutRay> cut_rays(VectorPool<D>& pool, const Vector* cut,
                               std::span<const std::int8_t> signs) const {
    std::vector<CutRay> result;
    for (std::size_t i = 0; i < size(); ++i) {
      if (signs[i] <= 0) continue;
      for (std::size_t j = 0; j < size(); ++j) {
        if (signs[j] >= 0 || !are_adjacent(i, j)) continue;
        CutRay& made = result.emplace_back();
        made.ray = pool.combine(rays_[i], rays_[j], cut);
        made.tight.resize(words_);
        for (std::size_t w = 0; w < words_; ++w) made.tight[w] = tight(i)[w] & tight(j)[w];
      }
    }
    return result;
  }
  Cell part(const Vector* cut, std::span<const std::int8_t> signs, int keep,
            std::span<const CutRay> made) const {
    Cell result;
    result.words_ = words_;
    result.facets_ = facets_;
    for (std::size_t i = 0; i < size(); ++i) {
      if (signs[i] == -keep) continue;
      result.rays_.push_back(rays_[i]);
      result.tight_.insert(result.tight_.end(), tight(i).begin(), tight(i).end());
    }
    for (const CutRay& ray : made) {
      result.rays_.push_back(ray.ray);
      result.tight_.insert(result.tight_.end(), ray.tight.begin(), ray.tight.end());
    }
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
    for (std::size_t f = 0; f < facets_.size(); ++f) {
      if (facets_[f] == nullptr) continue;
      int count = 0;
      for (std::size_t i = 0; i < size() && count < D - 1; ++i) count += is_tight(i, f);
      if (count >= D - 1) continue;
      facets_[f] = nullptr;
      for (std::size_t i = 0; i < size(); ++i) {
        tight_[i * words_ + f / 64] &= ~(Word{1} << (f % 64));
      }
    }
  }
  void widen() {
    std::vector<Word> wider((words_ + 1) * size(), 0);
    for (std::size_t i = 0; i < size(); ++i) {
      std::copy(tight(i).begin(), tight(i).end(), wider.begin() + i * (words_ + 1));
    }
    tight_ = std::move(wider);
    ++words_;
  }

  std::size_t words_ = 1;
  std::vector<const Vector*> rays_;
  std::vector<Word> tight_;  // #rays x words_
  std::vector<const Vector*> facets_;
};

}  // namespace viewcover::exact
