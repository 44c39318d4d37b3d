#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace viewcover {

/// What a user can mend: a bad file, a bad option, a place that cannot be written.
///
/// `what()` is one line, `PLACE: what is wrong; what would be right`, where PLACE is `FILE:LINE`,
/// `FILE: face N` (1-based, where a format has no lines), `FILE` or `--option`.
/// The command line prints it after `viewcover: ` and exits with 2.
class InputError : public std::runtime_error {
 public:
  InputError(std::string_view place, std::string_view what_is_wrong, std::string_view what_is_right)
      : std::runtime_error(compose(place, what_is_wrong, what_is_right)) {}

  /// The place of line `line` (1-based) of `file`.
  static std::string at_line(std::string_view file, std::size_t line) {
    return std::string(file) + ":" + std::to_string(line);
  }
  /// The place of face `face` (1-based) of `file`.
  static std::string at_face(std::string_view file, std::size_t face) {
    return std::string(file) + ": face " + std::to_string(face);
  }

 private:
  static std::string compose(std::string_view place, std::string_view wrong,
                             std::string_view right) {
    std::string line(place);
    line.append(": ").append(wrong);
    if (!right.empty()) line.append("; ").append(right);
    return line;
  }
};

/// The user asked to stop (Ctrl-C). The command line marks the bundle incomplete and exits with
/// 130.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

}  // namespace viewcover
