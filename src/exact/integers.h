#pragma once

#include <CGAL/Gmpz.h>

#include <bit>
#include <cstdint>
#include <stdexcept>
#include <utility>

namespace viewcover::exact {

/// 128-bit integers: products of two 62-bit numbers, and sums of six of those, fit.
__extension__ using Wide = __int128;
/// Integers of any size.
using BigInteger = CGAL::Gmpz;

inline constexpr int sign(Wide x) { return (x > 0) - (x < 0); }
inline int sign(const BigInteger& x) { return static_cast<int>(x.sign()); }

inline BigInteger to_big(std::int64_t x) { return BigInteger(static_cast<long>(x)); }
inline BigInteger to_big(Wide x) {
  const BigInteger high = to_big(static_cast<std::int64_t>(x >> 62));
  const auto low = static_cast<std::int64_t>(x & ((Wide{1} << 62) - 1));
  BigInteger result;
  mpz_mul_2exp(result.mpz(), high.mpz(), 62);
  return result + to_big(low);
}
inline const BigInteger& to_big(const BigInteger& x) { return x; }

/// Greatest common divisor of two numbers >= 0; gcd(0, x) = x. Binary (Stein 1967).
template <class Unsigned>
int trailing_zeros(Unsigned x) {
  if constexpr (sizeof(Unsigned) > 8) {
    const auto low = static_cast<std::uint64_t>(x);
    return low != 0 ? std::countr_zero(low)
                    : 64 + std::countr_zero(static_cast<std::uint64_t>(x >> 64));
  } else {
    return std::countr_zero(x);
  }
}
template <class Unsigned>
Unsigned binary_gcd(Unsigned a, Unsigned b) {
  if (a == 0) return b;
  if (b == 0) return a;
  const int shift = trailing_zeros(static_cast<Unsigned>(a | b));
  a >>= trailing_zeros(a);
  while (b != 0) {
    b >>= trailing_zeros(b);
    if (a > b) std::swap(a, b);
    b -= a;
    if constexpr (sizeof(Unsigned) > 8) {
      if ((a >> 64) == 0 && (b >> 64) == 0) {
        return static_cast<Unsigned>(
                   binary_gcd(static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b)))
               << shift;
      }
    }
  }
  return a << shift;
}
inline Wide gcd(Wide a, Wide b) {
  __extension__ using UnsignedWide = unsigned __int128;
  return static_cast<Wide>(binary_gcd(static_cast<UnsignedWide>(a < 0 ? -a : a),
                                      static_cast<UnsignedWide>(b < 0 ? -b : b)));
}
inline BigInteger gcd(const BigInteger& a, const BigInteger& b) {
  BigInteger result;
  mpz_gcd(result.mpz(), a.mpz(), b.mpz());
  return result;
}

/// 128-bit integers that throw `Overflow` instead of wrapping: the fast way through formulas that
/// are written once for every kind of integer.
class CheckedWide {
 public:
  struct Overflow : std::overflow_error {
    Overflow() : std::overflow_error("128 bits exceeded") {}
  };

  CheckedWide() = default;
  CheckedWide(std::int64_t value) : value_(value) {}  // NOLINT: as a built-in integer

  Wide value() const { return value_; }

  friend CheckedWide operator+(CheckedWide a, CheckedWide b) {
    CheckedWide result;
    if (__builtin_add_overflow(a.value_, b.value_, &result.value_)) throw Overflow();
    return result;
  }
  friend CheckedWide operator-(CheckedWide a, CheckedWide b) {
    CheckedWide result;
    if (__builtin_sub_overflow(a.value_, b.value_, &result.value_)) throw Overflow();
    return result;
  }
  friend CheckedWide operator*(CheckedWide a, CheckedWide b) {
    CheckedWide result;
    if (__builtin_mul_overflow(a.value_, b.value_, &result.value_)) throw Overflow();
    return result;
  }
  friend CheckedWide operator-(CheckedWide a) { return CheckedWide() - a; }
  friend bool operator==(CheckedWide a, CheckedWide b) { return a.value_ == b.value_; }
  friend CheckedWide gcd(CheckedWide a, CheckedWide b) {
    CheckedWide result;
    result.value_ = exact::gcd(a.value_, b.value_);
    return result;
  }
  static CheckedWide divided(CheckedWide a, CheckedWide b) {
    CheckedWide result;
    result.value_ = a.value_ / b.value_;
    return result;
  }

 private:
  Wide value_ = 0;
};

inline int sign(CheckedWide x) { return sign(x.value()); }
inline double to_double(CheckedWide x) { return static_cast<double>(x.value()); }
inline double to_double(const BigInteger& x) { return x.to_double(); }
inline BigInteger to_big(CheckedWide x) { return to_big(x.value()); }

}  // namespace viewcover::exact
