#pragma once

#include <cstdint>
#include <optional>

#include "links/sight_line.h"

namespace viewcover {

/// Random rays for a single question on no lattice: the first of up to `rays` segments, uniform
/// over region (or from the viewpoint) and element, that is a sight line. None if all are blocked,
/// which proves nothing. Same seed, same segments.
std::optional<Witness> find_sight_line(const ShaftPolygons& shaft, int rays, std::uint64_t seed);

}  // namespace viewcover
