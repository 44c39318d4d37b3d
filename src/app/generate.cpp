#include <fmt/core.h>
#include <fmt/ranges.h>

#include <array>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/option_values.h"
#include "scene/error.h"
#include "scene/generate/gallery.h"
#include "scene/generate/generated_scene.h"

namespace viewcover {
namespace {

/// Beyond this a soup's file has gigabytes.
constexpr std::uint64_t kMostTriangles = 10'000'000;

/// Farther out the lattice of a scene would move their corners.
constexpr std::uint64_t kMostRooms = 40;

struct GenerateOptions {
  CommonOptions common;
  std::string file;
  std::string detail = "simple";
  std::string name;
  bool list = false;
  std::string triangles;
  std::string rooms;
  std::string polygon, height = "1";
};

std::uint64_t seed_of(const GenerateOptions& options) {
  if (!options.common.threads.empty()) {
    count_option("--threads", options.common.threads, 1, 1024);
  }
  return count_option("--seed", options.common.seed, 0, UINT64_MAX);
}

void write(const GeneratedScene& scene, const GenerateOptions& options) {
  if (options.file.empty()) {
    throw InputError("--output", "is missing", "give the file to write, such as -o scene.obj");
  }
  write_generated_scene(scene, options.file);
  if (options.common.quiet) return;
  print_out(fmt::format("{}: {} polygons in {} groups\n{}: the viewing region\n", options.file,
                        scene.faces.size(), scene.groups.size(),
                        region_file_beside(options.file).string()));
}

void list_analytic_scenes() {
  std::string text;
  for (const AnalyticScene& scene : analytic_scenes()) {
    text += fmt::format("{}: --regions {}", scene.name, scene.regions);
    if (scene.element_area) text += fmt::format(" --element-area {}", *scene.element_area);
    if (scene.optimal_regions) text += fmt::format("; optimal regions: {}", *scene.optimal_regions);
    if (!scene.visible_groups.empty()) {
      text += fmt::format("; visible: {}", fmt::join(scene.visible_groups, ", "));
    }
    if (!scene.hidden_groups.empty()) {
      text += fmt::format("; hidden: {}", fmt::join(scene.hidden_groups, ", "));
    }
    text += fmt::format("\n    {}\n", scene.derivation);
  }
  print_out(text);
}

RoomDetail detail_of(const GenerateOptions& options) {
  if (options.detail == "simple") return RoomDetail::kSimple;
  if (options.detail == "complex") return RoomDetail::kComplex;
  throw InputError("--detail", "'" + options.detail + "' is no kind of living room",
                   "use simple or complex");
}

void generate_living_room(const GenerateOptions& options) {
  seed_of(options);  // the rooms are fixed; the option is still checked
  write(living_room(detail_of(options)), options);
}

void generate_rooms(const GenerateOptions& options) {
  seed_of(options);
  write(row_of_rooms(count_option("--rooms", options.rooms, 1, kMostRooms), detail_of(options)),
        options);
}

void generate_analytic(const GenerateOptions& options) {
  seed_of(options);
  if (options.list) {
    list_analytic_scenes();
    return;
  }
  for (const AnalyticScene& scene : analytic_scenes()) {
    if (scene.name == options.name) {
      write(scene.scene, options);
      return;
    }
  }
  throw InputError("generate analytic", "no scene is named '" + options.name + "'",
                   "--list shows the names");
}

void generate_soup(const GenerateOptions& options) {
  const std::uint64_t seed = seed_of(options);
  const std::uint64_t triangles = count_option("--triangles", options.triangles, 1, kMostTriangles);
  write(triangle_soup(triangles, seed), options);
}

void generate_gallery(const GenerateOptions& options) {
  seed_of(options);
  if (options.polygon.empty()) {
    throw InputError("POLYGON", "is missing", "give a file with a corner `x y` a line");
  }
  const double height = positive_option("--height", options.height);
  write(gallery(options.polygon, read_floor_plan(options.polygon), height), options);
}

}  // namespace

void add_generate_command(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<GenerateOptions>();
  CLI::App* const generate =
      app.add_subcommand("generate", "write a scene made by rule, and its viewing region");
  generate->require_subcommand(1);

  const auto add_kind = [&](const char* name, const char* what,
                            void (*run)(const GenerateOptions&)) {
    CLI::App* const kind = generate->add_subcommand(name, what);
    kind->add_option("-o,--output", options->file,
                     "OBJ file to write; the region goes beside it, with suffix .region.json")
        ->type_name("FILE");
    add_common_options(*kind, options->common);
    kind->callback([options, run, &exit_code] {
      run(*options);
      exit_code = 0;
    });
    return kind;
  };

  add_kind("living-room", "a furnished living room of 316 or 1228 polygons", generate_living_room)
      ->add_option("--detail", options->detail, "simple (316, default) or complex (1228)")
      ->type_name("KIND");
  CLI::App* const rooms =
      add_kind("rooms", "living rooms in a row with open doors between them", generate_rooms);
  rooms->add_option("--rooms", options->rooms, "how many")->type_name("N")->required();
  rooms->add_option("--detail", options->detail, "simple (default) or complex")->type_name("KIND");
  CLI::App* const analytic =
      add_kind("analytic", "a scene whose answer is known", generate_analytic);
  analytic->add_option("name", options->name, "which one")->type_name("NAME");
  analytic->add_flag("--list", options->list, "print the names and answers");
  add_kind("soup", "random triangles round a square region", generate_soup)
      ->add_option("--triangles", options->triangles, "how many")
      ->type_name("N")
      ->required();
  CLI::App* const art =
      add_kind("gallery", "walls, floor and ceiling over a polygon, seen from half the height",
               generate_gallery);
  art->add_option("polygon", options->polygon,
                  "text file: a corner `x y` a line; `hole` or a blank line starts a hole")
      ->type_name("POLYGON");
  art->add_option("--height", options->height, "of the walls (default: 1)")->type_name("H");
}

}  // namespace viewcover
