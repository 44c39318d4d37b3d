#include "report/tables.h"

#include <algorithm>
#include <span>
#include <sstream>
#include <string_view>

#include "full_coverage/full_coverage.h"
#include "optim/cover_proof.h"
#include "report/file_writer.h"
#include "viewpoints/refined_bound.h"

namespace viewcover {
namespace {

/// Column titles `,x0,y0,z0,x1,...` for polygons of up to `corners` corners.
void write_corner_titles(FileWriter& out, std::size_t corners) {
  for (std::size_t i = 0; i < corners; ++i) {
    for (const char axis : {'x', 'y', 'z'}) out << ',' << axis << i;
  }
}

void write_corners(FileWriter& out, std::span<const Point> polygon, std::size_t corners) {
  for (std::size_t i = 0; i < corners; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      out << ',';
      if (i < polygon.size()) out << polygon[i][axis];
    }
  }
}

void write_place(FileWriter& out, int level, std::uint64_t path, const Point& centre) {
  out << level << ',' << path << ',' << centre.x() << ',' << centre.y() << ',' << centre.z();
}

template <class Polygon>
std::size_t most_corners(const std::vector<Polygon>& polygons) {
  std::size_t corners = 0;
  for (const Polygon& polygon : polygons) corners = std::max(corners, polygon.size());
  return corners;
}

/// Of a polygon as they come; those of a box as tables.h says.
std::vector<Point> corners_of(const RegionShape& shape) {
  if (!shape.is_box()) return {shape.polygon().begin(), shape.polygon().end()};
  const std::array<Point, 8> corners = box_corners(shape.box());
  return {corners.begin(), corners.end()};
}

template <class Owner>
void write_node(FileWriter& out, QuadAddress<Owner> node) {
  out << node.owner().value + 1 << ':' << node.level() << ':' << node.path();
}

void write_bits(const BitRows& bits, std::string_view what, const std::filesystem::path& file) {
  std::size_t entries = 0;
  for (std::size_t row = 0; row < bits.rows(); ++row) entries += count_bits(bits.row(row));
  FileWriter out(file);
  out << "%%MatrixMarket matrix coordinate pattern general\n% " << what << '\n'
      << bits.rows() << ' ' << bits.columns() << ' ' << entries << '\n';
  for (std::size_t row = 0; row < bits.rows(); ++row) {
    for_each_bit(bits.row(row),
                 [&](std::size_t column) { out << row + 1 << ' ' << column + 1 << '\n'; });
  }
  out.commit();
}

void write_proof_of(const BitRows& matrix, const CoverProof& proof,
                    const std::filesystem::path& file) {
  const CoverInstance instance(matrix, std::vector<double>(matrix.columns(), 1.0));
  std::ostringstream text;
  write_cover_proof(text, instance.rows(), proof);
  FileWriter out(file);
  out << text.str();
  out.commit();
}

/// Without a proof there is no file.
void write_proof_or_none(const BitRows& matrix, const RegionCover& cover,
                         const std::filesystem::path& file) {
  if (cover.proof == nullptr) {
    std::filesystem::remove(file);
  } else {
    write_proof_of(matrix, *cover.proof, file);
  }
}

}  // namespace

void write_regions(const Solution& solution, const std::filesystem::path& file) {
  const ViewingRegion& region = solution.region;
  std::vector<RegionShape> shapes;
  std::vector<std::vector<Point>> corners;
  for (std::size_t i = 0; i < region.region_count(); ++i) {
    shapes.push_back(region.shape(region.address(i)));
    corners.push_back(corners_of(shapes.back()));
  }
  std::vector<bool> chosen(region.region_count(), false);
  for (const std::size_t row : solution.chosen()) chosen[row] = true;

  const bool has_boxes = !region.boxes.empty();
  const std::size_t most = most_corners(corners);
  FileWriter out(file);
  out << "region,part,level,path,cx,cy,cz,area,chosen";
  write_corner_titles(out, most);
  out << (has_boxes ? ",volume\n" : "\n");
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const RegionAddress address = region.address(i);
    out << i + 1 << ',' << address.owner().value + 1 << ',';
    write_place(out, address.level(), address.path(), shapes[i].middle());
    out << ',' << shapes[i].surface_area() << ',' << (chosen[i] ? '1' : '0');
    write_corners(out, corners[i], most);
    if (has_boxes) out << ',';
    if (shapes[i].is_box()) out << shapes[i].box().volume();
    out << '\n';
  }
  out.commit();
}

void write_faces(const Solution& solution, const std::filesystem::path& file) {
  const ViewingRegion& region = solution.region;
  if (region.boxes.empty()) {
    std::filesystem::remove(file);
    return;
  }
  constexpr std::size_t kCorners = 4;
  FileWriter out(file);
  out << "part,region";
  write_corner_titles(out, kCorners);
  out << '\n';
  for (std::size_t part = region.polygon_count(); part < region.parts.size(); ++part) {
    out << part + 1 << ',' << region.first_index(RegionAddress(PartId(part))) + 1;
    write_corners(out, region.parts[part], kCorners);
    out << '\n';
  }
  out.commit();
}

void write_elements(const Solution& solution, const std::filesystem::path& file) {
  const std::vector<ElementAddress>& elements = solution.matrix.elements;
  std::vector<ConvexPolygon> polygons;
  polygons.reserve(elements.size());
  for (const ElementAddress element : elements) {
    polygons.push_back(subdivided(solution.scene[element.owner()].polygon, element));
  }
  std::vector<std::string> groups;
  for (const std::string& group : solution.scene.groups) groups.push_back(csv_field(group));
  const std::vector<std::uint32_t> times_visible = solution.matrix.times_visible();
  std::vector<std::uint32_t> times_visible_wide;
  if (solution.wide != nullptr) {
    times_visible_wide = count_in_columns(solution.wide->visibility.bits);
  }

  const std::size_t corners = most_corners(polygons);
  FileWriter out(file);
  out << "element,surface,group,level,path,cx,cy,cz,area,times_visible"
      << (solution.wide != nullptr ? ",times_visible_wide" : "");
  write_corner_titles(out, corners);
  out << '\n';
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const SurfaceId surface = elements[i].owner();
    out << i + 1 << ',' << surface.value + 1 << ',' << groups[solution.scene[surface].group.value]
        << ',';
    write_place(out, elements[i].level(), elements[i].path(), centroid(polygons[i]));
    out << ',' << solution.matrix.areas[i] << ',' << times_visible[i];
    if (solution.wide != nullptr) out << ',' << times_visible_wide[i];
    write_corners(out, polygons[i], corners);
    out << '\n';
  }
  out.commit();
}

void write_links(const Solution& solution, const std::filesystem::path& file) {
  FileWriter out(file);
  out << "region,element,kind,occluders" << (solution.wide != nullptr ? ",narrow\n" : "\n");
  std::vector<std::uint32_t> surfaces;
  for (std::size_t i = 0; i < solution.links.size(); ++i) {
    const Link link = solution.links[i];
    write_node(out, link.region);
    out << ',';
    write_node(out, link.element);
    out << ',' << name(link.verdict) << ',';
    surfaces.clear();
    for (const OccluderId occluder : solution.links.occluders(i)) {
      surfaces.push_back(solution.clusters.surface(occluder).value + 1);
    }
    std::ranges::sort(surfaces);
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      if (s > 0) out << ' ';
      out << surfaces[s];
    }
    if (solution.wide != nullptr) {
      const bool narrow =
          is_narrow(link, solution.region, solution.matrix, solution.wide->visibility);
      out << ',' << (narrow ? '1' : '0');
    }
    out << '\n';
  }
  out.commit();
}

void write_visibility(const VisibilityMatrix& matrix, const std::filesystem::path& file) {
  write_bits(matrix.bits,
             "rows: regions, columns: elements, in the order of regions.csv and elements.csv",
             file);
}

void write_cover(const RegionCover& cover, const std::filesystem::path& file) {
  FileWriter out(file);
  out << "k,covered_area_percent,upper_bound_percent,seconds,evaluations,regions\n";
  for (const CoverStep& step : cover.steps) {
    out << step.k << ',' << step.covered_percent << ',' << step.upper_bound_percent << ','
        << step.seconds << ',' << step.evaluations << ',';
    for (std::size_t i = 0; i < step.chosen.size(); ++i) {
      if (i > 0) out << ' ';
      out << step.chosen[i] + 1;
    }
    out << '\n';
  }
  out.commit();
}

void write_proof(const Solution& solution, const std::filesystem::path& file) {
  write_proof_or_none(solution.matrix.bits, solution.cover, file);
}

void write_wide(const Solution& solution, const std::filesystem::path& folder) {
  const auto gaps = folder / "gaps.csv", matrix = folder / "visibility-wide.mtx",
             cover = folder / "cover-wide.csv", proof = folder / "cover-wide.proof";
  if (solution.wide == nullptr) {
    for (const auto& file : {gaps, matrix, cover, proof}) std::filesystem::remove(file);
    return;
  }
  const auto& [visibility, wide_cover] = *solution.wide;
  constexpr std::size_t kCorners = 3;
  FileWriter out(gaps);
  out << "gap,surface,other,width";
  write_corner_titles(out, kCorners);
  out << '\n';
  for (std::size_t i = 0; i < visibility.gaps.size(); ++i) {
    const NarrowGap& gap = visibility.gaps[i];
    out << i + 1 << ',' << gap.surface.value + 1 << ',' << gap.other.value + 1 << ',' << gap.width;
    write_corners(out, gap.patch, kCorners);
    out << '\n';
  }
  out.commit();
  write_bits(visibility.bits, "as visibility.mtx, with the gaps of gaps.csv closed", matrix);
  write_cover(wide_cover, cover);
  write_proof_or_none(visibility.bits, wide_cover, proof);
}

void write_viewpoints(const Solution& solution, const std::filesystem::path& file) {
  FileWriter out(file);
  const ViewpointSet* set = solution.viewpoints;
  const bool is_full = set != nullptr && set->full != nullptr;
  out << "viewpoint,x,y,z,region,covered_area_percent,seconds"
      << (is_full ? ",imaged_area_percent\n" : "\n");
  if (set != nullptr) {
    for (std::size_t i = 0; i < set->viewpoints.size(); ++i) {
      const auto& [position, region] = set->viewpoints[i];
      out << i + 1 << ',' << position.x() << ',' << position.y() << ',' << position.z() << ','
          << region + 1 << ',' << set->covered_percent[i] << ',' << set->seconds[i];
      if (is_full) out << ',' << set->full->imaged_percent[i];
      out << '\n';
    }
  }
  out.commit();
}

void write_viewpoint_visibility(const Solution& solution, const std::filesystem::path& file) {
  if (solution.viewpoints == nullptr) {
    std::filesystem::remove(file);
    return;
  }
  write_bits(solution.viewpoints->seen,
             "rows: viewpoints, columns: elements, in the order of viewpoints.csv and elements.csv",
             file);
}

/// The places that the viewpoints have to see beyond a part of each element.
void write_witnesses(const Solution& solution, const std::filesystem::path& file) {
  if (solution.viewpoints == nullptr || solution.viewpoints->full == nullptr) {
    std::filesystem::remove(file);
    return;
  }
  FileWriter out(file);
  out << "witness,element,x,y,z\n";
  const std::vector<ElementTarget>& witnesses = solution.viewpoints->full->witnesses;
  for (std::size_t i = 0; i < witnesses.size(); ++i) {
    const auto& [column, place] = witnesses[i];
    out << i + 1 << ',' << column + 1 << ',' << place.x() << ',' << place.y() << ',' << place.z()
        << '\n';
  }
  out.commit();
}

void write_refined_bound(const Solution& solution, const std::filesystem::path& folder) {
  const auto cells = folder / "bound.csv", matrix = folder / "bound.mtx",
             proof = folder / "bound.proof";
  if (solution.viewpoints == nullptr || solution.viewpoints->refined_bound == nullptr) {
    for (const auto& file : {cells, matrix, proof}) std::filesystem::remove(file);
    return;
  }
  const RefinedBound& bound = *solution.viewpoints->refined_bound;
  const ViewingRegion& region = solution.region;
  FileWriter out(cells);
  out << "cell,region,part,level,path\n";
  for (std::size_t i = 0; i < bound.cells.size(); ++i) {
    RegionAddress ancestor = bound.cells[i];
    while (ancestor.level() > region.level) ancestor = ancestor.parent();
    out << i + 1 << ',' << region.first_index(ancestor) + 1 << ','
        << bound.cells[i].owner().value + 1 << ',' << bound.cells[i].level() << ','
        << bound.cells[i].path() << '\n';
  }
  out.commit();
  const std::shared_ptr<const FullCoverage>& full = solution.viewpoints->full;
  const std::string columns =
      full != nullptr && full->bound_is_of_witnesses ? "witnesses" : "elements";
  write_bits(
      bound.seen,
      "rows: cells, columns: " + columns + ", in the order of bound.csv and " + columns + ".csv",
      matrix);
  write_proof_of(bound.seen, *bound.proof, proof);
}

}  // namespace viewcover
