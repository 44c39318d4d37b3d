#include "optim/integer_weights.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace viewcover {

IntegerWeights::IntegerWeights(const CoverInstance& instance) {
  constexpr int kTotalBits = 40;
  for (const double weight : instance.weights()) {
    // A total of 0 leaves one unit a column: the number of columns counts.
    const double share = instance.total_weight() > 0 ? weight / instance.total_weight() : 0;
    columns.push_back(std::max<Score>(1, std::llround(std::ldexp(share, kTotalBits))));
  }
  total = std::accumulate(columns.begin(), columns.end(), Score{0});
  for (std::size_t row = 0; row < instance.rows().rows(); ++row) {
    Score weight = 0;
    for_each_bit(instance.rows().row(row), [&](std::size_t column) { weight += columns[column]; });
    heaviest_rows.push_back(weight);
  }
  std::ranges::sort(heaviest_rows, std::greater<>());
}

Score IntegerWeights::upper_bound(std::size_t k) const {
  const auto end =
      heaviest_rows.begin() + static_cast<std::ptrdiff_t>(std::min(k, heaviest_rows.size()));
  return std::min(total, std::accumulate(heaviest_rows.begin(), end, Score{0}));
}

}  // namespace viewcover
