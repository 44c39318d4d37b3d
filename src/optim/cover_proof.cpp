#include "optim/cover_proof.h"

#include <ostream>
#include <unordered_map>

#include "optim/check_cover_proof.h"

namespace viewcover {
namespace {

const char* keyword(ReductionStep::Kind kind) {
  switch (kind) {
    case ReductionStep::Kind::kColumn:
      return "column ";
    case ReductionStep::Kind::kRow:
      return "row ";
    case ReductionStep::Kind::kTake:
      return "take ";
  }
  return "";
}

void write_dual(std::ostream& out, const CoverDual& dual) {
  out << "dual " << dual.denominator;
  for (const auto& [column, numerator] : dual.prices) out << ' ' << column + 1 << ':' << numerator;
  out << '\n';
}

}  // namespace

void write_cover_proof(std::ostream& out, const BitRows& matrix, const CoverProof& proof) {
  using Kind = CoverProof::Node::Kind;
  out << "viewcover-cover-proof 1\n"
      << "matrix " << matrix.rows() << ' ' << matrix.columns() << ' ' << matrix_hash(matrix) << '\n'
      << "bound " << proof.lower_bound << '\n';
  for (const ReductionStep& step : proof.steps) {
    out << keyword(step.kind) << step.subject + 1 << ' ' << step.reason + 1 << '\n';
  }
  std::unordered_map<std::uint32_t, std::size_t> numbers;  // of duals in the file
  for (const CoverProof::Component& component : proof.components) {
    out << "component " << component.bound;
    for (const std::uint32_t row : component.rows) out << ' ' << row + 1;
    out << '\n';
    for (const CoverProof::Node& node : component.nodes) {
      if (node.kind == Kind::kBranch) {
        out << "branch " << node.rows.front() + 1 << '\n';
        continue;
      }
      const auto [number, is_new] = numbers.emplace(node.dual, numbers.size() + 1);
      if (is_new) write_dual(out, proof.duals[node.dual]);
      out << (node.kind == Kind::kLeaf ? "leaf " : "without ") << number->second;
      if (node.kind == Kind::kWithout) {
        for (const std::uint32_t row : node.rows) out << ' ' << row + 1;
      }
      out << '\n';
    }
  }
  out << "end\n";
}

}  // namespace viewcover
