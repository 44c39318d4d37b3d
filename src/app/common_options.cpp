#include "app/commands.h"

namespace viewcover {

void add_common_options(CLI::App& command, CommonOptions& options) {
  command.add_option("--threads", options.threads, "threads to use (default: all cores)")
      ->type_name("N");
  command.add_option("--seed", options.seed, "seed of everything random (default: 1)")
      ->type_name("S");
  command.add_flag("--quiet", options.quiet, "no tables, notes and progress");
}

}  // namespace viewcover
