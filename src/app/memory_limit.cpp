#include "app/memory_limit.h"

#include <unistd.h>

#include <chrono>

#include "app/console.h"
#include "app/exit_codes.h"
#include "app/interrupt.h"
#include "report/machine.h"

namespace viewcover {
namespace {

/// From one look to the next: a thread fills some 50 MB in that time.
constexpr std::chrono::milliseconds kInterval(20);

}  // namespace

MemoryLimit::MemoryLimit(std::uint64_t bytes) : bytes_(bytes) {
  if (bytes_ > 0) thread_ = std::thread([this] { watch(); });
}

MemoryLimit::~MemoryLimit() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

InputError MemoryLimit::error() {
  return {"--memory-limit", "reached, the bundle is marked incomplete",
          "use fewer regions or a larger --element-area, or continue with --resume and more "
          "memory"};
}

void MemoryLimit::watch() {
  std::unique_lock lock(mutex_);
  while (!wake_.wait_for(lock, kInterval, [this] { return done_; })) {
    const std::uint64_t used = resident_memory();
    if (used > bytes_ && !reached_) {
      reached_ = true;
      interrupt();
    }
    if (used > bytes_ + bytes_ / 8) {
      print_error_line(error().what());
      ::_exit(kBadInput);
    }
  }
}

}  // namespace viewcover
