#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>

#include "links/bit_rows.h"

namespace viewcover {

/// What the checker says about a proof.
struct CoverProofVerdict {
  bool holds = false;
  std::uint64_t lower_bound = 0;  ///< proved; 0 unless the proof holds
  std::size_t line = 0;           ///< of what is wrong, 1-based; 0 if the proof holds
  std::string reason;             ///< what is wrong, one line; empty if the proof holds
};

/// Hexadecimal SHA-256 of a matrix as text: "ROWS COLUMNS\n" and for each row its columns, numbered
/// from 1 and ascending, separated by blanks, and "\n".
std::string matrix_hash(const BitRows& matrix);

/// Reads a proof in the format of optim/cover_proof.h and checks every line of it against a 0/1
/// matrix, any that has the canonical form that the proof names. Integer arithmetic without
/// overflow (numbers of the file below 2^62, sums in 128 bits), nothing shared with what writes
/// proofs but the bits of the matrix: a proof that holds is a theorem whatever found it. Cost: for
/// each line with a dual, O(ones of its columns + #rows + #columns).
CoverProofVerdict check_cover_proof(const BitRows& matrix, std::istream& proof);

}  // namespace viewcover
