#pragma once

#include <cstdint>
#include <vector>

#include "links/bit_rows.h"
#include "optim/incidence.h"

namespace viewcover {

/// One step of a reduction: what leaves the instance, and why. Rows and columns are numbered as in
/// the matrix that is reduced; "remaining" is what no step before has removed.
///
/// Each step keeps the least number of rows (Garfinkel and Nemhauser 1972, chapter 8):
///  - kColumn: column `subject` goes, since the remaining rows of column `reason` are among its
///  own:
///    whoever covers `reason` covers it.
///  - kRow: row `subject` goes, since its remaining columns are among those of row `reason`, which
///    can stand in for it in every cover.
///  - kTake: row `subject` is in every cover, as the only remaining row of column `reason`; it goes
///    with all its columns.
struct ReductionStep {
  enum class Kind : std::uint8_t { kColumn, kRow, kTake };
  Kind kind;
  std::uint32_t subject;
  std::uint32_t reason;
};

/// Rows and columns that no other part of the remaining instance has anything to do with.
struct CoverComponent {
  std::vector<std::uint32_t> rows, columns;  ///< ascending
  Incidence incidence;                       ///< numbered along `rows` and `columns`
};

/// What is left of a cover instance, and how it came to that. The fewest rows are the taken ones
/// and the fewest of each component: solutions map back by union, bounds by sum.
struct Reduction {
  std::vector<ReductionStep> steps;        ///< in the order in which they were made
  std::vector<std::uint32_t> taken;        ///< rows of the kTake steps, ascending
  std::vector<CoverComponent> components;  ///< by their first row; remaining rows that cover
                                           ///< nothing are in none
};

/// Reduces until nothing changes. Columns that no row covers are left aside. Deterministic.
/// Cost: O(rounds x #ones x (#rows + #columns) / 64), a few rounds in practice.
Reduction reduce_cover(const BitRows& matrix);

/// Only the columns implied by others go: every cover remains one, so all optimal sets survive.
/// Ascending numbers of the columns that stay; uncoverable columns do not.
std::vector<std::uint32_t> columns_without_implied(const BitRows& matrix);

/// Only dominated rows go, with the columns as they are: keeps the most weight that k rows can
/// cover for every k up to the number of rows that stay, since in any set a dominated row can be
/// exchanged for the one that dominates it, or for any other where that is chosen already.
/// Ascending numbers of the rows that stay; rows that cover nothing do not, unless none does.
std::vector<std::uint32_t> rows_without_dominated(const BitRows& matrix);

}  // namespace viewcover
