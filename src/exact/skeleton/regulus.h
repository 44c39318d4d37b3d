#pragma once

#include <array>
#include <optional>
#include <vector>

#include "exact/skeleton/shaft_features.h"

namespace viewcover::exact {

/// A rational number strictly between two others in [0, 1].
CGAL::Gmpq between(const Surd& low, const Surd& high);

/// The lines that meet three pairwise skew lines, one for each point a + s (b - a) of the first:
/// quadratic in s, with integer coefficients.
class Regulus {
 public:
  Regulus(const LineArithmetic& arithmetic, const FeatureEdge& first, const FeatureEdge& second,
          const FeatureEdge& third);

  StabbingLine at(const LineArithmetic& arithmetic, const CGAL::Gmpq& s) const;

  /// Part of the regulus, between two values of s.
  class Interval {
   public:
    Interval(const Surd& low, const Surd& high);

   private:
    friend class Regulus;
    Surd low_, high_;
    double low_rounded_ = 0, high_rounded_ = 0, error_ = 0;
  };
  /// The sign that a functional has on all lines of a closed interval; 0 if unsure.
  int sign_on(const Interval& interval, const LineVector& functional) const;
  /// Is there certainly no line inside the interval on which the functional is 0, given that it is
  /// 0 at its low or high end?
  bool has_no_other_zero(const Interval& interval, const LineVector& functional, bool at_low) const;
  /// The lines inside the interval on which a functional is 0, unless it is on all.
  std::vector<StabbingLine> zeros(LineArithmetic& arithmetic, const Interval& interval,
                                  const LineVector& functional) const;

 private:
  /// A functional on the line of s, as a quadratic in s: rounded coefficients, each within `error`.
  struct Rounded {
    std::array<double, 3> c{};
    double error = 0;
  };
  Rounded rounded(const LineVector& functional) const;

  std::array<LineComponents, 3> coefficients_;
  std::array<std::array<double, 6>, 3> rounded_;
};

}  // namespace viewcover::exact
