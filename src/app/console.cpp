#include "app/console.h"

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include "scene/error.h"

namespace viewcover {

void print_out(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) {
    return;
  }
  throw InputError("standard output",
                   "cannot be written: " + std::generic_category().message(errno), "");
}

void print_error_line(std::string_view line) {
  std::string text = "viewcover: ";
  for (const char character : line) {
    text += character == '\n' || character == '\r' ? ' ' : character;
  }
  text += '\n';
  std::fwrite(text.data(), 1, text.size(), stderr);
}

}  // namespace viewcover
