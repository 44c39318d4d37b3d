#include "report/poly_data.h"

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

void write_polygons(FileWriter& out, std::span<const ConvexPolygon> polygons) {
  out << "      <Polys>\n"
      << "        <DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">\n";
  std::size_t next = 0;
  for (const ConvexPolygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) out << (i > 0 ? " " : "") << next++;
    out << '\n';
  }
  out << "        </DataArray>\n"
      << "        <DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">\n";
  std::size_t end = 0;
  for (const ConvexPolygon& polygon : polygons) out << (end += polygon.size()) << '\n';
  out << "        </DataArray>\n      </Polys>\n";
}

}  // namespace

void write_poly_data(const std::filesystem::path& file, std::span<const ConvexPolygon> polygons,
                     std::span<const CellArray> arrays, std::string_view scalars,
                     const std::function<void(FileWriter&)>& write_fields) {
  std::size_t points = 0;
  for (const ConvexPolygon& polygon : polygons) points += polygon.size();
  FileWriter out(file);
  out << "<?xml version=\"1.0\"?>\n"
      << "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
      << "  <PolyData>\n";
  if (write_fields) write_fields(out);
  out << "    <Piece NumberOfPoints=\"" << points << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
      << "NumberOfStrips=\"0\" NumberOfPolys=\"" << polygons.size() << "\">\n";
  write_cell_data(out, arrays, scalars);
  write_points(out, polygons);
  write_polygons(out, polygons);
  out << "    </Piece>\n  </PolyData>\n</VTKFile>\n";
  out.commit();
}

}  // namespace viewcover
