#include <algorithm>
#include <thread>

#include "app/commands.h"
#include "app/option_values.h"

namespace viewcover {

int thread_count(const CommonOptions& options) {
  // More threads than any machine at hand has, few enough to start.
  constexpr std::uint64_t kMostThreads = 1024;
  return static_cast<int>(
      options.threads.empty()
          ? std::clamp<std::uint64_t>(std::thread::hardware_concurrency(), 1, kMostThreads)
          : count_option("--threads", options.threads, 1, kMostThreads));
}

void add_common_options(CLI::App& command, CommonOptions& options) {
  command.add_option("--threads", options.threads, "threads to use (default: all cores)")
      ->type_name("N");
  command.add_option("--seed", options.seed, "seed of everything random (default: 1)")
      ->type_name("S");
  command.add_flag("--quiet", options.quiet, "no tables, notes and progress");
}

}  // namespace viewcover
