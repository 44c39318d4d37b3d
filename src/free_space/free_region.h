#pragma once

#include <array>
#include <optional>
#include <vector>

#include "scene/scene.h"
#include "scene/viewing_region.h"

namespace viewcover {

struct FreeRegionOptions {
  int up_axis = 2;            ///< 0, 1 or 2: x, y or z is up
  double height = 0;          ///< of the cameras, along that axis
  double clearance = 0;       ///< least distance of a camera from any surface
  std::optional<Point> seed;  ///< a place from where the region must be reachable; its height
                              ///< does not count. None: the largest connected part
};

/// Where a camera may be at one height: a part of a horizontal plane.
struct FreeRegion {
  std::vector<ConvexPolygon>
      parts;               ///< strictly convex, interiors disjoint, on the scene's lattice
  double area = 0;         ///< of the parts
  double left_out = 0;     ///< area of slivers that are not among the parts
  std::size_t holes = 0;   ///< obstacles that the region surrounds
  std::size_t others = 0;  ///< connected parts that cannot be reached from it
  double area_of_others = 0;
};

/// The free horizontal space at camera height that is connected with the seed: the scene's bounding
/// rectangle without what is nearer to a surface than the clearance, split into convex parts.
///
/// Surfaces between height - clearance and height + clearance are projected and grown by octagons
/// round discs of the clearance and of a few lattice steps, so every place of the region keeps the
/// clearance in space, for rounding too; the region ends up to 8 % of the clearance early. Unions
/// are exact (CGAL Boolean set operations); corners are rounded to the lattice.
///
/// Errors: InputError at `--height` for one outside the scene and where no free space is left, at
/// `--seed-point` for a place that is not free, at `--clearance` for a negative one.
/// Cost: O(n log n) for n surfaces near that height, about 0.1 s for 300. Thread-safe.
FreeRegion find_free_region(const Scene& scene, const FreeRegionOptions& options);

struct FreeBoxOptions {
  int up_axis = 2;                            ///< 0, 1 or 2: x, y or z is up
  double low = 0, high = 0;                   ///< heights between which the cameras are
  double clearance = 0;                       ///< least distance of a camera from any surface
  std::optional<Point> seed;                  ///< as for FreeRegionOptions
  std::array<std::size_t, 3> cells{4, 4, 1};  ///< of the grid, along x, y and z
};

/// Where a camera may be between two heights: boxes of a grid.
struct FreeBoxes {
  std::vector<Box> boxes;  ///< on the scene's lattice, interiors disjoint, in the order of the grid
  double area = 0;         ///< that they cover in plan
  double left_out = 0;     ///< free area in plan of boxes of the grid that are not wholly free
  std::size_t others = 0;  ///< as for FreeRegion
  double area_of_others = 0;
};

/// The boxes of a regular grid that lie wholly in the free space between two heights that is
/// connected with the seed. Free is what of the plan no surface between the heights, grown by the
/// clearance, projects to (as for `find_free_region`); the grid divides the bounding rectangle of
/// that area and the space between the heights, rounded, at its border inward, by less than 1/64 of
/// the shortest side of a cell.
///
/// Errors: InputError at `--volume` for heights outside the scene, out of order or less than a
/// lattice step apart and where no free space is left; at `--cells` for a grid of which no box is
/// free, or that is finer than the lattice; `--seed-point` and `--clearance` as above.
/// Cost: as for `find_free_region`, and about 1 ms a box of one layer. Thread-safe.
FreeBoxes find_free_boxes(const Scene& scene, const FreeBoxOptions& options);

}  // namespace viewcover
