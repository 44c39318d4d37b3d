#pragma once

#include <array>
#include <span>

#include "scene/generate/placement.h"
#include "scene/generate/scene_builder.h"

namespace viewcover {

/// Solids in the frame of a placement, with outward normals. Every face is strictly convex and
/// exactly planar for the coordinates as they are stored.

/// A ring of corners in whole numbers, counter-clockwise from above.
using Ring = std::span<const std::array<int, 2>>;

/// What rings and their scales are whole numbers of, in metres.
inline constexpr double kRingUnit = 1.0 / 256;

/// Octagon with all corners at distance 13.
inline constexpr std::array<std::array<int, 2>, 8> kOctagon = {
    {{12, 5}, {5, 12}, {-5, 12}, {-12, 5}, {-12, -5}, {-5, -12}, {5, -12}, {12, -5}}};
/// Hexagon with corners at distance 8 (to 1 %).
inline constexpr std::array<std::array<int, 2>, 6> kHexagon = {
    {{8, 0}, {4, 7}, {-4, 7}, {-8, 0}, {-4, -7}, {4, -7}}};

/// Axis-parallel box of the frame; 6 faces. REQUIRES: low < high in every coordinate.
void add_box(SceneBuilder& scene, const Placement& at, const Point& low, const Point& high);

/// Box with edges `a`, `b`, `c` from the corner `low`; 6 faces. REQUIRES: a, b, c right-handed.
void add_slanted_box(SceneBuilder& scene, const Placement& at, const Point& low, const Point& a,
                     const Point& b, const Point& c);

/// What closes a frustum.
enum class Caps { kNone, kBottom, kBoth };

/// Stands on the ring times `bottom`, tapers to the ring times `top`, both in units of 2^-8 m about
/// the vertical axis of the frame, from height `low` to `high`. As many faces as the ring has
/// corners, and the caps. The sides are exactly planar because both rings are multiples of one.
void add_frustum(SceneBuilder& scene, const Placement& at, Ring ring, int bottom, int top,
                 double low, double high, Caps caps);

/// How the front of a carcass is divided.
struct Compartments {
  int columns = 1;
  int rows = 1;
  double frame = 0.03;  ///< thickness of the boards seen from the front, metres
  double depth = 0;     ///< of a compartment, metres, less than that of the carcass
};

/// Box [0, width] x [0, depth] x [0, height] whose front (y = 0) has recessed compartments, closed
/// and watertight: 6 columns rows + 2 columns + 6 faces.
void add_carcass(SceneBuilder& scene, const Placement& at, const Point& size,
                 const Compartments& compartments);

/// The frame of compartment (column, row), row 0 at the bottom: its origin is the front left
/// corner of the compartment's floor. `inner` receives width, depth and height.
Placement compartment(const Placement& carcass, const Point& size, const Compartments& compartments,
                      int column, int row, Point& inner);

}  // namespace viewcover
