#include "small_instances.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <random>

namespace viewcover::testing {

SmallInstance small_instance(std::uint64_t seed, std::size_t most_rows, std::size_t most_columns) {
  std::mt19937_64 random(seed);
  const std::size_t rows = random() % (most_rows + 1), columns = random() % (most_columns + 1);
  const std::uint64_t sparsity = 2 + random() % 6;
  SmallInstance instance{BitRows(rows, columns), {}};
  for (std::size_t c = 0; c < columns; ++c) {
    instance.weights.push_back(static_cast<double>(random() % 50) / 8);
    const std::uint64_t kind = random() % 10;
    for (std::size_t r = 0; r < rows && kind != 0; ++r) {
      const bool same = kind == 1 && c > 0;
      if (same ? instance.matrix.test(r, c - 1) : random() % sparsity == 0) {
        instance.matrix.set(r, c);
      }
    }
  }
  return instance;
}

BitRows affine_space(int dimension) {
  std::size_t points = 1;
  for (int i = 0; i < dimension; ++i) points *= 3;
  std::vector<std::array<std::size_t, 3>> lines;
  for (std::size_t a = 0; a < points; ++a) {
    for (std::size_t b = a + 1; b < points; ++b) {
      std::size_t c = 0;  // the third point of the line: digits of a line's points sum up to 0
      for (std::size_t digit = 1; digit < points; digit *= 3) {
        c += (6 - a / digit % 3 - b / digit % 3) % 3 * digit;
      }
      if (c > b) lines.push_back({a, b, c});
    }
  }
  BitRows matrix(points, lines.size());
  for (std::size_t line = 0; line < lines.size(); ++line) {
    for (const std::size_t point : lines[line]) matrix.set(point, line);
  }
  return matrix;
}

BitRows shuffled(const BitRows& matrix, std::size_t copies, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::size_t> rows(matrix.rows()), columns(copies * matrix.columns());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  std::iota(columns.begin(), columns.end(), std::size_t{0});
  std::ranges::shuffle(rows, random);
  std::ranges::shuffle(columns, random);
  BitRows result(rows.size(), columns.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (matrix.test(rows[r], columns[c] % matrix.columns())) result.set(r, c);
    }
  }
  return result;
}

}  // namespace viewcover::testing
