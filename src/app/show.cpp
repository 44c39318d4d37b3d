#include <fmt/core.h>
#include <tbb/global_control.h>

#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_codes.h"
#include "app/option_values.h"
#include "app/show_query.h"
#include "scene/error.h"
#include "show/figure.h"
#include "show/page.h"

namespace viewcover {
namespace {

struct ShowText {
  CommonOptions common;
  std::string folder, scene, against;
  std::string view, size = "1400x1050", up, colour_by = "covered_by", camera;
  std::string query;
  bool no_page = false, skeleton = false, one_sided = false;
};

/// The two halves of `text` round `separator`.
std::pair<std::string_view, std::string_view> halves(std::string_view option, std::string_view text,
                                                     char separator, std::string_view advice) {
  const auto place = text.find(separator);
  if (place == std::string_view::npos) {
    throw InputError(option, "'" + std::string(text) + "' is no pair", advice);
  }
  return {text.substr(0, place), text.substr(place + 1)};
}

PixelSize size_of(const std::string& text) {
  const auto [width, height] = halves("--size", text, 'x', "give WIDTHxHEIGHT in pixels");
  return {integer_option("--size", width, 200, 10'000),
          integer_option("--size", height, 150, 10'000)};
}

ViewDirection view_of(const std::string& text) {
  const std::string advice = "give AZIMUTH,ELEVATION in degrees, such as 235,38";
  const auto [azimuth, elevation] = halves("--view", text, ',', advice);
  ViewDirection view;
  view.azimuth = number_option("--view", azimuth, -360, 360);
  view.elevation = number_option("--view", elevation, -90, 90);
  return view;
}

FigureOptions figure_options(const ShowText& text) {
  FigureOptions options;
  options.size = size_of(text.size);
  if (!text.view.empty()) options.view = view_of(text.view);
  if (!text.up.empty()) {
    using namespace std::string_view_literals;
    require_available("--up", text.up, std::array{"x"sv, "y"sv, "z"sv});
    options.up_axis = text.up[0] - 'x';
  }
  require_available("--colour-by", text.colour_by, colour_by_names());
  options.colour_by = *colour_by_named(text.colour_by);
  if (!text.camera.empty()) {
    options.viewpoint = count_option("--camera", text.camera, 1, UINT32_MAX) - 1;
  }
  return options;
}

/// The folder's own name.
std::string name_of(const std::filesystem::path& folder) {
  const auto whole = std::filesystem::absolute(folder).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

std::string write_page(const RunData& run, const CommonElements& shown,
                       const std::optional<RunData>& other, const FigureOptions& options,
                       const ShowText& text) {
  const PageContent content{run,
                            shown,
                            other ? &*other : nullptr,
                            name_of(text.folder),
                            other ? name_of(text.against) : std::string(),
                            *options.up_axis,
                            options.view.value_or(ViewDirection())};
  const auto file = std::filesystem::path(text.folder) / "report.html";
  write_page(content, file);
  return file.string();
}

int show_query(const ShowText& text, const FigureOptions& options) {
  std::filesystem::path folder = text.folder;
  if (folder.empty()) folder = std::filesystem::path(text.query).parent_path();
  return show_queries(
      {text.query, folder, text.skeleton, text.one_sided, options.view, options.size});
}

int show(const ShowText& text) {
  FigureOptions options = figure_options(text);
  if (!text.query.empty()) return show_query(text, options);
  if (text.folder.empty()) throw InputError("DIR", "is missing", "give the folder of a run");
  const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                    static_cast<std::size_t>(thread_count(text.common)));
  const std::filesystem::path folder = text.folder;
  const RunData run = load_run_data(folder, text.scene);
  std::optional<RunData> other;
  if (!text.against.empty()) other = load_run_data(text.against, text.scene);
  const CommonElements shown =
      other ? common_elements(run, *other, "--against") : common_elements(run);
  options.up_axis = options.up_axis.value_or(up_axis_of(run));
  const bool from_outside = !options.viewpoint || !text.no_page;
  if (from_outside && !options.view) options.view = default_view(run, shown, *options.up_axis);
  const auto figure =
      folder / (options.viewpoint ? fmt::format("camera_{}.png", *options.viewpoint + 1)
                                  : std::string("figure.png"));
  draw_figure(run, shown, options, figure);
  Json line = {{"figure", figure.string()}};
  if (!text.no_page) line["page"] = write_page(run, shown, other, options, text);
  print_out(line.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  return kDone;
}

}  // namespace

void add_show_command(CLI::App& app, int& exit_code) {
  const auto text = std::make_shared<ShowText>();
  CLI::App* const command =
      app.add_subcommand("show", "draw a run: a picture and a page to explore it");
  command->add_option("folder", text->folder, "the folder of the run")->type_name("DIR");
  command->add_option("--scene", text->scene, "the scene of the run, where it has moved")
      ->type_name("FILE");
  command->add_option("--against", text->against, "another run to compare with")->type_name("DIR2");
  command->add_option("--view", text->view, "from where, degrees; default: the best of eight")
      ->type_name("AZIMUTH,ELEVATION");
  command->add_option("--up", text->up, "which way is up; default: across the viewing region")
      ->type_name("x|y|z");
  command->add_option("--size", text->size, "of the picture, pixels")
      ->type_name("WIDTHxHEIGHT")
      ->capture_default_str();
  command
      ->add_option("--colour-by", text->colour_by,
                   "times_visible, covered_by, viewpoints, difference, group or unseen")
      ->type_name("WHAT")
      ->capture_default_str();
  command->add_option("--camera", text->camera, "draw what this viewpoint sees, all round")
      ->type_name("N");
  command
      ->add_option("--query", text->query,
                   "draw queries of `sees` instead, into DIR or beside their file")
      ->type_name("FILE");
  command->add_flag("--skeleton", text->skeleton, "with --query: extremal stabbing lines, too");
  command->add_flag("--one-sided", text->one_sided,
                    "with --query: only the front of an element counts as visible");
  command->add_flag("--no-page", text->no_page, "draw the picture only");
  add_common_options(*command, text->common);
  command->callback([text, &exit_code] { exit_code = show(*text); });
}

}  // namespace viewcover
