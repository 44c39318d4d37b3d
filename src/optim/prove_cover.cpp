#include "optim/prove_cover.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "optim/cover_tree.h"
#include "optim/heuristic_cover.h"
#include "optim/incidence.h"
#include "optim/reductions.h"

namespace viewcover {
namespace {

/// The components of a reduced instance with the best covers and bounds so far.
class CoverProver {
 public:
  CoverProver(const BitRows& matrix, SearchLimits& limits, const CoverOptions& options)
      : limits_(limits), options_(options), reduction_(reduce_cover(matrix)) {
    std::ranges::stable_sort(reduction_.components, {}, [](const CoverComponent& component) {
      return component.columns.size();
    });
    bounds_.assign(reduction_.components.size(), 1);
    for (const CoverComponent& component : reduction_.components) {
      covers_.push_back(greedy_cover(component.incidence));
    }
  }

  ProvedCover run() && {
    ProvedCover result;
    report();
    for (std::size_t i = 0; i < reduction_.components.size(); ++i) {
      const CoverComponent& component = reduction_.components[i];
      CoverTree tree(component.incidence, covers_[i], limits_);
      search(tree, i);
      result.nodes += tree.node_count();
      append_component(result.proof, tree, component);
    }
    result.rows = rows();
    result.proof.lower_bound = bound();
    result.proof.steps = std::move(reduction_.steps);
    return result;
  }

 private:
  /// Until the tree is done or the limits expire, with covers from local search in between: after a
  /// first slice, which is enough for most rooms, and with a time limit after every further slice,
  /// each about as long as all before it.
  void search(CoverTree& tree, std::size_t number) {
    constexpr CoverTree::Slice kFirst{.nodes = 50, .seconds = 1}, kAll;
    constexpr double kShareOfTime = 0.25;  // of local search beside the tree
    // What the first programme of the tree hardly notices, and what a slice does.
    constexpr std::uint64_t kFirstPatiencePerOne = 20, kPatience = 10'000'000;
    const bool timed = std::isfinite(limits_.seconds_left());
    const auto after_node = [&] { update(tree, number); };
    const Incidence& incidence = reduction_.components[number].incidence;
    HeuristicCover heuristic(incidence, limits_, options_.seed);
    tree.offer(heuristic.run(kFirstPatiencePerOne * incidence.ones()));
    CoverTree::Slice slice{.nodes = kFirst.nodes, .seconds = timed ? kFirst.seconds : kAll.seconds};
    while (true) {
      const double began = limits_.seconds();
      tree.search(slice, after_node);
      const double took = limits_.seconds() - began;
      if (tree.bound() >= tree.best().size() || limits_.expired()) break;
      tree.offer(heuristic.run_for_share(timed ? kShareOfTime * took / limits_.seconds_left() : 1,
                                         kPatience));
      slice = {.seconds = timed ? 2 * took : kAll.seconds};
    }
    update(tree, number);
  }

  void update(const CoverTree& tree, std::size_t number) {
    if (tree.bound() == bounds_[number] && tree.best().size() == covers_[number].size()) return;
    bounds_[number] = tree.bound();
    covers_[number] = tree.best();
    report();
  }

  void report() {
    const std::vector<std::size_t> chosen = rows();
    if (options_.on_better && !chosen.empty() &&
        (reported_rows_ == 0 || chosen.size() < reported_rows_)) {
      options_.on_better({chosen, limits_.seconds()});
      reported_rows_ = chosen.size();
    }
    if (options_.on_bound && bound() > reported_bound_) {
      reported_bound_ = bound();
      options_.on_bound(reported_bound_);
    }
  }

  std::vector<std::size_t> rows() const {
    std::vector<std::size_t> rows(reduction_.taken.begin(), reduction_.taken.end());
    for (std::size_t i = 0; i < covers_.size(); ++i) {
      for (const std::uint32_t row : covers_[i]) {
        rows.push_back(reduction_.components[i].rows[row]);
      }
    }
    std::ranges::sort(rows);
    return rows;
  }
  std::size_t bound() const {
    return std::accumulate(bounds_.begin(), bounds_.end(), reduction_.taken.size());
  }

  SearchLimits& limits_;
  const CoverOptions& options_;
  Reduction reduction_;
  std::vector<std::vector<std::uint32_t>> covers_;  ///< numbers along the components' rows
  std::vector<std::size_t> bounds_;
  std::size_t reported_rows_ = 0, reported_bound_ = 0;
};

}  // namespace

ProvedCover prove_cover(const BitRows& matrix, SearchLimits& limits, const CoverOptions& options) {
  return CoverProver(matrix, limits, options).run();
}

// The component's rows and columns take the place of numbers along them.
void append_component(CoverProof& proof, const CoverTree& tree, const CoverComponent& component) {
  const std::size_t first_dual = proof.duals.size();
  std::vector<CoverProof::Node> nodes = tree.proof(proof.duals);
  for (std::size_t dual = first_dual; dual < proof.duals.size(); ++dual) {
    for (auto& [column, price] : proof.duals[dual].prices) column = component.columns[column];
  }
  for (CoverProof::Node& node : nodes) {
    for (std::uint32_t& row : node.rows) row = component.rows[row];
  }
  proof.components.push_back({component.rows, tree.bound(), std::move(nodes)});
}

}  // namespace viewcover
