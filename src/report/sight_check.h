#pragma once

#include <filesystem>
#include <vector>

#include "report/bundle_check.h"

namespace viewcover {

/// Asks again, in the scene, whether each viewpoint of a bundle sees the elements that
/// viewpoints.mtx says and, where the backend of the run was exact, no others: exactly, by the
/// audit's arithmetic (audit/seen_elements.h), which shares no step with the backends and knows
/// nothing of regions, links or occluder lists. What random rays found must be there; what they
/// missed is no contradiction.
///
/// No claims for a bundle without viewpoints. Cost: about 15 ms a viewpoint for a room of 316
/// polygons. Uses all threads of the current TBB arena. Errors: as `load_bundle_scene`, and
/// InputError for files that cannot be read.
std::vector<BundleClaim> check_sights(const std::filesystem::path& folder,
                                      const std::filesystem::path& scene_file = {});

}  // namespace viewcover
