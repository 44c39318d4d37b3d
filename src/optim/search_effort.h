#pragma once

#include <cmath>
#include <cstdint>
#include <limits>

#include "optim/search_limits.h"

namespace viewcover {

/// How long one of the searches that a method consists of may take. With a time limit: a share of
/// what is left of it. Without: until so much work, in entries of the matrix touched, was done
/// since the last success; then the end of the search does not depend on the machine.
class SearchEffort {
 public:
  /// `work`: done before the search.
  SearchEffort(SearchLimits& limits, double share, std::uint64_t patience, std::uint64_t work)
      : limits_(&limits),
        end_(limits.seconds() + share * limits.seconds_left()),
        patience_(patience),
        work_at_success_(work),
        next_look_(work) {}

  /// The same work with and without a time limit.
  SearchEffort(SearchLimits& limits, std::uint64_t patience, std::uint64_t work)
      : limits_(&limits),
        end_(std::numeric_limits<double>::infinity()),
        patience_(patience),
        work_at_success_(work),
        next_look_(work) {}

  /// Errors: Interrupted if the stop flag is set.
  bool spent(std::uint64_t work) {
    if (!spent_ && work >= next_look_) {
      next_look_ = work + kWorkPerLook;
      spent_ = limits_->expired() || (std::isfinite(end_) ? limits_->seconds() >= end_
                                                          : work - work_at_success_ >= patience_);
    }
    return spent_;
  }
  /// True iff the time limit was what ended the search.
  bool cut_short() const { return spent_ && std::isfinite(end_); }
  void succeeded(std::uint64_t work) { work_at_success_ = work; }

 private:
  /// Work between two looks at clock and stop flag: some hundredths of a millisecond.
  static constexpr std::uint64_t kWorkPerLook = 10000;

  SearchLimits* limits_;
  double end_;
  std::uint64_t patience_;
  std::uint64_t work_at_success_;
  std::uint64_t next_look_;
  bool spent_ = false;
};

}  // namespace viewcover
