#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_codes.h"
#include "app/option_values.h"
#include "report/run_record.h"
#include "scene/closed_surface.h"
#include "scene/cracks.h"
#include "scene/error.h"
#include "scene/polygon_soup.h"
#include "scene/surface_mesh.h"

namespace viewcover {
namespace {

/// Of the largest coordinate: cracks up to this width are looked for by default.
constexpr double kDefaultWidth = 0x1p-12;
/// Cracks and outliers listed; all are counted.
constexpr std::size_t kListed = 10;
/// A vertex is far out beyond so many times the box that holds the middle 80 % of the vertices.
constexpr double kFarOut = 20;

struct InspectText {
  CommonOptions common;
  std::string scene, width;
};

struct Extent {
  double low = 0, high = 0;
  double size() const { return high - low; }
};

/// Where the middle 80 % of the vertices lie along an axis.
Extent usual_extent(const PolygonSoup& soup, int axis) {
  std::vector<double> values;
  for (const Point& vertex : soup.vertices) values.push_back(vertex[axis]);
  std::ranges::sort(values);
  const std::size_t cut = values.size() / 10;
  return {values[cut], values[values.size() - 1 - cut]};
}

std::vector<std::size_t> outliers(const PolygonSoup& soup) {
  std::array<Extent, 3> usual;
  double size = 0;
  for (int axis = 0; axis < 3; ++axis) {
    usual[static_cast<std::size_t>(axis)] = usual_extent(soup, axis);
    size = std::max(size, usual[static_cast<std::size_t>(axis)].size());
  }
  std::vector<std::size_t> far;
  for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const Extent& extent = usual[static_cast<std::size_t>(axis)];
      const double x = soup.vertices[i][axis];
      if (x >= extent.low - kFarOut * size && x <= extent.high + kFarOut * size) continue;
      far.push_back(i);
      break;
    }
  }
  return far;
}

/// By the height of a room, where the scene is one: the least of its extents.
std::string_view units_guess(const Box& bounds) {
  struct Range {
    double from, to;
    std::string_view unit;
  };
  constexpr std::array kRooms = {Range{2, 8, "metres"}, Range{8, 30, "feet"},
                                 Range{75, 160, "inches"}, Range{200, 800, "centimetres"},
                                 Range{2000, 8000, "millimetres"}};
  const double height = bounds.sizes().minCoeff();
  const auto fits = [&](const Range& range) { return height >= range.from && height < range.to; };
  const auto range = std::ranges::find_if(kRooms, fits);
  return range == kRooms.end() ? "unknown" : range->unit;
}

Json as_json(const Point& p) { return {p.x(), p.y(), p.z()}; }

Json cracks_of(const PolygonSoup& soup, double width) {
  Cracks cracks = find_cracks(soup, width);
  const auto wider = [](const Crack& a, const Crack& b) { return a.width > b.width; };
  const double widest_crack =
      cracks.beside_edges.empty()
          ? 0
          : std::ranges::max_element(cracks.beside_edges, {}, &Crack::width)->width;
  std::ranges::stable_sort(cracks.beside_edges, wider);
  Json listed = Json::array();
  for (const Crack& crack : cracks.beside_edges) {
    if (listed.size() == kListed) break;
    listed.push_back({{"place", as_json(soup.vertices[crack.vertex])},
                      {"width", crack.width},
                      {"face", crack.face + 1},
                      {"group", soup.groups[soup.face_groups[crack.face].value]}});
  }
  return {{"looked_for_up_to", width},
          {"vertices_beside_edges", cracks.beside_edges.size()},
          {"widest", widest_crack},
          {"unmerged_vertices", cracks.apart.size()},
          {"vertices_on_edges", cracks.junctions},
          {"listed", listed}};
}

Json surface_of(const Scene& scene) {
  const SurfaceMesh mesh(scene.surfaces);
  std::size_t oriented = 0, outward = 0;
  const std::vector<ClosedSurface> closed = closed_surfaces(scene);
  for (const ClosedSurface& piece : closed) {
    if (!piece.is_oriented) continue;
    ++oriented;
    double volume = 0;
    for (const SurfaceId id : piece.surfaces) {
      const ConvexPolygon& polygon = scene[id].polygon;
      volume += (polygon[0] - piece.bounds.center()).dot(area_vector(polygon));
    }
    outward += volume > 0;
  }
  return {{"pieces", mesh.components()},
          {"edges", mesh.edges()},
          {"open_edges", mesh.boundary_edges()},
          {"edges_of_three_or_more", mesh.non_manifold_edges()},
          {"closed_pieces", closed.size()},
          {"closed_with_fronts_outward", outward},
          {"closed_with_fronts_inward", oriented - outward},
          {"closed_with_fronts_either_way", closed.size() - oriented}};
}

/// The same for people.
std::string as_lines(const Json& found) {
  std::string text;
  for (const auto& [name, value] : found.items()) {
    if (value.is_object()) {
      for (const auto& [inner, one] : value.items()) {
        if (inner != "listed") text += fmt::format("{:12} {:28} {}\n", name, inner, one.dump());
      }
    } else {
      text += fmt::format("{:12} {:28} {}\n", name, "", value.dump());
    }
  }
  for (const Json& crack : found.at("cracks").at("listed")) {
    text += fmt::format("a crack {} wide at {} beside face {} ({})\n", crack.at("width").dump(),
                        crack.at("place").dump(), crack.at("face").dump(),
                        crack.at("group").dump(-1, ' ', false, Json::error_handler_t::replace));
  }
  return text;
}

int inspect(const InspectText& text) {
  if (text.scene.empty()) throw InputError("SCENE", "is missing", "give a file");
  PolygonSoup soup = read_polygon_soup(text.scene);
  const Scene scene = make_scene(soup);
  const std::vector<std::size_t> far = outliers(soup);
  const double largest =
      scene.bounds.min().cwiseAbs().cwiseMax(scene.bounds.max().cwiseAbs()).maxCoeff();
  const double width =
      text.width.empty() ? kDefaultWidth * largest : positive_option("--width", text.width);
  // Cracks are those of the scene as it is solved: on its lattice.
  for (Point& vertex : soup.vertices) vertex = scene.lattice.round(vertex) + Point::Zero();
  Json places = Json::array();
  for (std::size_t i = 0; i < std::min(far.size(), kListed); ++i) {
    places.push_back(soup.place_of_vertex(far[i]));
  }
  const Json found = {{"scene", scene.name},
                      {"size",
                       {{"faces", scene.faces},
                        {"polygons", scene.surfaces.size()},
                        {"groups", scene.groups.size()},
                        {"area", scene.area()},
                        {"least_corner", as_json(scene.bounds.min())},
                        {"greatest_corner", as_json(scene.bounds.max())},
                        {"units_guess", units_guess(scene.bounds)},
                        {"lattice_step", scene.lattice.step()}}},
                      {"repairs", repairs_of(scene)},
                      {"surface", surface_of(scene)},
                      {"cracks", cracks_of(soup, width)},
                      {"far_out", {{"vertices", far.size()}, {"places", places}}}};
  if (!text.common.quiet) print_out(as_lines(found));
  print_out(found.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  return kDone;
}

}  // namespace

void add_inspect_command(CLI::App& app, int& exit_code) {
  const auto text = std::make_shared<InspectText>();
  CLI::App* const command = app.add_subcommand(
      "inspect", "what a scene is like: size, repairs, pieces, cracks, vertices far out");
  command->add_option("scene", text->scene, "the scene: .obj, .off, .ply or .stl")
      ->type_name("SCENE");
  command
      ->add_option("--width", text->width,
                   "cracks to look for (default: 1/4096 of the largest coordinate)")
      ->type_name("W");
  add_common_options(*command, text->common);
  command->callback([text, &exit_code] { exit_code = inspect(*text); });
}

}  // namespace viewcover
