#include <tbb/global_control.h>

#include <algorithm>
#include <iterator>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_codes.h"
#include "app/option_values.h"
#include "report/audit_check.h"
#include "report/bundle_check.h"
#include "report/sight_check.h"
#include "report/witness_check.h"
#include "scene/error.h"

namespace viewcover {
namespace {

struct VerifyOptions {
  CommonOptions common;
  std::string folder, scene;
};

std::vector<BundleClaim> checked_claims(const VerifyOptions& options) {
  const std::filesystem::path folder = options.folder;
  AuditCheckOptions audit;
  audit.scene_file = options.scene;
  audit.seed = count_option("--seed", options.common.seed, 0, UINT64_MAX);
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(thread_count(options.common)));
  std::vector<BundleClaim> claims = check_bundle(folder);
  std::ranges::move(check_sights(folder, options.scene, audit.seed), std::back_inserter(claims));
  std::ranges::move(check_witnesses(folder, {.scene_file = options.scene, .seed = audit.seed}),
                    std::back_inserter(claims));
  if (std::filesystem::exists(folder / "audit.csv")) {
    std::ranges::move(check_audit(folder, audit), std::back_inserter(claims));
  }
  return claims;
}

int verify(const VerifyOptions& options) {
  if (options.folder.empty()) throw InputError("DIR", "is missing", "give the folder of a run");
  bool all_hold = true;
  for (const BundleClaim& claim : checked_claims(options)) {
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
  command->add_option("--scene", options->scene, "the scene of the run, where it has moved")
      ->type_name("FILE");
  add_common_options(*command, options->common);
  command->callback([options, &exit_code] { exit_code = verify(*options); });
}

}  // namespace viewcover
