#pragma once

#include <filesystem>
#include <optional>

#include "show/camera.h"

namespace viewcover {

struct ShowQueryOptions {
  std::filesystem::path file;    ///< queries as those of `sees`
  std::filesystem::path folder;  ///< where pictures go
  bool skeleton = false, one_sided = false;
  std::optional<ViewDirection> view;
  PixelSize size;
};

/// Draws query N of the file, counted from 1, as `query_N.png` and prints one JSON object for each,
/// `{"id", "figure"}` or `{"id", "error"}`. Returns the exit code: 2 if one was bad.
/// Errors: InputError for a file that cannot be read and pictures that cannot be written.
int show_queries(const ShowQueryOptions& options);

}  // namespace viewcover
