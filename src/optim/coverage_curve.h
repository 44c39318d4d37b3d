#pragma once

#include <memory>
#include <vector>

#include "optim/coverage_bound.h"
#include "optim/linear_program.h"
#include "optim/region_cover.h"
#include "optim/search_limits.h"

namespace viewcover {

/// Maximum coverage for one k after the other, each search starting from the best set of the last.
///
/// After the root of the tree (optim/coverage_tree.h) the rows that its bound rules out leave the
/// problem, columns that have become equal are merged, and the search starts anew on what is left,
/// as long as that is much smaller.
/// Not safe for concurrent use.
class CoverageCurve {
 public:
  static constexpr std::size_t kAnyNumberOfNodes = static_cast<std::size_t>(-1);

  /// The instance and the limits must outlive the curve. `most_nodes`: of the tree for one k. Rows
  /// worth the same, such as those of equal rooms, leave more sets close to the bound than can be
  /// gone through.
  CoverageCurve(const CoverInstance& instance, SearchLimits& limits,
                std::size_t most_nodes = kAnyNumberOfNodes);

  /// The best set of k rows that is found before the limits expire, and what is proved.
  /// Requires k below the number of rows of a smallest cover. Errors: Interrupted.
  CoverStep step(std::size_t k);

 private:
  /// Those of the best rows that the problem has, in its numbers.
  std::vector<std::uint32_t> best_rows_in(const CoverageProblem& problem) const;

  const CoverInstance& instance_;
  SearchLimits& limits_;
  std::size_t most_nodes_;
  CoverageProblem problem_;
  std::vector<std::size_t> best_;                           ///< for the last k, ascending
  std::shared_ptr<const LinearProgram::Basis> root_basis_;  ///< of the last k
};

}  // namespace viewcover
