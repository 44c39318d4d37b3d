#pragma once

#include <limits>
#include <span>

#include "links/occluder_set.h"
#include "links/shaft.h"
#include "scene/small_list.h"

namespace viewcover {

using ShaftOccluders = SmallList<ShaftOccluder, 96>;

inline constexpr std::size_t kOpenAll = std::numeric_limits<std::size_t>::max();

/// Shaft culling (paper, section 2.2): writes to `kept` what may meet the open shaft among the
/// candidates, in their order. Clusters outside the shaft are dropped whole; others are opened
/// until `limit` nodes are kept, and stand unopened after that. With `kOpenAll` only surfaces are
/// kept.
///
/// Returns true, with `kept` unfinished, as soon as one occluder blocks the whole shaft.
/// Cost: linear in the candidates and the clusters opened. Thread-safe.
bool cull(const Shaft& shaft, std::span<const ShaftOccluder> candidates, std::size_t limit,
          ShaftOccluders& kept);

}  // namespace viewcover
