#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <optional>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_codes.h"
#include "app/option_values.h"
#include "free_space/free_region.h"
#include "report/file_writer.h"
#include "report/run_record.h"
#include "scene/error.h"
#include "scene/read/polygon_soup.h"

namespace viewcover {
namespace {

struct RegionText {
  CommonOptions common;
  std::string scene, output, height, volume, cells, clearance = "0", up = "z", seed_point, heal,
                                                    crop;
};

constexpr double kLargest = 1e30;
/// Along an axis: boxes that a person may still look at, and a minute of computing.
constexpr std::uint64_t kMostCells = 128;

/// What FreeRegionOptions and FreeBoxOptions have in common.
template <class Options>
Options options_of(const RegionText& text) {
  constexpr std::array<std::string_view, 3> kAxes = {"x", "y", "z"};
  Options options;
  require_available("--up", text.up, kAxes);
  options.up_axis = static_cast<int>(std::ranges::find(kAxes, text.up) - kAxes.begin());
  options.clearance = non_negative_option("--clearance", text.clearance);
  if (!text.seed_point.empty()) options.seed = place_option("--seed-point", text.seed_point);
  return options;
}

FreeRegionOptions region_options(const RegionText& text) {
  auto options = options_of<FreeRegionOptions>(text);
  options.height = number_option("--height", text.height, -kLargest, kLargest);
  return options;
}

FreeBoxOptions box_options(const RegionText& text) {
  auto options = options_of<FreeBoxOptions>(text);
  const std::vector<std::string_view> heights = fields_of(text.volume);
  if (heights.size() != 2) {
    throw InputError("--volume", "is no pair of heights", "give two heights LOW,HIGH");
  }
  options.low = number_option("--volume", heights[0], -kLargest, kLargest);
  options.high = number_option("--volume", heights[1], -kLargest, kLargest);
  if (!text.cells.empty()) {
    const std::vector<std::string_view> cells = fields_of(text.cells);
    if (cells.size() != 3) {
      throw InputError("--cells", "is no grid", "give three whole numbers NX,NY,NZ");
    }
    for (std::size_t i = 0; i < 3; ++i) {
      options.cells[i] = count_option("--cells", cells[i], 1, kMostCells);
    }
  }
  return options;
}

Json as_json(const ConvexPolygon& polygon) {
  Json corners = Json::array();
  for (const Point& corner : polygon) corners.push_back({corner.x(), corner.y(), corner.z()});
  return corners;
}

Json as_json(const Box& box) {
  const auto corner = [](const Point& p) { return Json{p.x(), p.y(), p.z()}; };
  return {{"min", corner(box.min())}, {"max", corner(box.max())}};
}

/// Writes {key: parts}, once `solve` would accept it.
template <class Part>
void write_region(const RegionText& text, const Scene& scene, const ViewingRegion& region,
                  double clearance, const char* key, const std::vector<Part>& parts) {
  check_region_is_free(text.output, scene, region, {.clearance = clearance});
  Json list = Json::array();
  for (const Part& part : parts) list.push_back(as_json(part));
  FileWriter out(text.output);
  out << Json{{key, list}}.dump() << '\n';
  out.commit();
}

/// `line` says what was found: of the kind FreeRegion or FreeBoxes.
template <class Free>
void report(const RegionText& text, const Free& free, Json line) {
  if (!text.common.quiet && free.others > 0) {
    print_out(fmt::format("{} of free space in {} other places cannot be reached from there\n",
                          free.area_of_others, free.others));
  }
  line["left_out"] = free.left_out;
  line["others"] = free.others;
  line["area_of_others"] = free.area_of_others;
  print_out(line.dump() + "\n");
}

void write_polygons(const RegionText& text, const Scene& scene, const FreeRegionOptions& options) {
  const FreeRegion free = find_free_region(scene, options);
  write_region(text, scene, {.parts = free.parts, .level = 0}, options.clearance, "polygons",
               free.parts);
  report(text, free,
         {{"region", text.output},
          {"parts", free.parts.size()},
          {"area", free.area},
          {"holes", free.holes}});
}

void write_boxes(const RegionText& text, const Scene& scene, const FreeBoxOptions& options) {
  const FreeBoxes free = find_free_boxes(scene, options);
  write_region(text, scene, make_viewing_region({}, free.boxes, 0), options.clearance, "boxes",
               free.boxes);
  report(text, free, {{"region", text.output}, {"boxes", free.boxes.size()}, {"area", free.area}});
}

int write_free_region(const RegionText& text) {
  if (text.scene.empty()) throw InputError("SCENE", "is missing", "give a file");
  if (text.height.empty() == text.volume.empty()) {
    throw InputError("--height", text.height.empty() ? "is missing" : "comes with --volume",
                     "give the cameras' height, or two heights with --volume");
  }
  if (!text.cells.empty() && text.volume.empty()) {
    throw InputError("--cells", "is about boxes", "use it with --volume");
  }
  if (text.output.empty()) throw InputError("--output", "is missing", "give the file to write");
  // Bad options are known before a large scene is read.
  std::optional<FreeRegionOptions> polygons;
  std::optional<FreeBoxOptions> boxes;
  if (text.volume.empty()) {
    polygons = region_options(text);
  } else {
    boxes = box_options(text);
  }
  SceneOptions scene_options;
  if (!text.heal.empty()) scene_options.heal = positive_option("--heal", text.heal);
  if (!text.crop.empty()) scene_options.crop = box_option("--crop", text.crop);
  const Scene scene = load_scene(text.scene, scene_options);
  if (!text.common.quiet) {
    if (!scene.warning.empty()) print_error_line(scene.warning);
    if (scene.repairs.cropped_faces > 0) {
      print_error_line(text.scene + ": " + scene.repairs.summary());
    }
  }
  if (polygons) write_polygons(text, scene, *polygons);
  if (boxes) write_boxes(text, scene, *boxes);
  return kDone;
}

}  // namespace

void add_region_command(CLI::App& app, int& exit_code) {
  const auto text = std::make_shared<RegionText>();
  CLI::App* const command = app.add_subcommand(
      "region", "find where cameras may be: the free space at one height or between two");
  command->add_option("scene", text->scene, "the scene: " + mesh_file_types())->type_name("SCENE");
  command->add_option("-o,--output", text->output, "the region file to write (JSON)")
      ->type_name("FILE");
  command->add_option("--height", text->height, "of the cameras")->type_name("H");
  command
      ->add_option("--volume", text->volume, "free boxes between two heights instead of polygons")
      ->type_name("LOW,HIGH");
  command
      ->add_option("--cells", text->cells,
                   "with --volume: how many boxes along x, y and z (default: 4,4,1)")
      ->type_name("NX,NY,NZ");
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
