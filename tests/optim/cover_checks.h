#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "optim/cover_methods.h"

namespace viewcover::reference {

inline RegionCover solve(std::string_view method, const BitRows& matrix,
                         const std::vector<double>& weights, const CoverOptions& options = {}) {
  return make_cover_method(method)->solve(CoverInstance(matrix, weights), options);
}

/// Checks all that a cover claims but optimality, with the original matrix only.
inline void expect_certificates(const BitRows& matrix, const std::vector<double>& weights,
                                const RegionCover& cover, const CoverOptions& options = {}) {
  const std::vector<BitRows::Word> all = matrix.union_of_all();
  const double total = weight_of(all, weights);
  const bool every_k = options.goal == CoverGoal::kEveryK;
  double before = 0;
  for (std::size_t i = 0; i < cover.steps.size(); ++i) {
    const CoverStep& step = cover.steps[i];
    const bool last = i + 1 == cover.steps.size();
    if (every_k) {
      ASSERT_EQ(step.k, i + 1);
    }
    ASSERT_EQ(step.chosen.size(), step.k);
    ASSERT_TRUE(std::ranges::is_sorted(step.chosen));
    ASSERT_EQ(std::ranges::adjacent_find(step.chosen), step.chosen.end());
    const std::vector<BitRows::Word> covered = matrix.union_of(step.chosen);
    if (total > 0) {
      ASSERT_NEAR(step.covered_percent, 100 * weight_of(covered, weights) / total, 1e-9);
    }
    ASSERT_GE(step.covered_percent, before);
    ASSERT_LE(step.covered_percent, step.upper_bound_percent);
    ASSERT_EQ(covered == all, last && cover.whole);
    before = step.covered_percent;
  }
  if (!every_k) {
    ASSERT_LE(cover.steps.size(), 1u);
  }
  if (options.goal == CoverGoal::kOneK) {
    ASSERT_LE(cover.size(), options.k);
    ASSERT_TRUE(cover.whole || cover.size() == options.k);
  } else {
    ASSERT_TRUE(cover.whole);
  }
  if (cover.whole) {
    ASSERT_LE(cover.lower_bound, cover.size());
  }
}

}  // namespace viewcover::reference
