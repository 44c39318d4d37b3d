#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace viewcover {

/// Shows on standard error how far a phase has come while it lives: phase, share, elapsed and
/// remaining time. A line redrawn in place on a terminal, else a plain line every few seconds.
class Progress {
 public:
  struct State {
    double share = 0;    ///< in [0, 1]
    std::string detail;  ///< such as "12,000 links"
  };

  /// `look` is called from another thread until the destructor has returned.
  Progress(std::string phase, std::function<State()> look, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

 private:
  void show(bool on_terminal, double elapsed) const;

  std::string phase_;
  std::function<State()> look_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool done_ = false;
  std::thread thread_;
};

}  // namespace viewcover
