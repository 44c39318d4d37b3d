#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <ostream>
#include <string>
#include <vector>

#include "scene/generate/gallery.h"

namespace viewcover::testing {

using Place = Eigen::Vector2d;
using Loop2 = std::vector<Place>;

/// A polygon whose art gallery number is known. All coordinates are multiples of 2^-10 below 2^6,
/// so that no lattice moves them.
struct GalleryCase {
  std::string name;
  Loop2 outer;                   ///< counter-clockwise
  std::vector<Loop2> holes;      ///< clockwise
  std::size_t optimum = 0;       ///< fewest points that see every point
  std::vector<Place> guards;     ///< so many, and they do
  std::vector<Place> witnesses;  ///< fewer points do not see all of these
  /// The guards see every wall from its front too, none along it only: then the optimum of walls
  /// and floor is that of the floor. False where the only guard is in line with a wall; it may
  /// stand on a corner then, where no viewpoint may be, and points near it miss as little as one
  /// likes.
  bool walls_too = true;
};

/// For messages of tests.
inline void PrintTo(const GalleryCase& gallery, std::ostream* out) { *out << gallery.name; }

/// Convex and star-shaped polygons, combs, staircases, corridors, spirals, holes; the source
/// derives each optimum, gallery_polygons_test.cpp checks guards and witnesses exactly.
std::vector<GalleryCase> gallery_cases();

/// As `viewcover generate gallery` reads it.
void write_floor_plan(const GalleryCase& gallery, const std::filesystem::path& file);
/// As it has been read; lines as in the file.
FloorPlan floor_plan_of(const GalleryCase& gallery);

}  // namespace viewcover::testing
