#pragma once

#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

namespace viewcover::testing::second_opinion {

using Fraction = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;
using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Double arithmetic ran into a loop that exact arithmetic would have left.
struct Undecided : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class N>
int sign_of(const N& value) {
  return value > 0 ? 1 : value < 0 ? -1 : 0;
}

template <class N>
struct Numbers;

template <>
struct Numbers<Fraction> {
  static constexpr bool kExact = true;
  static double approximate(const Fraction& value) { return value.convert_to<double>(); }

  /// Divides by a positive number: leaves integers without a common divisor.
  static void reduce(std::span<Fraction> values) {
    Integer multiple = 1, divisor = 0;
    for (const Fraction& value : values) {
      if (value.is_zero()) continue;
      multiple = lcm(multiple, Integer(denominator(value)));
      divisor = gcd(divisor, Integer(numerator(value)));
    }
    if (divisor.is_zero() || (multiple == 1 && divisor == 1)) return;
    const Fraction scale(multiple, divisor);
    for (Fraction& value : values) value *= scale;
  }

  /// If rational.
  static std::optional<Fraction> square_root(const Fraction& value) {
    if (value < 0) return std::nullopt;
    const Integer above = numerator(value), below = denominator(value);
    const Integer root_above = sqrt(above), root_below = sqrt(below);
    if (root_above * root_above != above || root_below * root_below != below) return std::nullopt;
    return Fraction(root_above, root_below);
  }
};

template <>
struct Numbers<double> {
  static constexpr bool kExact = false;
  static double approximate(double value) { return value; }
  static void reduce(std::span<double> values) {
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    if (largest > 0) {
      for (double& value : values) value /= largest;
    }
  }
  static std::optional<double> square_root(double) { return std::nullopt; }
};

/// Bounds relative errors: of a double nearest to a number, or next to it, and of an operation.
inline constexpr double kRounding = 0x1p-52;

}  // namespace viewcover::testing::second_opinion
