#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "compare/common_elements.h"
#include "show/colour.h"

namespace viewcover {

/// What the colour of an element tells.
enum class ColourBy {
  kTimesVisible,  ///< how many regions see it
  kCoveredBy,     ///< how many of the chosen regions see it
  kViewpoints,    ///< how many of the viewpoints see it
  kDifference,    ///< how many regions see it in one run only
  kGroup,         ///< its group
  kUnseen,        ///< not seen, seen by one region only, or by more
};

/// The names as options have them: `times_visible`, `covered_by`, ...
std::span<const std::string_view> colour_by_names();
std::optional<ColourBy> colour_by_named(std::string_view name);

struct LegendEntry {
  Colour colour;
  std::string text;
};

/// A colour for each shown element, and what the colours mean.
struct Shading {
  std::vector<Colour> colours;
  std::string title;                 ///< of the legend
  std::vector<LegendEntry> entries;  ///< apart from the ramp
  std::uint32_t ramp_end = 0;        ///< if > 0: ramp(0) is 1, ramp(1) this number
};

/// Errors: InputError at `--colour-by` for a difference without a second run and for viewpoints
/// where there are none.
Shading shade(const RunData& run, const CommonElements& shown, ColourBy by);

}  // namespace viewcover
