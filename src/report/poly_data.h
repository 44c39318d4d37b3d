#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "report/file_writer.h"
#include "scene/convex_polygon.h"

namespace viewcover {

/// A whole number for each polygon.
struct CellArray {
  std::string_view name;
  std::vector<std::uint32_t> values;
};

/// Polygons as a VTK XML PolyData file in ASCII, for ParaView, coloured by `scalars` at first. One
/// of a single corner is a vertex; vertices come first.
/// `write_fields` writes what goes before the polygons, such as a FieldData element.
/// Errors: InputError where the file cannot be written.
void write_poly_data(const std::filesystem::path& file, std::span<const ConvexPolygon> polygons,
                     std::span<const CellArray> arrays, std::string_view scalars,
                     const std::function<void(FileWriter&)>& write_fields = {});

}  // namespace viewcover
