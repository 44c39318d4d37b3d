#pragma once

#include <cmath>
#include <utility>

#include "support/second_opinion/univariate.h"

namespace viewcover::testing::second_opinion {

/// centre + factor sqrt(radicand)
template <class N>
struct QuadraticRoot {
  N centre, factor, radicand;
  double value = 0, error = 0;

  QuadraticRoot() = default;
  QuadraticRoot(N c, N f, N r)
      : centre(std::move(c)), factor(std::move(f)), radicand(std::move(r)) {
    const double main = Numbers<N>::approximate(centre);
    const double part =
        Numbers<N>::approximate(factor) * std::sqrt(Numbers<N>::approximate(radicand));
    value = main + part;
    error = 8 * kRounding * (std::abs(main) + std::abs(part));
  }
  static QuadraticRoot rational(N number) { return {std::move(number), N(0), N(0)}; }
};

/// Sign of a + b sqrt(c), c >= 0.
template <class N>
int sign_of_sum(const N& a, const N& b, const N& c) {
  const int first = sign_of(a), second = sign_of(b) * sign_of(c);
  if (first * second >= 0) return first != 0 ? first : second;
  return first * sign_of(N(a * a - b * b * c));
}

/// Sign of a - b.
template <class N>
int compare(const QuadraticRoot<N>& a, const QuadraticRoot<N>& b) {
  if (const double gap = a.value - b.value; std::abs(gap) > 2 * (a.error + b.error)) {
    return gap > 0 ? 1 : -1;
  }
  const N rest = a.centre - b.centre;
  const int left = sign_of_sum(rest, a.factor, a.radicand);
  const int right = sign_of(b.factor) * sign_of(b.radicand);
  if (left != right || left == 0) return left > right ? 1 : left < right ? -1 : 0;
  const N squares =
      rest * rest + a.factor * a.factor * a.radicand - b.factor * b.factor * b.radicand;
  return left * sign_of_sum(squares, N(2 * rest * a.factor), a.radicand);
}

}  // namespace viewcover::testing::second_opinion
