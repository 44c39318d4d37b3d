#pragma once

#include <memory>
#include <queue>
#include <set>
#include <vector>

#include "optim/coverage_bound.h"
#include "optim/linear_program.h"
#include "optim/search_limits.h"

namespace viewcover {

/// Branch and bound for the most weight that k rows cover.
///
/// Nodes are bounded by integer prices (optim/coverage_bound.h) that come from the linear programme
/// max sum w_c z_c, z_c <= sum of rows that cover c, sum of rows <= k (Church and ReVelle 1974),
/// solved in its dual form, which has one constraint a row. The open node of the greatest bound
/// comes first. Sets are found by rounding and exchange. Deterministic unless a limit strikes. Not
/// safe for concurrent use.
class CoverageTree {
 public:
  using Benefit = CoverState::Benefit;

  /// `start`: some set of k rows or fewer, as numbered in the problem; `to_beat`: the benefit of a
  /// set known from elsewhere, or -1. Requires k of at most the number of rows. The problem and the
  /// limits must outlive the tree. `basis`: of the root, from a tree of the same problem.
  CoverageTree(const CoverageProblem& problem, std::size_t k, std::vector<std::uint32_t> start,
               Benefit to_beat, SearchLimits& limits,
               std::shared_ptr<const LinearProgram::Basis> basis = nullptr);

  /// Bounds the root only, and finds the rows that no set better than best() can have.
  /// Errors: Interrupted.
  void search_root();
  /// The basis of the root; null if its programme has not been solved.
  std::shared_ptr<const LinearProgram::Basis> root_basis() const { return root_basis_; }
  /// Rows that search_root() has left.
  std::vector<std::uint32_t> rows_left() const;
  /// Goes on until best() is proved, the limits expire or the tree has so many nodes. Errors:
  /// Interrupted.
  void search(std::size_t most_nodes);

  const std::vector<std::uint32_t>& best() const {
    return best_;
  }  ///< ascending, k rows; none
     ///< if `to_beat` is not beaten
  Benefit best_benefit() const { return best_benefit_; }
  Benefit bound() const;  ///< no k rows cover more; at least best_benefit()
  std::size_t node_count() const { return nodes_.size(); }

 private:
  using NodeId = std::uint32_t;
  static constexpr NodeId kNoNode = static_cast<NodeId>(-1);

  struct Node {
    NodeId parent = kNoNode;
    std::uint32_t depth = 0;
    bool row_chosen = false;       ///< the parent's branch row
    std::uint32_t branch_row = 0;  ///< if there are children
    Benefit bound = 0;
    std::vector<std::uint32_t> included, excluded;  ///< rows that the bound decides
    std::shared_ptr<const LinearProgram::Basis> basis;
  };
  struct Open {
    Benefit bound;
    std::uint32_t depth;
    NodeId node;
    bool operator<(const Open& other) const {  ///< the greatest one comes first
      if (bound != other.bound) return bound < other.bound;
      return depth != other.depth ? depth < other.depth : node < other.node;
    }
  };

  CoverNodeState state_of(NodeId id) const;
  /// False if there is nothing left to do, or no time.
  bool search_next();
  /// False if the limits expired before the node was done with.
  bool process(NodeId id);
  bool solve_programme(const Node& node, const CoverNodeState& state);
  void decide_rows(Node& node, const CoverageValue& value, const CoverNodeState& state);
  /// Completes a set to k rows, exchanges while that helps, and keeps it if it is the best. Does
  /// nothing for a set that was offered before.
  void offer(std::vector<std::uint32_t> rows);
  void branch(NodeId id, const CoverNodeState& state);
  void push(NodeId id) { open_.push({nodes_[id].bound, nodes_[id].depth, id}); }

  const CoverageProblem& problem_;
  std::size_t k_;
  SearchLimits& limits_;
  double unit_;  ///< benefit of one unit of weight in the programme
  LinearProgram programme_;
  std::vector<CoverNodeState::Row> programme_rows_;  ///< as the programme has them
  std::vector<Node> nodes_;
  std::priority_queue<Open> open_;
  std::shared_ptr<const LinearProgram::Basis> root_basis_;
  std::set<std::vector<std::uint32_t>> offered_;
  std::vector<std::uint32_t> best_;
  Benefit best_benefit_;
};

}  // namespace viewcover
