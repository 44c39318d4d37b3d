#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "links/bit_rows.h"

namespace viewcover {

struct CoverProof;

/// Choose the fewest rows whose union is the union of all rows; a column counts with its weight.
///
/// Built from any 0/1 matrix: equal columns are merged with their weights summed, columns that no
/// row covers are left out. Merged columns keep the order of their first occurrence.
/// Immutable; concurrent reads are safe.
class CoverInstance {
 public:
  /// `weights`: one a column, >= 0, with a finite sum. Cost: O(#rows x #columns / 64 + #ones).
  CoverInstance(const BitRows& matrix, std::span<const double> weights);

  const BitRows& rows() const { return rows_; }                 ///< #rows x #merged columns
  std::span<const double> weights() const { return weights_; }  ///< of the merged columns
  double total_weight() const { return total_weight_; }         ///< of all coverable columns

  bool covers_all(std::span<const std::size_t> chosen) const;
  double covered_weight(std::span<const std::size_t> chosen) const;
  /// Share of total_weight(), in [0, 100]; 100 if the rows cover everything or nothing has weight.
  double covered_percent(std::span<const std::size_t> chosen) const;

  /// A proven lower bound on the number of rows of a cover: the size of a set of columns no two of
  /// which share a row, gathered greedily, columns of few rows first. 0 without columns.
  std::size_t lower_bound() const;
  /// No k rows cover more than this share of total_weight(): the k heaviest rows together, rounded
  /// upward. At most 100.
  double upper_bound_percent(std::size_t k) const;

 private:
  BitRows rows_;
  std::vector<double> weights_;
  double total_weight_ = 0;
  std::vector<double> heaviest_;  ///< row weights, descending
};

/// The best set found for one number of rows.
struct CoverStep {
  std::size_t k = 0;
  std::vector<std::size_t> chosen;   ///< row numbers, ascending, k of them
  double covered_percent = 0;        ///< of total_weight()
  double upper_bound_percent = 100;  ///< no k rows cover more (proven)
  std::uint64_t evaluations = 0;     ///< benefits computed for this k, or for the only step
  double seconds = 0;                ///< for this k, or for the only step
  /// No k rows have a greater benefit in the units of CoverState, by methods that prove it.
  bool proved = false;

  friend bool operator==(const CoverStep&, const CoverStep&) = default;
};

struct RegionCover {
  std::vector<CoverStep> steps;  ///< ascending in k; what they are depends on the goal
  std::size_t lower_bound = 0;   ///< proven, on the number of rows of a whole cover
  /// The last step covers everything coverable. Only `kOneK` ends with less.
  bool whole = true;
  /// The time limit ended the search. Sets that it kept from being searched are filled up greedily.
  bool time_limit_reached = false;
  /// Of lower_bound, for the instance's rows(), by methods that prove it (optim/cover_proof.h).
  std::shared_ptr<const CoverProof> proof;
  /// Different smallest covers, each ascending, at most CoverOptions::solutions of them.
  std::vector<std::vector<std::size_t>> solutions;
  bool solutions_complete = false;  ///< there are no other smallest covers

  /// Rows of the last step; 0 where nothing is coverable.
  std::size_t size() const { return steps.empty() ? 0 : steps.back().k; }
  /// True iff the last step is known to be a smallest whole cover.
  bool proved() const { return whole && size() == lower_bound; }
};

enum class CoverGoal {
  kEveryK,      ///< one step for each k = 1, 2, ... up to a whole cover
  kWholeCover,  ///< one step: a whole cover, as small as can be found
  kOneK,        ///< one step: the best k rows, or fewer if fewer are found to cover everything
};

/// A whole cover smaller than those found before.
struct BetterCover {
  std::vector<std::size_t> chosen;  ///< row numbers, ascending
  double seconds = 0;               ///< since the search began
};

struct CoverOptions {
  CoverGoal goal = CoverGoal::kEveryK;
  std::size_t k = 0;  ///< of `kOneK`; with 0 there are no steps
  /// How many different smallest covers are wanted in RegionCover::solutions; `exact` only.
  std::size_t solutions = 0;
  std::uint64_t seed = 1;
  double time_limit_seconds = 0;                      ///< 0: none
  const std::atomic<bool>* stop = nullptr;            ///< set from outside to end early
  bool stop_keeps_best = false;                       ///< `stop` ends as the time limit does
  std::function<void(const CoverStep&)> on_step;      ///< after each k that is searched
  std::function<void(const BetterCover&)> on_better;  ///< after each smaller whole cover
  std::function<void(std::size_t)> on_bound;          ///< after each rise of a proved lower bound
};

/// One method of choosing rows; methods are found by name (optim/cover_methods.h).
///
/// The result depends on the instance and options.seed only, unless a time limit strikes.
/// Thread-safety: concurrent calls on one object are allowed.
class CoverMethod {
 public:
  virtual ~CoverMethod() = default;
  virtual std::string_view name() const = 0;
  /// Best sets for options.goal: by default for k = 1, 2, ... until everything coverable is covered
  /// (paper, section 2.3). An instance without coverable columns gives no steps.
  /// The functions of `options` are called from the calling thread.
  /// Errors: Interrupted if options.stop is set, unless options.stop_keeps_best is.
  virtual RegionCover solve(const CoverInstance& instance, const CoverOptions& options) const = 0;

 protected:
  CoverMethod() = default;
  CoverMethod(const CoverMethod&) = default;
  CoverMethod& operator=(const CoverMethod&) = default;
};

}  // namespace viewcover
