#pragma once

#include <cstdint>

#include "optim/cover_dual.h"
#include "optim/incidence.h"
#include "optim/linear_program.h"

namespace viewcover {

/// The linear programme of a cover, min sum x_r, sum_{r covers c} x_r >= 1, and bounds from its
/// prices. Not safe for concurrent use.
class CoverProgramme {
 public:
  using Status = LinearProgram::Status;

  /// The incidence must outlive the programme.
  explicit CoverProgramme(const Incidence& incidence);

  /// Solves the part of the tree that `state` describes, up to `limit` (linear_program.h).
  Status solve(const CoverNodeState& state, SearchLimits& limits,
               double limit = LinearProgram::kInfinity);

  /// The best rounded prices of the last solution and what they prove; `dual` is replaced if they
  /// prove as much as it does.
  CoverDualValue improve(CoverDual& dual, const CoverNodeState& state) const;

  std::span<const double> solution() const { return programme_.solution(); }
  LinearProgram::Basis basis() const { return programme_.basis(); }
  void set_basis(const LinearProgram::Basis& basis) { programme_.set_basis(basis); }

 private:
  const Incidence& incidence_;
  LinearProgram programme_;
  std::vector<CoverNodeState::Row> rows_;  ///< as the programme has them
};

}  // namespace viewcover
