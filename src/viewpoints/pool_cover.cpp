#include "viewpoints/pool_cover.h"

#include <algorithm>

#include "optim/cover_programme.h"
#include "optim/cover_tree.h"
#include "optim/heuristic_cover.h"
#include "optim/incidence.h"
#include "optim/prove_cover.h"
#include "optim/reductions.h"

namespace viewcover {
namespace {

/// A tree this small is searched before a heuristic is asked.
constexpr std::size_t kNodesBeforeHeuristic = 20;

void add_prices(const CoverComponent& component, SearchLimits& limits, PoolCover& cover) {
  const CoverNodeState state(component.incidence);
  CoverProgramme programme(component.incidence);
  if (programme.solve(state, limits) == LinearProgram::Status::kNone) return;
  CoverDual dual;
  programme.improve(dual, state);
  for (const auto& [column, price] : dual.prices) {
    cover.prices[component.columns[column]] =
        static_cast<double>(price) / static_cast<double>(dual.denominator);
  }
}

}  // namespace

PoolCover cover_pool(const BitRows& rows, const PoolCoverEffort& effort, std::uint64_t seed,
                     SearchLimits& limits) {
  PoolCover cover;
  cover.prices.assign(rows.columns(), 0.0);
  Reduction reduction = reduce_cover(rows);
  for (const ReductionStep& step : reduction.steps) {
    if (step.kind == ReductionStep::Kind::kTake) cover.prices[step.reason] = 1;
  }
  cover.chosen.assign(reduction.taken.begin(), reduction.taken.end());
  cover.lower_bound = reduction.taken.size();
  for (const CoverComponent& component : reduction.components) {
    add_prices(component, limits, cover);
    CoverTree tree(component.incidence, greedy_cover(component.incidence), limits);
    tree.search({.nodes = std::min(kNodesBeforeHeuristic, effort.nodes)});
    if (tree.bound() < tree.best().size()) {
      HeuristicCover heuristic(component.incidence, limits, seed);
      tree.offer(heuristic.run(effort.patience));
      tree.search({.nodes = effort.nodes});
    }
    cover.lower_bound += tree.bound();
    if (effort.proof) append_component(cover.proof, tree, component);
    for (const std::uint32_t row : tree.best()) cover.chosen.push_back(component.rows[row]);
  }
  std::ranges::sort(cover.chosen);
  cover.proof.lower_bound = cover.lower_bound;
  cover.proof.steps = std::move(reduction.steps);
  for (const double price : cover.prices) cover.relaxation += price;
  return cover;
}

}  // namespace viewcover
