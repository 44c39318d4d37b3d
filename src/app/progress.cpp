#include "app/progress.h"

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace viewcover {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

/// Often enough to look alive on a terminal, seldom enough for a log file.
constexpr auto kRedraw = 200ms;
constexpr auto kPlainLine = 5000ms;
/// A phase that is over sooner shows nothing.
constexpr auto kFirstLook = 500ms;
/// Below this share the remaining time is a guess out of nothing.
constexpr double kLeastShareForEstimate = 0.005;

std::string clock_time(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  if (whole >= 3600)
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

Progress::Progress(std::string phase, std::function<State()> look, bool quiet)
    : phase_(std::move(phase)), look_(std::move(look)) {
  if (quiet) return;
  thread_ = std::thread([this] {
    const bool on_terminal = ::isatty(STDERR_FILENO) == 1;
    const Clock::time_point start = Clock::now();
    Clock::time_point next = start + (on_terminal ? kFirstLook : kPlainLine);
    bool shown = false;
    std::unique_lock lock(mutex_);
    while (!wake_.wait_until(lock, next, [this] { return done_; })) {
      show(on_terminal, std::chrono::duration<double>(Clock::now() - start).count());
      shown = true;
      next = Clock::now() + (on_terminal ? kRedraw : kPlainLine);
    }
    if (shown && on_terminal) std::fputs("\r\x1b[K", stderr);
  });
}

Progress::~Progress() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void Progress::show(bool on_terminal, double elapsed) const {
  const State state = look_();
  std::string line =
      fmt::format("{}: {:.0f} %, {} elapsed", phase_, 100 * state.share, clock_time(elapsed));
  if (state.share > kLeastShareForEstimate) {
    line += fmt::format(", {} remaining", clock_time(elapsed * (1 - state.share) / state.share));
  }
  if (!state.detail.empty()) line += ", " + state.detail;
  // Not through fmt::print, which throws when standard error is closed.
  const std::string text = on_terminal ? "\r\x1b[K" + line : line + "\n";
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace viewcover
