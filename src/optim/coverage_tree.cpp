#include "optim/coverage_tree.h"

#include <algorithm>
#include <cassert>
#include <numeric>

namespace viewcover {
namespace {

using Benefit = CoverState::Benefit;
using Row = CoverNodeState::Row;

/// Weights in the programme are 1 on average: far from its tolerances on both sides.
double unit_of(const CoverageProblem& problem) {
  return static_cast<double>(problem.total()) / static_cast<double>(problem.weights.size());
}

/// Variables: the price of each column, the price of a row, what each row is worth beyond it.
/// Constraint of row r: (price of a row) + (surplus of r) - (prices of its columns) >= 0; its own
/// price is x_r.
LinearProgram make_programme(const CoverageProblem& problem, std::size_t k, double unit) {
  const std::size_t rows = problem.incidence.row_count();
  std::vector<LinearProgram::Variable> variables;
  for (std::size_t column = 0; column < problem.weights.size(); ++column) {
    const std::span<const std::uint32_t> covering = problem.incidence.rows_of(column);
    variables.push_back({.cost = -1,
                         .upper = static_cast<double>(problem.weights[column]) / unit,
                         .rows = {covering.begin(), covering.end()},
                         .coefficients = std::vector<double>(covering.size(), -1.0)});
  }
  std::vector<std::uint32_t> all(rows);
  std::iota(all.begin(), all.end(), 0u);
  variables.push_back({.cost = static_cast<double>(k),
                       .rows = all,
                       .coefficients = std::vector<double>(rows, 1.0)});
  for (const std::uint32_t row : all) {
    variables.push_back({.cost = 1, .rows = {row}, .coefficients = {1.0}});
  }
  return LinearProgram(variables, std::vector<double>(rows, 0.0));
}

}  // namespace

CoverageTree::CoverageTree(const CoverageProblem& problem, std::size_t k,
                           std::vector<std::uint32_t> start, Benefit to_beat, SearchLimits& limits,
                           std::shared_ptr<const LinearProgram::Basis> basis)
    : problem_(problem),
      k_(k),
      limits_(limits),
      unit_(unit_of(problem)),
      programme_(make_programme(problem, k, unit_)),
      programme_rows_(problem.incidence.row_count(), Row::kFree),
      best_benefit_(to_beat) {
  assert(start.size() <= k && k <= problem.incidence.row_count());
  offer(std::move(start));
  // Prices equal to weights: the k heaviest rows.
  Node root;
  std::vector<double> weights(problem.weights.begin(), problem.weights.end());
  root.bound = coverage_value(problem, weights, 1, CoverNodeState(problem.incidence), k).value;
  root.basis = std::move(basis);
  nodes_.push_back(std::move(root));
  push(0);
}

Benefit CoverageTree::bound() const {
  return open_.empty() ? best_benefit_ : std::max(best_benefit_, open_.top().bound);
}

void CoverageTree::search_root() {
  if (nodes_.size() == 1) search_next();
}

std::vector<std::uint32_t> CoverageTree::rows_left() const {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < problem_.incidence.row_count(); ++row) {
    if (!std::ranges::binary_search(nodes_[0].excluded, row)) rows.push_back(row);
  }
  return rows;
}

void CoverageTree::search(std::size_t most_nodes) {
  while (nodes_.size() < most_nodes && search_next()) {
  }
}

bool CoverageTree::search_next() {
  if (open_.empty() || open_.top().bound <= best_benefit_ || limits_.expired()) return false;
  const NodeId id = open_.top().node;
  open_.pop();
  if (process(id)) return true;
  push(id);
  return false;
}

CoverNodeState CoverageTree::state_of(NodeId id) const {
  CoverNodeState state(problem_.incidence);
  for (NodeId at = id; at != kNoNode; at = nodes_[at].parent) {
    const Node& node = nodes_[at];
    for (const std::uint32_t row : node.excluded) state.rows[row] = Row::kExcluded;
    for (const std::uint32_t row : node.included) state.choose(problem_.incidence, row);
    if (node.parent == kNoNode) break;
    const std::uint32_t row = nodes_[node.parent].branch_row;
    if (node.row_chosen) {
      state.choose(problem_.incidence, row);
    } else {
      state.rows[row] = Row::kExcluded;
    }
  }
  return state;
}

bool CoverageTree::process(NodeId id) {
  const CoverNodeState state = state_of(id);
  const bool solved = solve_programme(nodes_[id], state);
  if (!solved && limits_.expired()) return false;
  Node& node = nodes_[id];
  if (solved) {
    const CoverageValue value = coverage_value(problem_, programme_.solution(), unit_, state, k_);
    node.bound = std::min(node.bound, value.value);
    node.basis = std::make_shared<const LinearProgram::Basis>(programme_.basis());
    if (node.parent == kNoNode) root_basis_ = node.basis;
    const std::span<const double> x = programme_.prices();
    std::vector<std::uint32_t> rows;
    for (std::uint32_t row = 0; row < state.rows.size(); ++row) {
      if (state.rows[row] != Row::kExcluded) rows.push_back(row);
    }
    std::ranges::stable_sort(rows, std::greater<>(), [&](std::uint32_t row) {
      return state.rows[row] == Row::kChosen ? 2.0 : x[row];
    });
    rows.resize(std::min(rows.size(), k_));
    offer(std::move(rows));
    if (node.bound <= best_benefit_) return true;
    decide_rows(node, value, state);
  }
  branch(id, state_of(id));
  return true;
}

bool CoverageTree::solve_programme(const Node& node, const CoverNodeState& state) {
  const std::size_t first_surplus = problem_.weights.size() + 1;
  for (std::size_t row = 0; row < state.rows.size(); ++row) {
    if (programme_rows_[row] == state.rows[row]) continue;
    programme_rows_[row] = state.rows[row];
    const double infinity = LinearProgram::kInfinity;
    programme_.set_bounds(first_surplus + row, state.rows[row] == Row::kChosen ? -infinity : 0,
                          infinity);
    programme_.set_right_hand_side(row, state.rows[row] == Row::kExcluded ? -infinity : 0);
  }
  if (node.basis) programme_.set_basis(*node.basis);
  const bool from_scratch = node.basis == nullptr;
  const auto status =
      from_scratch ? programme_.solve_dual(limits_) : programme_.solve_primal(limits_);
  return status == LinearProgram::Status::kOptimal;
}

void CoverageTree::decide_rows(Node& node, const CoverageValue& value,
                               const CoverNodeState& state) {
  for (std::uint32_t row = 0; row < state.rows.size(); ++row) {
    if (state.rows[row] != Row::kFree) continue;
    const Benefit price = value.row_prices[row];
    const bool counts = price >= value.least_counted;
    if (!counts && value.value - value.least_counted + price <= best_benefit_) {
      node.excluded.push_back(row);
    } else if (price > value.next && value.value - price + value.next <= best_benefit_) {
      node.included.push_back(row);
    }
  }
}

void CoverageTree::branch(NodeId id, const CoverNodeState& state) {
  const std::span<const double> x = programme_.prices();
  std::uint32_t best = 0;
  double best_score = -1;
  std::size_t free_rows = 0;
  for (std::uint32_t row = 0; row < state.rows.size(); ++row) {
    if (state.rows[row] != Row::kFree) continue;
    ++free_rows;
    const double share = std::clamp(x[row], 0.0, 1.0);
    const double score = share * (1 - share) + share * 1e-3;
    if (score > best_score) {
      best = row;
      best_score = score;
    }
  }
  if (state.chosen + free_rows <= k_ || state.chosen >= k_) {
    // Nothing is left to decide: one set.
    std::vector<std::uint32_t> rows;
    for (std::uint32_t row = 0; row < state.rows.size(); ++row) {
      if (state.rows[row] == Row::kChosen || (state.rows[row] == Row::kFree && state.chosen < k_)) {
        rows.push_back(row);
      }
    }
    if (rows.size() <= k_) offer(std::move(rows));
    return;
  }
  nodes_[id].branch_row = best;
  for (const bool chosen : {false, true}) {
    Node child;
    child.parent = id;
    child.depth = nodes_[id].depth + 1;
    child.row_chosen = chosen;
    child.bound = nodes_[id].bound;
    child.basis = nodes_[id].basis;
    nodes_.push_back(std::move(child));
    push(static_cast<NodeId>(nodes_.size() - 1));
  }
  nodes_[id].basis.reset();
}

void CoverageTree::offer(std::vector<std::uint32_t> rows) {
  std::ranges::sort(rows);
  if (!offered_.insert(rows).second) return;
  const Incidence& incidence = problem_.incidence;
  std::vector<std::uint32_t> times(problem_.weights.size(), 0);
  std::vector<bool> is_chosen(incidence.row_count(), false);
  const auto add = [&](std::uint32_t row) {
    is_chosen[row] = true;
    for (const std::uint32_t column : incidence.columns_of(row)) ++times[column];
  };
  const auto remove = [&](std::uint32_t row) {
    is_chosen[row] = false;
    for (const std::uint32_t column : incidence.columns_of(row)) --times[column];
  };
  const auto weight_covered = [&](std::uint32_t row, std::uint32_t times_covered) {
    Benefit sum = 0;
    for (const std::uint32_t column : incidence.columns_of(row)) {
      if (times[column] == times_covered) sum += problem_.weights[column];
    }
    return sum;
  };
  const auto best_addition = [&] {
    std::uint32_t best = 0;
    Benefit best_gain = -1;
    for (std::uint32_t row = 0; row < is_chosen.size(); ++row) {
      if (is_chosen[row]) continue;
      const Benefit gain = weight_covered(row, 0);
      if (gain > best_gain) {
        best = row;
        best_gain = gain;
      }
    }
    return std::pair(best, best_gain);
  };
  for (const std::uint32_t row : rows) add(row);
  while (rows.size() < k_) {
    rows.push_back(best_addition().first);
    add(rows.back());
  }
  // Each row in turn is exchanged for the best one, until none in k turns has helped.
  for (std::size_t place = 0, idle = 0; idle < rows.size() && rows.size() < is_chosen.size();
       place = (place + 1) % rows.size()) {
    const Benefit loss = weight_covered(rows[place], 1);
    remove(rows[place]);
    const auto [row, gain] = best_addition();
    idle = gain > loss ? 0 : idle + 1;
    if (gain > loss) rows[place] = row;
    add(rows[place]);
  }
  std::ranges::sort(rows);
  const Benefit benefit = problem_.covered(rows);
  if (benefit <= best_benefit_) return;
  best_benefit_ = benefit;
  best_ = std::move(rows);
}

}  // namespace viewcover
