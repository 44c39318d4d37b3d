#include "audit/flat_polygon.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "exact/integer_geometry.h"

namespace viewcover::flat {
namespace {

/// x / 2^exponent; relative error at most 2^-52, as it is cut off.
double scaled_double(const BigInteger& x, long exponent) {
  long own = 0;
  const double mantissa = mpz_get_d_2exp(&own, x.mpz());
  return std::ldexp(mantissa, static_cast<int>(std::clamp(own - exponent, -4000L, 4000L)));
}

long exponent_of(const BigInteger& x) {
  return sign(x) == 0 ? 0 : static_cast<long>(mpz_sizeinbase(x.mpz(), 2));
}

}  // namespace

double quotient(const BigInteger& x, const BigInteger& w) {
  // Two numbers cut off and a rounded quotient: (1 + 2^-52) / (1 - 2^-52) (1 + 2^-53).
  const long exponent = exponent_of(w);
  return scaled_double(x, exponent) / scaled_double(w, exponent);
}

FlatPoint::FlatPoint(BigInteger first, BigInteger second, BigInteger weight)
    : u(std::move(first)), v(std::move(second)), w(std::move(weight)) {
  if (sign(w) < 0) {
    u = -u;
    v = -v;
    w = -w;
  }
  near_u = quotient(u, w);
  near_v = quotient(v, w);
}

FlatLine::FlatLine(BigInteger first, BigInteger second, BigInteger third)
    : a(std::move(first)), b(std::move(second)), c(std::move(third)) {
  const long exponent = std::max(exponent_of(a), exponent_of(b));
  near_a = scaled_double(a, exponent);
  near_b = scaled_double(b, exponent);
  near_c = scaled_double(c, exponent);
}

FlatLine::FlatLine(const FlatPoint& p, const FlatPoint& q)
    : FlatLine(minor(p.v, q.w, q.v, p.w), minor(q.u, p.w, p.u, q.w), minor(p.u, q.v, q.u, p.v)) {}

FlatLine FlatLine::reversed() const {
  FlatLine line = *this;
  for (BigInteger* x : {&line.a, &line.b, &line.c}) *x = -*x;
  for (double* x : {&line.near_a, &line.near_b, &line.near_c}) *x = -*x;
  return line;
}

int FlatLine::side(const FlatPoint& point) const {
  // Each product is off by less than 4 2^-52 for its factors and 2^-53 for rounding, the sums by
  // 2^-53 twice: in all less than 6 2^-52 of the sum of magnitudes, which is rounded itself. Where
  // products may have underflowed nothing is sure.
  constexpr double kBound = 0x1p-49, kLeast = 0x1p-900;
  const double by_u = near_a * point.near_u, by_v = near_b * point.near_v;
  const double value = by_u + by_v + near_c;
  const double unsure = kBound * (std::fabs(by_u) + std::fabs(by_v) + std::fabs(near_c)) + kLeast;
  if (value > unsure) return 1;
  if (value < -unsure) return -1;
  BigInteger exact_value = a * point.u;
  mpz_addmul(exact_value.mpz(), b.mpz(), point.v.mpz());
  mpz_addmul(exact_value.mpz(), c.mpz(), point.w.mpz());
  return sign(exact_value);
}

FlatPoint FlatLine::meet(const FlatLine& other) const {
  return {minor(b, other.c, other.b, c), minor(c, other.a, other.c, a),
          minor(a, other.b, other.a, b)};
}

void Extent::extend(const FlatPoint& point) {
  low_u = std::min(low_u, point.near_u);
  high_u = std::max(high_u, point.near_u);
  low_v = std::min(low_v, point.near_v);
  high_v = std::max(high_v, point.near_v);
}

bool Extent::is_apart_from(const Extent& other) const {
  // Each number is off by less than 3 2^-52 of itself.
  const auto is_less = [](double high, double low) {
    return low - high > 0x1p-49 * (std::fabs(low) + std::fabs(high));
  };
  return is_less(high_u, other.low_u) || is_less(other.high_u, low_u) ||
         is_less(high_v, other.low_v) || is_less(other.high_v, low_v);
}

FlatPolygon::FlatPolygon(std::vector<FlatPoint> corners) : corners_(std::move(corners)) {
  // The turn at the first corner that is one.
  const std::size_t n = corners_.size();
  int turn = 0;
  for (std::size_t i = 0; i < n && turn == 0; ++i) {
    turn = FlatLine(corners_[i], corners_[(i + 1) % n]).side(corners_[(i + 2) % n]);
  }
  if (turn < 0) std::ranges::reverse(corners_);
  lines_.reserve(n);
  for (std::size_t i = 0; i < n; ++i) lines_.emplace_back(corners_[i], corners_[(i + 1) % n]);
  set_extent();
}

void FlatPolygon::set_extent() {
  for (const FlatPoint& corner : corners_) extent_.extend(corner);
}

bool FlatPolygon::is_right_of(const FlatLine& line) const {
  return std::ranges::all_of(corners_,
                             [&](const FlatPoint& corner) { return line.side(corner) <= 0; });
}

bool FlatPolygon::is_apart_from(const FlatPolygon& other) const {
  if (extent_.is_apart_from(other.extent_)) return true;
  const auto has_outside = [](const FlatPolygon& p, const FlatPolygon& q) {
    return std::ranges::any_of(p.lines_, [&](const FlatLine& line) { return q.is_right_of(line); });
  };
  return has_outside(*this, other) || has_outside(other, *this);
}

std::optional<FlatPolygon> FlatPolygon::cut(const FlatLine& line) {
  const std::size_t n = corners_.size();
  std::vector<int> sides;
  for (const FlatPoint& corner : corners_) sides.push_back(line.side(corner));
  if (std::ranges::none_of(sides, [](int side) { return side < 0; })) return std::nullopt;
  FlatPolygon left, right;
  if (std::ranges::none_of(sides, [](int side) { return side > 0; })) {
    std::swap(*this, right);
    return right;
  }
  for (FlatPolygon* part : {&left, &right}) {
    part->corners_.reserve(n + 2);
    part->lines_.reserve(n + 2);
  }
  const auto add = [](FlatPolygon& part, const FlatPoint& corner, const FlatLine& onward) {
    part.corners_.push_back(corner);
    part.lines_.push_back(onward);
  };
  const FlatLine back = line.reversed();
  for (std::size_t i = 0; i < n; ++i) {
    const int here = sides[i], next = sides[(i + 1) % n];
    // From a corner on the line, the part that the polygon leaves goes back along it.
    if (here >= 0) add(left, corners_[i], here == 0 && next < 0 ? line : lines_[i]);
    if (here <= 0) add(right, corners_[i], here == 0 && next > 0 ? back : lines_[i]);
    if (here * next < 0) {
      const FlatPoint crossing = lines_[i].meet(line);
      add(left, crossing, next < 0 ? line : lines_[i]);
      add(right, crossing, next > 0 ? back : lines_[i]);
    }
  }
  left.set_extent();
  right.set_extent();
  *this = std::move(left);
  return right;
}

namespace {

/// A line without its direction and common divisor.
using LineKey = std::array<BigInteger, 3>;

LineKey key_of(const FlatLine& line) {
  LineKey key = {line.a, line.b, line.c};
  exact::make_primitive(key);
  if (sign(key[1]) < 0 || (sign(key[1]) == 0 && sign(key[0]) < 0)) {
    for (BigInteger& x : key) x = -x;
  }
  return key;
}

/// The ends of edges on one line, by their coordinate along it: how many more edges end than start
/// there.
using Ends = std::map<Rational, int>;

/// Terms of many denominators, pairwise, so that most sums are of short numbers.
Rational sum_of(std::span<const Rational> terms) {
  if (terms.empty()) return 0;
  if (terms.size() == 1) return terms[0];
  const std::size_t half = terms.size() / 2;
  return sum_of(terms.first(half)) + sum_of(terms.subspan(half));
}

}  // namespace

Rational twice_area(std::span<const FlatPolygon* const> polygons) {
  std::map<LineKey, Ends> lines;
  for (const FlatPolygon* polygon : polygons) {
    const auto corners = polygon->corners();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const FlatLine& line = polygon->lines()[i];
      const bool by_u = sign(line.b) != 0;
      Ends& ends = lines[key_of(line)];
      const auto end = [&](const FlatPoint& p) -> int& { return ends[{by_u ? p.u : p.v, p.w}]; };
      --end(corners[i]);
      ++end(corners[(i + 1) % corners.size()]);
    }
  }
  // On a u + b v + c = 0 the term u_i v_j - u_j v_i of an edge is (u_j - u_i) c / b, or with b = 0
  // (v_j - v_i) (-c / a).
  std::vector<Rational> terms;
  for (const auto& [line, ends] : lines) {
    Rational along = 0;
    for (const auto& [coordinate, times] : ends) {
      if (times != 0) along += times * coordinate;
    }
    if (along == 0) continue;
    terms.push_back(
        along * (sign(line[1]) != 0 ? Rational(line[2], line[1]) : Rational(-line[2], line[0])));
  }
  return sum_of(terms);
}

Rational twice_area(const FlatPolygon& polygon) {
  const std::array<const FlatPolygon*, 1> one = {&polygon};
  return twice_area(one);
}

}  // namespace viewcover::flat
