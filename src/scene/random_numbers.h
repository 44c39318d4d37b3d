#pragma once

#include <cstddef>
#include <cstdint>

namespace viewcover {

/// The finalizer of splitmix64: a bijection of 64-bit numbers that mixes all bits.
constexpr std::uint64_t mixed(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// splitmix64 (Steele, Lea and Flood, OOPSLA 2014): the same numbers on every platform, unlike the
/// distributions of <random>. Not for cryptography. One object a thread.
class RandomNumbers {
 public:
  explicit RandomNumbers(std::uint64_t seed) : state_(seed) {}

  std::uint64_t bits() { return mixed(state_ += 0x9e3779b97f4a7c15u); }
  /// In [0, limit), limit > 0. By remainder: off uniform by limit / 2^64.
  std::size_t below(std::size_t limit) { return static_cast<std::size_t>(bits() % limit); }
  /// In [0, 1): multiples of 2^-53.
  double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }
  /// In (0, 1): odd multiples of 2^-53.
  double open_unit() { return static_cast<double>(bits() >> 12 << 1 | 1) * 0x1p-53; }
  /// In [low, high), up to the rounding of the map.
  double between(double low, double high) { return low + (high - low) * unit(); }

 private:
  std::uint64_t state_;
};

}  // namespace viewcover
