#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>

#include "scene/error.h"

namespace viewcover {

/// Ends a run before the system's memory is used up: while it lives, a thread looks at the resident
/// memory of the process. Beyond the limit it interrupts the run (app/interrupt.h); should the
/// memory grow on for an eighth, it ends the process with exit code 2 and one line, which is safe
/// at any moment (report/bundle.h).
class MemoryLimit {
 public:
  /// 0: none.
  explicit MemoryLimit(std::uint64_t bytes);
  ~MemoryLimit();
  MemoryLimit(const MemoryLimit&) = delete;
  MemoryLimit& operator=(const MemoryLimit&) = delete;

  bool reached() const { return reached_; }
  /// What to say then.
  static InputError error();

 private:
  void watch();

  std::uint64_t bytes_;
  std::atomic<bool> reached_ = false;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::thread thread_;
};

}  // namespace viewcover
