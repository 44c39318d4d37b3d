#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "report/csv_table.h"
#include "scene/address.h"
#include "scene/region_shape.h"
#include "scene/scene.h"

namespace viewcover {

/// The scene of a finished run and its elements, loaded again as the run loaded it.
struct BundleScene {
  Scene scene;
  bool one_sided = false;
  std::vector<ElementAddress> elements;      ///< ascending, tile every surface
  std::vector<std::uint32_t> times_visible;  ///< regions that see each element
};

/// Reads run.json and elements.csv. `scene_file` stands in where the file named in run.json has
/// moved; empty if it has not.
///
/// Errors: InputError for a folder without a finished run, a scene file that is missing or whose
/// SHA-256 is not the one in run.json, and elements that are not those of the scene.
BundleScene load_bundle_scene(const std::filesystem::path& folder,
                              const std::filesystem::path& scene_file = {});

/// The polygon with the corners in columns x0, y0, z0, x1, ... of a row.
ConvexPolygon corners_in(const CsvTable& table, std::size_t row);
/// The region that a row of regions.csv has: a box where it has a volume. Nothing where it has
/// neither three corners nor a box with a volume.
std::optional<RegionShape> region_in(const CsvTable& regions, std::size_t row);
/// The node of bound.csv or regions.csv, down from the region that its row names; nothing where it
/// is not in that region.
std::optional<RegionShape> region_of_cell(const CsvTable& cells, std::size_t row,
                                          const CsvTable& regions);

/// The columns x, y, z of a CSV file, exactly the doubles that its decimals read as. Errors:
/// InputError for a file that cannot be read, and for a coordinate that is not a finite number.
std::vector<Point> read_positions(const std::filesystem::path& file);

}  // namespace viewcover
