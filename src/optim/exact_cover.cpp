#include "optim/exact_cover.h"

#include <algorithm>
#include <cmath>

#include "optim/cover_proof.h"
#include "optim/cover_tree.h"
#include "optim/coverage_curve.h"
#include "optim/incidence.h"
#include "optim/optimal_covers.h"
#include "optim/reductions.h"
#include "optim/search_effort.h"
#include "optim/search_limits.h"
#include "optim/stopwatch.h"
#include "optim/whole_cover_search.h"
#include "scene/random_numbers.h"

namespace viewcover {
namespace {

/// A whole cover and the proof of how far from smallest it may be.
struct ProvedCover {
  std::vector<std::size_t> rows;  ///< ascending
  CoverProof proof;
  std::uint64_t nodes = 0;  ///< of the trees
};

/// The component's rows and columns, in place of numbers along them.
CoverProof::Component in_matrix_numbers(const CoverComponent& component, std::size_t bound,
                                        std::vector<CoverProof::Node> nodes) {
  for (CoverProof::Node& node : nodes) {
    for (std::uint32_t& row : node.rows) row = component.rows[row];
  }
  return {component.rows, bound, std::move(nodes)};
}

/// Local search for covers of a component beside its tree.
class HeuristicCover {
 public:
  HeuristicCover(const CoverComponent& component, SearchLimits& limits, std::uint64_t seed)
      : incidence_(component.incidence),
        limits_(limits),
        random_(seed),
        search_(incidence_, random_) {}

  /// As much as the first programme of the tree hardly notices.
  const std::vector<std::uint32_t>& begin() {
    SearchEffort effort(limits_, 20 * incidence_.ones(), search_.work());
    return run(effort);
  }
  /// Goes on for a share of the time that is left; without a time limit until so much work, the
  /// same on any machine, brought nothing better.
  const std::vector<std::uint32_t>& improve(double share) {
    constexpr std::uint64_t kPatience = 10'000'000;
    SearchEffort effort(limits_, share, kPatience, search_.work());
    return run(effort);
  }

 private:
  const std::vector<std::uint32_t>& run(SearchEffort& effort) {
    search_.run(effort, 1, [] {});
    best_.assign(search_.best().begin(), search_.best().end());
    std::ranges::sort(best_);
    return best_;
  }

  const Incidence& incidence_;
  SearchLimits& limits_;
  RandomNumbers random_;
  WholeCoverSearch search_;
  std::vector<std::uint32_t> best_;
};

/// The tree of a component until it is done or the limits expire, with covers from local search in
/// between: after a first slice, which is enough for most rooms, and with a time limit after every
/// further slice, each twice as long as all before it.
CoverTree searched_tree(const CoverComponent& component, SearchLimits& limits, std::uint64_t seed) {
  constexpr CoverTree::Slice kFirst{.nodes = 50, .seconds = 1};
  constexpr double kShareOfTime = 0.25;  // of local search beside the tree
  const bool timed = std::isfinite(limits.seconds_left());
  HeuristicCover heuristic(component, limits, seed);
  CoverTree tree(component.incidence, heuristic.begin(), limits);
  CoverTree::Slice slice = kFirst;
  if (!timed) slice.seconds = CoverTree::Slice().seconds;
  while (true) {
    const double began = limits.seconds();
    tree.search(slice);
    const double took = limits.seconds() - began;
    if (tree.bound() >= tree.best().size() || limits.expired()) return tree;
    tree.offer(heuristic.improve(timed ? kShareOfTime * took / limits.seconds_left() : 1));
    slice = {.seconds = timed ? 2 * took : CoverTree::Slice().seconds};
  }
}

ProvedCover prove_cover(const CoverInstance& instance, SearchLimits& limits, std::uint64_t seed) {
  ProvedCover result;
  Reduction reduction = reduce_cover(instance.rows());
  result.rows.assign(reduction.taken.begin(), reduction.taken.end());
  result.proof.lower_bound = reduction.taken.size();
  std::ranges::stable_sort(reduction.components, {}, [](const CoverComponent& component) {
    return component.columns.size();
  });
  for (const CoverComponent& component : reduction.components) {
    const CoverTree tree = searched_tree(component, limits, seed);
    result.nodes += tree.node_count();
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
CoverStep whole_step(const CoverInstance& instance, ProvedCover cover) {
  CoverStep step;
  step.k = cover.rows.size();
  step.chosen = std::move(cover.rows);
  step.evaluations = cover.nodes;
  step.covered_percent = instance.covered_percent(step.chosen);
  step.proved = true;
  return step;
}

}  // namespace

RegionCover ExactCover::solve(const CoverInstance& instance, const CoverOptions& options) const {
  RegionCover cover;
  const Stopwatch watch;
  SearchLimits limits(options);
  limits.expired();
  CoverOptions cover_options = options;
  if (options.goal != CoverGoal::kWholeCover) cover_options.time_limit_seconds /= 2;
  SearchLimits cover_limits(cover_options);
  ProvedCover proved = prove_cover(instance, cover_limits, options.seed);
  cover.lower_bound = proved.proof.lower_bound;
  cover.proof = std::make_shared<const CoverProof>(std::move(proved.proof));
  if (proved.rows.empty()) return cover;
  if (options.on_better) options.on_better({proved.rows, watch.seconds()});

  CoverStep whole = whole_step(instance, std::move(proved));
  whole.seconds = watch.seconds();
  const std::size_t whole_size = whole.k;
  const auto add_step = [&](CoverStep step) {
    cover.steps.push_back(std::move(step));
    if (options.on_step) options.on_step(cover.steps.back());
  };
  const bool every_k = options.goal == CoverGoal::kEveryK, one_k = options.goal == CoverGoal::kOneK;
  cover.whole = !one_k || options.k >= whole_size;
  if (every_k || !cover.whole) {
    CoverageCurve coverage(instance, limits);
    const std::size_t first = every_k ? 1 : options.k, end = every_k ? whole_size : options.k + 1;
    for (std::size_t k = std::max(first, std::size_t{1}); k < end; ++k) add_step(coverage.step(k));
  }
  if (cover.whole) add_step(std::move(whole));
  if (options.solutions > 0 && cover.lower_bound == whole_size) {
    OptimalCovers found = covers_of_size(instance.rows(), whole_size, options.solutions, limits);
    cover.solutions = std::move(found.covers);
    cover.solutions_complete = found.complete;
  }
  cover.time_limit_reached = limits.has_expired() || cover_limits.has_expired();
  return cover;
}

}  // namespace viewcover
