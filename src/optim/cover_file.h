#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "links/bit_rows.h"

namespace viewcover {

enum class CoverFormat {
  kMatrixMarket,  ///< coordinate pattern; rows are chosen, columns covered
  kScp,           ///< OR-Library: #rows #columns, costs of columns, the columns of each row
  kRail,          ///< OR-Library: #rows #columns, cost and rows of each column
  kHittingSet,    ///< PACE 2025: `p hs #elements #sets`, the elements of each set
};

/// Reads a set cover problem as a 0/1 matrix whose rows are chosen and whose columns are covered:
/// in OR-Library files those are columns and rows (costs are ignored), in hitting set files
/// elements and sets. Repeated entries count once.
///
/// Cost: O(file) time, #rows x #columns bits of memory, at most 2^36.
/// Errors: InputError with file and line for anything malformed: numbers that are none or out of
/// range, too few or too many of them, dimensions too large.
BitRows read_cover_file(const std::filesystem::path& file, CoverFormat format);

/// The same from the file's content; `file` names it in messages. `most_entries` bounds #rows x
/// #columns.
BitRows parse_cover(std::string content, const std::filesystem::path& file, CoverFormat format,
                    std::size_t most_entries = std::size_t{1} << 36);

/// By the first characters of the file. Errors: InputError if they do not tell: OR-Library's two
/// kinds look alike.
CoverFormat detect_cover_format(const std::filesystem::path& file);

/// One number >= 0 for each column, separated by white space.
/// Errors: InputError with file and line.
std::vector<double> read_weights(const std::filesystem::path& file, std::size_t columns);

}  // namespace viewcover
