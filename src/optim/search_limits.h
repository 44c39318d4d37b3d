#pragma once

#include <algorithm>
#include <limits>

#include "optim/region_cover.h"
#include "optim/stopwatch.h"
#include "scene/error.h"

namespace viewcover {

/// What ends a search from outside: the stop flag and the time limit of its options.
class SearchLimits {
 public:
  explicit SearchLimits(const CoverOptions& options)
      : stop_(options.stop),
        stop_keeps_best_(options.stop_keeps_best),
        time_limit_(options.time_limit_seconds) {}

  /// True once the time limit has passed, and from then on. Cost: a clock reading, with a limit.
  /// Errors: Interrupted if the stop flag is set and does not keep the best.
  bool expired() {
    if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) {
      if (!stop_keeps_best_) throw Interrupted();
      expired_ = true;
    }
    if (!expired_ && time_limit_ > 0) expired_ = watch_.seconds() >= time_limit_;
    return expired_;
  }
  /// Until the time limit; infinite without one, 0 once it has passed.
  double seconds_left() const {
    if (time_limit_ <= 0) return std::numeric_limits<double>::infinity();
    return expired_ ? 0 : std::max(0.0, time_limit_ - watch_.seconds());
  }
  /// Since construction.
  double seconds() const { return watch_.seconds(); }
  /// True iff expired() would say so or throw; changes nothing.
  bool due() const {
    if (stop_ != nullptr && stop_->load(std::memory_order_relaxed)) return true;
    return expired_ || (time_limit_ > 0 && watch_.seconds() >= time_limit_);
  }
  /// True iff some call of expired() said so.
  bool has_expired() const { return expired_; }

 private:
  const std::atomic<bool>* stop_;
  bool stop_keeps_best_;
  double time_limit_;
  Stopwatch watch_;
  bool expired_ = false;
};

}  // namespace viewcover
