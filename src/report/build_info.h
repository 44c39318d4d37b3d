#pragma once

#include <string_view>

namespace viewcover {

/// What made this program, for run.json and `--version`.
struct BuildInfo {
  std::string_view version;  ///< such as "0.1.0"
  std::string_view commit;  ///< git commit, with "+" if the tree was changed; "unknown" without git
  std::string_view compiler;  ///< such as "GCC 12.2.0"
};

BuildInfo build_info();

}  // namespace viewcover
