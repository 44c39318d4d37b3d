#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "report/bundle_check.h"

namespace viewcover {

struct AuditCheckOptions {
  std::filesystem::path scene_file;  ///< where the scene of the run has moved; empty: it has not
  std::uint64_t seed = 1;            ///< of the random points
  std::size_t most_segments =
      1'000'000;  ///< random points x viewpoints, as near as 4 a point allow
};

/// Recomputes what audit.csv and audit.json of a bundle claim, by random points on all elements
/// that are classified exactly (report/audit_sampling.h), with no code that made the audit: imaged
/// shares by element and in total, numbers of images, and sums.
///
/// A claim that is true is called wrong with a probability of at most 2e-9 (6 sigma), by bounds
/// that hold for any number of samples: Chernoff's for an element, the level divided by the number
/// of elements (Bonferroni), Bernstein's and Hoeffding's for totals. What a claim of 0 or 1
/// excludes is never excused by chance.
///
/// Cost: seconds. Uses all threads of the current TBB arena. Errors: as `load_bundle_scene`, and
/// InputError for files that cannot be read.
std::vector<BundleClaim> check_audit(const std::filesystem::path& folder,
                                     const AuditCheckOptions& options = {});

}  // namespace viewcover
