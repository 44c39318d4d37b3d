#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "scene/generate/generated_scene.h"
#include "scene/types.h"

namespace viewcover {

/// A corner of a floor plan and the line of the file that it stands on.
struct PlanCorner {
  Point position;  ///< z is 0
  std::size_t line = 0;
};
/// The first loop is the outer boundary, the others are holes; in either direction.
using FloorPlan = std::vector<std::vector<PlanCorner>>;

/// Reads a polygon: a corner `x y` a line; a blank line or one that says `hole` starts the next
/// loop; `#` starts a comment. A last corner that repeats the first of its loop is left out.
/// Errors: InputError for a file that cannot be read, anything but two finite numbers on a line,
/// and a loop of fewer than 3 corners.
FloorPlan read_floor_plan(const std::filesystem::path& file);
/// The same from the file's content; `file` names it in messages.
FloorPlan parse_floor_plan(std::string_view content, const std::string& file);

/// The art gallery of a floor plan: walls of the given height, a floor and a ceiling in convex
/// parts (groups `wall`, `floor` and `ceiling`, fronts inward); the viewing region is the plan at
/// half the height, in convex parts. Coordinates are rounded to the lattice on which they will be
/// loaded.
///
/// `file` names the plan in messages. Errors: InputError for loops that cross or touch themselves
/// or each other on that lattice, a hole that is not within the outer boundary or is within
/// another, and a height that is not positive or too small for the lattice.
/// Cost: O(n^2) for n corners, O(n^3) more a hole.
GeneratedScene gallery(const std::filesystem::path& file, FloorPlan plan, double height);

}  // namespace viewcover
