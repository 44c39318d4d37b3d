#include "report/scene_vtp.h"

#include <algorithm>
#include <array>

#include "report/poly_data.h"

namespace viewcover {
namespace {

/// The cells in the making: an entry a cell in every array.
struct Cells {
  std::vector<ConvexPolygon> polygons;
  std::vector<CellArray> arrays{{"kind", {}},   {"times_visible", {}}, {"covered_by", {}},
                                {"chosen", {}}, {"surface", {}},       {"group", {}}};

  void add(ConvexPolygon polygon, const std::array<std::uint32_t, 6>& values) {
    polygons.push_back(std::move(polygon));
    for (std::size_t i = 0; i < values.size(); ++i) arrays[i].values.push_back(values[i]);
  }
};

constexpr std::uint32_t kElement = 0, kRegion = 1, kViewpoint = 2;

Cells cells_of(const Solution& solution) {
  const VisibilityMatrix& matrix = solution.matrix;
  const std::vector<std::uint32_t> times_visible = matrix.times_visible();
  std::vector<std::uint32_t> covered_by(matrix.elements.size(), 0);
  std::vector<std::uint32_t> chosen(solution.region.region_count(), 0);
  for (const std::size_t row : solution.chosen()) {
    chosen[row] = 1;
    for_each_bit(matrix.bits.row(row), [&](std::size_t column) { ++covered_by[column]; });
  }
  Cells cells;
  // VTK wants vertices before polygons.
  if (solution.viewpoints != nullptr) {
    for (const Viewpoint& viewpoint : solution.viewpoints->viewpoints) {
      cells.add({viewpoint.position}, {kViewpoint, 0, 0, 1, 0, 0});
    }
  }
  for (std::size_t i = 0; i < matrix.elements.size(); ++i) {
    const SurfaceId id = matrix.elements[i].owner();
    const Surface& surface = solution.scene[id];
    cells.add(
        subdivided(surface.polygon, matrix.elements[i]),
        {kElement, times_visible[i], covered_by[i], 0, id.value + 1, surface.group.value + 1});
  }
  const ViewingRegion& region = solution.region;
  for (std::size_t i = 0; i < region.polygon_count() * region.regions_per_part(); ++i) {
    cells.add(region.polygon(region.address(i)), {kRegion, 0, 0, chosen[i], 0, 0});
  }
  for (std::size_t part = region.polygon_count(); part < region.parts.size(); ++part) {
    const std::size_t of_region = region.first_index(RegionAddress(PartId(part)));
    cells.add(region.parts[part], {kRegion, 0, 0, chosen[of_region], 0, 0});
  }
  return cells;
}

/// VTK writes a string in ASCII files as the codes of its bytes with a zero at the end, so that
/// names need no quoting.
void write_group_names(FileWriter& out, const std::vector<std::string>& groups) {
  out << "    <FieldData>\n      <Array type=\"String\" Name=\"group_names\" NumberOfTuples=\""
      << groups.size() << "\" format=\"ascii\">\n";
  for (const std::string& group : groups) {
    for (const char character : group) {
      out << static_cast<unsigned>(static_cast<unsigned char>(character)) << ' ';
    }
    out << "0\n";
  }
  out << "      </Array>\n    </FieldData>\n";
}

}  // namespace

void write_scene_vtp(const Solution& solution, const std::filesystem::path& file) {
  const Cells cells = cells_of(solution);
  write_poly_data(file, cells.polygons, cells.arrays, "times_visible",
                  [&](FileWriter& out) { write_group_names(out, solution.scene.groups); });
}

}  // namespace viewcover
