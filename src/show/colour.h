#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace viewcover {

/// sRGB, 8 bits a channel.
struct Colour {
  std::uint8_t red = 0, green = 0, blue = 0;

  friend bool operator==(Colour, Colour) = default;
};

/// Text and outlines.
inline constexpr Colour kInk{30, 32, 36};

/// a at 0, b at 1, in between linear in sRGB.
Colour mixed(Colour a, Colour b, double t);

/// Colours in growing lightness for t in [0, 1], dark blue to pale yellow: one order in colour, in
/// grey and for any kind of colour blindness. Never as dark as black.
Colour ramp(double t);
/// For what one run sees and another misses: pale to deep orange, for t in [0, 1].
Colour missed_ramp(double t);
/// The other way round: pale to deep blue.
Colour excess_ramp(double t);

/// Well-apart colours for names (Okabe and Ito, without black, lightened): the same again after
/// the last.
Colour category(std::size_t number);

inline constexpr Colour kNeverSeen{0, 0, 0};
inline constexpr Colour kUnchanged{206, 206, 202};     ///< element that nothing is said of
inline constexpr Colour kRegionColour{72, 72, 76};     ///< the viewing region
inline constexpr Colour kChosenColour{150, 150, 154};  ///< chosen regions
inline constexpr Colour kViewpointColour{245, 245, 245};
inline constexpr Colour kHardlySeen{213, 94, 0};  ///< seen by one region only

}  // namespace viewcover
