#pragma once

#include <cstdint>
#include <optional>

#include "links/point_shaft.h"
#include "links/shaft.h"
#include "links/visibility_backend.h"

namespace viewcover {

struct SegmentOptions {
  int most = 16;            ///< segments tried, at least 1
  std::uint64_t seed = 1;   ///< of the run; a shaft's generator depends on it and both addresses
  bool stratified = false;  ///< Latin hypercube samples instead of independent ones
};

struct SegmentCounts {
  int free = 0;                         ///< sight lines, certain
  int blocked = 0;                      ///< blocked, or too near an occluder to tell
  std::optional<SightLine> sight_line;  ///< the free one
};

/// Random segments between the region and the element of a shaft (paper, section 3), until one is
/// free.
///
/// A segment counts as free only if it misses every occluder by more than rounding could hide, in
/// clusters that were not opened too: free is certain. Requires an occluder left in the shaft.
/// Cost: segments x occluders. Thread-safe; the same for the same seed and addresses.
SegmentCounts try_random_segments(const Shaft& shaft, const SegmentOptions& options);

/// The same from a viewpoint; the shaft's target, where it has one, is tried before and not counted
/// among options.most. The generator depends on the seed, the viewpoint and the element's address.
SegmentCounts try_random_segments(const PointShaft& shaft, const SegmentOptions& options);

}  // namespace viewcover
