#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "links/visibility_backend.h"
#include "report/solution.h"

namespace viewcover {

/// Keys in the order they were put in.
using Json = nlohmann::ordered_json;

/// Wall-clock times of a run, seconds.
struct RunSeconds {
  double visibility = 0;
  double cover = 0;
  double viewpoints = 0;
  double total = 0;
  std::optional<double> wide = {};  ///< for what narrow gaps do not show, if asked for
};

/// What run.json says of a run before it starts: program, inputs with their SHA-256, seed, options
/// and what was repaired in the scene; `"complete": false`. Everything that may differ between
/// equal runs is under the key `measured`. Errors: InputError if an input cannot be read.
Json make_run_record(const std::filesystem::path& scene_file,
                     const std::filesystem::path& region_file, const Scene& scene,
                     std::uint64_t seed, const Json& options, int threads);

/// Adds results and counts of verdicts; `seconds` and the peak memory go to `measured`.
/// `"complete"` stays as it is.
void add_results(Json& record, const Solution& solution, Guarantee guarantee,
                 const RunSeconds& seconds);

/// The JSON object that `solve` prints last, from the record of a complete run. `viewpoints` is
/// null if none were looked for; `lower_bound` is null where the backend proves none.
Json summary_line(const Json& record);

/// The run.json of a finished run. Errors: InputError for a folder that has none, one that is
/// malformed, or a run that is not complete.
Json read_complete_run(const std::filesystem::path& folder);

/// Elements that some region sees.
std::size_t visible_elements(const VisibilityMatrix& matrix);

/// What was changed between the file and the scene, by name.
Json repairs_of(const Scene& scene);

}  // namespace viewcover
