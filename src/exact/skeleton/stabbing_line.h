#pragma once

#include <CGAL/Gmpq.h>
#include <CGAL/Sqrt_extension.h>

#include <array>
#include <utility>

#include "exact/integer_geometry.h"
#include "exact/real_lines.h"

namespace viewcover::exact {

/// a + b sqrt(c), rational a, b, c. Numbers with different c can be compared.
using Surd = CGAL::Sqrt_extension<CGAL::Gmpq, CGAL::Gmpq, CGAL::Tag_true, CGAL::Tag_true>;

using LineComponents = std::array<BigInteger, 6>;

/// A real line (direction, moment) with components a + b sqrt(root), up to a positive factor.
struct StabbingLine {
  LineComponents a, b;
  BigInteger root;  ///< 0, or no perfect square
  Approximation<6, double> approximate;

  bool is_rational() const { return exact::sign(root) == 0; }
  Surd operator[](std::size_t i) const;
  std::array<Surd, 3> direction() const { return {(*this)[0], (*this)[1], (*this)[2]}; }
  /// The opposite direction.
  void reverse();
};

/// A double fraction in [1/2, 1) or (-1, -1/2], or 0, times 2^exponent; truncated.
struct ScaledNumber {
  double fraction = 0;
  long exponent = 0;
};

/// Makes lines and finds their signs, beside a pool of vectors: double with a proven bound first,
/// then integers.
class LineArithmetic {
 public:
  /// `unit_exponent` as given to the pool.
  LineArithmetic(LinePool& pool, int unit_exponent) : pool_(pool), unit_exponent_(unit_exponent) {}

  LinePool& pool() { return pool_; }

  StabbingLine line(LineComponents components) const;
  /// a + b sqrt(root), root >= 0.
  StabbingLine line(LineComponents a, LineComponents b, BigInteger root) const;

  /// Correct to two units in the last place of the largest component.
  Approximation<6, double> approximate(const LineComponents& line) const;

  /// Sign of the scalar product with a functional.
  int sign(const StabbingLine& line, const LineVector& functional) {
    return sign_of<0>(line, functional);
  }
  /// Sign of the polar form of the Klein form with another line: 0 iff they meet.
  int side(const StabbingLine& line, const LineVector& other) { return sign_of<3>(line, other); }

  /// The sign of the scalar product, 0 if unsure.
  template <int Shift = 0>
  static int certain_sign(const Approximation<6, double>& x, const LineVector& vector) {
    double value = 0;
    const auto& y = vector.approximate();
    for (std::size_t i = 0; i < 6; ++i) value += x.x[i] * y.x[(i + Shift) % 6];
    const double bound = LinePool::bound(x.size, x.error, y.size, y.error, LinePool::kUnit);
    return (value > bound) - (value < -bound);
  }

  bool are_equal(const StabbingLine& x, const StabbingLine& y) const;

  /// Components in the unit that floating-point forms have, times one power of two for all lines.
  template <std::size_t N>
  std::array<std::array<double, 6>, N> rounded(const std::array<LineComponents, N>& lines) const;

 private:
  using Scaled = std::array<ScaledNumber, 6>;
  Approximation<6, double> approximate(Scaled x) const;

  template <int Shift>
  int sign_of(const StabbingLine& line, const LineVector& vector) {
    const int sign = certain_sign<Shift>(line.approximate, vector);
    return sign != 0 ? sign : exact_sign<Shift>(line, vector);
  }
  template <int Shift>
  int exact_sign(const StabbingLine& line, const LineVector& vector);
  LinePool& pool_;
  int unit_exponent_;
};

/// Sign of a + b sqrt(root), root >= 0.
int sign_of_root(const BigInteger& a, const BigInteger& b, const BigInteger& root);

/// w m - x cross d for a point x / w: 0 iff the line (d, m) passes through the point.
template <class Number>
std::array<Number, 3> offset_from(const std::array<Number, 6>& line, const Vector3<Number>& x,
                                  const Number& w) {
  std::array<Number, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    result[k] = w * line[3 + k] - (x[u] * line[v] - x[v] * line[u]);
  }
  return result;
}

inline bool is_zero(const Vector3<BigInteger>& v) {
  return sign(v[0]) == 0 && sign(v[1]) == 0 && sign(v[2]) == 0;
}

/// The line through two points, zero if they are the same.
LineComponents line_through(const HomogeneousPoint<BigInteger>& a,
                            const HomogeneousPoint<BigInteger>& b);

CGAL::Gmpq coordinate(const HomogeneousPoint<BigInteger>& point, std::size_t k);

/// The place s where a line meets the line a + s (b - a). Requires that they meet in one point.
Surd place_on(const StabbingLine& line, const HomogeneousPoint<BigInteger>& a,
              const HomogeneousPoint<BigInteger>& b);

/// Where a line meets a plane that does not hold it and is not parallel to it.
std::array<Surd, 3> meeting_point(const StabbingLine& line, const IntegerPlane<BigInteger>& plane);

}  // namespace viewcover::exact
