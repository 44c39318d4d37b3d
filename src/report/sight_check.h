#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "report/bundle_check.h"

namespace viewcover {

/// Asks again, in the scene, what the matrices of a bundle with viewpoints say: exactly, by the
/// audit's arithmetic (audit/seen_elements.h), which shares no step with the backends and knows
/// nothing of regions, links or occluder lists.
///  - Each viewpoint sees the elements that viewpoints.mtx says; where the backend of the run was
///    exact, no others. What random rays missed is no contradiction.
///  - Of an exact run: what random positions in regions see, visibility.mtx says of these regions;
///    what random positions in cells of the bound see of the elements that bound.mtx is about, it
///    says of these cells. So hidden pairs, on which the lower bounds rest, are sampled.
///  - Of an exact run with an aperture: the same for visibility-wide.mtx in the scene with the gaps
///    of gaps.csv closed.
///
/// No claims for a bundle with neither viewpoints nor gaps. Cost: about 15 ms a viewpoint or
/// position for a room of 316 polygons, up to 32 positions in regions, in cells and with gaps
/// closed. Uses all threads of the current TBB arena. Errors: as `load_bundle_scene`, and
/// InputError for files that cannot be read.
std::vector<BundleClaim> check_sights(const std::filesystem::path& folder,
                                      const std::filesystem::path& scene_file = {},
                                      std::uint64_t seed = 1);

}  // namespace viewcover
