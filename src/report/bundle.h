#pragma once

#include <filesystem>
#include <string_view>

#include "report/run_record.h"
#include "report/solution.h"

namespace viewcover {

/// The result folder of a run (its files: tables.h, scene_vtp.h, run_record.h). From creation until
/// complete() its run.json says `"complete": false`, whatever happens to the process.
///
/// Every file appears whole under its name or not at all. Errors, from any call: InputError with
/// the path and the system's reason; the bundle then stays incomplete.
class Bundle {
 public:
  /// Makes the folder if needed. A bundle already there is made incomplete before anything else
  /// of it changes; then what a killed run left half written goes.
  Bundle(std::filesystem::path folder, Json record);

  /// Writes all tables and pictures of the scene.
  void write(const Solution& solution) const;

  /// The last step: run.json with the record's results and `"complete": true`.
  void complete(const Solution& solution, Guarantee guarantee, const RunSeconds& seconds);
  /// Leaves the bundle incomplete, with the reason in run.json under `measured`.
  void abandon(std::string_view reason);

  const std::filesystem::path& folder() const { return folder_; }
  /// As it stands in run.json.
  const Json& record() const { return record_; }

 private:
  void write_record() const;

  std::filesystem::path folder_;
  Json record_;
};

}  // namespace viewcover
