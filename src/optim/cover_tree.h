#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "optim/cover_dual.h"
#include "optim/cover_programme.h"
#include "optim/cover_proof.h"
#include "optim/incidence.h"
#include "optim/linear_program.h"
#include "optim/search_limits.h"

namespace viewcover {

/// Branch and bound for the fewest rows that cover all columns of one component.
///
/// Nodes are solved by the linear programme of the cover, warm-started; its prices, rounded to
/// integers (optim/cover_dual.h), bound the node. Choosing a row that would raise the bound to the
/// best cover is ruled out (reduced costs). The open node of the least bound comes first, of
/// several the deepest: the proved bound rises as fast as it can, and where it is one below the
/// best cover the search goes depth first. Covers are found by rounding.
///
/// The tree is ours, not that of an integer programming solver, because it is the proof: each leaf
/// is closed by an integer dual that anybody can check, while a solver's bound in floating point
/// is no theorem (HiGHS ends with 225.0000000000046 where 225 is optimal; rounded up that is 226).
/// Deterministic unless a limit strikes. Not safe for concurrent use.
class CoverTree {
 public:
  /// `cover`: some cover. Every column must have a row. The incidence and the limits must outlive
  /// the tree.
  CoverTree(const Incidence& incidence, std::vector<std::uint32_t> cover, SearchLimits& limits);

  /// How far a call of search() goes.
  struct Slice {
    std::size_t nodes = std::numeric_limits<std::size_t>::max();  ///< of the tree
    double seconds = std::numeric_limits<double>::infinity();     ///< of the call, about
  };
  /// Goes on until best() is proved smallest, the slice is used up or the limits expire; calls
  /// `after_node` after each node. Errors: Interrupted.
  void search(
      const Slice& slice, const std::function<void()>& after_node = [] {});
  /// A cover from elsewhere, in case it is smaller than best().
  void offer(std::vector<std::uint32_t> cover);

  const std::vector<std::uint32_t>& best() const { return best_; }  ///< ascending
  std::size_t bound() const;  ///< proved; at most best().size()
  std::size_t node_count() const { return nodes_.size(); }

  /// The tree cut back to what proves bound(), its duals appended to `duals`. Rows and columns are
  /// numbered as in the incidence.
  std::vector<CoverProof::Node> proof(std::vector<CoverDual>& duals) const;

 private:
  using NodeId = std::uint32_t;
  static constexpr NodeId kNoNode = static_cast<NodeId>(-1);

  struct Node {
    NodeId parent = kNoNode;
    std::uint32_t depth = 0;
    bool row_chosen = false;                  ///< the parent's branch row
    std::uint32_t branch_row = 0;             ///< if there are children
    NodeId children[2] = {kNoNode, kNoNode};  ///< row not chosen, chosen
    CoverDual dual;
    std::size_t proved = 0;                             ///< by the dual
    std::size_t bound = 0;                              ///< by the dual or the parent's bound
    std::vector<std::uint32_t> excluded;                ///< free rows that the dual rules out
    std::shared_ptr<const LinearProgram::Basis> basis;  ///< to start from
  };
  struct Open {
    std::size_t bound;
    std::uint32_t depth;
    NodeId node;
    bool operator<(const Open& other) const {  ///< the greatest one comes first
      if (bound != other.bound) return bound > other.bound;
      return depth != other.depth ? depth < other.depth : node < other.node;
    }
  };

  CoverNodeState state_of(NodeId id) const;
  /// False if the limits expired before the node was done with.
  bool process(NodeId id);
  bool close_without_programme(Node& node, const CoverNodeState& state);
  LinearProgram::Status solve_programme(const Node& node, const CoverNodeState& state);
  void exclude_rows(Node& node, const CoverDualValue& value, const CoverNodeState& state);
  void round_solution(const CoverNodeState& state);
  std::uint32_t branch_row(const CoverNodeState& state) const;
  void branch(NodeId id, std::uint32_t row);
  void push(NodeId id) { open_.push({nodes_[id].bound, nodes_[id].depth, id}); }

  const Incidence& incidence_;
  SearchLimits& limits_;
  CoverProgramme programme_;
  std::vector<Node> nodes_;
  std::priority_queue<Open> open_;
  std::vector<std::uint32_t> best_;
};

/// A cover: the row that covers most of what is left, again and again (the first of several), then
/// without rows that the others make redundant. Rows of `first` are taken before. Ascending.
std::vector<std::uint32_t> greedy_cover(const Incidence& incidence,
                                        std::span<const std::uint32_t> first = {});

}  // namespace viewcover
