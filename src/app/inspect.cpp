#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_codes.h"
#include "app/option_values.h"
#include "report/run_record.h"
#include "scene/error.h"
#include "scene/read/polygon_soup.h"
#include "scene/repair/closed_surface.h"
#include "scene/repair/cracks.h"
#include "scene/repair/crop.h"
#include "scene/repair/surface_mesh.h"

namespace viewcover {
namespace {

/// Of the largest coordinate: cracks up to this width are looked for by default.
constexpr double kDefaultWidth = 0x1p-12;
/// Cracks and outliers listed; all are counted.
constexpr std::size_t kListed = 10;

struct InspectText {
  CommonOptions common;
  std::string scene, width, crop;
};

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
  const Cracks cracks = find_cracks(soup, width);
  std::vector<VertexBesideFace> all = cracks.beside_faces;
  for (const Crack& crack : cracks.beside_edges) {
    all.push_back({crack.vertex, crack.face, crack.width});
  }
  std::ranges::stable_sort(all, std::greater(), &VertexBesideFace::distance);
  Json listed = Json::array();
  for (const VertexBesideFace& crack : all) {
    if (listed.size() == kListed) break;
    listed.push_back({{"place", as_json(soup.vertices[crack.vertex])},
                      {"width", crack.distance},
                      {"face", soup.number_in_file(crack.face) + 1},
                      {"group", soup.groups[soup.face_groups[crack.face].value]}});
  }
  return {{"looked_for_up_to", width},
          {"vertices_beside_edges", cracks.beside_edges.size()},
          {"vertices_beside_faces", cracks.beside_faces.size()},
          {"widest", all.empty() ? 0 : all.front().distance},
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
  SceneOptions options;
  if (!text.crop.empty()) options.crop = box_option("--crop", text.crop);
  const Scene scene = make_scene(soup, options);
  if (options.crop) crop(soup, *options.crop);
  if (!scene.warning.empty() && !text.common.quiet) print_error_line(scene.warning);
  const FarOut far = find_far_out(soup);
  const double largest =
      scene.bounds.min().cwiseAbs().cwiseMax(scene.bounds.max().cwiseAbs()).maxCoeff();
  const double width =
      text.width.empty() ? kDefaultWidth * largest : positive_option("--width", text.width);
  // Cracks are those of the scene as it is solved: on its lattice.
  for (Point& vertex : soup.vertices) vertex = scene.lattice.round(vertex) + Point::Zero();
  Json places = Json::array();
  for (std::size_t i = 0; i < std::min(far.vertices.size(), kListed); ++i) {
    places.push_back(soup.place_of_vertex(far.vertices[i]));
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
                      {"far_out",
                       {{"vertices", far.vertices.size()},
                        {"faces", far.faces.size()},
                        {"lattice_step_without", far.step_without},
                        {"places", places}}}};
  if (!text.common.quiet) print_out(as_lines(found));
  print_out(found.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  return kDone;
}

}  // namespace

void add_inspect_command(CLI::App& app, int& exit_code) {
  const auto text = std::make_shared<InspectText>();
  CLI::App* const command = app.add_subcommand(
      "inspect", "what a scene is like: size, repairs, pieces, cracks, vertices far out");
  command->add_option("scene", text->scene, "the scene: " + mesh_file_types())->type_name("SCENE");
  command
      ->add_option("--width", text->width,
                   "cracks to look for (default: 1/4096 of the largest coordinate)")
      ->type_name("W");
  command->add_option("--crop", text->crop, kCropHelp)->type_name(kCropType);
  add_common_options(*command, text->common);
  command->callback([text, &exit_code] { exit_code = inspect(*text); });
}

}  // namespace viewcover
