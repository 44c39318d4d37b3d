#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/sight_query.h"
#include "scene/convex_polygon.h"

// Is E visible from R? Decided in the plane of R: no lines as points, no cells of lines.
//
// From a point p of R off the occluders' planes an occluder T hides the cone over it: the q of
// plane(E) on the inner side of each plane through p and an edge of T. On plane(E) these are lines
// whose coefficients are affine in p = (x, y). Subtracting cone after cone from E leaves nothing of
// positive area (E is hidden from p) or something (then a neighbourhood of (p, q) is free: visible,
// proved). Occluders count where they are strictly on E's side of plane(R) and on R's side of
// plane(E); R and E are cut by each other's plane first, and each pair of parts is decided alone.
//
// Certificate. If E is hidden from p, every piece left over by the subtraction has been found empty
// because a line t >= 0 on it although t < 0 there by construction. By Farkas two sides a, b of the
// piece prove it: D(a,b) t = D(t,b) a + D(a,t) b + M(a,b,t), where D, M are the 2x2 and 3x3
// determinants of the lines' coefficients and all four have the same sign. D and M are polynomials
// in p of degree <= 2 (M once the factor "height of p over plane(E)" is divided out). So E is
// hidden from every point of R that is joined to p without crossing a zero of their irreducible
// factors, common factors left out, nor of the planes of the occluders used.
//
// Sweep (a cylindrical algebraic covering, see Abraham, Davenport, England and Kremer 2021, with
// open cells only). On the vertical line x = x0 a certificate at y0 holds between the next zeros of
// its curves below and above. Repeating this in the gaps covers the line. The covering stays valid
// for all x around x0 up to the next zero of (1) discriminant and leading coefficient of each curve
// that bounds an interval, (2) the discriminant of every other curve of its certificate and the
// resultants of that curve with the two bounding ones, (3) the resultant of the two bounding curves
// of an interval and of those of neighbours in the covering. Proof: up to there bounds are
// continuous and never meet or pass each other; a curve enters the interval only across a bound,
// a zero of (2), or as a new double root, a zero of its discriminant. Repeating this in the gaps
// covers R.
//
// Complete: "hidden" leaves out finitely many x and, for every other x, finitely many y; the free
// set is open, hence empty. Terminates: each sample settles a cell of the finite arrangement of all
// possible curves. Factors are irreducible over the rationals, so that different ones are coprime
// and no resultant or discriminant is identically zero. A sample at which some polynomial is zero
// is replaced by another.

namespace viewcover::testing {
namespace second_opinion {

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

// ---------------------------------------------------------------- polynomials in x

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

// ---------------------------------------------------------------- roots of quadratics

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

// ---------------------------------------------------------------- polynomials in (x, y)

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

// ---------------------------------------------------------------- space

template <class N>
using Vector = std::array<N, 3>;

template <class N>
Vector<N> cross(const Vector<N>& a, const Vector<N>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class N>
N dot(const Vector<N>& a, const Vector<N>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

template <class N>
Vector<N> minus(const Vector<N>& a, const Vector<N>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

template <class N>
bool is_zero(const Vector<N>& a) {
  return sign_of(a[0]) == 0 && sign_of(a[1]) == 0 && sign_of(a[2]) == 0;
}

template <class N>
using Corners = std::vector<Vector<N>>;

/// Without corners within edges.
template <class N>
Corners<N> corners_of(std::span<const Point> polygon) {
  Corners<N> all, result;
  for (const Point& p : polygon) all.push_back({N(p.x()), N(p.y()), N(p.z())});
  for (std::size_t i = 0, n = all.size(); i < n; ++i) {
    const Vector<N>& here = all[i];
    const Vector<N> from = minus(here, all[(i + n - 1) % n]);
    if (!is_zero(cross(from, minus(all[(i + 1) % n], here)))) result.push_back(here);
  }
  return result;
}

/// normal . v = offset; its points are given by their coordinates along two axes.
template <class N>
struct Plane {
  Vector<N> normal{};
  N offset{};
  std::size_t first = 0, second = 1, dropped = 2;

  explicit Plane(const Corners<N>& corners) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector<N> part = cross(corners[i], corners[(i + 1) % corners.size()]);
      for (std::size_t k = 0; k < 3; ++k) normal[k] += part[k];
    }
    offset = dot(normal, corners[0]);
    std::array<N, 4> all{normal[0], normal[1], normal[2], offset};
    Numbers<N>::reduce(all);
    normal = {all[0], all[1], all[2]};
    offset = all[3];
    for (std::size_t k = 0; k < 3; ++k) {
      if (abs_of(normal[k]) > abs_of(normal[dropped])) dropped = k;
    }
    first = (dropped + 1) % 3;
    second = (dropped + 2) % 3;
  }

  static N abs_of(const N& value) { return value < 0 ? N(-value) : value; }
  N height(const Vector<N>& v) const { return dot(normal, v) - offset; }

  /// The function g . v + c on this plane, times a positive constant of the plane.
  Affine<N> restricted(const Vector<N>& g, const N& c) const {
    const N scale = abs_of(normal[dropped]);
    const N share = normal[dropped] < 0 ? N(-g[dropped]) : g[dropped];
    return {scale * g[first] - normal[first] * share, scale * g[second] - normal[second] * share,
            scale * c + offset * share};
  }
  Affine<N> restricted_height_over(const Plane& other) const {
    return restricted(other.normal, N(-other.offset));
  }
};

/// The part of a polygon where sign * height over the plane >= 0.
template <class N>
Corners<N> part_above(const Corners<N>& polygon, const Plane<N>& plane, int sign) {
  Corners<N> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector<N>&a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const N ha = sign * plane.height(a), hb = sign * plane.height(b);
    if (ha >= 0) result.push_back(a);
    if (sign_of(ha) * sign_of(hb) < 0) {
      const N t = ha / (ha - hb);
      result.push_back(
          {a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]), a[2] + t * (b[2] - a[2])});
    }
  }
  return result;
}

template <class N>
bool has_area(const Corners<N>& polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    if (!is_zero(cross(minus(polygon[i], polygon[0]), minus(polygon[i - 1], polygon[0])))) {
      return true;
    }
  }
  return false;
}

// ---------------------------------------------------------------- the decision

/// One side of plane(R) and one side of plane(E).
template <class N>
class Sweep {
 public:
  /// `from`, the part of R on the side `side_e` of plane(E), has an area; E has points on the side
  /// `side_r` of plane(R).
  Sweep(const Plane<N>& plane_r, const Corners<N>& from, const Plane<N>& plane_e,
        const Corners<N>& element, const std::vector<Corners<N>>& occluders, int side_r, int side_e)
      : plane_r_(plane_r), plane_e_(plane_e) {
    set_region(from);
    height_ = plane_r.restricted_height_over(plane_e);
    if (side_e < 0) height_ = {-height_.x, -height_.y, -height_.c};
    set_element(element, side_r);
    for (const Corners<N>& occluder : occluders) add_occluder(occluder, side_r, side_e);
  }

  bool sees() {
    if (element_.size() < 3) return false;
    if (try_some_points()) return true;
    std::vector<std::pair<RealRoot<N>, RealRoot<N>>> gaps = {
        {RealRoot<N>::rational(low_x_), RealRoot<N>::rational(high_x_)}};
    while (!gaps.empty()) {
      auto [low, high] = std::move(gaps.back());
      gaps.pop_back();
      if (compare(low, high) >= 0) continue;
      if (sees_between(low, high, gaps)) return true;
    }
    return false;
  }

  std::size_t points = 0;  ///< of R looked from
  std::size_t lines = 0;   ///< x = constant

 private:
  enum class Look { kSeen, kHidden, kDegenerate };

  /// A line of plane(E), >= 0 where it may hide; coefficients of first, second axis and 1.
  struct Line {
    std::array<Affine<N>, 3> coefficients;
    int blocker = -1;  ///< whose side of p gives the line's sign; none for E's own
    bool moves = false;
  };
  struct Blocker {
    Affine<N> side;  ///< > 0 for p where its lines have the right sign
    int fixed_sign = 0;
    int curve = -1;
    std::vector<int> lines;
  };
  struct Curve {
    Conic<N> f;
    std::array<double, 6> approximate{};
    bool has_y = false, has_yy = false;
    bool crosses_region = true;
  };
  /// Signed lines, twice the line plus 1 if it is turned, counter-clockwise round the cell.
  using Cell = std::vector<int>;
  struct Bound {
    QuadraticRoot<N> root;
    int curve = -1, branch = 0;
    bool same_branch(const Bound& other) const {
      return curve == other.curve && branch == other.branch;
    }
  };
  struct Interval {
    Bound low, high;
    std::vector<int> curves;  ///< of the proof that E is hidden from it
  };
  /// Of the points of R with one x: neighbours overlap or share a bound.
  struct Cover {
    Bound bottom, top;  ///< where R ends
    std::vector<Interval> intervals;
  };

  // ---- set-up

  void set_region(const Corners<N>& from) {
    std::vector<std::array<N, 2>> corners;
    for (const Vector<N>& v : from) corners.push_back({v[plane_r_.first], v[plane_r_.second]});
    region_ = turned_left(std::move(corners));
    low_x_ = high_x_ = region_[0][0];
    low_y_ = high_y_ = region_[0][1];
    for (std::size_t i = 0; i < region_.size(); ++i) {
      const auto &a = region_[i], &b = region_[(i + 1) % region_.size()];
      low_x_ = std::min(low_x_, a[0]);
      high_x_ = std::max(high_x_, a[0]);
      low_y_ = std::min(low_y_, a[1]);
      high_y_ = std::max(high_y_, a[1]);
      if (a[0] == b[0]) continue;
      (a[0] < b[0] ? floor_ : ceiling_).push_back(curve_of(conic_of(line_through(a, b))));
    }
  }

  static std::vector<std::array<N, 2>> turned_left(std::vector<std::array<N, 2>> polygon) {
    N twice_area{};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      twice_area += a[0] * b[1] - a[1] * b[0];
    }
    if (twice_area < 0) std::reverse(polygon.begin(), polygon.end());
    return polygon;
  }

  /// >= 0 on the left of ab
  static Affine<N> line_through(const std::array<N, 2>& a, const std::array<N, 2>& b) {
    return {a[1] - b[1], b[0] - a[0], a[0] * b[1] - a[1] * b[0]};
  }

  int add_line(std::array<Affine<N>, 3> coefficients, int blocker) {
    std::array<N, 9> all;
    for (std::size_t i = 0; i < 3; ++i) {
      all[3 * i] = coefficients[i].x;
      all[3 * i + 1] = coefficients[i].y;
      all[3 * i + 2] = coefficients[i].c;
    }
    Numbers<N>::reduce(all);
    Line line;
    for (std::size_t i = 0; i < 3; ++i) {
      line.coefficients[i] = {all[3 * i], all[3 * i + 1], all[3 * i + 2]};
      line.moves = line.moves || !line.coefficients[i].is_constant();
    }
    line.blocker = blocker;
    lines_.push_back(std::move(line));
    return static_cast<int>(lines_.size()) - 1;
  }

  int add_fixed_line(const Affine<N>& line, int blocker) {
    return add_line({Affine<N>{0, 0, line.x}, Affine<N>{0, 0, line.y}, Affine<N>{0, 0, line.c}},
                    blocker);
  }

  void set_element(const Corners<N>& element, int side_r) {
    std::vector<std::array<N, 2>> corners;
    bool cut = false;
    for (const Vector<N>& v : element) {
      corners.push_back({v[plane_e_.first], v[plane_e_.second]});
      cut = cut || sign_of(plane_r_.height(v)) * side_r < 0;
    }
    corners = turned_left(std::move(corners));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto line = line_through(corners[i], corners[(i + 1) % corners.size()]);
      element_.push_back(2 * add_fixed_line(line, -1));
    }
    if (!cut) return;
    Affine<N> height = plane_e_.restricted_height_over(plane_r_);
    if (side_r < 0) height = {-height.x, -height.y, -height.c};
    const int line = 2 * add_fixed_line(height, -1);
    set_point(region_[0][0], region_[0][1]);
    element_ = clipped(element_, line, signs_at_corners(element_, line));
  }

  void add_occluder(const Corners<N>& corners, int side_r, int side_e) {
    const Plane<N> plane(corners);
    const auto in_plane = [&](const Plane<N>& other) {
      return std::ranges::all_of(corners,
                                 [&](const Vector<N>& v) { return sign_of(other.height(v)) == 0; });
    };
    if (in_plane(plane_r_) || in_plane(plane_e_)) return;
    if (!has_area(part_above(part_above(corners, plane_r_, side_r), plane_e_, side_e))) return;
    const int id = static_cast<int>(blockers_.size());
    Blocker blocker;
    blocker.side = plane_r_.restricted_height_over(plane);
    std::array<bool, 2> seen{};
    for (const auto& corner : region_) {
      const int sign = sign_of(blocker.side.at(corner[0], corner[1]));
      if (sign != 0) seen[sign > 0] = true;
    }
    if (seen[0] != seen[1]) {
      blocker.fixed_sign = seen[1] ? 1 : -1;
    } else {
      blocker.curve = curve_of(conic_of(blocker.side));
    }
    // What can hide is the part of the occluder strictly on both sides. Other edges do not bound
    // it; plane(E) does where it cuts; plane(R) need not be a side as all of E is beyond it.
    bool reaches_element = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector<N>&a = corners[i], &b = corners[(i + 1) % corners.size()];
      const auto below = [&](const Plane<N>& other, int side) {
        return sign_of(other.height(a)) * side <= 0 && sign_of(other.height(b)) * side <= 0;
      };
      reaches_element =
          reaches_element || sign_of(plane_e_.height(a)) * side_e < 0 || below(plane_e_, side_e);
      if (below(plane_r_, side_r) || below(plane_e_, side_e)) continue;
      blocker.lines.push_back(2 * add_line(edge_shadow(a, b), id));
    }
    if (reaches_element) {
      const Affine<N> height = plane_e_.restricted_height_over(plane);
      blocker.lines.push_back(2 * add_fixed_line({-height.x, -height.y, -height.c}, id));
    }
    blockers_.push_back(std::move(blocker));
  }

  /// The plane through p and ab where it meets plane(E); >= 0 on the inner side for p in front.
  std::array<Affine<N>, 3> edge_shadow(const Vector<N>& a, const Vector<N>& b) const {
    // (b - p) x (a - p) = m + p x c is the normal, -m . p the constant
    const Vector<N> m = cross(b, a), c = minus(b, a);
    const N zero{};
    const std::array<Affine<N>, 4> plane = {
        plane_r_.restricted({zero, c[2], N(-c[1])}, m[0]),
        plane_r_.restricted({N(-c[2]), zero, c[0]}, m[1]),
        plane_r_.restricted({c[1], N(-c[0]), zero}, m[2]),
        plane_r_.restricted({N(-m[0]), N(-m[1]), N(-m[2])}, zero)};
    std::array<Affine<N>, 3> line;
    for (N Affine<N>::*part : {&Affine<N>::x, &Affine<N>::y, &Affine<N>::c}) {
      const Affine<N> on_element =
          plane_e_.restricted({plane[0].*part, plane[1].*part, plane[2].*part}, plane[3].*part);
      line[0].*part = on_element.x;
      line[1].*part = on_element.y;
      line[2].*part = on_element.c;
    }
    return line;
  }

  // ---- curves in the plane of R

  int curve_of(Conic<N> f) {
    Numbers<N>::reduce(f);
    const auto lead = std::ranges::find_if(f, [](const N& c) { return sign_of(c) != 0; });
    if (lead != f.end() && *lead < 0) {
      for (N& c : f) c = -c;
    }
    const auto [place, is_new] = curve_ids_.emplace(f, static_cast<int>(curves_.size()));
    if (is_new) {
      Curve curve;
      curve.f = f;
      for (std::size_t i = 0; i < 6; ++i) curve.approximate[i] = Numbers<N>::approximate(f[i]);
      curve.has_yy = sign_of(f[5]) != 0;
      curve.has_y = curve.has_yy || sign_of(f[2]) != 0 || sign_of(f[4]) != 0;
      curve.crosses_region = may_cross_region(f);
      curves_.push_back(std::move(curve));
    }
    return place->second;
  }

  /// False only if f >= 0 on all of R or f <= 0: by Bernstein coefficients on a fan of triangles.
  bool may_cross_region(const Conic<N>& f) const {
    std::array<bool, 2> seen{};
    const auto look = [&](std::size_t i, std::size_t j) {
      const auto &p = region_[i], &q = region_[j];
      const N polar = 2 * f[0] + f[1] * (p[0] + q[0]) + f[2] * (p[1] + q[1]) +
                      2 * f[3] * p[0] * q[0] + f[4] * (p[0] * q[1] + p[1] * q[0]) +
                      2 * f[5] * p[1] * q[1];
      const int sign = sign_of(polar);
      if (sign != 0) seen[sign > 0] = true;
    };
    for (std::size_t i = 0; i < region_.size(); ++i) {
      look(i, i);
      look(i, (i + 1) % region_.size());
      look(0, i);
    }
    return seen[0] && seen[1];
  }

  int sign_at(const Curve& curve, const N& x, const N& y, double dx, double dy) const {
    if constexpr (Numbers<N>::kExact) {
      const std::array<double, 6> terms = {
          curve.approximate[0],           curve.approximate[1] * dx,
          curve.approximate[2] * dy,      curve.approximate[3] * dx * dx,
          curve.approximate[4] * dx * dy, curve.approximate[5] * dy * dy};
      double sum = 0, size = 0;
      for (const double term : terms) {
        sum += term;
        size += std::abs(term);
      }
      if (std::abs(sum) > 32 * kRounding * size) return sum > 0 ? 1 : -1;
    }
    return sign_of(curve.f.at(x, y));
  }

  const Conic<N>& two_lines(int a, int b) {
    const auto [place, is_new] = two_lines_.try_emplace({a, b});
    if (is_new) {
      place->second = {};
      place->second.add(lines_[a].coefficients[0], lines_[b].coefficients[1], 1);
      place->second.add(lines_[a].coefficients[1], lines_[b].coefficients[0], -1);
    }
    return place->second;
  }

  /// Their determinant for a < b < c, divided by the height of p over plane(E) if all move.
  const Conic<N>& three_lines(int a, int b, int c) {
    const auto [place, is_new] = three_lines_.try_emplace({a, b, c});
    if (is_new) {
      Cubic<N> sum{};
      const std::array<int, 3> ids = {a, b, c};
      for (std::size_t k = 0; k < 3; ++k) {
        const Line &u = lines_[ids[(k + 1) % 3]], &v = lines_[ids[(k + 2) % 3]];
        Conic<N> minor{};
        minor.add(u.coefficients[0], v.coefficients[1], 1);
        minor.add(u.coefficients[1], v.coefficients[0], -1);
        sum.add(minor, lines_[ids[k]].coefficients[2]);
      }
      if (lines_[a].moves && lines_[b].moves && lines_[c].moves) {
        place->second = sum.over(height_);
      } else {
        std::copy_n(sum.begin(), 6, place->second.begin());
      }
    }
    return place->second;
  }

  struct ProofCurves {
    std::vector<int> bounding;  ///< where the signs may stop being equal
    std::vector<int> all;       ///< where one of the signs is zero
  };

  /// Of the Farkas proof with these three lines.
  const ProofCurves& curves_of_proof(int a, int b, int c) {
    std::array<int, 3> ids = {a, b, c};
    std::ranges::sort(ids);
    const auto [place, is_new] = curves_of_proof_.try_emplace({ids[0], ids[1], ids[2]});
    if (is_new) {
      ProofCurves& curves = place->second;
      std::vector<std::vector<int>> changing_sign;
      for (const Conic<N>* f : {&two_lines(ids[0], ids[1]), &two_lines(ids[1], ids[2]),
                                &two_lines(ids[0], ids[2]), &three_lines(ids[0], ids[1], ids[2])}) {
        if (f->is_zero()) continue;
        changing_sign.emplace_back();
        const Factors<N> factors = irreducible_factors(*f);
        for (const Conic<N>& factor : factors.factors) {
          curves.all.push_back(curve_of(factor));
          if (!factors.is_square) changing_sign.back().push_back(curves.all.back());
        }
      }
      for (const auto& one : changing_sign) {
        for (const int id : one) {
          const bool changes_all = std::ranges::all_of(
              changing_sign, [&](const auto& other) { return std::ranges::count(other, id) > 0; });
          if (!changes_all) curves.bounding.push_back(id);
        }
      }
      make_set(curves.bounding);
      make_set(curves.all);
    }
    return place->second;
  }

  template <class T>
  static void make_set(std::vector<T>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  // ---- from a point

  struct Approximate {
    std::array<double, 3> value, size;
  };

  bool set_point(const N& x, const N& y) {
    x_ = x;
    y_ = y;
    dx_ = Numbers<N>::approximate(x);
    dy_ = Numbers<N>::approximate(y);
    blocker_signs_.clear();
    for (const Blocker& blocker : blockers_) {
      const int sign =
          blocker.fixed_sign != 0 ? blocker.fixed_sign : sign_of(blocker.side.at(x, y));
      if (sign == 0) return false;
      blocker_signs_.push_back(sign);
    }
    approximate_.resize(lines_.size());
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Affine<N>& c = lines_[i].coefficients[k];
        const double px = Numbers<N>::approximate(c.x) * dx_,
                     py = Numbers<N>::approximate(c.y) * dy_, pc = Numbers<N>::approximate(c.c);
        approximate_[i].value[k] = px + py + pc;
        approximate_[i].size[k] = std::abs(px) + std::abs(py) + std::abs(pc);
      }
    }
    return true;
  }

  int orientation(int signed_line) const {
    const int blocker = lines_[signed_line / 2].blocker;
    return (blocker < 0 ? 1 : blocker_signs_[blocker]) * (signed_line % 2 == 0 ? 1 : -1);
  }

  /// Sign of D(a, b): b is a turned to the left.
  int turn(int a, int b) {
    const int i = a / 2, j = b / 2, flips = orientation(a) * orientation(b);
    if (i == j) return 0;
    const Approximate &u = approximate_[i], &v = approximate_[j];
    const double value = u.value[0] * v.value[1] - u.value[1] * v.value[0];
    const double size = u.size[0] * v.size[1] + u.size[1] * v.size[0];
    if (!Numbers<N>::kExact || std::abs(value) > 32 * kRounding * size) {
      return sign_of(value) * flips;
    }
    return sign_of(two_lines(i, j).at(x_, y_)) * flips;
  }

  /// Sign of line c where a and b meet, if turn(a, b) > 0.
  int side(int a, int b, int c) {
    std::array<int, 3> ids = {a / 2, b / 2, c / 2};
    int flips = orientation(a) * orientation(b) * orientation(c);
    if (ids[0] == ids[1] || ids[1] == ids[2] || ids[0] == ids[2]) return 0;
    const Approximate &u = approximate_[ids[0]], &v = approximate_[ids[1]],
                      &w = approximate_[ids[2]];
    double value = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
      value += w.value[k] * (u.value[l] * v.value[m] - u.value[m] * v.value[l]);
      size += w.size[k] * (u.size[l] * v.size[m] + u.size[m] * v.size[l]);
    }
    if (!Numbers<N>::kExact || std::abs(value) > 64 * kRounding * size) {
      return sign_of(value) * flips;
    }
    for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {0, 1}}) {
      if (ids[i] > ids[j]) {
        std::swap(ids[i], ids[j]);
        flips = -flips;
      }
    }
    return sign_of(three_lines(ids[0], ids[1], ids[2]).at(x_, y_)) * flips;
  }

  /// The corner i is where lines i and i + 1 meet.
  std::vector<int> signs_at_corners(const Cell& cell, int line) {
    std::vector<int> signs(cell.size());
    for (std::size_t i = 0; i < cell.size(); ++i) {
      signs[i] = side(cell[i], cell[(i + 1) % cell.size()], line);
    }
    return signs;
  }

  /// The part where line >= 0; empty if it has no area. `signs` are those of the line at the
  /// corners.
  static Cell clipped(const Cell& cell, int line, const std::vector<int>& signs) {
    if (std::ranges::none_of(signs, [](int s) { return s > 0; })) return {};
    if (std::ranges::none_of(signs, [](int s) { return s < 0; })) return cell;
    Cell result;
    const std::size_t n = cell.size();
    for (std::size_t i = 0; i < n; ++i) {
      // Line i runs from corner i - 1 to corner i.
      const int from = signs[(i + n - 1) % n], to = signs[i];
      if (from <= 0 && to <= 0) continue;
      result.push_back(cell[i]);
      if (from > 0 && to <= 0) result.push_back(line);
    }
    return result;
  }

  /// Is all of the cell hidden by the remaining occluders? Notes the proofs.
  bool covered(Cell cell, unsigned remaining) {
    int best = -1, best_hidden = -1;
    for (std::size_t b = 0; b < blockers_.size(); ++b) {
      if ((remaining >> b & 1) == 0) continue;
      bool misses = false;
      std::vector<bool> hidden(cell.size(), true);
      for (const int line : blockers_[b].lines) {
        const std::vector<int> signs = signs_at_corners(cell, line);
        misses = std::ranges::none_of(signs, [](int s) { return s > 0; });
        if (misses) break;
        for (std::size_t i = 0; i < cell.size(); ++i) hidden[i] = hidden[i] && signs[i] >= 0;
      }
      if (misses) {
        remaining &= ~(1u << b);
        continue;
      }
      const int count = static_cast<int>(std::ranges::count(hidden, true));
      const int score = count == static_cast<int>(cell.size()) ? 1000 : count;
      if (score > best_hidden) {
        best_hidden = score;
        best = static_cast<int>(b);
      }
    }
    if (best < 0) return false;
    remaining &= ~(1u << best);
    if (const int curve = blockers_[best].curve; curve >= 0) proof_.push_back(curve);
    for (const int line : blockers_[best].lines) {
      std::vector<int> signs = signs_at_corners(cell, line);
      if (std::ranges::none_of(signs, [](int s) { return s < 0; })) {
        note_proof(cell, line);
        continue;
      }
      const Cell inside = clipped(cell, line, signs);
      for (int& sign : signs) sign = -sign;
      if (!covered(clipped(cell, line ^ 1, signs), remaining)) return false;
      if (inside.empty()) return true;
      cell = inside;
    }
    return true;
  }

  /// Why line >= 0 on the cell: the two sides that meet at its lowest corner, seen from the line.
  void note_proof(const Cell& cell, int line) {
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const int a = cell[i], b = cell[(i + 1) % cell.size()];
      if (turn(line, b) < 0 || turn(a, line) < 0) continue;
      const ProofCurves& curves = curves_of_proof(a / 2, b / 2, line / 2);
      proof_.insert(proof_.end(), curves.bounding.begin(), curves.bounding.end());
      zero_free_.insert(zero_free_.end(), curves.all.begin(), curves.all.end());
      return;
    }
    throw Undecided("no lowest corner");
  }

  /// E from the point (x, y) of R. If hidden, proof_ holds the curves to be crossed before that can
  /// change. Degenerate if a sign of the proof is zero by chance, or in the plane of an occluder.
  Look look_from(const N& x, const N& y) {
    if (++points > 100'000) throw Undecided("number of points");
    if (!set_point(x, y)) return Look::kDegenerate;
    proof_.clear();
    zero_free_.clear();
    if (!covered(element_, (1u << blockers_.size()) - 1)) return Look::kSeen;
    make_set(proof_);
    make_set(zero_free_);
    for (const int id : zero_free_) {
      if (sign_at(curves_[id], x_, y_, dx_, dy_) == 0) return Look::kDegenerate;
    }
    std::erase_if(proof_, [&](int id) { return !curves_[id].crosses_region; });
    return Look::kHidden;
  }

  bool try_some_points() {
    std::uint64_t state = 1;
    for (int trial = 0; trial < 8; ++trial) {
      N x{}, y{}, total{};
      for (const auto& corner : region_) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        const N weight(static_cast<int>(state >> 58) + 1);
        x += weight * corner[0];
        y += weight * corner[1];
        total += weight;
      }
      if (look_from(x / total, y / total) == Look::kSeen) return true;
    }
    return false;
  }

  // ---- along a line x = constant

  std::vector<Bound> roots_at(int id, const N& x) const {
    const Conic<N>& f = curves_[id].f;
    const N c = f[0] + x * (f[1] + x * f[3]), b = f[2] + x * f[4];
    const N& a = f[5];
    if (sign_of(a) == 0) {
      if (sign_of(b) == 0) return {};
      return {{QuadraticRoot<N>::rational(-c / b), id, 0}};
    }
    const N radicand = b * b - 4 * a * c;
    if (sign_of(radicand) < 0) return {};
    const N centre = -b / (2 * a);
    N factor = N(1) / (2 * a);
    if (factor < 0) factor = -factor;
    return {{QuadraticRoot<N>(centre, N(-factor), radicand), id, 0},
            {QuadraticRoot<N>(centre, factor, radicand), id, 1}};
  }

  /// A short number strictly between, by halving [low, high].
  template <class Root, class Order>
  static N between(Root& from, Root& to, N low, N high, const Order& order) {
    for (int step = 0; step < 2000; ++step) {
      const N middle = (low + high) / 2;
      if (order(from, middle) >= 0) {
        low = middle;
      } else if (order(to, middle) <= 0) {
        high = middle;
      } else {
        return middle;
      }
    }
    throw Undecided("number between two roots");
  }

  /// Covers R on the line x = x0 by intervals on which E is hidden.
  Look cover_line(const N& x, Cover& cover) {
    Bound &bottom = cover.bottom, &top = cover.top;
    for (const int id : floor_) {
      const Bound bound = roots_at(id, x).at(0);
      if (bottom.curve < 0 || compare(bound.root, bottom.root) > 0) bottom = bound;
    }
    for (const int id : ceiling_) {
      const Bound bound = roots_at(id, x).at(0);
      if (top.curve < 0 || compare(bound.root, top.root) < 0) top = bound;
    }
    std::vector<Interval> found;
    std::vector<std::pair<Bound, Bound>> gaps = {{bottom, top}};
    while (!gaps.empty()) {
      const auto [from, to] = std::move(gaps.back());
      gaps.pop_back();
      if (compare(from.root, to.root) >= 0) continue;
      Interval interval;
      const Look look = look_between(x, from, to, interval.curves);
      if (look != Look::kHidden) return look;
      const auto here = QuadraticRoot<N>::rational(y_);
      interval.low = bottom;
      interval.high = top;
      for (const int id : interval.curves) {
        for (const Bound& bound : roots_at(id, x)) {
          const int order = compare(bound.root, here);
          if (order == 0) return Look::kDegenerate;
          Bound& nearest = order < 0 ? interval.low : interval.high;
          if (compare(bound.root, nearest.root) == -order) nearest = bound;
        }
      }
      gaps.push_back({from, interval.low});
      gaps.push_back({interval.high, to});
      found.push_back(std::move(interval));
    }
    // Few intervals that still cover, in order.
    const Bound* reached = &bottom;
    while (compare(reached->root, top.root) < 0) {
      const Interval* next = nullptr;
      for (const Interval& interval : found) {
        if (compare(interval.low.root, reached->root) <= 0 &&
            (next == nullptr || compare(interval.high.root, next->high.root) > 0)) {
          next = &interval;
        }
      }
      if (next == nullptr || compare(next->high.root, reached->root) <= 0) {
        throw Undecided("gap in a covering");
      }
      cover.intervals.push_back(*next);
      reached = &next->high;
    }
    return Look::kHidden;
  }

  Look look_between(const N& x, const Bound& from, const Bound& to, std::vector<int>& curves) {
    const auto order = [](const QuadraticRoot<N>& root, const N& y) {
      return compare(root, QuadraticRoot<N>::rational(y));
    };
    QuadraticRoot<N> low = from.root, high = to.root;
    for (int attempt = 0; attempt < 5; ++attempt) {
      const N y = between(low, high, low_y_, high_y_, order);
      const Look look = look_from(x, y);
      if (look == Look::kHidden) curves = proof_;
      if (look != Look::kDegenerate) return look;
      high = QuadraticRoot<N>::rational(y);
    }
    return Look::kDegenerate;
  }

  // ---- along x

  enum class Event { kItself, kLeading, kDiscriminant, kResultant };
  using EventKey = std::tuple<Event, int, int>;

  /// The zeros in R's range of x.
  std::vector<RealRoot<N>>& zeros(const EventKey& key) {
    const auto [place, is_new] = zeros_.try_emplace(key);
    if (is_new) {
      const auto [event, i, j] = key;
      const Conic<N>& f = curves_[i].f;
      Univariate<N> polynomial;
      switch (event) {
        case Event::kItself:
          polynomial = f.by_y()[0];
          break;
        case Event::kLeading:
          polynomial = f.by_y()[curves_[i].has_yy ? 2 : 1];
          break;
        case Event::kDiscriminant:
          polynomial = discriminant(f);
          break;
        case Event::kResultant:
          polynomial = resultant(f, curves_[j].f);
          break;
      }
      if (polynomial.empty()) throw Undecided("identically zero");
      Numbers<N>::reduce(polynomial);
      isolate(std::make_shared<const Univariate<N>>(std::move(polynomial)), false, low_x_, high_x_,
              0, place->second);
    }
    return place->second;
  }

  void add_resultant(std::vector<EventKey>& events, int i, int j) const {
    if (i != j) events.push_back({Event::kResultant, std::min(i, j), std::max(i, j)});
  }

  void add_bound(std::vector<EventKey>& events, const Bound& bound) const {
    events.push_back({Event::kLeading, bound.curve, 0});
    if (curves_[bound.curve].has_yy) events.push_back({Event::kDiscriminant, bound.curve, 0});
  }

  std::vector<EventKey> events_of(const Cover& cover) const {
    std::vector<EventKey> events;
    add_bound(events, cover.bottom);
    add_bound(events, cover.top);
    const Bound* reached = &cover.bottom;
    for (const Interval& interval : cover.intervals) {
      if (!reached->same_branch(interval.low)) {
        add_resultant(events, reached->curve, interval.low.curve);
      }
      reached = &interval.high;
      add_bound(events, interval.low);
      add_bound(events, interval.high);
      add_resultant(events, interval.low.curve, interval.high.curve);
      for (const int id : interval.curves) {
        if (!curves_[id].has_y) {
          events.push_back({Event::kItself, id, 0});
          continue;
        }
        if (id == interval.low.curve || id == interval.high.curve) continue;
        if (curves_[id].has_yy) events.push_back({Event::kDiscriminant, id, 0});
        add_resultant(events, id, interval.low.curve);
        add_resultant(events, id, interval.high.curve);
      }
    }
    if (!reached->same_branch(cover.top)) {
      add_resultant(events, reached->curve, cover.top.curve);
    }
    make_set(events);
    return events;
  }

  /// Looks along one line between the two; appends what is left of the gap.
  bool sees_between(RealRoot<N>& low, RealRoot<N>& high,
                    std::vector<std::pair<RealRoot<N>, RealRoot<N>>>& gaps) {
    const auto order = [](RealRoot<N>& root, const N& x) { return compare(root, x); };
    RealRoot<N> limit = high;
    for (int attempt = 0; attempt < 50; ++attempt) {
      const N x = between(low, limit, low_x_, high_x_, order);
      limit = RealRoot<N>::rational(x);
      ++lines;
      Cover cover;
      const Look look = cover_line(x, cover);
      if (look == Look::kSeen) return true;
      if (look == Look::kDegenerate) continue;
      RealRoot<N> below = low, above = high;
      if (!holds_around(x, events_of(cover), below, above)) continue;
      gaps.push_back({low, below});
      gaps.push_back({above, high});
      return false;
    }
    throw Undecided("no line in general position");
  }

  /// Moves the two to the next zeros below and above x, if between; false if x is a zero.
  bool holds_around(const N& x, const std::vector<EventKey>& events, RealRoot<N>& below,
                    RealRoot<N>& above) {
    for (const EventKey& key : events) {
      for (RealRoot<N>& root : zeros(key)) {
        const int order = compare(root, x);
        if (order == 0) return false;
        RealRoot<N>& nearest = order < 0 ? below : above;
        if (compare(root, nearest) == -order) nearest = root;
      }
    }
    return true;
  }

  Plane<N> plane_r_, plane_e_;
  std::vector<std::array<N, 2>> region_;  ///< counter-clockwise
  N low_x_, high_x_, low_y_, high_y_;
  Affine<N> height_;  ///< of p over plane(E), > 0, times a constant
  std::vector<int> floor_, ceiling_;
  std::vector<Line> lines_;
  Cell element_;
  std::vector<Blocker> blockers_;

  std::vector<Curve> curves_;
  std::map<std::array<N, 6>, int> curve_ids_;
  std::map<std::pair<int, int>, Conic<N>> two_lines_;
  std::map<std::tuple<int, int, int>, Conic<N>> three_lines_;
  std::map<std::tuple<int, int, int>, ProofCurves> curves_of_proof_;
  std::map<EventKey, std::vector<RealRoot<N>>> zeros_;

  N x_, y_;
  double dx_ = 0, dy_ = 0;
  std::vector<int> blocker_signs_;
  std::vector<Approximate> approximate_;
  std::vector<int> proof_, zero_free_;
};

struct Effort {
  std::size_t points = 0, lines = 0;
};

/// The decision in numbers of type N. Throws Undecided; if N is exact, only after 100,000 points.
template <class N>
bool sees(const SightQuery& query, Effort* effort = nullptr) {
  const Corners<N> region = corners_of<N>(query.region), element = corners_of<N>(query.element);
  std::vector<Corners<N>> occluders;
  for (const ConvexPolygon& polygon : query.occluders) occluders.push_back(corners_of<N>(polygon));
  if (occluders.size() > 30) throw std::invalid_argument("more than 30 occluders");
  const Plane<N> plane_r(region), plane_e(element);
  for (const int side_e : {1, -1}) {
    const Corners<N> from = part_above(region, plane_e, side_e);
    if (!has_area(from) || std::ranges::all_of(from, [&](const Vector<N>& v) {
          return sign_of(plane_e.height(v)) == 0;
        })) {
      continue;
    }
    for (const int side_r : {1, -1}) {
      if (std::ranges::none_of(element, [&](const Vector<N>& v) {
            return sign_of(plane_r.height(v)) * side_r > 0;
          })) {
        continue;
      }
      Sweep<N> sweep(plane_r, from, plane_e, element, occluders, side_r, side_e);
      const bool result = sweep.sees();
      if (effort != nullptr) {
        effort->points += sweep.points;
        effort->lines += sweep.lines;
      }
      if (result) return true;
    }
  }
  return false;
}

}  // namespace second_opinion

/// Decides exactly whether the element is visible from the region, whatever one_sided says.
/// REQUIRES: at most 30 occluders, polygons that are convex, planar and have an area.
/// Cost: 1 ms or so for up to six occluders on a small integer grid; grows fast with both.
inline bool sees_by_second_opinion(const SightQuery& query) {
  return second_opinion::sees<second_opinion::Fraction>(query);
}

/// The same in double: an answer without any guarantee. Throws second_opinion::Undecided.
inline bool sees_by_second_opinion_in_double(const SightQuery& query) {
  return second_opinion::sees<double>(query);
}

}  // namespace viewcover::testing
