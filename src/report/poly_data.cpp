#include "report/poly_data.h"

#include <algorithm>

namespace viewcover {
namespace {

void write_cell_data(FileWriter& out, std::span<const CellArray> arrays, std::string_view scalars) {
  out << "      <CellData Scalars=\"" << scalars << "\">\n";
  for (const CellArray& array : arrays) {
    out << "        <DataArray type=\"Int32\" Name=\"" << array.name << "\" format=\"ascii\">\n";
    for (const std::uint32_t value : array.values) out << value << '\n';
    out << "        </DataArray>\n";
  }
  out << "      </CellData>\n";
}

void write_points(FileWriter& out, std::span<const ConvexPolygon> polygons) {
  out << "      <Points>\n"
      << "        <DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">\n";
  for (const ConvexPolygon& polygon : polygons) {
    for (const Point& corner : polygon) {
      out << corner.x() << ' ' << corner.y() << ' ' << corner.z() << '\n';
    }
  }
  out << "        </DataArray>\n      </Points>\n";
}

/// Cells whose corners are numbered on from `first_corner`.
void write_cells(FileWriter& out, std::string_view kind, std::span<const ConvexPolygon> polygons,
                 std::size_t first_corner) {
  out << "      <" << kind << ">\n"
      << "        <DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  std::size_t next = first_corner;
  for (const ConvexPolygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) out << (i > 0 ? " " : "") << next++;
    out << '\n';
  }
  out << "        </DataArray>\n"
      << "        <DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  std::size_t end = 0;
  for (const ConvexPolygon& polygon : polygons) out << (end += polygon.size()) << '\n';
  out << "        </DataArray>\n      </" << kind << ">\n";
}

}  // namespace

void write_poly_data(const std::filesystem::path& file, std::span<const ConvexPolygon> polygons,
                     std::span<const CellArray> arrays, std::string_view scalars,
                     const std::function<void(FileWriter&)>& write_fields) {
  std::size_t points = 0;
  for (const ConvexPolygon& polygon : polygons) points += polygon.size();
  const auto first_polygon = std::ranges::find_if(
      polygons, [](const ConvexPolygon& polygon) { return polygon.size() > 1; });
  const std::span<const ConvexPolygon> vertices(polygons.begin(), first_polygon);
  FileWriter out(file);
  out << "<?xml version=\"1.0\"?>\n"
      << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      << "  <PolyData>\n";
  if (write_fields) write_fields(out);
  out << "    <Piece NumberOfPoints=\"" << points << "\" NumberOfVerts=\"" << vertices.size()
      << "\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
      << polygons.size() - vertices.size() << "\">\n";
  write_cell_data(out, arrays, scalars);
  write_points(out, polygons);
  if (!vertices.empty()) write_cells(out, "Verts", vertices, 0);
  write_cells(out, "Polys", polygons.subspan(vertices.size()), vertices.size());
  out << "    </Piece>\n  </PolyData>\n</VTKFile>\n";
  out.commit();
}

}  // namespace viewcover
