#pragma once

#include <array>
#include <optional>

#include "exact/cell.h"

namespace viewcover::exact {

/// A line as (d, m): direction and moment x cross d of any point x on it. Vectors with d . m != 0
/// are no real lines.
using LineVector = LazyVector<6>;
using LinePool = VectorPool<6>;
using LineCell = Cell<6>;

/// Half the Klein form is d . m; real lines are its zeros.
inline double klein_form(const std::array<double, 6>& x) {
  return 2 * (x[0] * x[3] + x[1] * x[4] + x[2] * x[5]);
}

/// Two vectors of a cell on which the Klein form has opposite strict signs, rounded.
struct RealLineBracket {
  std::array<double, 6> positive, negative;
};

/// Does the cell's interior hold a real line? Exact: it does iff the Klein form takes both strict
/// signs on the cell (papers/exact.md, section 3). None if it does not.
///
/// Looks at single rays and pairs in floating point with proven bounds first; then exactly, at
/// subsets of up to four rays, which is enough for a form of signature (3, 3).
std::optional<RealLineBracket> find_real_lines(LinePool& pool, const LineCell& cell);

/// Does the Klein form take the given strict sign on the cone of the cell's rays? Exact. The cell
/// may be a face: rays, and what they are tight at, of a cell.
bool takes_sign(LinePool& pool, const LineCell& cell, int sign);

}  // namespace viewcover::exact
