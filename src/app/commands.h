#pragma once

#include <CLI/CLI.hpp>

namespace viewcover {

/// The options that every command has.
struct CommonOptions {
  std::string threads;  ///< empty: all cores
  std::string seed = "1";
  bool quiet = false;
};

/// `--crop`, which `solve`, `region` and `inspect` have.
constexpr const char* kCropHelp =
    "leave out the faces that lie wholly outside the box between two corners";
constexpr const char* kCropType = "X0,Y0,Z0,X1,Y1,Z1";

/// Adds `--threads`, `--seed` and `--quiet` to a command.
void add_common_options(CLI::App& command, CommonOptions& options);

/// The number of threads asked for; all cores by default. Errors: InputError.
int thread_count(const CommonOptions& options);

// Each adds one command with its options to `app`; once parsed, the command runs and leaves its
// exit code in `exit_code`. Errors while it runs: InputError, Interrupted.
void add_solve_command(CLI::App& app, int& exit_code);
void add_generate_command(CLI::App& app, int& exit_code);
void add_sees_command(CLI::App& app, int& exit_code);
void add_cover_command(CLI::App& app, int& exit_code);
void add_audit_command(CLI::App& app, int& exit_code);
void add_inspect_command(CLI::App& app, int& exit_code);
void add_region_command(CLI::App& app, int& exit_code);
void add_compare_command(CLI::App& app, int& exit_code);
void add_show_command(CLI::App& app, int& exit_code);
void add_verify_command(CLI::App& app, int& exit_code);

}  // namespace viewcover
