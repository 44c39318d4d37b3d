#include "report/scene_vtp.h"

#include <string_view>

#include "report/file_writer.h"

namespace viewcover {
namespace {

constexpr int kElement = 0;
constexpr int kRegion = 1;
constexpr int kViewpoint = 2;

struct Cell {
  ConvexPolygon polygon;
  int kind = kElement;
  std::uint32_t times_visible = 0;
  std::uint32_t covered_by = 0;
  int chosen = 0;
  std::uint32_t surface = 0;
  std::uint32_t group = 0;
};

std::vector<Cell> cells_of(const Solution& solution) {
  const VisibilityMatrix& matrix = solution.matrix;
  const std::vector<std::uint32_t> times_visible = matrix.times_visible();
  std::vector<std::uint32_t> covered_by(matrix.elements.size(), 0);
  for (const std::size_t row : solution.chosen()) {
    for_each_bit(matrix.bits.row(row), [&](std::size_t column) { ++covered_by[column]; });
  }

  // VTK wants vertices before polygons.
  std::vector<Cell> cells;
  if (solution.viewpoints != nullptr) {
    for (const Viewpoint& viewpoint : solution.viewpoints->viewpoints) {
      cells.push_back({.polygon = {viewpoint.position}, .kind = kViewpoint, .chosen = 1});
    }
  }
  const std::size_t first_region = cells.size() + matrix.elements.size();
  cells.reserve(first_region + solution.region.region_count());
  for (std::size_t i = 0; i < matrix.elements.size(); ++i) {
    const SurfaceId id = matrix.elements[i].owner();
    const Surface& surface = solution.scene[id];
    cells.push_back({.polygon = subdivided(surface.polygon, matrix.elements[i]),
                     .kind = kElement,
                     .times_visible = times_visible[i],
                     .covered_by = covered_by[i],
                     .surface = id.value + 1,
                     .group = surface.group.value + 1});
  }
  for (std::size_t i = 0; i < solution.region.region_count(); ++i) {
    cells.push_back(
        {.polygon = solution.region.polygon(solution.region.address(i)), .kind = kRegion});
  }
  for (const std::size_t row : solution.chosen()) cells[first_region + row].chosen = 1;
  return cells;
}

template <class Value>
void write_array(FileWriter& out, std::string_view name, const std::vector<Cell>& cells,
                 Value Cell::*member) {
  out << "        <DataArray type=\"Int32\" Name=\"" << name << "\" format=\"ascii\">\n";
  for (const Cell& cell : cells) out << cell.*member << '\n';
  out << "        </DataArray>\n";
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

/// `Verts` or `Polys`: cells [first, last), the corners of all cells being numbered in turn.
void write_cells(FileWriter& out, std::string_view what, const std::vector<Cell>& cells,
                 std::size_t first, std::size_t last) {
  out << "      <" << what << ">\n"
      << "        <DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  std::size_t next = 0;
  for (std::size_t i = 0; i < first; ++i) next += cells[i].polygon.size();
  for (std::size_t i = first; i < last; ++i) {
    for (std::size_t k = 0; k < cells[i].polygon.size(); ++k) out << (k > 0 ? " " : "") << next++;
    out << '\n';
  }
  out << "        </DataArray>\n"
      << "        <DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  std::size_t end = 0;
  for (std::size_t i = first; i < last; ++i) out << (end += cells[i].polygon.size()) << '\n';
  out << "        </DataArray>\n      </" << what << ">\n";
}

}  // namespace

void write_scene_vtp(const Solution& solution, const std::filesystem::path& file) {
  const std::vector<Cell> cells = cells_of(solution);
  const std::size_t viewpoints =
      solution.viewpoints != nullptr ? solution.viewpoints->viewpoints.size() : 0;
  std::size_t points = 0;
  for (const Cell& cell : cells) points += cell.polygon.size();

  FileWriter out(file);
  out << "<?xml version=\"1.0\"?>\n"
      << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      << "  <PolyData>\n";
  write_group_names(out, solution.scene.groups);
  out << "    <Piece NumberOfPoints=\"" << points << "\" NumberOfVerts=\"" << viewpoints
      << "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" << cells.size() - viewpoints
      << "\">\n"
      << "      <CellData Scalars=\"times_visible\">\n";
  write_array(out, "kind", cells, &Cell::kind);
  write_array(out, "times_visible", cells, &Cell::times_visible);
  write_array(out, "covered_by", cells, &Cell::covered_by);
  write_array(out, "chosen", cells, &Cell::chosen);
  write_array(out, "surface", cells, &Cell::surface);
  write_array(out, "group", cells, &Cell::group);
  out << "      </CellData>\n      <Points>\n"
      << "        <DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const Cell& cell : cells) {
    for (const Point& corner : cell.polygon) {
      out << corner.x() << ' ' << corner.y() << ' ' << corner.z() << '\n';
    }
  }
  out << "        </DataArray>\n      </Points>\n";
  if (viewpoints > 0) write_cells(out, "Verts", cells, 0, viewpoints);
  write_cells(out, "Polys", cells, viewpoints, cells.size());
  out << "    </Piece>\n  </PolyData>\n</VTKFile>\n";
  out.commit();
}

}  // namespace viewcover
