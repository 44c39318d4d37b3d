#pragma once

#include <CGAL/Gmpq.h>

#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "exact/integers.h"

namespace viewcover::flat {

// Exact convex polygons in the plane of an element, seen along one axis: coordinates (u, v). Lines
// and points are integer vectors. A corner is where two lines meet that were given, never derived
// from corners, so its integers stay small however often the polygon is cut. Doubles with an error
// bound decide most signs.

using exact::BigInteger;
using exact::sign;
using Rational = CGAL::Gmpq;

/// a b - c d.
inline BigInteger minor(const BigInteger& a, const BigInteger& b, const BigInteger& c,
                        const BigInteger& d) {
  BigInteger result;
  mpz_mul(result.mpz(), a.mpz(), b.mpz());
  mpz_submul(result.mpz(), c.mpz(), d.mpz());
  return result;
}

/// x / w, w > 0; relative error less than 3 2^-52.
double quotient(const BigInteger& x, const BigInteger& w);

/// The point (u / w, v / w), w > 0; the three may have a common divisor.
struct FlatPoint {
  BigInteger u, v, w;
  double near_u = 0, near_v = 0;  ///< of the quotients; relative errors less than 3 2^-52

  FlatPoint(BigInteger u, BigInteger v, BigInteger w);
};

/// a u + b v + c = 0; positive to the left of its direction (b, -a). The three may have a common
/// divisor.
struct FlatLine {
  BigInteger a, b, c;
  double near_a = 0, near_b = 0, near_c = 0;  ///< times one power of two; relative errors 2^-52

  /// Requires a or b not 0.
  FlatLine(BigInteger a, BigInteger b, BigInteger c);
  /// From p to q, which differ.
  FlatLine(const FlatPoint& p, const FlatPoint& q);
  FlatLine reversed() const;
  /// 1 to the left, -1 to the right, 0 on the line; exact.
  int side(const FlatPoint& point) const;
  /// Requires lines that are not parallel.
  FlatPoint meet(const FlatLine& other) const;
};

/// A box of near coordinates. Not Eigen's, whose moves may throw: vectors would copy polygons.
struct Extent {
  double low_u = std::numeric_limits<double>::infinity(), low_v = low_u;
  double high_u = -low_u, high_v = -low_u;

  void extend(const FlatPoint& point);
  /// Certainly; false proves nothing.
  bool is_apart_from(const Extent& other) const;
};

/// A convex polygon, counter-clockwise, with the lines of its edges: line i from corner i to the
/// next. Corners within edges are allowed.
class FlatPolygon {
 public:
  /// Corners in either order; they must not lie on one line.
  explicit FlatPolygon(std::vector<FlatPoint> corners);

  std::span<const FlatPoint> corners() const { return corners_; }
  std::span<const FlatLine> lines() const { return lines_; }

  /// Are the interiors disjoint?
  bool is_apart_from(const FlatPolygon& other) const;
  /// Do all corners lie to the right of the line, or on it?
  bool is_right_of(const FlatLine& line) const;
  /// Without corners, after a cut that left nothing.
  bool is_empty() const { return corners_.empty(); }
  /// Cuts along the line: the part to its left stays, the part to its right is returned. Where no
  /// corner lies strictly to the right nothing is returned, and where none lies strictly to the
  /// left nothing stays.
  std::optional<FlatPolygon> cut(const FlatLine& line);

 private:
  FlatPolygon() = default;
  void set_extent();

  std::vector<FlatPoint> corners_;
  std::vector<FlatLine> lines_;
  Extent extent_;
};

// Else vectors of pieces would copy them when they grow.
static_assert(std::is_nothrow_move_constructible_v<FlatPolygon>);

/// Twice the area of a union of polygons with disjoint interiors, exact. Edges are summed line by
/// line, where the ends that two of them share cancel: the sum has only the terms of the union's
/// own corners.
Rational twice_area(std::span<const FlatPolygon* const> polygons);
Rational twice_area(const FlatPolygon& polygon);

}  // namespace viewcover::flat
