#include "exact/skeleton/regulus.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>

namespace viewcover::exact {
namespace {

/// A plane through a point x0 + s x1 and a line: normal and offset are linear in s.
struct PlanePencil {
  std::array<Vector3<BigInteger>, 2> normal;
  std::array<BigInteger, 2> offset;

  PlanePencil(const LineComponents& line, const std::array<Vector3<BigInteger>, 2>& x,
              const BigInteger& w) {
    const Vector3<BigInteger> moment = {line[3], line[4], line[5]};
    normal = {offset_from(line, x[0], w), offset_from(line, x[1], BigInteger(0))};
    offset = {dot(x[0], moment), dot(x[1], moment)};
  }
};

int certain_sign(double value, double error) { return (value > error) - (value < -error); }

}  // namespace

CGAL::Gmpq between(const Surd& low, const Surd& high) {
  const CGAL::Gmpq guess((CGAL::to_double(low) + CGAL::to_double(high)) / 2);
  if (low < guess && guess < high) return guess;
  CGAL::Gmpq from(0), to(1);
  while (true) {
    const CGAL::Gmpq middle = (from + to) / CGAL::Gmpq(2);
    if (!(low < middle)) {
      from = middle;
    } else if (!(middle < high)) {
      to = middle;
    } else {
      return middle;
    }
  }
}

Regulus::Regulus(const LineArithmetic& arithmetic, const FeatureEdge& first,
                 const FeatureEdge& second, const FeatureEdge& third) {
  const BigPoint &a = first.a, &b = first.b;
  const BigInteger w = a.w * b.w;
  const std::array<Vector3<BigInteger>, 2> x = {b.w * a.x, a.w * b.x - b.w * a.x};
  const PlanePencil p(second.components(), x, w), q(third.components(), x, w);
  // The line in the planes n . y = u and o . y = v: (n x o, v n - u o).
  for (LineComponents& coefficient : coefficients_) coefficient.fill(BigInteger(0));
  for (std::size_t i = 0; i < 2; ++i) {
    for (std::size_t j = 0; j < 2; ++j) {
      LineComponents& sum = coefficients_[i + j];
      const auto d = cross(p.normal[i], q.normal[j]);
      for (std::size_t k = 0; k < 3; ++k) {
        sum[k] += d[k];
        sum[3 + k] += q.offset[j] * p.normal[i][k] - p.offset[i] * q.normal[j][k];
      }
    }
  }
  std::array<BigInteger, 18> all;
  for (std::size_t i = 0; i < 18; ++i) all[i] = coefficients_[i / 6][i % 6];
  make_primitive(all);
  for (std::size_t i = 0; i < 18; ++i) coefficients_[i / 6][i % 6] = all[i];
  rounded_ = arithmetic.rounded(coefficients_);
}

StabbingLine Regulus::at(const LineArithmetic& arithmetic, const CGAL::Gmpq& s) const {
  const BigInteger u = s.numerator(), w = s.denominator();
  LineComponents line;
  for (std::size_t k = 0; k < 6; ++k) {
    line[k] =
        coefficients_[0][k] * w * w + coefficients_[1][k] * u * w + coefficients_[2][k] * u * u;
  }
  return arithmetic.line(line);
}

Regulus::Interval::Interval(const Surd& low, const Surd& high) : low_(low), high_(high) {
  const auto l = CGAL::to_interval(low), h = CGAL::to_interval(high);
  low_rounded_ = l.first;
  high_rounded_ = h.first;
  error_ = std::max(l.second - l.first, h.second - h.first);
}

/// Rounded components are below 1 and truncated at 53 bits: 2 u each. Six products of numbers below
/// 1, each off by at most 2 u and the functional's error, and 11 roundings of sums below 6.
Regulus::Rounded Regulus::rounded(const LineVector& functional) const {
  Rounded result;
  const auto& f = functional.approximate();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 6; ++k) result.c[i] += rounded_[i][k] * f.x[k];
  }
  result.error = 128 * LinePool::kUnit + 7 * f.error;
  return result;
}

/// In Bernstein form: the values at the ends, and c0 + c1 (low + high) / 2 + c2 low high. For ends
/// in [0, 1] each is off by at most 3 errors of coefficients, and as these are below 6, by 18 times
/// that of the ends; some roundings of sums below 18.
int Regulus::sign_on(const Interval& interval, const LineVector& functional) const {
  const Rounded h = rounded(functional);
  const double l = interval.low_rounded_, r = interval.high_rounded_;
  const double error = 3 * h.error + 18 * interval.error_ + 256 * LinePool::kUnit;
  const int sign = certain_sign(h.c[0] + l * (h.c[1] + l * h.c[2]), error);
  if (sign == 0 || certain_sign(h.c[0] + r * (h.c[1] + r * h.c[2]), error) != sign ||
      certain_sign(h.c[0] + h.c[1] * (l + r) / 2 + h.c[2] * l * r, error) != sign) {
    return 0;
  }
  return sign;
}

/// A zero at the low end leaves at most one more. There is none inside if the functional leaves 0
/// toward the sign that it has at the high end; and the reverse.
bool Regulus::has_no_other_zero(const Interval& interval, const LineVector& functional,
                                bool at_low) const {
  const Rounded h = rounded(functional);
  const double zero = at_low ? interval.low_rounded_ : interval.high_rounded_;
  const double end = at_low ? interval.high_rounded_ : interval.low_rounded_;
  const double error = 3 * h.error + 18 * interval.error_ + 256 * LinePool::kUnit;
  const int slope = certain_sign(h.c[1] + 2 * h.c[2] * zero, error);
  const int sign = certain_sign(h.c[0] + end * (h.c[1] + end * h.c[2]), error);
  return sign != 0 && slope == (at_low ? sign : -sign);
}

std::vector<StabbingLine> Regulus::zeros(LineArithmetic& arithmetic, const Interval& interval,
                                         const LineVector& functional) const {
  const auto& f = arithmetic.pool().exact(functional);
  std::array<BigInteger, 3> c;
  for (std::size_t i = 0; i < 3; ++i) {
    c[i] = BigInteger(0);
    for (std::size_t k = 0; k < 6; ++k) c[i] += coefficients_[i][k] * f[k];
  }
  std::vector<StabbingLine> result;
  const auto is_inside = [&](const Surd& s) { return interval.low_ < s && s < interval.high_; };
  if (sign(c[2]) == 0) {
    if (sign(c[1]) == 0) return result;
    const CGAL::Gmpq s(-c[0], c[1]);
    if (is_inside(Surd(s))) result.push_back(at(arithmetic, s));
    return result;
  }
  const BigInteger root = c[1] * c[1] - BigInteger(4) * c[0] * c[2];
  if (sign(root) < 0) return result;
  const BigInteger w = c[2] + c[2], u = -c[1];
  for (const int way : {1, -1}) {
    if (way < 0 && sign(root) == 0) break;
    const Surd s = sign(root) == 0
                       ? Surd(CGAL::Gmpq(u, w))
                       : Surd(CGAL::Gmpq(u, w), CGAL::Gmpq(BigInteger(way), w), CGAL::Gmpq(root));
    if (!is_inside(s)) continue;
    // s = (u + way sqrt(root)) / w, times w^2.
    LineComponents a, b;
    for (std::size_t k = 0; k < 6; ++k) {
      const BigInteger &l0 = coefficients_[0][k], &l1 = coefficients_[1][k],
                       &l2 = coefficients_[2][k];
      a[k] = l0 * w * w + l1 * w * u + l2 * (u * u + root);
      b[k] = BigInteger(way) * (l1 * w + BigInteger(2) * l2 * u);
    }
    result.push_back(arithmetic.line(a, b, root));
  }
  return result;
}

}  // namespace viewcover::exact
