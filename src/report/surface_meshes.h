#pragma once

#include <filesystem>

#include "report/solution.h"

namespace viewcover {

/// Writes the elements as a coloured mesh, .ply or .om by suffix, as in the paper's figure 6: the
/// brighter, the more regions see an element; black ones are seen from nowhere.
/// Errors: InputError where the file cannot be written.
void write_surface_mesh(const Solution& solution, const std::filesystem::path& file);

}  // namespace viewcover
