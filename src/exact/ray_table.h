#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "exact/vector_pool.h"
#include "scene/small_list.h"

namespace viewcover::exact {

/// Room for the rays of most cells without allocation.
inline constexpr std::size_t kUsualRays = 40;

/// Places that the rays of a cell keep while it is cut, so that bits of a word can stand for them.
class RayPlaces {
 public:
  using Word = std::uint64_t;
  static constexpr std::size_t kMost = 64;

  RayPlaces() = default;
  explicit RayPlaces(std::size_t rays) { give_free_places(rays); }

  /// The place of a ray, kMost where there was none left.
  std::size_t operator[](std::size_t i) const { return of_ray_[i]; }
  Word used() const { return used_; }
  /// Of a part of the cell, see `Cell::part`. Rays that stay keep their places.
  RayPlaces of_part(std::span<const std::int8_t> signs, int keep, std::size_t made) const {
    RayPlaces part;
    for (std::size_t i = 0; i < signs.size(); ++i) {
      if (signs[i] == -keep) continue;
      part.of_ray_.push_back(of_ray_[i]);
      if (of_ray_[i] < kMost) part.used_ |= Word{1} << of_ray_[i];
    }
    part.give_free_places(made);
    return part;
  }

 private:
  void give_free_places(std::size_t rays) {
    for (std::size_t i = 0; i < rays; ++i) {
      const auto place = static_cast<std::uint8_t>(std::countr_one(used_));
      of_ray_.push_back(place);
      if (place < kMost) used_ |= Word{1} << place;
    }
  }

  SmallList<std::uint8_t, kUsualRays> of_ray_;
  Word used_ = 0;
};

/// What is known of the signs of a functional on the rays of a cell, by their places.
struct KnownSigns {
  using Word = RayPlaces::Word;
  Word at_least_0 = 0, at_most_0 = 0;  // both where it is 0

  Word known() const { return at_least_0 | at_most_0; }
  bool any_positive() const { return (at_least_0 & ~at_most_0) != 0; }
  bool any_negative() const { return (at_most_0 & ~at_least_0) != 0; }
  int at(std::size_t place) const {
    return static_cast<int>(at_least_0 >> place & 1) - static_cast<int>(at_most_0 >> place & 1);
  }
  void note(std::size_t place, int sign) {
    at_least_0 |= Word{sign >= 0} << place;
    at_most_0 |= Word{sign <= 0} << place;
  }
  KnownSigns only_at(Word places) const { return {at_least_0 & places, at_most_0 & places}; }
  KnownSigns with(const KnownSigns& more) const {
    return {at_least_0 | more.at_least_0, at_most_0 | more.at_most_0};
  }
};

/// A functional, or its opposite, in single precision.
template <int D>
struct SingleRow {
  std::array<float, D> x;
  float size, error;
};

/// Up to 64 vectors in single precision, by places: finds most signs of a functional on all of them
/// at once.
///
/// The bound is that of `VectorPool::bound` with u = 2^-24. Rounding components, at most 1, to
/// single precision adds u to the error of either vector. kUp covers that sizes are those of
/// doubles (6 u of at least 1/2), and the roundings of factors, products and sum.
template <int D>
class RayTable {
 public:
  static SingleRow<D> row(const LazyVector<D>& functional, int sign) {
    const Approximation<D, double>& a = functional.approximate();
    SingleRow<D> row;
    for (std::size_t k = 0; k < D; ++k) row.x[k] = static_cast<float>(sign * a.x[k]);
    row.size = static_cast<float>(kUp * a.size);
    row.error = static_cast<float>(kUp * (a.error + kSingleUnit));
    return row;
  }

  void clear() {
    for (auto& column : columns_) std::fill_n(column.begin(), blocks_, Lanes{});
    blocks_ = 0;
  }
  void set(std::size_t place, const Approximation<D, double>& a) {
    const auto write = [&](std::size_t column, double x) {
      columns_[column][place / kLanes][place % kLanes] = static_cast<float>(x);
    };
    for (std::size_t k = 0; k < D; ++k) write(k, a.x[k]);
    const double error = a.error + kSingleUnit;
    write(D, kUp * (7 * kSingleUnit + error));
    write(D + 1, kUp * (a.size + D * error));
    blocks_ = std::max(blocks_, place / kLanes + 1);
  }

  /// The strict signs that are certain.
  KnownSigns signs(const SingleRow<D>& row) const {
    KnownSigns result;
    for (std::size_t block = 0; block < blocks_; ++block) {
      Lanes value = row.x[0] * columns_[0][block];
      for (std::size_t k = 1; k < D; ++k) value += row.x[k] * columns_[k][block];
      const Lanes bound = row.size * columns_[D][block] + row.error * columns_[D + 1][block];
      result.at_least_0 |= bits(value > bound) << (block * kLanes);
      result.at_most_0 |= bits(value < -bound) << (block * kLanes);
    }
    return result;
  }

 private:
  // Vectors of GCC and Clang: four numbers that one instruction treats.
  static constexpr std::size_t kLanes = 4;
  using Lanes [[gnu::vector_size(4 * kLanes)]] = float;
  using Truths [[gnu::vector_size(4 * kLanes)]] = std::int32_t;

  static KnownSigns::Word bits(Truths truths) {
#ifdef __SSE2__
    return static_cast<KnownSigns::Word>(__builtin_ia32_movmskps(Lanes(truths)));
#else
    KnownSigns::Word word = 0;
    for (std::size_t i = 0; i < kLanes; ++i) word |= KnownSigns::Word{truths[i] != 0} << i;
    return word;
#endif
  }

  static constexpr double kSingleUnit = 0x1p-24;
  static constexpr double kUp = 1 + 0x1p-20;

  std::array<std::array<Lanes, RayPlaces::kMost / kLanes>, D + 2> columns_{};
  std::size_t blocks_ = 0;
};

}  // namespace viewcover::exact
