#include "exact/skeleton/stabbing_line.h"

#include <gmp.h>

#include <algorithm>
#include <cmath>

namespace viewcover::exact {
namespace {

ScaledNumber scaled(const BigInteger& x) {
  ScaledNumber result;
  result.fraction = mpz_get_d_2exp(&result.exponent, x.mpz());
  return result;
}

std::array<ScaledNumber, 6> scaled(const LineComponents& line) {
  std::array<ScaledNumber, 6> result;
  for (std::size_t i = 0; i < 6; ++i) result[i] = scaled(line[i]);
  return result;
}

/// GMP floating-point numbers of one precision.
class LongFloat {
 public:
  explicit LongFloat(mp_bitcnt_t bits) { mpf_init2(value_, bits); }
  LongFloat(const LongFloat&) = delete;
  LongFloat& operator=(const LongFloat&) = delete;
  ~LongFloat() { mpf_clear(value_); }
  mpf_ptr get() { return value_; }

 private:
  mpf_t value_;
};

std::size_t bits(const BigInteger& x) { return mpz_sizeinbase(x.mpz(), 2); }

/// a_i + b_i sqrt(root). As (a_i + b_i sqrt(root)) (a_i - b_i sqrt(root)) is an integer and not 0,
/// the first factor is at least 2^-(B + 1) where both terms are below 2^B; with 2 B + 128 bits its
/// leading 100 bits are right.
std::array<ScaledNumber, 6> scaled(const StabbingLine& line) {
  std::array<ScaledNumber, 6> result;
  std::size_t most = 0;
  for (std::size_t i = 0; i < 6; ++i) {
    most = std::max({most, bits(line.a[i]), bits(line.b[i]) + bits(line.root) / 2 + 1});
  }
  const mp_bitcnt_t precision = 2 * most + 128;
  LongFloat root(precision), x(precision), y(precision);
  mpf_set_z(root.get(), line.root.mpz());
  mpf_sqrt(root.get(), root.get());
  for (std::size_t i = 0; i < 6; ++i) {
    mpf_set_z(x.get(), line.b[i].mpz());
    mpf_mul(x.get(), x.get(), root.get());
    mpf_set_z(y.get(), line.a[i].mpz());
    mpf_add(x.get(), x.get(), y.get());
    result[i].fraction = mpf_get_d_2exp(&result[i].exponent, x.get());
  }
  return result;
}

/// Doubles times one power of two, such that the largest magnitude is in [1/2, 1).
template <std::size_t N>
std::array<double, N> leveled(const std::array<ScaledNumber, N>& x) {
  long highest = std::numeric_limits<long>::min();
  for (const ScaledNumber& value : x) {
    if (value.fraction != 0) highest = std::max(highest, value.exponent);
  }
  std::array<double, N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    if (x[i].fraction == 0) continue;
    const long below = std::min(highest - x[i].exponent, 1000L);
    result[i] = std::ldexp(x[i].fraction, static_cast<int>(-below));
  }
  return result;
}

CGAL::Gmpq fraction(const BigInteger& numerator, const BigInteger& denominator) {
  return CGAL::Gmpq(numerator, denominator);
}

}  // namespace

int sign_of_root(const BigInteger& a, const BigInteger& b, const BigInteger& root) {
  const int of_a = sign(a), of_b = sign(root) == 0 ? 0 : sign(b);
  if (of_a * of_b >= 0) return of_a != 0 ? of_a : of_b;
  return of_a * sign(a * a - b * b * root);
}

Surd StabbingLine::operator[](std::size_t i) const {
  if (is_rational()) return Surd(CGAL::Gmpq(a[i]));
  return Surd(CGAL::Gmpq(a[i]), CGAL::Gmpq(b[i]), CGAL::Gmpq(root));
}

void StabbingLine::reverse() {
  for (std::size_t i = 0; i < 6; ++i) {
    a[i] = -a[i];
    b[i] = -b[i];
    approximate.x[i] = -approximate.x[i];
  }
}

StabbingLine LineArithmetic::line(LineComponents components) const {
  make_primitive(components);
  StabbingLine result;
  result.a = std::move(components);
  result.b.fill(BigInteger(0));
  result.root = BigInteger(0);
  result.approximate = approximate(result.a);
  return result;
}

StabbingLine LineArithmetic::line(LineComponents a, LineComponents b, BigInteger root) const {
  if (mpz_perfect_square_p(root.mpz()) != 0) {
    BigInteger exact_root;
    mpz_sqrt(exact_root.mpz(), root.mpz());
    for (std::size_t i = 0; i < 6; ++i) a[i] += b[i] * exact_root;
    return line(std::move(a));
  }
  std::array<BigInteger, 12> all;
  std::copy(a.begin(), a.end(), all.begin());
  std::copy(b.begin(), b.end(), all.begin() + 6);
  make_primitive(all);
  StabbingLine result;
  std::copy_n(all.begin(), 6, result.a.begin());
  std::copy_n(all.begin() + 6, 6, result.b.begin());
  result.root = std::move(root);
  result.approximate = approximate(scaled(result));
  return result;
}

Approximation<6, double> LineArithmetic::approximate(const LineComponents& line) const {
  return approximate(scaled(line));
}

Approximation<6, double> LineArithmetic::approximate(Scaled x) const {
  Approximation<6, double> result;
  for (std::size_t i = 0; i < 3; ++i) x[i].exponent += unit_exponent_;
  result.x = leveled(x);
  result.error = 4 * LinePool::kUnit;  // truncated, of at most 1
  for (const double component : result.x) result.size += std::fabs(component);
  result.size *= LinePool::kRoundUp;
  return result;
}

template <int Shift>
int LineArithmetic::exact_sign(const StabbingLine& line, const LineVector& vector) {
  const auto& y = pool_.exact(vector);
  BigInteger a(0), b(0);
  for (std::size_t i = 0; i < 6; ++i) a += line.a[i] * y[(i + Shift) % 6];
  if (line.is_rational()) return exact::sign(a);
  for (std::size_t i = 0; i < 6; ++i) b += line.b[i] * y[(i + Shift) % 6];
  return sign_of_root(a, b, line.root);
}
template int LineArithmetic::exact_sign<0>(const StabbingLine&, const LineVector&);
template int LineArithmetic::exact_sign<3>(const StabbingLine&, const LineVector&);

bool LineArithmetic::are_equal(const StabbingLine& x, const StabbingLine& y) const {
  if (x.is_rational() != y.is_rational()) return false;
  std::size_t k = 0;
  for (std::size_t i = 1; i < 6; ++i) {
    if (std::fabs(x.approximate.x[i]) > std::fabs(x.approximate.x[k])) k = i;
  }
  for (std::size_t i = 0; i < 6; ++i) {
    const double minor = x.approximate.x[i] * y.approximate.x[k] -  //
                         x.approximate.x[k] * y.approximate.x[i];
    // Two products of magnitudes below 1 with errors of 4 u each and three roundings.
    if (std::fabs(minor) > 24 * LinePool::kUnit) return false;
  }
  // sqrt(y.root) = common / x.root sqrt(x.root), where common is rational iff the fields are one.
  LineComponents c = y.a, d = y.b;
  if (!x.is_rational() && x.root != y.root) {
    const BigInteger product = x.root * y.root;
    if (mpz_perfect_square_p(product.mpz()) == 0) return false;
    BigInteger common;
    mpz_sqrt(common.mpz(), product.mpz());
    for (std::size_t i = 0; i < 6; ++i) {
      c[i] *= x.root;
      d[i] *= common;
    }
  }
  for (std::size_t i = 0; i < 6; ++i) {
    if (exact::sign(x.a[i] * c[k] - x.a[k] * c[i] + (x.b[i] * d[k] - x.b[k] * d[i]) * x.root) !=
            0 ||
        exact::sign(x.a[i] * d[k] + x.b[i] * c[k] - x.a[k] * d[i] - x.b[k] * c[i]) != 0) {
      return false;
    }
  }
  return true;
}

template <std::size_t N>
std::array<std::array<double, 6>, N> LineArithmetic::rounded(
    const std::array<LineComponents, N>& lines) const {
  std::array<ScaledNumber, 6 * N> all;
  for (std::size_t n = 0; n < N; ++n) {
    for (std::size_t i = 0; i < 6; ++i) {
      all[6 * n + i] = scaled(lines[n][i]);
      if (i < 3) all[6 * n + i].exponent += unit_exponent_;
    }
  }
  const auto level = leveled(all);
  std::array<std::array<double, 6>, N> result;
  for (std::size_t n = 0; n < N; ++n) std::copy_n(level.begin() + 6 * n, 6, result[n].begin());
  return result;
}
template std::array<std::array<double, 6>, 3> LineArithmetic::rounded(
    const std::array<LineComponents, 3>&) const;

LineComponents line_through(const HomogeneousPoint<BigInteger>& a,
                            const HomogeneousPoint<BigInteger>& b) {
  const auto m = cross(a.x, b.x);
  return {a.w * b.x[0] - b.w * a.x[0],
          a.w * b.x[1] - b.w * a.x[1],
          a.w * b.x[2] - b.w * a.x[2],
          m[0],
          m[1],
          m[2]};
}

CGAL::Gmpq coordinate(const HomogeneousPoint<BigInteger>& point, std::size_t k) {
  return fraction(point.x[k], point.w);
}

Surd place_on(const StabbingLine& line, const HomogeneousPoint<BigInteger>& a,
              const HomogeneousPoint<BigInteger>& b) {
  // The offset from points of the line ab is linear along it.
  const auto rational_a = offset_from(line.a, a.x, a.w), rational_b = offset_from(line.a, b.x, b.w);
  const auto surd_a = offset_from(line.b, a.x, a.w), surd_b = offset_from(line.b, b.x, b.w);
  const auto surd = [&](const BigInteger& x, const BigInteger& y, const BigInteger& w) {
    return line.is_rational() ? Surd(fraction(x, w))
                              : Surd(fraction(x, w), fraction(y, w), CGAL::Gmpq(line.root));
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const Surd at_a = surd(rational_a[k], surd_a[k], a.w),
               at_b = surd(rational_b[k], surd_b[k], b.w);
    const Surd change = at_a - at_b;
    if (change.sign() != CGAL::ZERO) return at_a / change;
  }
  return Surd(0);
}

std::array<Surd, 3> meeting_point(const StabbingLine& line, const IntegerPlane<BigInteger>& plane) {
  std::array<Surd, 3> result;
  const auto normal = [&](std::size_t k) { return CGAL::Gmpq(plane.normal[k]); };
  const Surd below = line[0] * normal(0) + line[1] * normal(1) + line[2] * normal(2);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
    result[k] =
        (line[3 + v] * normal(u) - line[3 + u] * normal(v) + line[k] * CGAL::Gmpq(plane.offset)) /
        below;
  }
  return result;
}

}  // namespace viewcover::exact
