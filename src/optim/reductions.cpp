#include "optim/reductions.h"

#include <algorithm>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <numeric>

namespace viewcover {
namespace {

using Word = BitRows::Word;
using Kind = ReductionStep::Kind;

/// A set of numbers below a fixed size.
class Members {
 public:
  explicit Members(std::size_t size) : bits_(1, size) { bits_.set_range(0, 0, size); }
  bool has(std::size_t member) const { return bits_.test(0, member); }
  void erase(std::size_t member) { bits_.row(0)[member / 64] &= ~(Word{1} << (member % 64)); }
  std::span<const Word> words() const { return bits_.row(0); }

 private:
  BitRows bits_;
};

/// The matrix both ways, and what of it remains.
class Reducer {
 public:
  explicit Reducer(const BitRows& matrix)
      : incidence_(matrix),
        row_bits_(matrix),
        column_bits_(matrix.columns(), matrix.rows()),
        rows_(matrix.rows()),
        columns_(matrix.columns()) {
    for (std::size_t row = 0; row < matrix.rows(); ++row) {
      for (const std::uint32_t column : incidence_.columns_of(row)) column_bits_.set(column, row);
    }
    for (std::size_t column = 0; column < matrix.columns(); ++column) {
      if (incidence_.rows_of(column).empty()) columns_.erase(column);
    }
  }

  bool drop_implied_columns() {
    const auto rows_of = [this](std::uint32_t column) { return incidence_.rows_of(column); };
    return drop(Kind::kColumn, rows_of, rows_, row_bits_, columns_, true);
  }
  bool drop_dominated_rows() {
    const auto columns_of = [this](std::uint32_t row) { return incidence_.columns_of(row); };
    return drop(Kind::kRow, columns_of, columns_, column_bits_, rows_, false);
  }
  bool take_essential_rows() {
    bool changed = false;
    for (std::uint32_t column = 0; column < incidence_.column_count(); ++column) {
      if (!columns_.has(column)) continue;
      const std::vector<std::uint32_t> rows = remaining(incidence_.rows_of(column), rows_);
      if (rows.size() != 1) continue;
      steps_.push_back({Kind::kTake, rows.front(), column});
      rows_.erase(rows.front());
      for (const std::uint32_t covered : incidence_.columns_of(rows.front()))
        columns_.erase(covered);
      changed = true;
    }
    return changed;
  }

  Reduction result() && {
    Reduction reduction;
    for (const ReductionStep& step : steps_) {
      if (step.kind == Kind::kTake) reduction.taken.push_back(step.subject);
    }
    std::ranges::sort(reduction.taken);
    reduction.components = components();
    reduction.steps = std::move(steps_);
    return reduction;
  }

  std::vector<std::uint32_t> remaining_rows() const {
    return remaining(all(row_bits_.rows()), rows_);
  }
  std::vector<std::uint32_t> remaining_columns() const {
    return remaining(all(column_bits_.rows()), columns_);
  }

 private:
  static std::vector<std::uint32_t> all(std::size_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0u);
    return numbers;
  }
  static std::vector<std::uint32_t> remaining(std::span<const std::uint32_t> numbers,
                                              const Members& members) {
    std::vector<std::uint32_t> kept;
    for (const std::uint32_t number : numbers) {
      if (members.has(number)) kept.push_back(number);
    }
    return kept;
  }

  /// Compares the things of `members`, each with a list of `crossing` things: one goes if another
  /// one has all it has (`supersets_go` false), or the other one does (true). `bits[x]`: the things
  /// that crossing thing x has.
  template <class ListOf>
  bool drop(Kind kind, ListOf&& list_of, const Members& crossing, const BitRows& bits,
            Members& members, bool supersets_go) {
    // Small ones first; of equal ones the first one stays.
    std::vector<std::uint32_t> order;
    std::vector<std::vector<std::uint32_t>> kept(bits.columns());
    for (std::uint32_t thing = 0; thing < kept.size(); ++thing) {
      if (!members.has(thing)) continue;
      kept[thing] = remaining(list_of(thing), crossing);
      order.push_back(thing);
    }
    if (!supersets_go) std::ranges::reverse(order);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t thing) { return kept[thing].size(); });
    bool changed = false;
    std::vector<Word> supersets;
    for (const std::uint32_t thing : order) {
      if (!members.has(thing)) continue;
      supersets.assign(members.words().begin(), members.words().end());
      supersets[thing / 64] &= ~(Word{1} << (thing % 64));
      for (const std::uint32_t other : kept[thing]) {
        Word any = 0;
        const std::span<const Word> with_other = bits.row(other);
        for (std::size_t w = 0; w < supersets.size(); ++w) {
          supersets[w] &= with_other[w];
          any |= supersets[w];
        }
        if (any == 0) break;
      }
      for_each_bit(supersets, [&](std::size_t superset) {
        const std::uint32_t other = static_cast<std::uint32_t>(superset);
        const std::uint32_t gone = supersets_go ? other : thing;
        if (!members.has(gone)) return;
        members.erase(gone);
        steps_.push_back({kind, gone, supersets_go ? thing : other});
        changed = true;
      });
    }
    return changed;
  }

  std::vector<CoverComponent> components() const {
    const std::size_t row_count = row_bits_.rows();
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> graph(row_count +
                                                                              column_bits_.rows());
    for (const std::uint32_t column : remaining_columns()) {
      for (const std::uint32_t row : remaining(incidence_.rows_of(column), rows_)) {
        boost::add_edge(row, row_count + column, graph);
      }
    }
    std::vector<std::size_t> component_of(boost::num_vertices(graph));
    boost::connected_components(graph, component_of.data());

    constexpr std::size_t kNone = static_cast<std::size_t>(-1);
    std::vector<std::size_t> place(component_of.size(), kNone);  // of a component in the result
    std::vector<CoverComponent> result;
    for (const std::uint32_t row : remaining_rows()) {
      if (boost::out_degree(row, graph) == 0) continue;
      std::size_t& at = place[component_of[row]];
      if (at == kNone) {
        at = result.size();
        result.emplace_back();
      }
      result[at].rows.push_back(row);
    }
    for (const std::uint32_t column : remaining_columns()) {
      result[place[component_of[row_count + column]]].columns.push_back(column);
    }
    std::vector<std::uint32_t> number(row_count);
    for (CoverComponent& component : result) {
      for (std::uint32_t i = 0; i < component.rows.size(); ++i) number[component.rows[i]] = i;
      std::vector<std::vector<std::uint32_t>> lists;
      for (const std::uint32_t column : component.columns) {
        lists.push_back(remaining(incidence_.rows_of(column), rows_));
        for (std::uint32_t& row : lists.back()) row = number[row];
      }
      component.incidence = Incidence(component.rows.size(), lists);
    }
    return result;
  }

  Incidence incidence_;
  BitRows row_bits_, column_bits_;
  Members rows_, columns_;
  std::vector<ReductionStep> steps_;
};

}  // namespace

Reduction reduce_cover(const BitRows& matrix) {
  Reducer reducer(matrix);
  bool changed = true;
  while (changed) {
    changed = reducer.drop_implied_columns();
    changed |= reducer.drop_dominated_rows();
    changed |= reducer.take_essential_rows();
  }
  return std::move(reducer).result();
}

std::vector<std::uint32_t> columns_without_implied(const BitRows& matrix) {
  Reducer reducer(matrix);
  reducer.drop_implied_columns();
  return reducer.remaining_columns();
}

std::vector<std::uint32_t> rows_without_dominated(const BitRows& matrix) {
  Reducer reducer(matrix);
  reducer.drop_dominated_rows();
  return reducer.remaining_rows();
}

}  // namespace viewcover
