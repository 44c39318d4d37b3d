#include <algorithm>
#include <exception>
#include <new>
#include <string>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_codes.h"
#include "app/interrupt.h"
#include "report/build_info.h"
#include "scene/error.h"

namespace {

/// What was wrong with the command line, on one line.
std::string complaint(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  // A word in a command's place would only be reported as a command missing.
  const CLI::App* command = &app;
  for (int i = 1; i < argc; ++i) {
    const auto commands = command->get_subcommands([](const CLI::App*) { return true; });
    if (commands.empty() || argv[i][0] == '-') break;
    const auto named = std::ranges::find_if(
        commands, [&](const CLI::App* candidate) { return candidate->check_name(argv[i]); });
    if (named == commands.end()) {
      return std::string(argv[i]) + ": no such command; see viewcover --help";
    }
    command = *named;
  }
  return std::string(error.what()) + "; see viewcover --help";
}

}  // namespace

int main(int argc, char** argv) {
  using namespace viewcover;
  install_signal_handlers();
  CLI::App app(
      "How many images does a scene need so that every visible surface is in one of them, "
      "and where must they be taken?");
  app.name("viewcover");
  const BuildInfo build = build_info();
  app.set_version_flag("--version", "viewcover " + std::string(build.version) + " (" +
                                        std::string(build.commit) + ", " +
                                        std::string(build.compiler) + ")");
  app.require_subcommand(1);
  int exit_code = 0;
  add_solve_command(app, exit_code);
  add_generate_command(app, exit_code);
  add_sees_command(app, exit_code);
  add_cover_command(app, exit_code);
  add_audit_command(app, exit_code);
  add_inspect_command(app, exit_code);
  add_region_command(app, exit_code);
  add_compare_command(app, exit_code);
  add_show_command(app, exit_code);
  add_verify_command(app, exit_code);
  try {
    app.parse(argc, argv);
    return exit_code;
  } catch (const CLI::ParseError& error) {
    // Help and version come as errors with exit code 0, too.
    if (error.get_exit_code() == 0) return app.exit(error);
    print_error_line(complaint(app, error, argc, argv));
    return kBadInput;
  } catch (const Interrupted&) {
    print_error_line("interrupted");
    return kInterrupted;
  } catch (const InputError& error) {
    print_error_line(error.what());
  } catch (const std::bad_alloc&) {
    print_error_line("out of memory; use fewer regions or a larger --element-area");
  } catch (const std::exception& error) {
    print_error_line(error.what());
  }
  return kBadInput;
}
