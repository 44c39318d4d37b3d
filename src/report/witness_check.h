#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "report/bundle_check.h"

namespace viewcover {

struct WitnessCheckOptions {
  std::filesystem::path scene_file;  ///< where the scene of the run has moved; empty: it has not
  std::uint64_t seed = 1;            ///< of the random positions
  std::size_t most_segments = 400'000;
};

/// Asks again what full coverage claims of its witnesses: that each lies in its element, on no
/// other surface and in the plane of no region, that some viewpoint sees each, and that cells of
/// the bound do not see those that bound.mtx says they do not: random positions in such a cell must
/// be blocked. Each segment is compared exactly with all surfaces in turn, by no code that made the
/// claims.
///
/// No claims for a bundle without witnesses.csv. Cost: seconds. Uses all threads of the current TBB
/// arena. Errors: as `load_bundle_scene`, and InputError for files that cannot be read.
std::vector<BundleClaim> check_witnesses(const std::filesystem::path& folder,
                                         const WitnessCheckOptions& options = {});

}  // namespace viewcover
