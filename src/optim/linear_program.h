#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "optim/search_limits.h"

namespace viewcover {

/// A linear programme, minimum of c x over lower <= x <= upper, A x >= b, solved by the simplex
/// method of COIN-OR CLP in floating point, warm-started from the basis of the last solution.
///
/// Nothing it says is a theorem: objective, solution and prices are hints that are rounded and then
/// checked in integers (optim/cover_dual.h, optim/coverage_bound.h).
/// Not safe for concurrent use; different objects are independent.
class LinearProgram {
 public:
  using Index = std::uint32_t;
  /// The state of a simplex tableau; small enough to be kept with every node of a tree.
  using Basis = std::vector<unsigned char>;

  enum class Status {
    kOptimal,
    kAboveLimit,  ///< the minimum is above the limit; prices are dual feasible
    kNone,        ///< infeasible, given up, or out of time: solution and prices say nothing
  };

  struct Variable {
    double cost = 0, lower = 0, upper = kInfinity;
    std::vector<Index> rows;           ///< constraints it appears in, without repetition
    std::vector<double> coefficients;  ///< one for each
  };
  static constexpr double kInfinity = 1e300;

  LinearProgram(std::span<const Variable> variables, std::span<const double> right_hand_sides);
  ~LinearProgram();
  LinearProgram(LinearProgram&&) noexcept;
  LinearProgram& operator=(LinearProgram&&) noexcept;

  void set_bounds(std::size_t variable, double lower, double upper);
  /// b of a constraint; -kInfinity switches it off.
  void set_right_hand_side(std::size_t constraint, double value);

  /// The dual simplex method: quick after changes of bounds and right-hand sides. May end early
  /// once the minimum is known to exceed `limit`.
  Status solve_dual(SearchLimits& limits, double limit = kInfinity);
  /// The primal simplex method: quick where the last solution is still feasible.
  Status solve_primal(SearchLimits& limits);

  double objective() const;
  std::span<const double> solution() const;  ///< x, one a variable
  std::span<const double> prices() const;    ///< dual variables, one a constraint

  Basis basis() const;
  void set_basis(const Basis& basis);

 private:
  class Simplex;
  std::unique_ptr<Simplex> simplex_;
};

}  // namespace viewcover
