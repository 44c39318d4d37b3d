#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_codes.h"
#include "app/option_values.h"
#include "free_space/free_region.h"
#include "report/file_writer.h"
#include "report/run_record.h"
#include "scene/error.h"
#include "scene/polygon_soup.h"

namespace viewcover {
namespace {

struct RegionText {
  CommonOptions common;
  std::string scene, output, height, clearance = "0", up = "z", seed_point, heal, crop;
};

FreeRegionOptions region_options(const RegionText& text) {
  constexpr double kLargest = 1e30;
  constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
  FreeRegionOptions options;
  require_available("--up", text.up, kAxes);
  options.up_axis = static_cast<int>(std::ranges::find(kAxes, text.up) - kAxes.begin());
  options.height = number_option("--height", text.height, -kLargest, kLargest);
  options.clearance = non_negative_option("--clearance", text.clearance);
  if (!text.seed_point.empty()) options.seed = place_option("--seed-point", text.seed_point);
  return options;
}

Json as_json(const ConvexPolygon& polygon) {
  Json corners = Json::array();
  for (const Point& corner : polygon) corners.push_back({corner.x(), corner.y(), corner.z()});
  return corners;
}

int write_free_region(const RegionText& text) {
  if (text.scene.empty()) throw InputError("SCENE", "is missing", "give a file");
  if (text.height.empty()) throw InputError("--height", "is missing", "give the cameras' height");
  if (text.output.empty()) throw InputError("--output", "is missing", "give the file to write");
  const FreeRegionOptions options = region_options(text);
  SceneOptions scene_options;
  if (!text.heal.empty()) scene_options.heal = positive_option("--heal", text.heal);
  if (!text.crop.empty()) scene_options.crop = box_option("--crop", text.crop);
  const Scene scene = load_scene(text.scene, scene_options);
  if (!text.common.quiet) {
    if (!scene.warning.empty()) print_error_line(scene.warning);
    if (scene.repairs.cropped_faces > 0)
      print_error_line(text.scene + ": " + scene.repairs.summary());
  }
  const FreeRegion free = find_free_region(scene, options);
  // By the rules that `solve` has, before anything is written.
  check_region_is_free(text.output, scene, {.parts = free.parts, .level = 0},
                       {.clearance = options.clearance});
  Json polygons = Json::array();
  for (const ConvexPolygon& part : free.parts) polygons.push_back(as_json(part));
  FileWriter out(text.output);
  out << Json{{"polygons", polygons}}.dump() << '\n';
  out.commit();
  if (!text.common.quiet && free.others > 0) {
    print_out(fmt::format("{} of free space in {} other places cannot be reached from there\n",
                          free.area_of_others, free.others));
  }
  const Json line = {{"region", text.output},
                     {"parts", free.parts.size()},
                     {"area", free.area},
                     {"holes", free.holes},
                     {"left_out", free.left_out},
                     {"others", free.others},
                     {"area_of_others", free.area_of_others}};
  print_out(line.dump() + "\n");
  return kDone;
}

}  // namespace

void add_region_command(CLI::App& app, int& exit_code) {
  const auto text = std::make_shared<RegionText>();
  CLI::App* const command =
      app.add_subcommand("region", "find where cameras may be: the free space at one height");
  command->add_option("scene", text->scene, "the scene: " + mesh_file_types())->type_name("SCENE");
  command->add_option("-o,--output", text->output, "the region file to write (JSON)")
      ->type_name("FILE");
  command->add_option("--height", text->height, "of the cameras")->type_name("H");
  command->add_option("--up", text->up, "which way is up (default: z)")->type_name("x|y|z");
  command
      ->add_option("--clearance", text->clearance,
                   "least distance of a camera from any surface (default: 0)")
      ->type_name("D");
  command
      ->add_option("--seed-point", text->seed_point,
                   "a place that the region must be connected with (default: the largest)")
      ->type_name("X,Y,Z");
  command->add_option("--heal", text->heal, "close cracks up to this width, as `solve` does")
      ->type_name("W");
  command->add_option("--crop", text->crop, kCropHelp)->type_name(kCropType);
  add_common_options(*command, text->common);
  command->callback([text, &exit_code] { exit_code = write_free_region(*text); });
}

}  // namespace viewcover
