#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace viewcover {

/// What is known about a shaft, and how (a verdict says how it is known).
enum class Verdict : std::uint8_t {
  kFullyVisible,          ///< no occluder meets the shaft
  kVisibleWitness,        ///< a free sight line was found; occluders may be in the shaft
  kAssumedVisible,        ///< nothing proves it hidden
  kHiddenNotFacing,       ///< region and element are coplanar, or the region is behind a one-sided
                          ///< element
  kHiddenByOne,           ///< one occluder blocks the whole shaft (exact)
  kHiddenBySet,           ///< several occluders together block it (proved)
  kHiddenAllRaysBlocked,  ///< every random ray was blocked: may be wrong
};
inline constexpr std::size_t kVerdictCount = 7;

constexpr bool is_visible(Verdict verdict) { return verdict <= Verdict::kAssumedVisible; }

/// The name used in links.csv and run.json, such as "hidden_by_one".
constexpr std::string_view name(Verdict verdict) {
  constexpr std::array<std::string_view, kVerdictCount> kNames = {
      "fully_visible", "visible_witness", "assumed_visible",        "hidden_not_facing",
      "hidden_by_one", "hidden_by_set",   "hidden_all_rays_blocked"};
  return kNames[static_cast<std::size_t>(verdict)];
}

}  // namespace viewcover
