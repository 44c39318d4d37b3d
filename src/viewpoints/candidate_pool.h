#pragma once

#include <span>
#include <vector>

#include "links/bit_rows.h"
#include "viewpoints/viewpoint.h"

namespace viewcover {

/// A viewpoint that was looked from.
struct Candidate {
  Viewpoint viewpoint;
  std::vector<BitRows::Word> seen;  ///< columns, as in a row of the visibility matrix
  double seconds = 0;               ///< since the search began
};

/// Viewpoints to choose from: none sees only what another sees.
class CandidatePool {
 public:
  explicit CandidatePool(std::size_t columns) : columns_(columns) {}

  std::size_t size() const { return candidates_.size(); }
  const Candidate& operator[](std::size_t index) const { return candidates_[index]; }

  /// False if a candidate that is here sees as much; otherwise those that see no more go.
  /// Cost: O(size x columns / 64).
  bool add(Candidate candidate);

  /// Keeps the `most` with the greatest scores (one a candidate), in their order; of equal ones
  /// those that came first.
  void keep_best(std::size_t most, std::span<const double> scores);

  /// One row a candidate.
  BitRows rows() const;
  /// How many candidates see each column.
  std::vector<std::size_t> viewers() const;

 private:
  std::size_t columns_;
  std::vector<Candidate> candidates_;
};

}  // namespace viewcover
