#pragma once

#include <cstdint>
#include <vector>

#include "optim/region_cover.h"

namespace viewcover {

using Score = std::int64_t;

/// The weights of an instance in units of 2^-40 of their sum, rounded, at least one unit each:
/// sums do not depend on their order, and weights may grow a million times.
struct IntegerWeights {
  std::vector<Score> columns;
  std::vector<Score> heaviest_rows;  ///< weights of whole rows, descending
  Score total = 0;

  explicit IntegerWeights(const CoverInstance& instance);
  /// No k rows cover more.
  Score upper_bound(std::size_t k) const;
};

}  // namespace viewcover
