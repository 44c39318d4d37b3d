#pragma once

#include <atomic>

namespace viewcover {

/// From now on the first SIGINT or SIGTERM sets interrupt_flag(), a second one ends the process;
/// SIGXFSZ and SIGPIPE are ignored, so that writing fails with a reason instead.
void install_signal_handlers();

/// Set by the first SIGINT or SIGTERM and by interrupt(), never reset.
const std::atomic<bool>& interrupt_flag();

/// Does what the first SIGINT does. Thread-safe.
void interrupt();

/// While it lives, an interrupt also sets `target`, at once if it has come already. One at a time.
class ForwardInterrupt {
 public:
  explicit ForwardInterrupt(std::atomic<bool>& target);
  ~ForwardInterrupt();
  ForwardInterrupt(const ForwardInterrupt&) = delete;
  ForwardInterrupt& operator=(const ForwardInterrupt&) = delete;
};

}  // namespace viewcover
