#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/backends.h"
#include "app/commands.h"
#include "report/run_record.h"

namespace viewcover {

/// The options of `solve` as text, where command-line parsing puts them.
struct SolveText {
  CommonOptions common;
  std::string scene_file, region_file, output;
  std::string backend{backends().front().name};
  std::string rays = "16", sampling = "plain", regions = "64", element_area;
  std::string optimizer, viewpoints = "sa", coverage = "elements", missed_share;
  std::string clearance = "0", time_limit, close_gap, lattice, heal, crop, aperture, memory_limit;
  std::string checkpoint = "10";
  std::vector<std::string> targets;
  bool one_sided = false, merge_coplanar = false, allow_outside = false, resume = false;

  /// Adds the options to the command.
  void add_to(CLI::App& command);
};

/// The options of `solve`, checked.
struct SolveOptions {
  std::filesystem::path scene_file, region_file, output;
  int threads = 1;
  std::uint64_t seed = 1;
  bool quiet = false;
  const BackendEntry* backend = nullptr;
  BackendOptions backend_options;
  std::size_t regions_per_part = 64;
  std::optional<double> element_area;  ///< default: from the scene
  std::string optimizer;
  bool one_sided = false;
  double clearance = 0;
  bool find_viewpoints = true;
  bool full_coverage = false;               ///< image all visible area, not a part of each element
  double missed_share = 1e-4;               ///< of the area imaged, that one more image may add
  double time_limit_seconds = 0;            ///< 0: none
  std::optional<double> close_gap_seconds;  ///< default: some rounds
  std::optional<int> lattice_exponent;
  bool merge_coplanar = false;
  double heal = 0;
  std::optional<Box> crop;
  double aperture = 0;  ///< width below which gaps are closed for a second look; 0: none
  std::vector<std::string> targets;  ///< none: all groups
  bool allow_outside = false;
  bool resume = false;             ///< continue what is in `output`
  double checkpoint_seconds = 10;  ///< from one save of the visibility so far to the next
  std::uint64_t memory_limit = 0;  ///< bytes; 0: none

  /// Errors: InputError for a value out of range or one that is not available.
  explicit SolveOptions(const SolveText& text);

  /// Every option that can change the result, for run.json; `element_area` as it was used.
  Json to_json(double used_element_area) const;
};

}  // namespace viewcover
