#include "scene/read/apart.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <exception>
#include <new>
#include <string_view>
#include <system_error>

// GCC says it by a macro. It has no __has_feature, but some headers define one that is always 0.
#if defined(__SANITIZE_ADDRESS__)
#define VIEWCOVER_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define VIEWCOVER_SANITIZED
#endif
#endif

namespace viewcover {
namespace {

void write_all(int file, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) ::_exit(1);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

void set_limits([[maybe_unused]] std::size_t bytes, unsigned seconds) {
  const rlimit no_core{0, 0}, time{seconds, seconds + 1};
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::setrlimit(RLIMIT_CPU, &time);
#ifndef VIEWCOVER_SANITIZED
  const rlimit data{bytes, bytes};
  ::setrlimit(RLIMIT_DATA, &data);
#endif
  for (const int crash : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU}) {
    std::signal(crash, SIG_DFL);
  }
  const int nowhere = ::open("/dev/null", O_WRONLY);
  if (nowhere >= 0) ::dup2(nowhere, STDERR_FILENO);
}

/// The first byte says how it ended.
[[noreturn]] void run_copy(const std::function<std::string()>& task, int out) {
  Apart::End end = Apart::End::kDone;
  std::string bytes;
  try {
    bytes = task();
  } catch (const std::bad_alloc&) {
    end = Apart::End::kNoMemory;
  } catch (const std::exception& error) {
    end = Apart::End::kThrew;
    bytes = error.what();
  }
  const char first = static_cast<char>(end);
  write_all(out, {&first, 1});
  write_all(out, bytes);
  ::_exit(0);
}

std::string read_all(int file) {
  std::string bytes;
  std::array<char, 1 << 16> some;
  for (;;) {
    const ssize_t got = ::read(file, some.data(), some.size());
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return bytes;
    bytes.append(some.data(), static_cast<std::size_t>(got));
  }
}

}  // namespace

Apart run_apart(const std::function<std::string()>& task, std::size_t bytes, unsigned seconds) {
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0) throw std::system_error(errno, std::system_category());
  const ::pid_t copy = ::fork();
  if (copy == 0) {
    ::close(pipe[0]);
    set_limits(bytes, seconds);
    run_copy(task, pipe[1]);
  }
  const int error = errno;
  ::close(pipe[1]);
  if (copy < 0) {
    ::close(pipe[0]);
    throw std::system_error(error, std::system_category());
  }
  std::string said = read_all(pipe[0]);
  ::close(pipe[0]);
  int status = 0;
  while (::waitpid(copy, &status, 0) < 0 && errno == EINTR) {
  }
  Apart result;
  if (WIFSIGNALED(status)) {
    const int signal = WTERMSIG(status);
    if (signal == SIGXCPU || signal == SIGKILL) result.end = Apart::End::kNoTime;
  } else if (WEXITSTATUS(status) == 0 && !said.empty()) {
    result.end = static_cast<Apart::End>(said[0]);
    result.bytes = said.substr(1);
  }
  return result;
}

}  // namespace viewcover
