#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "links/link_set.h"
#include "report/run_record.h"

namespace viewcover {

/// How far the visibility of a run had come.
struct VisibilityState {
  std::size_t batches = 0;  ///< of its refinement (links/refine.h)
  LinkSet links;
  BackendStatistics statistics;
};

/// The visibility of an incomplete bundle, in its folder `checkpoint`: one file for each time it
/// was saved, with the links since the time before, whole or not there. Only `solve --resume` reads
/// it; it goes when the bundle is complete.
///
/// Errors, from any call: InputError with the path.
class Checkpoint {
 public:
  /// Of the bundle in `folder`.
  explicit Checkpoint(const std::filesystem::path& folder) : folder_(folder / "checkpoint") {}

  /// What was saved; nothing where nothing was. Later calls of save() go on from there.
  VisibilityState load();
  /// Requires the links that were saved before, and more. Cost: linear in those that are new.
  void save(std::size_t batches, const LinkSet& links, const BackendStatistics& statistics);
  void remove() const;

 private:
  std::filesystem::path file(std::size_t number) const;

  std::filesystem::path folder_;
  std::size_t files_ = 0, links_ = 0;
};

/// What is in a folder where a run is to be continued.
enum class RunState { kNone, kIncomplete, kComplete };

/// Compares the run.json of a folder with the record of a run that is to continue it. Paths of
/// input files may differ, their content not. Errors: InputError at `--resume` with the first
/// difference, and for a run.json that is malformed.
RunState state_of_run(const std::filesystem::path& folder, const Json& record);

}  // namespace viewcover
