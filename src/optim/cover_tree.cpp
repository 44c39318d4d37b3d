#include "optim/cover_tree.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace viewcover {
namespace {

using Row = CoverNodeState::Row;
using Status = LinearProgram::Status;

/// How far above a whole number a programme's value must be before its prices are tried for the
/// next one: what rounding to 2^-20 may cost prices of a few hundred columns.
constexpr double kAboveWhole = 1e-3;
/// Values of x nearer to 0 than this count as 0 when rows are picked; a hint, nothing depends on
/// it.
constexpr double kZero = 1e-6;

/// Columns no two of which share a row, columns of few rows first, at price 1 each.
CoverDual independent_columns(const Incidence& incidence) {
  std::vector<std::uint32_t> order(incidence.column_count());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {},
                           [&](std::uint32_t column) { return incidence.rows_of(column).size(); });
  std::vector<bool> taken(incidence.row_count(), false);
  CoverDual dual;
  for (const std::uint32_t column : order) {
    const std::span<const std::uint32_t> rows = incidence.rows_of(column);
    if (std::ranges::any_of(rows, [&](std::uint32_t row) { return taken[row]; })) continue;
    for (const std::uint32_t row : rows) taken[row] = true;
    dual.prices.emplace_back(column, 1);
  }
  std::ranges::sort(dual.prices);
  return dual;
}

}  // namespace

std::vector<std::uint32_t> greedy_cover(const Incidence& incidence,
                                        std::span<const std::uint32_t> first) {
  std::vector<std::uint32_t> times(incidence.column_count(), 0), gain(incidence.row_count());
  for (std::size_t row = 0; row < gain.size(); ++row) {
    gain[row] = static_cast<std::uint32_t>(incidence.columns_of(row).size());
  }
  std::vector<std::uint32_t> cover;
  std::size_t uncovered = times.size();
  const auto add = [&](std::uint32_t row) {
    cover.push_back(row);
    for (const std::uint32_t column : incidence.columns_of(row)) {
      if (times[column]++ > 0) continue;
      --uncovered;
      for (const std::uint32_t other : incidence.rows_of(column)) --gain[other];
    }
  };
  for (const std::uint32_t row : first) {
    if (gain[row] > 0) add(row);
  }
  while (uncovered > 0) {
    add(static_cast<std::uint32_t>(std::ranges::max_element(gain) - gain.begin()));
  }
  // The last ones cover least, so they are the first to go.
  for (std::size_t i = cover.size(); i-- > 0;) {
    const std::span<const std::uint32_t> columns = incidence.columns_of(cover[i]);
    if (std::ranges::any_of(columns, [&](std::uint32_t c) { return times[c] == 1; })) continue;
    for (const std::uint32_t column : columns) --times[column];
    cover.erase(cover.begin() + static_cast<std::ptrdiff_t>(i));
  }
  std::ranges::sort(cover);
  return cover;
}

CoverTree::CoverTree(const Incidence& incidence, std::vector<std::uint32_t> cover,
                     SearchLimits& limits)
    : incidence_(incidence), limits_(limits), programme_(incidence), best_(std::move(cover)) {
  Node root;
  root.dual = independent_columns(incidence);
  root.proved = root.bound = value_of(root.dual, incidence, CoverNodeState(incidence)).bound();
  nodes_.push_back(std::move(root));
  push(0);
}

std::size_t CoverTree::bound() const {
  return open_.empty() ? best_.size() : std::min(best_.size(), open_.top().bound);
}

void CoverTree::search(const Slice& slice, const std::function<void()>& after_node) {
  const double end = limits_.seconds() + slice.seconds;
  while (!open_.empty() && open_.top().bound < best_.size() && nodes_.size() < slice.nodes) {
    if (limits_.expired() || limits_.seconds() >= end) return;
    const NodeId id = open_.top().node;
    open_.pop();
    if (!process(id)) {
      push(id);
      return;
    }
    after_node();
  }
}

CoverNodeState CoverTree::state_of(NodeId id) const {
  CoverNodeState state(incidence_);
  for (NodeId at = id; at != kNoNode; at = nodes_[at].parent) {
    const Node& node = nodes_[at];
    for (const std::uint32_t row : node.excluded) state.rows[row] = Row::kExcluded;
    if (node.parent == kNoNode) break;
    const std::uint32_t row = nodes_[node.parent].branch_row;
    if (node.row_chosen) {
      state.choose(incidence_, row);
    } else {
      state.rows[row] = Row::kExcluded;
    }
  }
  return state;
}

bool CoverTree::process(NodeId id) {
  const CoverNodeState state = state_of(id);
  if (close_without_programme(nodes_[id], state)) return true;
  const Status status = solve_programme(nodes_[id], state);
  if (status == Status::kNone) {
    if (limits_.expired()) return false;
    branch(id, branch_row(state));  // numerical trouble: smaller problems will do
    return true;
  }
  Node& node = nodes_[id];
  const CoverDualValue value = programme_.improve(node.dual, state);
  node.proved = value.bound();
  node.bound = std::max(node.bound, node.proved);
  node.basis = std::make_shared<const LinearProgram::Basis>(programme_.basis());
  if (node.bound >= best_.size()) return true;
  if (status == Status::kAboveLimit) {
    push(id);
    return true;
  }
  round_solution(state);
  if (node.bound >= best_.size()) return true;
  exclude_rows(node, value, state);
  branch(id, branch_row(state_of(id)));
  return true;
}

bool CoverTree::close_without_programme(Node& node, const CoverNodeState& state) {
  bool all_covered = true;
  for (std::uint32_t column = 0; column < incidence_.column_count(); ++column) {
    if (state.times_covered[column] > 0) continue;
    all_covered = false;
    if (std::ranges::any_of(incidence_.rows_of(column),
                            [&](std::uint32_t row) { return state.rows[row] == Row::kFree; })) {
      continue;
    }
    // No row is left for this column: it may have any price.
    const auto more_than_all = static_cast<std::int64_t>(incidence_.row_count()) + 1;
    node.dual = {1, {{column, more_than_all}}};
    node.proved = node.bound = value_of(node.dual, incidence_, state).bound();
    return true;
  }
  if (!all_covered) return false;
  std::vector<std::uint32_t> cover;
  for (std::uint32_t row = 0; row < state.rows.size(); ++row) {
    if (state.rows[row] == Row::kChosen) cover.push_back(row);
  }
  node.dual = {};
  node.proved = node.bound = state.chosen;
  offer(std::move(cover));
  return true;
}

Status CoverTree::solve_programme(const Node& node, const CoverNodeState& state) {
  if (node.basis) programme_.set_basis(*node.basis);
  // The root's solution is wanted in any case, the others' only if they are to be branched on.
  if (node.parent == kNoNode) return programme_.solve(state, limits_);
  return programme_.solve(state, limits_, static_cast<double>(node.bound) + kAboveWhole);
}

void CoverTree::exclude_rows(Node& node, const CoverDualValue& value, const CoverNodeState& state) {
  const std::int64_t enough = value.denominator * (static_cast<std::int64_t>(best_.size()) - 1);
  for (std::uint32_t row = 0; row < state.rows.size(); ++row) {
    if (state.rows[row] == Row::kFree && value.value_with(row) > enough) {
      node.excluded.push_back(row);
    }
  }
}

void CoverTree::round_solution(const CoverNodeState& state) {
  const std::span<const double> x = programme_.solution();
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < x.size(); ++row) {
    if (state.rows[row] != Row::kExcluded && x[row] > kZero) rows.push_back(row);
  }
  std::ranges::stable_sort(rows, std::greater<>(), [&](std::uint32_t row) { return x[row]; });
  const auto half = std::ranges::find_if(rows, [&](std::uint32_t row) { return x[row] < 0.5; });
  offer(greedy_cover(incidence_, rows));
  offer(greedy_cover(incidence_, std::span(rows.begin(), half)));
}

void CoverTree::offer(std::vector<std::uint32_t> cover) {
  if (cover.size() < best_.size()) best_ = std::move(cover);
}

std::uint32_t CoverTree::branch_row(const CoverNodeState& state) const {
  const std::span<const double> x = programme_.solution();
  std::uint32_t best = 0;
  double best_score = -1;
  for (std::uint32_t row = 0; row < state.rows.size(); ++row) {
    if (state.rows[row] != Row::kFree) continue;
    const double share = std::clamp(x[row], 0.0, 1.0);
    const double score = share * (1 - share);
    if (score > best_score) {
      best = row;
      best_score = score;
    }
  }
  assert(best_score >= 0);
  return best;
}

void CoverTree::branch(NodeId id, std::uint32_t row) {
  nodes_[id].branch_row = row;
  for (const bool chosen : {false, true}) {
    Node child;
    child.parent = id;
    child.depth = nodes_[id].depth + 1;
    child.row_chosen = chosen;
    child.bound = nodes_[id].bound;
    child.basis = nodes_[id].basis;
    nodes_[id].children[chosen] = static_cast<NodeId>(nodes_.size());
    nodes_.push_back(std::move(child));
    push(nodes_[id].children[chosen]);
  }
  nodes_[id].basis.reset();
}

std::vector<CoverProof::Node> CoverTree::proof(std::vector<CoverDual>& duals) const {
  using Kind = CoverProof::Node::Kind;
  const std::size_t needed = bound();
  std::vector<CoverProof::Node> result;
  std::vector<NodeId> stack{0};
  while (!stack.empty()) {
    const Node& node = nodes_[stack.back()];
    stack.pop_back();
    const bool is_leaf = node.proved >= needed;
    if (is_leaf || !node.excluded.empty()) {
      const auto dual = static_cast<std::uint32_t>(duals.size());
      duals.push_back(node.dual);
      if (is_leaf) {
        result.push_back({Kind::kLeaf, dual, {}});
        continue;
      }
      result.push_back({Kind::kWithout, dual, node.excluded});
    }
    assert(node.children[0] != kNoNode);
    result.push_back({Kind::kBranch, 0, {node.branch_row}});
    stack.push_back(node.children[0]);
    stack.push_back(node.children[1]);
  }
  return result;
}

}  // namespace viewcover
