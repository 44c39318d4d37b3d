#pragma once

#include <cmath>

#include "scene/types.h"

namespace viewcover {

/// The power-of-two lattice that all coordinates are rounded to at load.
///
/// Coordinates are multiples of 2^-exponent; with the default choice they fit 24 bits, sign
/// included, so that midpoints of midpoints stay exact in double for kMaxSubdivisionLevel levels
/// (scene/address.h) and everything downstream may take doubles as exact numbers.
struct Lattice {
  int exponent = 0;

  double step() const { return std::ldexp(1.0, -exponent); }

  /// Nearest lattice point, ties to even. Exact where |x| < 2^(52 - exponent).
  Point round(const Point& p) const { return {round(p.x()), round(p.y()), round(p.z())}; }
  double round(double x) const {
    return std::ldexp(std::nearbyint(std::ldexp(x, exponent)), -exponent);
  }

  /// The finest lattice on which every coordinate of magnitude up to `largest_magnitude` fits
  /// 23 bits and a sign. `largest_magnitude` is finite and not negative; 0 gives exponent 0.
  static Lattice for_extent(double largest_magnitude) {
    if (largest_magnitude == 0) return {};
    int bits = 0;
    std::frexp(largest_magnitude, &bits);  // magnitude < 2^bits
    return {23 - bits};
  }

  friend bool operator==(const Lattice&, const Lattice&) = default;
};

}  // namespace viewcover
