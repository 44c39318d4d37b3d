#pragma once

#include <string_view>

namespace viewcover {

/// Writes text to standard output and flushes it. Errors: InputError if that fails.
void print_out(std::string_view text);

/// Writes `viewcover: LINE` to standard error; line breaks inside become spaces.
void print_error_line(std::string_view line);

}  // namespace viewcover
