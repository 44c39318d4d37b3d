#pragma once

#include <array>
#include <functional>
#include <unordered_map>
#include <vector>

#include "exact/skeleton/stabbing_line.h"

namespace viewcover::exact {

/// Cells whose interiors hold free lines and nothing else that is real; together, but for lines on
/// their boundaries, all free lines between one side of a region and one side of an element.
class FreeCells {
 public:
  FreeCells(LineArithmetic& arithmetic, const IntegerPlane<BigInteger>& from,
            const IntegerPlane<BigInteger>& to);

  void add(const LineCell& cell);
  bool empty() const { return entries_.empty(); }

  /// Is a line from region to element a limit of free lines? Exact.
  ///
  /// Let it lie in a cell, and let s be the Klein form's polar form with the line on the cell's
  /// rays. If s takes both strict signs, the form changes sign inside the cell near the line, which
  /// is a limit of zeros. If s >= 0, it is one iff the form is negative somewhere on the face of
  /// the rays with s = 0. For near the line a point of the cell is x + y, x from that face and near
  /// the line, y from the other rays, and the form there is q(x) + 2 b(x, y) + q(y): positive for
  /// all y != 0 near 0 if q >= 0 on the face. Otherwise it is negative near the line on the face
  /// and positive beside it.
  bool is_limit(const StabbingLine& line);

  using Filter = std::function<bool(const Approximation<6, double>&)>;
  using Visitor = std::function<void(StabbingLine)>;
  /// Calls `visit` for the real lines in which faces of dimension at most 2 meet the Klein quadric;
  /// for a face within it, its two ends. Leaves out what `may_matter` refuses when it sees it
  /// rounded.
  void visit_extremal(const Filter& may_matter, const Visitor& visit);

 private:
  struct Box {
    std::array<double, 4> low, high;
  };
  struct Entry {
    LineCell cell;
    std::vector<int> facet_signs;  // 0 where a place is free
    Box box;
  };

  bool is_limit_in(const StabbingLine& line, const Entry& entry);
  Box box_of(const Approximation<6, double>& x) const;
  const Approximation<6, double>& precise(const LineVector& ray);
  void visit_face(const LineVector& x, const LineVector& y, bool x_is_real,
                  const Filter& may_matter, const Visitor& visit);

  LineArithmetic& arithmetic_;
  // Two coordinates of the point in which a line meets either plane, as quotients of functionals.
  struct Quotient {
    const LineVector* numerator;
    const LineVector* denominator;
  };
  std::array<Quotient, 4> places_;
  std::vector<Entry> entries_;
  std::unordered_map<const LineVector*, Approximation<6, double>> precise_;
};

}  // namespace viewcover::exact
