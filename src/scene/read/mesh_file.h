#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>

#include "scene/convex_polygon.h"

namespace viewcover {

/// Red, green, blue.
using Colour = std::array<std::uint8_t, 3>;

/// Writes polygons, one colour each, as .ply (binary) or .om (OpenMesh's own format), by suffix,
/// any case, through OpenMesh. Coordinates are of single precision in .ply, which holds the lattice
/// points of a scene exactly, and of double precision in .om.
///
/// Polygons share no vertices, and the colour of a polygon stands at its vertices and at its face:
/// so viewers that know colours of vertices only (MeshLab, ParaView) show them flat.
/// Errors: InputError for another suffix and for a file that cannot be written to its end; then
/// what was written of it is removed. Requires as many colours as polygons.
void write_mesh(const std::filesystem::path& file, std::span<const ConvexPolygon> polygons,
                std::span<const Colour> colours);

}  // namespace viewcover
