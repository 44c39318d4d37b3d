#include "optim/linear_program.h"

#include <ClpDualRowSteepest.hpp>
#include <ClpEventHandler.hpp>
#include <ClpSimplex.hpp>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace viewcover {
namespace {

/// Iterations between two looks at the limits.
constexpr int kIterationsPerLook = 16;

/// A second brake for what passes between two iterations; its grain is what a
/// run may last beyond the limit.
void limit_seconds(ClpSimplex& simplex, const SearchLimits& limits) {
  constexpr double kGrain = 0.1;
  const double left = limits.seconds_left();
  simplex.setMaximumWallSeconds(std::isfinite(left) ? left + kGrain : -1.0);
}

/// Ends a simplex run when the limits say so; exceptions do not pass through the solver.
class LimitWatch : public ClpEventHandler {
 public:
  explicit LimitWatch(const SearchLimits* limits) : limits_(limits) {}
  int event(Event which) override {
    constexpr int kGoOn = -1, kStop = 5;
    if (which != endOfIteration || limits_ == nullptr) return kGoOn;
    return ++iterations_ % kIterationsPerLook == 0 && limits_->due() ? kStop : kGoOn;
  }
  ClpEventHandler* clone() const override { return new LimitWatch(*this); }

 private:
  const SearchLimits* limits_;
  int iterations_ = 0;
};

}  // namespace

class LinearProgram::Simplex : public ClpSimplex {};

LinearProgram::LinearProgram(std::span<const Variable> variables,
                             std::span<const double> right_hand_sides)
    : simplex_(std::make_unique<Simplex>()) {
  std::vector<int> starts{0}, rows;
  std::vector<double> coefficients, lower, upper, cost;
  for (const Variable& variable : variables) {
    assert(variable.rows.size() == variable.coefficients.size());
    rows.insert(rows.end(), variable.rows.begin(), variable.rows.end());
    coefficients.insert(coefficients.end(), variable.coefficients.begin(),
                        variable.coefficients.end());
    starts.push_back(static_cast<int>(rows.size()));
    lower.push_back(variable.lower);
    upper.push_back(variable.upper);
    cost.push_back(variable.cost);
  }
  simplex_->setLogLevel(0);
  simplex_->scaling(0);  // coefficients are 1 and -1; scaling would be done anew for every solution
  // Exact weights from the first iteration on: after a change of bounds the dual simplex takes a
  // third to two thirds of the iterations that it takes with weights of 1.
  constexpr int kExactWeights = 1;
  ClpDualRowSteepest steepest(kExactWeights);
  simplex_->setDualRowPivotAlgorithm(steepest);
  simplex_->loadProblem(static_cast<int>(variables.size()),
                        static_cast<int>(right_hand_sides.size()), starts.data(), rows.data(),
                        coefficients.data(), lower.data(), upper.data(), cost.data(),
                        right_hand_sides.data(), nullptr);
}

LinearProgram::~LinearProgram() = default;
LinearProgram::LinearProgram(LinearProgram&&) noexcept = default;
LinearProgram& LinearProgram::operator=(LinearProgram&&) noexcept = default;

void LinearProgram::set_bounds(std::size_t variable, double lower, double upper) {
  simplex_->setColumnBounds(static_cast<int>(variable), lower, upper);
}

void LinearProgram::set_right_hand_side(std::size_t constraint, double value) {
  simplex_->setRowLower(static_cast<int>(constraint), value);
}

LinearProgram::Status LinearProgram::solve_dual(SearchLimits& limits, double limit) {
  if (limits.expired()) return Status::kNone;
  LimitWatch watch(&limits);
  simplex_->passInEventHandler(&watch);
  limit_seconds(*simplex_, limits);
  simplex_->setDualObjectiveLimit(limit);
  simplex_->dual();
  limits.expired();
  if (simplex_->isProvenOptimal()) return Status::kOptimal;
  return simplex_->isDualObjectiveLimitReached() ? Status::kAboveLimit : Status::kNone;
}

LinearProgram::Status LinearProgram::solve_primal(SearchLimits& limits) {
  if (limits.expired()) return Status::kNone;
  LimitWatch watch(&limits);
  simplex_->passInEventHandler(&watch);
  limit_seconds(*simplex_, limits);
  simplex_->setDualObjectiveLimit(kInfinity);
  simplex_->primal();
  limits.expired();
  return simplex_->isProvenOptimal() ? Status::kOptimal : Status::kNone;
}

double LinearProgram::objective() const { return simplex_->objectiveValue(); }

std::span<const double> LinearProgram::solution() const {
  return {simplex_->primalColumnSolution(), static_cast<std::size_t>(simplex_->numberColumns())};
}

std::span<const double> LinearProgram::prices() const {
  return {simplex_->dualRowSolution(), static_cast<std::size_t>(simplex_->numberRows())};
}

LinearProgram::Basis LinearProgram::basis() const {
  const unsigned char* const status = simplex_->statusArray();
  return {status, status + simplex_->numberColumns() + simplex_->numberRows()};
}

void LinearProgram::set_basis(const Basis& basis) { simplex_->copyinStatus(basis.data()); }

}  // namespace viewcover
