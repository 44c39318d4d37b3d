#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "report/bundle_check.h"
#include "scene/error.h"

namespace viewcover {
namespace {

constexpr int kDone = 0, kContradicted = 3;

struct VerifyOptions {
  CommonOptions common;
  std::string folder;
};

int verify(const VerifyOptions& options) {
  if (options.folder.empty()) throw InputError("DIR", "is missing", "give the folder of a run");
  bool all_hold = true;
  for (const BundleClaim& claim : check_bundle(options.folder)) {
    all_hold = all_hold && claim.holds();
    if (!claim.holds()) {
      print_error_line(options.folder + ": not true that " + claim.claim + ": " +
                       claim.contradiction);
    } else if (!options.common.quiet) {
      print_out("holds: " + claim.claim + "\n");
    }
  }
  return all_hold ? kDone : kContradicted;
}

}  // namespace

void add_verify_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<VerifyOptions>();
  CLI::App* const command = app.add_subcommand(
      "verify", "recompute what the results of a run claim; exit code 3 if one fails");
  command->add_option("folder", options->folder, "the folder of the run")->type_name("DIR");
  add_common_options(*command, options->common);
  command->callback([options, &exit_code] { exit_code = verify(*options); });
}

}  // namespace viewcover
