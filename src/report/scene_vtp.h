#pragma once

#include <filesystem>

#include "report/solution.h"

namespace viewcover {

/// The viewpoints as vertices, then the elements and the viewing regions as polygons of a VTK XML
/// PolyData file in ASCII, for ParaView. Arrays over the cells:
///  - `kind`: 0 for an element, 1 for a region, 2 for a viewpoint
///  - `times_visible`: regions that see the element; 0 for others
///  - `covered_by`: chosen regions that see the element; 0 for others
///  - `chosen`: 1 for a chosen region or a viewpoint, 0 for everything else
///  - `surface`, `group`: 1-based numbers; 0 for all but elements
/// and, over the whole, `group_names`. Errors: InputError where the file cannot be written.
void write_scene_vtp(const Solution& solution, const std::filesystem::path& file);

}  // namespace viewcover
