#pragma once

#include <CGAL/Gmpq.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "exact/integers.h"
#include "scene/convex_polygon.h"

namespace viewcover::exact {

template <class Number>
struct HomogeneousPoint;

/// Turns doubles into integers: multiples of one power of two, relative to an origin. Exact.
///
/// Number is CheckedWide, where coordinates span few enough bits, or BigInteger.
class IntegerFrame {
 public:
  void include(std::span<const Point> points) {
    for (const Point& point : points) {
      for (int i = 0; i < 3; ++i) include(point[i]);
    }
    scale_ = std::ldexp(1.0, -std::clamp(lowest_, -1000, 1000));
  }
  void set_origin(const Point& origin) { origin_ = origin; }

  /// A coordinate along an axis, from integers back to scene units.
  CGAL::Gmpq absolute(const CGAL::Gmpq& x, std::size_t axis) const {
    const CGAL::Gmpq step = lowest_ >= 0 ? CGAL::Gmpq(power_of_two(lowest_), BigInteger(1))
                                         : CGAL::Gmpq(BigInteger(1), power_of_two(-lowest_));
    return x * step + CGAL::Gmpq(origin_[static_cast<Eigen::Index>(axis)]);
  }

  /// A point in units of 2^bits(), rounded.
  template <class Number>
  Point unit_point(const HomogeneousPoint<Number>& p) const {
    const double unit = std::ldexp(to_double(p.w), bits());
    return {to_double(p.x[0]) / unit, to_double(p.x[1]) / unit, to_double(p.x[2]) / unit};
  }

  /// Integers have at most so many bits, one more relative to an origin.
  int bits() const { return std::max(highest_ - lowest_, 0); }
  /// The origin, and the power of two that all coordinates relative to it are below twice of.
  const Point& origin() const { return origin_; }
  int unit_exponent() const { return lowest_ + bits(); }

  /// Can CheckedWide hold the coordinates, with room for products?
  bool is_narrow() const { return bits() <= kNarrowBits; }

  template <class Number>
  std::array<Number, 3> operator()(const Point& point) const {
    std::array<Number, 3> result;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      result[i] = integer<Number>(point[k]) - integer<Number>(origin_[k]);
    }
    return result;
  }

 private:
  static constexpr int kNarrowBits = 60;

  static BigInteger power_of_two(int exponent) {
    BigInteger result;
    mpz_setbit(result.mpz(), static_cast<mp_bitcnt_t>(exponent));
    return result;
  }

  void include(double x) {
    if (x == 0) return;
    constexpr int kMantissaBits = 52, kBias = 1075;  // 2^(e - 1075) is the last bit's weight
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto biased = static_cast<int>(bits >> kMantissaBits & 0x7ff);
    std::uint64_t mantissa = bits & ((std::uint64_t{1} << kMantissaBits) - 1);
    if (biased != 0) mantissa |= std::uint64_t{1} << kMantissaBits;
    const int last = std::max(biased, 1) - kBias;
    highest_ = std::max(highest_, last + static_cast<int>(std::bit_width(mantissa)));
    lowest_ = std::min(lowest_, last + std::countr_zero(mantissa));
  }

  template <class Number>
  Number integer(double x) const {
    if constexpr (std::is_same_v<Number, BigInteger>) {
      if (x == 0) return BigInteger(0);
      int exponent = 0;
      const double fraction = std::frexp(x, &exponent);
      const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
      const int shift = exponent - 53 - lowest_;
      BigInteger result = to_big(mantissa);
      if (shift >= 0) {
        mpz_mul_2exp(result.mpz(), to_big(mantissa).mpz(), static_cast<mp_bitcnt_t>(shift));
      } else {
        mpz_tdiv_q_2exp(result.mpz(), to_big(mantissa).mpz(), static_cast<mp_bitcnt_t>(-shift));
      }
      return result;
    } else {
      // A product is exact, and faster where the factor is a normal number.
      return static_cast<std::int64_t>(lowest_ > -1000 && lowest_ < 1000 ? x * scale_
                                                                         : std::ldexp(x, -lowest_));
    }
  }

  int lowest_ = 2000, highest_ = -2000;
  double scale_ = 1;  // 2^-lowest_
  Point origin_ = Point::Zero();
};

template <class Number>
using Vector3 = std::array<Number, 3>;

template <class Number>
Vector3<Number> operator-(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
template <class Number>
Vector3<Number> operator-(const Vector3<Number>& a) {
  return {-a[0], -a[1], -a[2]};
}
template <class Number>
Vector3<Number> operator*(const Number& s, const Vector3<Number>& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
template <class Number>
Vector3<Number> cross(const Vector3<Number>& a, const Vector3<Number>& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
template <class Number>
Number dot(const Vector3<Number>& a, const Vector3<Number>& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline CheckedWide quotient(CheckedWide a, CheckedWide b) { return CheckedWide::divided(a, b); }
inline BigInteger quotient(const BigInteger& a, const BigInteger& b) {
  BigInteger result;
  mpz_divexact(result.mpz(), a.mpz(), b.mpz());
  return result;
}

/// Divides by the greatest common divisor of all.
template <class Number, std::size_t N>
void make_primitive(std::array<Number, N>& x) {
  Number common(0);
  for (const Number& value : x) {
    common = gcd(common, value);
    if (common == Number(1)) return;
  }
  if (sign(common) == 0) return;
  for (Number& value : x) value = quotient(value, common);
}

/// A point (x, y, z) / w, w > 0.
template <class Number>
struct HomogeneousPoint {
  Vector3<Number> x;
  Number w = Number(1);
};

/// normal . x = offset; in front where normal . x > offset.
template <class Number>
struct IntegerPlane {
  Vector3<Number> normal;
  Number offset = Number(0);

  IntegerPlane() = default;
  /// The plane of a strictly convex polygon, in front where its corners run counter-clockwise.
  explicit IntegerPlane(std::span<const HomogeneousPoint<Number>> polygon) {
    normal = cross(polygon[1].x - polygon[0].x, polygon[2].x - polygon[0].x);
    offset = dot(normal, polygon[0].x);
    std::array<Number, 4> all = {normal[0], normal[1], normal[2], offset};
    make_primitive(all);
    normal = {all[0], all[1], all[2]};
    offset = all[3];
  }
  /// A positive multiple of the distance, with sign.
  Number value(const HomogeneousPoint<Number>& p) const { return dot(normal, p.x) - offset * p.w; }
  int side(const HomogeneousPoint<Number>& p) const { return sign(value(p)); }
  void reverse() {
    normal = -normal;
    offset = -offset;
  }
};

/// Which sides of a plane the corners of a polygon lie on.
struct Sides {
  bool front = false, back = false;

  template <class Number>
  static Sides of(const IntegerPlane<Number>& plane,
                  std::span<const HomogeneousPoint<Number>> polygon) {
    Sides sides;
    for (const HomogeneousPoint<Number>& corner : polygon) {
      const int side = plane.side(corner);
      sides.front |= side > 0;
      sides.back |= side < 0;
    }
    return sides;
  }
};

/// The part of a convex polygon on the front (keep = 1) or back (-1) of a plane, closed. Requires
/// corners strictly on that side.
template <class Number>
std::vector<HomogeneousPoint<Number>> cut_polygon(std::span<const HomogeneousPoint<Number>> polygon,
                                                  const IntegerPlane<Number>& plane, int keep) {
  std::vector<HomogeneousPoint<Number>> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const HomogeneousPoint<Number>& a = polygon[i];
    const HomogeneousPoint<Number>& b = polygon[(i + 1) % polygon.size()];
    Number at_a = plane.value(a), at_b = plane.value(b);
    if (keep < 0) {
      at_a = -at_a;
      at_b = -at_b;
    }
    if (sign(at_a) >= 0) result.push_back(a);
    if (sign(at_a) * sign(at_b) >= 0) continue;
    // (at_a b - at_b a), times the sign of at_a: weights stay positive.
    if (sign(at_a) < 0) {
      at_a = -at_a;
      at_b = -at_b;
    }
    std::array<Number, 4> point;
    for (std::size_t k = 0; k < 3; ++k) point[k] = at_a * b.x[k] - at_b * a.x[k];
    point[3] = at_a * b.w - at_b * a.w;
    make_primitive(point);
    result.push_back({{point[0], point[1], point[2]}, point[3]});
  }
  return result;
}

}  // namespace viewcover::exact
