#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "scene/read/polygon_soup.h"

namespace viewcover {

/// Leaves out the faces whose bounding boxes do not meet a closed box, and the vertices that no
/// other face has. Faces that stay are not cut. Returns how many faces are gone.
/// Errors: InputError at `--crop` if none is left.
std::size_t crop(PolygonSoup& soup, const Box& box);

/// What lies far from the rest of a soup. As the lattice has 24 bits for the largest coordinate,
/// one such face makes it coarse everywhere.
struct FarOut {
  std::vector<std::uint32_t> faces;     ///< of the soup
  std::vector<std::uint32_t> vertices;  ///< their corners, ascending
  double step_without = 0;              ///< lattice step without these faces; 0 if none is left
};

/// Faces that reach more than 40 times as far from the middle (the median along each axis) as 60 %
/// of the faces do. Cost: linear.
FarOut find_far_out(const PolygonSoup& soup);

/// One line that names the faces and what they do to the lattice; empty where they do not make it
/// coarser by 8 or more.
std::string far_out_warning(const PolygonSoup& soup, const FarOut& far_out, double step);

}  // namespace viewcover
