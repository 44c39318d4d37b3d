#pragma once

#include <cstddef>

#include "scene/types.h"

namespace viewcover {

/// A place to take an image from. It lies in its region exactly: the coordinates, taken as exact
/// numbers, are a combination of the corners (viewpoints/region_positions.h).
struct Viewpoint {
  Point position = Point::Zero();
  std::size_t region = 0;  ///< its number in the viewing region, from 0

  friend bool operator==(const Viewpoint&, const Viewpoint&) = default;
};

}  // namespace viewcover
