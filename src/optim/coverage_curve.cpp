#include "optim/coverage_curve.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "optim/coverage_tree.h"
#include "optim/stopwatch.h"

namespace viewcover {
namespace {

using Benefit = CoverState::Benefit;

/// A problem is much smaller if it has at most this share of the rows.
constexpr double kMuchSmaller = 0.8;

}  // namespace

CoverageCurve::CoverageCurve(const CoverInstance& instance, SearchLimits& limits,
                             std::size_t most_nodes)
    : instance_(instance), limits_(limits), most_nodes_(most_nodes), problem_(instance) {}

CoverStep CoverageCurve::step(std::size_t k) {
  const Stopwatch watch;
  CoverStep step;
  step.k = k;
  Benefit best = -1, bound = std::numeric_limits<Benefit>::max();
  std::optional<CoverageProblem> smaller;
  for (bool go_on = true; go_on;) {
    const CoverageProblem& problem = smaller ? *smaller : problem_;
    CoverageTree tree(problem, k, best_rows_in(problem), best, limits_,
                      smaller ? nullptr : root_basis_);
    tree.search_root();
    if (!smaller) root_basis_ = tree.root_basis();
    const std::vector<std::uint32_t> left = tree.rows_left();
    const auto size = static_cast<double>(problem.row_numbers.size());
    go_on = static_cast<double>(left.size()) <= kMuchSmaller * size;
    if (!go_on) tree.search(most_nodes_);
    if (tree.best_benefit() > best) {
      best = tree.best_benefit();
      best_.clear();
      for (const std::uint32_t row : tree.best()) best_.push_back(problem.row_numbers[row]);
    }
    bound = std::min(bound, tree.bound());
    step.evaluations += tree.node_count();
    if (left.size() < k) {
      bound = best;
      go_on = false;
    }
    if (go_on) smaller = CoverageProblem(problem, left);
  }
  step.chosen = best_;
  step.covered_percent = instance_.covered_percent(best_);
  step.upper_bound_percent = percent_at_most(instance_, bound);
  step.proved = best == bound;
  step.seconds = watch.seconds();
  return step;
}

std::vector<std::uint32_t> CoverageCurve::best_rows_in(const CoverageProblem& problem) const {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < problem.row_numbers.size(); ++row) {
    if (std::ranges::binary_search(best_, problem.row_numbers[row])) rows.push_back(row);
  }
  return rows;
}

}  // namespace viewcover
