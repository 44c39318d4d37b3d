#pragma once

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "scene/scratch_folder.h"

namespace viewcover::testing {

inline std::string read_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

/// A program that runs with its output in files.
class Process {
 public:
  struct Limits {
    std::optional<rlim_t> file_bytes;  ///< RLIMIT_FSIZE: stands in for a full disk
  };

  explicit Process(std::vector<std::string> arguments, Limits limits = {}) {
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);
    const std::string out = (folder_.path() / "out").string();
    const std::string error = (folder_.path() / "error").string();
    pid_ = ::fork();
    if (pid_ < 0) throw std::runtime_error("fork failed");
    if (pid_ > 0) return;
    // Only async-signal-safe calls from here on.
    const int out_file = ::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int error_file = ::open(error.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    ::dup2(out_file, STDOUT_FILENO);
    ::dup2(error_file, STDERR_FILENO);
    if (limits.file_bytes) {
      const rlimit limit{*limits.file_bytes, *limits.file_bytes};
      ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ::execv(argv[0], argv.data());
    ::_exit(127);
  }
  ~Process() {
    if (pid_ <= 0) return;
    ::kill(pid_, SIGKILL);
    wait();
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Nothing where it has ended: kill(0) would be for all processes of the group.
  void signal(int number) const {
    if (pid_ > 0) ::kill(pid_, number);
  }
  bool running() {
    if (pid_ > 0 && ::waitpid(pid_, &status_, WNOHANG) == pid_) pid_ = 0;
    return pid_ > 0;
  }
  /// The exit code; 128 + the signal's number if one ended the program, SIGKILL after ten minutes.
  int wait() {
    constexpr useconds_t kLook = 2000;  // microseconds
    for (int looks = 0; running(); ++looks) {
      if (looks == 300'000) signal(SIGKILL);
      ::usleep(kLook);
    }
    return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
  }
  /// What it has written so far.
  std::string out() const { return read_file(folder_.path() / "out"); }
  std::string error() const { return read_file(folder_.path() / "error"); }

 private:
  ScratchFolder folder_;
  ::pid_t pid_ = 0;
  int status_ = 0;
};

struct Outcome {
  int exit_code = 0;
  std::string out;
  std::string error;
};

/// Runs viewcover to its end.
inline Outcome viewcover_run(const std::vector<std::string>& arguments,
                             Process::Limits limits = {}) {
  std::vector<std::string> command;
  command.reserve(arguments.size() + 1);
  command.emplace_back(VIEWCOVER_BINARY);
  for (const std::string& argument : arguments) command.push_back(argument);
  Process process(std::move(command), limits);
  const int exit_code = process.wait();
  return {exit_code, process.out(), process.error()};
}

}  // namespace viewcover::testing
