#include "optim/exact_cover.h"

#include <algorithm>

#include "optim/cover_proof.h"
#include "optim/cover_tree.h"
#include "optim/coverage_bound.h"
#include "optim/coverage_tree.h"
#include "optim/reductions.h"
#include "optim/search_limits.h"
#include "optim/stopwatch.h"

namespace viewcover {
namespace {

/// A whole cover and the proof of how far from smallest it may be.
struct ProvedCover {
  std::vector<std::size_t> rows;  ///< ascending
  CoverProof proof;
};

/// The component's rows and columns, in place of numbers along them.
CoverProof::Component in_matrix_numbers(const CoverComponent& component, std::size_t bound,
                                        std::vector<CoverProof::Node> nodes) {
  for (CoverProof::Node& node : nodes) {
    for (std::uint32_t& row : node.rows) row = component.rows[row];
  }
  return {component.rows, bound, std::move(nodes)};
}

ProvedCover prove_cover(const CoverInstance& instance, SearchLimits& limits) {
  ProvedCover result;
  Reduction reduction = reduce_cover(instance.rows());
  result.rows.assign(reduction.taken.begin(), reduction.taken.end());
  result.proof.lower_bound = reduction.taken.size();
  std::ranges::stable_sort(reduction.components, {}, [](const CoverComponent& component) {
    return component.columns.size();
  });
  for (const CoverComponent& component : reduction.components) {
    CoverTree tree(component.incidence, greedy_cover(component.incidence), limits);
    tree.search();
    for (const std::uint32_t row : tree.best()) result.rows.push_back(component.rows[row]);
    result.proof.lower_bound += tree.bound();
    const std::size_t first_dual = result.proof.duals.size();
    std::vector<CoverProof::Node> nodes = tree.proof(result.proof.duals);
    for (std::size_t dual = first_dual; dual < result.proof.duals.size(); ++dual) {
      for (auto& [column, price] : result.proof.duals[dual].prices) {
        column = component.columns[column];
      }
    }
    result.proof.components.push_back(in_matrix_numbers(component, tree.bound(), std::move(nodes)));
  }
  result.proof.steps = std::move(reduction.steps);
  std::ranges::sort(result.rows);
  return result;
}

/// The step of a set of rows that covers everything coverable.
CoverStep whole_step(const CoverInstance& instance, std::vector<std::size_t> rows) {
  CoverStep step;
  step.k = rows.size();
  step.chosen = std::move(rows);
  step.covered_percent = instance.covered_percent(step.chosen);
  step.proved = true;
  return step;
}

/// Maximum coverage for one k after the other, each starting from the best set of the last.
class Coverage {
 public:
  Coverage(const CoverInstance& instance, SearchLimits& limits)
      : instance_(instance), problem_(instance), limits_(limits) {}

  std::size_t row_count() const { return problem_.incidence.rows.size(); }

  CoverStep step(std::size_t k) {
    const Stopwatch watch;
    CoverageTree tree(problem_, k, std::move(last_), limits_);
    tree.search();
    last_ = tree.best();
    CoverStep step;
    step.k = k;
    for (const std::uint32_t row : last_) step.chosen.push_back(problem_.row_numbers[row]);
    step.covered_percent = instance_.covered_percent(step.chosen);
    step.upper_bound_percent = percent_at_most(instance_, tree.bound());
    step.proved = tree.bound() == tree.best_benefit();
    step.evaluations = tree.node_count();
    step.seconds = watch.seconds();
    return step;
  }

 private:
  const CoverInstance& instance_;
  CoverageProblem problem_;
  SearchLimits& limits_;
  std::vector<std::uint32_t> last_;
};

}  // namespace

RegionCover ExactCover::solve(const CoverInstance& instance, const CoverOptions& options) const {
  RegionCover cover;
  const Stopwatch watch;
  SearchLimits limits(options);
  CoverOptions cover_options = options;
  if (options.goal != CoverGoal::kWholeCover) cover_options.time_limit_seconds /= 2;
  SearchLimits cover_limits(cover_options);
  ProvedCover proved = prove_cover(instance, cover_limits);
  cover.lower_bound = proved.proof.lower_bound;
  cover.proof = std::make_shared<const CoverProof>(std::move(proved.proof));
  if (proved.rows.empty()) return cover;

  CoverStep whole = whole_step(instance, std::move(proved.rows));
  whole.seconds = watch.seconds();
  const auto add_step = [&](CoverStep step) {
    cover.steps.push_back(std::move(step));
    if (options.on_step) options.on_step(cover.steps.back());
  };
  if (options.goal == CoverGoal::kEveryK ||
      (options.goal == CoverGoal::kOneK && options.k < whole.k)) {
    Coverage coverage(instance, limits);
    const bool every_k = options.goal == CoverGoal::kEveryK;
    for (std::size_t k = every_k ? 1 : options.k; k < (every_k ? whole.k : options.k + 1); ++k) {
      add_step(coverage.step(k));
    }
  }
  cover.whole = options.goal != CoverGoal::kOneK || options.k >= whole.k;
  if (cover.whole) add_step(std::move(whole));
  cover.time_limit_reached = limits.has_expired() || cover_limits.has_expired();
  return cover;
}

}  // namespace viewcover
