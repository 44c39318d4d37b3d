#pragma once

#include <cstdint>

namespace viewcover {

/// How the signs of exact decisions were found, and how much work there was.
struct ExactStatistics {
  std::uint64_t single_signs = 0;       ///< decided in single precision, with a proven error bound
  std::uint64_t filtered_signs = 0;     ///< decided in double, with the same bound
  std::uint64_t fixed_width_signs = 0;  ///< decided in 128-bit integers
  std::uint64_t quad_signs = 0;         ///< decided in binary128, with the same bound
  std::uint64_t big_integer_signs = 0;  ///< decided in integers of any size
  std::uint64_t cells = 0;              ///< cells looked at, root cells included
  std::uint64_t splits = 0;             ///< cells cut in two

  ExactStatistics& operator+=(const ExactStatistics& other) {
    single_signs += other.single_signs;
    filtered_signs += other.filtered_signs;
    fixed_width_signs += other.fixed_width_signs;
    quad_signs += other.quad_signs;
    big_integer_signs += other.big_integer_signs;
    cells += other.cells;
    splits += other.splits;
    return *this;
  }
};

}  // namespace viewcover
