#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "support/second_opinion/numbers.h"

namespace viewcover::testing::second_opinion {

/// Coefficients by degree; none for zero, else the last is not zero.
template <class N>
using Univariate = std::vector<N>;

template <class N>
void trim(Univariate<N>& polynomial) {
  while (!polynomial.empty() && sign_of(polynomial.back()) == 0) polynomial.pop_back();
}

template <class N>
Univariate<N> product(const Univariate<N>& a, const Univariate<N>& b) {
  if (a.empty() || b.empty()) return {};
  Univariate<N> result(a.size() + b.size() - 1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
  }
  trim(result);
  return result;
}

template <class N>
Univariate<N> difference(Univariate<N> a, const Univariate<N>& b) {
  if (a.size() < b.size()) a.resize(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) a[i] -= b[i];
  trim(a);
  return a;
}

template <class N>
N value_at(const Univariate<N>& polynomial, const N& x) {
  N sum{};
  for (std::size_t i = polynomial.size(); i-- > 0;) sum = sum * x + polynomial[i];
  return sum;
}

template <class N>
Univariate<N> quotient_and_remainder(Univariate<N>& a, const Univariate<N>& b) {
  Univariate<N> quotient;
  if (a.size() >= b.size()) quotient.resize(a.size() - b.size() + 1);
  while (a.size() >= b.size()) {
    const std::size_t shift = a.size() - b.size();
    quotient[shift] = a.back() / b.back();
    for (std::size_t i = 0; i + 1 < b.size(); ++i) a[i + shift] -= quotient[shift] * b[i];
    a.pop_back();
    trim(a);
  }
  return quotient;
}

template <class N>
Univariate<N> common_divisor(Univariate<N> a, Univariate<N> b) {
  while (!b.empty()) {
    quotient_and_remainder(a, b);
    Numbers<N>::reduce(a);
    std::swap(a, b);
  }
  return a;
}

template <class N>
Univariate<N> square_free(Univariate<N> polynomial) {
  Univariate<N> derivative;
  for (std::size_t i = 1; i < polynomial.size(); ++i) derivative.push_back(polynomial[i] * N(i));
  const Univariate<N> repeated = common_divisor(polynomial, derivative);
  if (repeated.size() <= 1) return polynomial;
  Univariate<N> result = quotient_and_remainder(polynomial, repeated);
  Numbers<N>::reduce(result);
  return result;
}

struct Variations {
  int count = 0;
  int first_sign = 0;  ///< of the polynomial just above the interval's lower end
};

/// Sign changes of the Bernstein coefficients on (low, high): the number of roots there, with
/// multiplicity, plus an even number (Descartes).
template <class N>
Variations variations(const Univariate<N>& polynomial, const N& low, const N& high) {
  Univariate<N> c = polynomial;
  const std::size_t size = c.size();
  for (std::size_t i = 0; i + 1 < size; ++i) {
    for (std::size_t j = size - 1; j-- > i;) c[j] += low * c[j + 1];
  }
  const N width = high - low;
  N power = width;
  for (std::size_t i = 1; i < size; ++i, power *= width) c[i] *= power;
  std::reverse(c.begin(), c.end());
  for (std::size_t i = 0; i + 1 < size; ++i) {
    for (std::size_t j = size - 1; j-- > i;) c[j] += c[j + 1];
  }
  Variations result;
  int last = 0;
  for (std::size_t i = size; i-- > 0;) {
    const int sign = sign_of(c[i]);
    if (sign == 0) continue;
    if (last == 0) result.first_sign = sign;
    if (last * sign < 0) ++result.count;
    last = sign;
  }
  return result;
}

/// A real number: the only root, a simple one, of a polynomial in (low, high), or `low` itself.
template <class N>
struct RealRoot {
  std::shared_ptr<const Univariate<N>> polynomial;
  N low, high;
  int sign_above_low = 0;

  bool is_rational() const { return polynomial == nullptr; }
  static RealRoot rational(const N& value) { return {nullptr, value, value, 0}; }
};

/// Sign of root - x. Narrows the root's interval to one side of x.
template <class N>
int compare(RealRoot<N>& root, const N& x) {
  if (root.is_rational()) return sign_of(N(root.low - x));
  if (x <= root.low) return 1;
  if (x >= root.high) return -1;
  const int sign = sign_of(value_at(*root.polynomial, x));
  if (sign == 0) {
    root = RealRoot<N>::rational(x);
    return 0;
  }
  (sign == root.sign_above_low ? root.low : root.high) = x;
  return sign == root.sign_above_low ? 1 : -1;
}

/// Sign of a - b.
template <class N>
int compare(RealRoot<N>& a, RealRoot<N>& b) {
  if (a.is_rational()) return -compare(b, N(a.low));
  if (b.is_rational()) return compare(a, N(b.low));
  if (a.polynomial == b.polynomial && a.low == b.low && a.high == b.high) return 0;
  for (int step = 0; step < 1000; ++step) {
    if (a.high <= b.low) return -1;
    if (b.high <= a.low) return 1;
    if (step == 8) {
      const Univariate<N> common = common_divisor(*a.polynomial, *b.polynomial);
      if (common.size() > 1 &&
          variations(common, std::max(a.low, b.low), std::min(a.high, b.high)).count % 2 == 1) {
        return 0;
      }
    }
    RealRoot<N>& wider = a.high - a.low > b.high - b.low ? a : b;
    RealRoot<N>& other = &wider == &a ? b : a;
    compare(wider, N((wider.low + wider.high) / 2));
    if (wider.is_rational()) {
      const int order = compare(other, N(wider.low));
      return &wider == &a ? -order : order;
    }
  }
  throw Undecided("order of two roots");
}

/// Appends the roots in (low, high), ascending.
template <class N>
void isolate(std::shared_ptr<const Univariate<N>> polynomial, bool is_square_free, const N& low,
             const N& high, int depth, std::vector<RealRoot<N>>& roots) {
  if (polynomial->size() < 2) return;
  if (depth > 500) throw Undecided("isolation of roots");
  const Variations found = variations(*polynomial, low, high);
  if (found.count == 0) return;
  if (found.count == 1) {
    roots.push_back({polynomial, low, high, found.first_sign});
    return;
  }
  if (!is_square_free) {
    polynomial = std::make_shared<const Univariate<N>>(square_free(*polynomial));
    return isolate(polynomial, true, low, high, depth + 1, roots);
  }
  const N middle = (low + high) / 2;
  isolate(polynomial, true, low, middle, depth + 1, roots);
  if (sign_of(value_at(*polynomial, middle)) == 0) {
    roots.push_back(RealRoot<N>::rational(middle));
  }
  isolate(polynomial, true, middle, high, depth + 1, roots);
}

}  // namespace viewcover::testing::second_opinion
