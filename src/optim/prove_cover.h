#pragma once

#include <vector>

#include "optim/cover_proof.h"
#include "optim/cover_tree.h"
#include "optim/reductions.h"
#include "optim/region_cover.h"
#include "optim/search_limits.h"

namespace viewcover {

/// A whole cover and the proof of how far from smallest it may be.
struct ProvedCover {
  std::vector<std::size_t> rows;  ///< ascending
  CoverProof proof;
  std::uint64_t nodes = 0;  ///< of the trees
};

/// A smallest cover of all coverable columns, or the best one and the best bound when the limits
/// expire: reductions, then component by component, few columns first, branch and bound
/// (optim/cover_tree.h) with local search beside it. Calls on_better and on_bound of the options.
/// Deterministic unless a limit strikes. Errors: Interrupted.
ProvedCover prove_cover(const BitRows& matrix, SearchLimits& limits, const CoverOptions& options);

/// Adds what a tree proves of its component to the proof of a whole cover; lower_bound and steps of
/// the proof are the caller's.
void append_component(CoverProof& proof, const CoverTree& tree, const CoverComponent& component);

}  // namespace viewcover
