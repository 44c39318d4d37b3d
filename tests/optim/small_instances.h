#pragma once

#include <cstdint>
#include <vector>

#include "links/bit_rows.h"

namespace viewcover::testing {

struct SmallInstance {
  BitRows matrix;
  std::vector<double> weights;  ///< one a column; some are 0
};

/// Up to `most_rows` rows and `most_columns` columns of random density; some rows and columns are
/// empty, some are equal to others. Same seed, same instance.
SmallInstance small_instance(std::uint64_t seed, std::size_t most_rows, std::size_t most_columns);

/// Rows are the points of the affine space AG(n, 3), columns its lines.
BitRows affine_space(int dimension);

/// The matrix with rows and columns in random order and every column `copies` times.
BitRows shuffled(const BitRows& matrix, std::size_t copies, std::uint64_t seed);

}  // namespace viewcover::testing
