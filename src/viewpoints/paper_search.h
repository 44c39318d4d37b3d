#pragma once

#include <vector>

#include "viewpoints/looks.h"

namespace viewcover {

struct PaperViewpoints {
  std::vector<Candidate> chosen;     ///< in the order in which they were chosen
  std::vector<std::size_t> missing;  ///< columns that no position was found for
};

/// Figure 5 of the paper: cycles through the chosen regions; in each, simulated annealing finds the
/// position that adds most area to what is seen, until everything visible is. All positions whose
/// view was computed in full go to the pool.
///
/// Beyond the figure: when a whole cycle adds nothing, positions where sight lines to a missing
/// element start are tried, in other regions too, so that the loop ends. Errors: Interrupted.
PaperViewpoints paper_search(Looks& looks, const ViewpointOptions& options, CandidatePool& pool);

}  // namespace viewcover
