#include "report/surface_meshes.h"

#include <cmath>

#include "report/file_writer.h"
#include "scene/read/mesh_file.h"

namespace viewcover {
namespace {

/// Grey of an element that a single region sees: told from black on any screen.
constexpr double kDimmest = 64;
constexpr double kBrightest = 255;

Colour colour_of(std::uint32_t times_visible, std::size_t regions) {
  if (times_visible == 0) return {0, 0, 0};
  const double share = static_cast<double>(times_visible) / static_cast<double>(regions);
  const auto grey =
      static_cast<std::uint8_t>(std::lround(kDimmest + (kBrightest - kDimmest) * share));
  return {grey, grey, grey};
}

}  // namespace

void write_surface_mesh(const Solution& solution, const std::filesystem::path& file) {
  const std::vector<std::uint32_t> times_visible = solution.matrix.times_visible();
  std::vector<ConvexPolygon> polygons;
  std::vector<Colour> colours;
  for (std::size_t i = 0; i < solution.matrix.elements.size(); ++i) {
    const ElementAddress element = solution.matrix.elements[i];
    polygons.push_back(subdivided(solution.scene[element.owner()].polygon, element));
    colours.push_back(colour_of(times_visible[i], solution.region.region_count()));
  }
  const std::filesystem::path temporary = temporary_beside(file);
  write_mesh(temporary, polygons, colours);
  rename_into_place(temporary, file);
}

}  // namespace viewcover
