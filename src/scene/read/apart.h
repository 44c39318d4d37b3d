#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace viewcover {

/// What became of a task in a process of its own.
struct Apart {
  enum class End { kDone, kThrew, kNoMemory, kNoTime, kCrashed };
  End end = End::kCrashed;
  std::string bytes;  ///< what the task returned, or the message of the exception that it threw
};

/// Runs a task of a library that foreign input can break in a copy of this process, whose crash
/// does no harm here. The copy is ended when its data exceeds `bytes` (beside sanitizers, which
/// need more) or its time on the processor `seconds`; it says nothing on standard error. It has
/// this thread alone, so the task must not wait for others. Errors: std::system_error if there can
/// be no copy.
Apart run_apart(const std::function<std::string()>& task, std::size_t bytes, unsigned seconds);

}  // namespace viewcover
