#pragma once

#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>

#include "scene/convex_polygon.h"

namespace viewcover::testing {

// Numbers a + b sqrt(root) and vectors of them, with no code of the library.

using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Fraction = boost::multiprecision::number<boost::multiprecision::gmp_rational,
                                               boost::multiprecision::et_off>;

inline int sign_of(const Fraction& x) { return x.sign(); }

/// a + b sqrt(root), with one root for all numbers of a line.
struct Root {
  Fraction a = 0, b = 0, root = 0;

  Root() = default;
  Root(const Fraction& rational) : a(rational) {}  // NOLINT: as a number
  Root(const Fraction& x, const Fraction& y, const Fraction& r) : a(x), b(y), root(r) {}

  static Fraction common(const Root& x, const Root& y) { return x.b == 0 ? y.root : x.root; }
  friend Root operator+(const Root& x, const Root& y) {
    return {x.a + y.a, x.b + y.b, common(x, y)};
  }
  friend Root operator-(const Root& x, const Root& y) {
    return {x.a - y.a, x.b - y.b, common(x, y)};
  }
  friend Root operator*(const Root& x, const Root& y) {
    const Fraction r = common(x, y);
    return {x.a * y.a + x.b * y.b * r, x.a * y.b + x.b * y.a, r};
  }
  friend Root operator/(const Root& x, const Root& y) {
    const Fraction norm = y.a * y.a - y.b * y.b * y.root;
    return x * Root{y.a / norm, -y.b / norm, y.root};
  }
  double rounded() const {
    return a.convert_to<double>() + b.convert_to<double>() * std::sqrt(root.convert_to<double>());
  }
};

inline int sign_of(const Root& x) {
  const int a = x.a.sign(), b = x.root == 0 ? 0 : x.b.sign();
  if (a * b >= 0) return a != 0 ? a : b;
  return a * Fraction(x.a * x.a - x.b * x.b * x.root).sign();
}

template <class N>
using Vec = std::array<N, 3>;
template <class N>
using Line = std::array<N, 6>;

template <class N, class M>
Vec<N> minus(const Vec<N>& x, const Vec<M>& y) {
  return {x[0] - N(y[0]), x[1] - N(y[1]), x[2] - N(y[2])};
}
template <class N, class M>
auto dot(const Vec<N>& x, const Vec<M>& y) {
  return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
}
template <class N>
Vec<N> cross(const Vec<N>& x, const Vec<N>& y) {
  return {x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]};
}
inline Vec<Root> roots(const Vec<Fraction>& x) { return {Root(x[0]), Root(x[1]), Root(x[2])}; }

inline Vec<Fraction> vec(const Point& p) {
  return {Fraction(p.x()), Fraction(p.y()), Fraction(p.z())};
}

inline Line<Fraction> through(const Vec<Fraction>& a, const Vec<Fraction>& b) {
  const auto d = minus(b, a), m = cross(a, b);
  return {d[0], d[1], d[2], m[0], m[1], m[2]};
}

/// Direction and moment of a line.
template <class N>
std::array<Vec<N>, 2> halves(const Line<N>& line) {
  return {Vec<N>{line[0], line[1], line[2]}, Vec<N>{line[3], line[4], line[5]}};
}

/// The polar form of the Klein form: 0 iff lines meet.
template <class N, class M>
auto form(const Line<N>& x, const Line<M>& y) {
  auto sum = x[0] * y[3];
  for (std::size_t k = 1; k < 6; ++k) sum = sum + x[k] * y[(k + 3) % 6];
  return sum;
}

}  // namespace viewcover::testing
