#pragma once

#include <cstdint>
#include <iosfwd>
#include <vector>

#include "optim/cover_dual.h"
#include "optim/reductions.h"

namespace viewcover {

/// A proof that no cover of an instance has fewer than lower_bound rows: reductions, then for each
/// component a tree of decisions with a dual at each leaf (papers/cover.md).
///
/// As text, one statement a line; rows and columns are numbered from 1, columns along the canonical
/// matrix: uncoverable columns left out, of equal columns the first one only, else in order.
///
///   viewcover-cover-proof 1
///   matrix ROWS COLUMNS SHA256    size of the canonical matrix and its hash (matrix_hash())
///   bound L                       what is proved
///   column C D                    column C goes: the remaining rows of column D are among its own
///   row R S                       row R goes: its remaining columns are among those of row S
///   take R C                      row R is taken: the only remaining row of column C
///   component B R R R ...         at least B of these rows are in any cover; then its tree:
///   dual D C:N C:N ...            prices N / D of columns; duals are numbered 1, 2, ... throughout
///   without J R R ...             dual J proves B for this part of the tree with any one of these
///                                 rows chosen; so they are not; the tree goes on
///   branch R                      two trees follow: row R chosen, row R not chosen
///   leaf J                        dual J proves B for this part of the tree
///   end
///
/// `column`, `row` and `take` come first, in the order in which they apply; each tree in prefix
/// order; a dual before its first use. L is the number of `take` lines and the sum of all B.
struct CoverProof {
  struct Node {
    enum class Kind : std::uint8_t { kWithout, kBranch, kLeaf };
    Kind kind;
    std::uint32_t dual;               ///< number in `duals`; unused by kBranch
    std::vector<std::uint32_t> rows;  ///< one row of kBranch, several of kWithout
  };
  struct Component {
    std::vector<std::uint32_t> rows;
    std::size_t bound;
    std::vector<Node> nodes;  ///< in prefix order
  };

  std::size_t lower_bound = 0;
  std::vector<ReductionStep> steps;
  std::vector<CoverDual> duals;
  std::vector<Component> components;
};

/// Writes the proof of a bound for this (canonical) matrix. Errors: those of the stream.
/// Cost: O(size of the proof + #rows x #columns / 64 + #ones).
void write_cover_proof(std::ostream& out, const BitRows& matrix, const CoverProof& proof);

}  // namespace viewcover
