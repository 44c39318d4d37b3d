#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "support/second_opinion/quadratic_root.h"

namespace viewcover::testing::second_opinion {

template <class N>
struct Affine {
  N x{}, y{}, c{};
  N at(const N& px, const N& py) const { return x * px + y * py + c; }
  bool is_constant() const { return sign_of(x) == 0 && sign_of(y) == 0; }
};

template <class N>
void add_product(N& sum, const N& a, const N& b, int sign) {
  if (sign_of(a) == 0 || sign_of(b) == 0) return;
  if (sign > 0) {
    sum += a * b;
  } else {
    sum -= a * b;
  }
}

/// Coefficients of 1, x, y, xx, xy, yy.
template <class N>
struct Conic : std::array<N, 6> {
  bool is_zero() const {
    return std::ranges::all_of(*this, [](const N& c) { return sign_of(c) == 0; });
  }
  bool is_linear() const {
    return sign_of((*this)[3]) == 0 && sign_of((*this)[4]) == 0 && sign_of((*this)[5]) == 0;
  }
  bool is_constant() const {
    return is_linear() && sign_of((*this)[1]) == 0 && sign_of((*this)[2]) == 0;
  }
  N at(const N& x, const N& y) const {
    const auto& c = *this;
    return c[0] + x * (c[1] + x * c[3] + y * c[4]) + y * (c[2] + y * c[5]);
  }
  void add(const Affine<N>& a, const Affine<N>& b, int sign) {
    auto& c = *this;
    add_product(c[0], a.c, b.c, sign);
    add_product(c[1], a.x, b.c, sign);
    add_product(c[1], a.c, b.x, sign);
    add_product(c[2], a.y, b.c, sign);
    add_product(c[2], a.c, b.y, sign);
    add_product(c[3], a.x, b.x, sign);
    add_product(c[4], a.x, b.y, sign);
    add_product(c[4], a.y, b.x, sign);
    add_product(c[5], a.y, b.y, sign);
  }
  /// As a polynomial in y, by degree.
  std::array<Univariate<N>, 3> by_y() const {
    const auto& c = *this;
    std::array<Univariate<N>, 3> result{Univariate<N>{c[0], c[1], c[3]}, Univariate<N>{c[2], c[4]},
                                        Univariate<N>{c[5]}};
    for (Univariate<N>& coefficient : result) trim(coefficient);
    return result;
  }
};

template <class N>
Conic<N> conic_of(const Affine<N>& a) {
  Conic<N> result{};
  result[0] = a.c;
  result[1] = a.x;
  result[2] = a.y;
  return result;
}

/// Coefficients of 1, x, y, xx, xy, yy, xxx, xxy, xyy, yyy.
template <class N>
struct Cubic : std::array<N, 10> {
  void add(const Conic<N>& a, const Affine<N>& b) {
    static constexpr std::size_t kTimesX[] = {1, 3, 4, 6, 7, 8}, kTimesY[] = {2, 4, 5, 7, 8, 9};
    for (std::size_t i = 0; i < 6; ++i) {
      add_product((*this)[i], a[i], b.c, 1);
      add_product((*this)[kTimesX[i]], a[i], b.x, 1);
      add_product((*this)[kTimesY[i]], a[i], b.y, 1);
    }
  }
  /// The quotient by a divisor that divides without remainder.
  Conic<N> over(const Affine<N>& h) const {
    const auto& c = *this;
    Conic<N> q{};
    if (sign_of(h.x) != 0) {
      q[3] = c[6] / h.x;
      q[4] = (c[7] - h.y * q[3]) / h.x;
      q[5] = (c[8] - h.y * q[4]) / h.x;
      q[1] = (c[3] - h.c * q[3]) / h.x;
      q[2] = (c[4] - h.c * q[4] - h.y * q[1]) / h.x;
      q[0] = (c[1] - h.c * q[1]) / h.x;
    } else if (sign_of(h.y) != 0) {
      q[3] = c[7] / h.y;
      q[4] = c[8] / h.y;
      q[5] = c[9] / h.y;
      q[1] = (c[4] - h.c * q[4]) / h.y;
      q[2] = (c[5] - h.c * q[5]) / h.y;
      q[0] = (c[2] - h.c * q[2]) / h.y;
    } else {
      for (std::size_t i = 0; i < 6; ++i) q[i] = c[i] / h.c;
    }
    return q;
  }
};

/// The different factors that are irreducible over the rationals, without constants. All have
/// multiplicity 1 but for a single one of multiplicity 2.
template <class N>
struct Factors {
  std::vector<Conic<N>> factors;
  bool is_square = false;
};

template <class N>
Factors<N> irreducible_factors(const Conic<N>& f) {
  if (f.is_constant()) return {};
  if (f.is_linear() || !Numbers<N>::kExact) return {{f}};
  const N four_determinants = 4 * f[3] * f[5] * f[0] + f[4] * f[2] * f[1] - f[3] * f[2] * f[2] -
                              f[5] * f[1] * f[1] - f[0] * f[4] * f[4];
  if (sign_of(four_determinants) != 0) return {{f}};
  const auto line = [](N x, N y, N c) {
    return conic_of(Affine<N>{std::move(x), std::move(y), std::move(c)});
  };
  if (sign_of(f[3]) == 0 && sign_of(f[5]) == 0) {
    return {{line(f[4], 0, f[2]), line(0, f[4], f[1])}};
  }
  // Solve for the variable that has a square; u stands for the other one.
  const bool solve_y = sign_of(f[5]) != 0;
  const N &square = solve_y ? f[5] : f[3], &linear = solve_y ? f[2] : f[1];
  const N &other_square = solve_y ? f[3] : f[5], &other_linear = solve_y ? f[1] : f[2];
  const N d2 = f[4] * f[4] - 4 * square * other_square;
  const N d1 = 2 * f[4] * linear - 4 * square * other_linear;
  const N d0 = linear * linear - 4 * square * f[0];
  // The discriminant d2 uu + d1 u + d0 is a square up to a constant: (r u + s)^2 if that is one.
  const auto root = Numbers<N>::square_root(sign_of(d2) != 0 ? d2 : d0);
  if (!root) return {{f}};
  const N r = sign_of(d2) != 0 ? *root : N(0), s = sign_of(d2) != 0 ? N(d1 / (2 * *root)) : *root;
  Factors<N> result;
  result.is_square = sign_of(r) == 0 && sign_of(s) == 0;
  for (const int sign : {1, -1}) {
    const N u = f[4] + sign * r, v = 2 * square, c = linear + sign * s;
    result.factors.push_back(solve_y ? line(u, v, c) : line(v, u, c));
    if (result.is_square) break;
  }
  return result;
}

template <class N>
Univariate<N> discriminant(const Conic<N>& f) {
  const auto [c, b, a] = f.by_y();
  return difference(product(b, b), product(product(Univariate<N>{N(4)}, a), c));
}

/// With respect to y, of two curves that both hold y.
template <class N>
Univariate<N> resultant(const Conic<N>& f, const Conic<N>& g) {
  const auto [c1, b1, a1] = f.by_y();
  const auto [c2, b2, a2] = g.by_y();
  const Univariate<N> bc = difference(product(b1, c2), product(b2, c1));
  if (a1.empty() && a2.empty()) return bc;
  const Univariate<N> ac = difference(product(a1, c2), product(a2, c1));
  const Univariate<N> ab = difference(product(a1, b2), product(a2, b1));
  return difference(product(ac, ac), product(ab, bc));
}

}  // namespace viewcover::testing::second_opinion
