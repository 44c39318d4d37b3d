#include "app/solve_options.h"

#include <algorithm>
#include <array>

#include "app/option_values.h"
#include "optim/cover_methods.h"
#include "scene/error.h"
#include "scene/read/polygon_soup.h"

namespace viewcover {
namespace {

/// A million rays see through any gap that matters; beyond, a run would never end.
constexpr int kMostRays = 1'000'000;
/// 4^10, the most regions a part (scene/viewing_region.h).
constexpr std::uint64_t kMostRegions = std::uint64_t{1} << 20;
/// Exponents of doubles that leave room for the bits of subdivision on either side.
constexpr int kMostLatticeExponent = 900;

template <class Entry>
std::vector<std::string_view> names_of(std::span<const Entry> entries) {
  std::vector<std::string_view> names;
  for (const Entry& entry : entries) names.push_back(entry.name);
  return names;
}

void require_given(std::string_view option, const std::string& value, std::string_view what) {
  if (value.empty()) throw InputError(option, "is missing", what);
}

void refuse_what_is_not_here(const SolveText& text) {
  using namespace std::string_view_literals;
  require_available("--backend", text.backend, names_of(backends()));
  require_available("--optimizer", text.optimizer, names_of(cover_methods()));
  require_available("--sampling", text.sampling, std::array{"plain"sv, "stratified"sv});
  require_available("--viewpoints", text.viewpoints, std::array{"sa"sv, "none"sv});
  require_available("--coverage", text.coverage, std::array{"elements"sv, "full"sv});
}

}  // namespace

void SolveText::add_to(CLI::App& command) {
  optimizer = cover_methods().front().name;
  const std::string backend_names = alternatives(names_of(backends()));
  const std::string optimizer_names = alternatives(names_of(cover_methods()));
  const auto option = [&](const char* name, std::string& value, const std::string& what,
                          const char* type) {
    return command.add_option(name, value, what)->type_name(type);
  };
  option("scene", scene_file, "the scene: " + mesh_file_types(), "SCENE");
  option("--region", region_file, "the viewing region: .json, " + mesh_file_types(), "REGION");
  option("-o,--output", output, "the folder for the results", "DIR");
  option("--backend", backend, "who decides shafts with several occluders: " + backend_names,
         "NAME");
  option("--rays", rays, "random rays a shaft (default: 16)", "N");
  option("--sampling", sampling, "how rays are drawn: plain (default) or stratified", "KIND");
  option("--regions", regions,
         "viewing regions a polygon or box of the region, a power of 4 (default: 64)", "N");
  option("--element-area", element_area,
         "subdivide elements while larger (default: 1 % of the mean area of the scene's bounding "
         "box faces)",
         "A");
  option("--optimizer", optimizer, "how regions are chosen: " + optimizer_names, "NAME");
  option("--viewpoints", viewpoints, "viewpoint search: sa (default) or none", "NAME");
  option("--coverage", coverage,
         "what viewpoints must do: see a part of each element (elements, default) or image all "
         "that is visible (full)",
         "KIND");
  option("--missed-share", missed_share,
         "with --coverage full: share of the area imaged that one more image may add (default: "
         "0.0001)",
         "SHARE");
  command.add_flag("--one-sided", one_sided, "only the front of a surface counts as visible");
  option("--clearance", clearance, "least distance of a camera from any surface (default: 0)", "D");
  option("--time-limit", time_limit,
         "seconds for choosing regions and viewpoints; then the best so far counts and the exit "
         "code is 1",
         "S");
  option(
      "--close-gap", close_gap,
      "seconds for raising the lower bound and finding fewer viewpoints until they meet (default: "
      "some rounds; 0: none)",
      "S");
  option("--lattice", lattice,
         "round coordinates to multiples of 2^-E (default: 24 bits for the largest)", "E");
  option("--heal", heal,
         "close cracks up to this width: vertices that near to a vertex, an edge or the inside of "
         "a face "
         "are joined to it",
         "W");
  option("--crop", crop, kCropHelp, kCropType);
  option(
      "--aperture", aperture,
      "mark what is visible only through gaps narrower than this, and choose regions without it, "
      "too",
      "W");
  command
      .add_option("--target", targets,
                  "a group to be seen, by its name or its object's, once for each; the others only "
                  "block views (default: all)")
      ->type_name("NAME")
      ->allow_extra_args(false);
  command.add_flag("--merge-coplanar", merge_coplanar, "join exactly coplanar neighbours");
  command.add_flag("--allow-outside", allow_outside, "accept a region outside the scene");
  command.add_flag("--resume", resume, "continue the run that is in DIR, if one is");
  option("--checkpoint", checkpoint,
         "seconds from one save of the visibility found so far to the next (default: 10)", "S");
  option("--memory-limit", memory_limit,
         "end the run when it holds more memory than this, such as 500M or 8G (default: none)",
         "SIZE");
  add_common_options(command, common);
}

SolveOptions::SolveOptions(const SolveText& text)
    : scene_file(text.scene_file),
      region_file(text.region_file),
      output(text.output),
      quiet(text.common.quiet),
      optimizer(text.optimizer),
      one_sided(text.one_sided),
      merge_coplanar(text.merge_coplanar),
      targets(text.targets),
      allow_outside(text.allow_outside),
      resume(text.resume) {
  require_given("SCENE", text.scene_file, "give a scene file");
  require_given("--region", text.region_file, "give a file with the viewing region");
  require_given("--output", text.output, "give a folder for the results, such as -o results");
  refuse_what_is_not_here(text);
  backend = &*std::ranges::find(backends(), text.backend, &BackendEntry::name);
  threads = thread_count(text.common);
  seed = count_option("--seed", text.common.seed, 0, UINT64_MAX);
  backend_options.rays = integer_option("--rays", text.rays, 1, kMostRays);
  backend_options.stratified = text.sampling == "stratified";
  backend_options.seed = seed;
  regions_per_part = count_option("--regions", text.regions, 1, kMostRegions);
  if (!text.element_area.empty()) {
    element_area = positive_option("--element-area", text.element_area);
  }
  clearance = non_negative_option("--clearance", text.clearance);
  if (!text.time_limit.empty()) {
    time_limit_seconds = positive_option("--time-limit", text.time_limit);
  }
  find_viewpoints = text.viewpoints == "sa";
  full_coverage = text.coverage == "full";
  if (full_coverage && !find_viewpoints) {
    throw InputError("--coverage", "full is about viewpoints", "use it with --viewpoints sa");
  }
  if (full_coverage && text.backend != "exact") {
    throw InputError("--coverage", "random rays do not tell what is imaged wholly",
                     "use full with --backend exact");
  }
  if (!text.missed_share.empty()) {
    missed_share = positive_option("--missed-share", text.missed_share);
    if (!full_coverage) {
      throw InputError("--missed-share", "is about full coverage", "use it with --coverage full");
    }
    if (missed_share >= 1) {
      throw InputError("--missed-share", text.missed_share + " is all there is",
                       "give a share below 1, such as 0.0001");
    }
  }
  if (!text.close_gap.empty()) {
    close_gap_seconds = non_negative_option("--close-gap", text.close_gap);
    if (!find_viewpoints) {
      throw InputError("--close-gap", "there are no viewpoints", "use it with --viewpoints sa");
    }
    if (text.backend != "exact") {
      throw InputError("--close-gap", "random rays prove no lower bound",
                       "use it with --backend exact");
    }
  }
  checkpoint_seconds = non_negative_option("--checkpoint", text.checkpoint);
  if (!text.memory_limit.empty()) {
    memory_limit = bytes_option("--memory-limit", text.memory_limit);
  }
  if (!text.crop.empty()) crop = box_option("--crop", text.crop);
  if (!text.heal.empty()) heal = positive_option("--heal", text.heal);
  if (!text.aperture.empty()) aperture = positive_option("--aperture", text.aperture);
  if (!text.lattice.empty()) {
    lattice_exponent =
        integer_option("--lattice", text.lattice, -kMostLatticeExponent, kMostLatticeExponent);
  }
}

Json SolveOptions::to_json(double used_element_area) const {
  Json options;
  options["backend"] = backend->name;
  options["rays"] = backend_options.rays;
  options["sampling"] = backend_options.stratified ? "stratified" : "plain";
  options["regions"] = regions_per_part;
  options["element_area"] = used_element_area;
  options["optimizer"] = optimizer;
  options["viewpoints"] = find_viewpoints ? "sa" : "none";
  options["coverage"] = full_coverage ? "full" : "elements";
  options["missed_share"] = full_coverage ? Json(missed_share) : Json(nullptr);
  options["one_sided"] = one_sided;
  options["clearance"] = clearance;
  options["time_limit"] = time_limit_seconds > 0 ? Json(time_limit_seconds) : Json(nullptr);
  options["close_gap"] = close_gap_seconds ? Json(*close_gap_seconds) : Json(nullptr);
  options["lattice"] = lattice_exponent ? Json(*lattice_exponent) : Json(nullptr);
  options["merge_coplanar"] = merge_coplanar;
  options["heal"] = heal;
  options["crop"] = nullptr;
  if (crop) {
    const Point &low = crop->min(), &high = crop->max();
    options["crop"] = {low.x(), low.y(), low.z(), high.x(), high.y(), high.z()};
  }
  options["targets"] = targets;
  options["aperture"] = aperture > 0 ? Json(aperture) : Json(nullptr);
  options["allow_outside"] = allow_outside;
  return options;
}

}  // namespace viewcover
