#include "report/run_record.h"

#include <fstream>

#include "full_coverage/full_coverage.h"
#include "report/build_info.h"
#include "report/machine.h"
#include "report/sha256.h"
#include "scene/error.h"

namespace viewcover {
namespace {

Json input(const std::filesystem::path& file) {
  return {{"file", file.string()}, {"sha256", sha256_of_file(file)}};
}

Json seconds_of(const RunSeconds& seconds) {
  Json json;
  json["visibility"] = seconds.visibility;
  json["cover"] = seconds.cover;
  if (seconds.wide) json["wide"] = *seconds.wide;
  json["viewpoints"] = seconds.viewpoints;
  json["total"] = seconds.total;
  return json;
}

std::vector<std::size_t> numbers_of(std::vector<std::size_t> rows) {
  for (std::size_t& row : rows) ++row;
  return rows;
}

/// What is left where gaps narrower than the aperture are closed.
Json wide_results(const Solution& solution) {
  const auto& [wide, cover] = *solution.wide;
  std::size_t narrow_pairs = 0;
  for (std::size_t row = 0; row < wide.bits.rows(); ++row) {
    narrow_pairs += count_bits(solution.matrix.bits.row(row)) - count_bits(wide.bits.row(row));
  }
  return {{"gaps", wide.gaps.size()},
          {"gaps_entered", wide.gaps_entered},
          {"narrow_pairs", narrow_pairs},
          {"visible_elements", count_bits(wide.bits.union_of_all())},
          {"optimal_regions", cover.size()},
          {"chosen", cover.steps.empty() ? std::vector<std::size_t>()
                                         : numbers_of(cover.steps.back().chosen)},
          {"regions_lower_bound", cover.lower_bound},
          {"proved", cover.proved()}};
}

}  // namespace

Json repairs_of(const Scene& scene) {
  const Repairs& repairs = scene.repairs;
  return {{"welded_vertices", repairs.welded_vertices},
          {"degenerate_faces", repairs.degenerate_faces},
          {"duplicate_faces", repairs.duplicate_faces},
          {"split_faces", repairs.split_faces},
          {"triangulated_faces", repairs.triangulated_faces},
          {"merged_surfaces", repairs.merged_surfaces},
          {"largest_move", repairs.largest_move},
          {"healed_vertices", repairs.healing.moved},
          {"healed_edges", repairs.healing.inserted},
          {"healed_faces", repairs.healing.bent},
          {"largest_healing_move", repairs.healing.largest_move},
          {"cropped_faces", repairs.cropped_faces}};
}

Json make_run_record(const std::filesystem::path& scene_file,
                     const std::filesystem::path& region_file, const Scene& scene,
                     std::uint64_t seed, const Json& options, int threads) {
  const BuildInfo build = build_info();
  const Machine machine = this_machine();
  Json record;
  record["complete"] = false;
  record["program"] = "viewcover";
  record["version"] = build.version;
  record["commit"] = build.commit;
  record["compiler"] = build.compiler;
  record["inputs"] = {{"scene", input(scene_file)}, {"region", input(region_file)}};
  record["seed"] = seed;
  record["options"] = options;
  record["scene"] = {{"name", scene.name},
                     {"faces", scene.faces},
                     {"polygons", scene.surfaces.size()},
                     {"groups", scene.groups.size()},
                     {"area", scene.area()},
                     {"lattice_exponent", scene.lattice.exponent},
                     {"repairs", repairs_of(scene)}};
  record["measured"] = {{"started", utc_now()},
                        {"threads", threads},
                        {"machine",
                         {{"processor", machine.processor},
                          {"system", machine.system},
                          {"cores", machine.cores},
                          {"memory_kb", machine.memory_kb}}}};
  return record;
}

void add_results(Json& record, const Solution& solution, Guarantee guarantee,
                 const RunSeconds& seconds) {
  Json verdicts = Json::object();
  for (std::size_t i = 0; i < kVerdictCount; ++i) {
    const Verdict verdict = static_cast<Verdict>(i);
    verdicts[std::string(name(verdict))] = solution.links.verdicts(verdict);
  }
  record["verdicts"] = verdicts;
  Json statistics = Json::object();
  for (const auto& [what, count] : solution.backend_statistics) statistics[what] = count;
  record["backend_statistics"] = statistics;
  record["results"] = {{"regions", solution.region.region_count()},
                       {"elements", solution.matrix.elements.size()},
                       {"visible_elements", visible_elements(solution.matrix)},
                       {"links", solution.links.size()},
                       {"optimal_regions", solution.cover.size()},
                       {"chosen", numbers_of(solution.chosen())},
                       {"regions_lower_bound", solution.cover.lower_bound},
                       {"proved", solution.cover.proved()},
                       {"lower_bound", nullptr}};
  if (guarantee == Guarantee::kExact) record["results"]["lower_bound"] = solution.lower_bound();
  if (const ViewpointSet* set = solution.viewpoints) {
    Json& results = record["results"];
    results["viewpoints"] = set->viewpoints.size();
    results["viewpoints_by_annealing_alone"] = set->paper_viewpoints;
    results["viewpoints_lower_bound"] = nullptr;
    if (guarantee == Guarantee::kExact) results["viewpoints_lower_bound"] = set->lower_bound;
    results["elements_from_no_position"] = set->missing.size();
    results["positions"] = set->positions;
    results["candidates"] = set->candidates;
    results["least_fractional_cover_by_candidates"] = set->relaxation;
    if (const FullCoverage* full = set->full.get()) {
      results["imaged_percent"] = full->imaged_percent.back();
      results["further_gain_percent"] = full->further_gain_percent;
      results["further_positions"] = full->further_positions;
      results["witnesses"] = full->witnesses.size();
      results["bound_columns"] = full->bound_is_of_witnesses ? "witnesses" : "elements";
    }
  }
  if (solution.wide != nullptr) record["results"]["wide"] = wide_results(solution);
  Json& measured = record["measured"];
  // Where a time limit strikes depends on the machine.
  measured["time_limit_reached"] = solution.time_limit_reached();
  measured["seconds"] = seconds_of(seconds);
  measured["peak_memory_kb"] = peak_memory_kb();
  measured["link_memory_bytes"] = solution.links.memory_bytes();
}

Json summary_line(const Json& record) {
  const Json &scene = record.at("scene"), &results = record.at("results"),
             &measured = record.at("measured");
  Json line;
  line["scene"] = scene.at("name");
  line["backend"] = record.at("options").at("backend");
  line["polygons"] = scene.at("polygons");
  for (const char* key : {"regions", "elements", "visible_elements", "links", "optimal_regions",
                          "proved", "lower_bound"}) {
    line[key] = results.at(key);
  }
  if (results.contains("wide")) {
    line["optimal_regions_wide"] = results.at("wide").at("optimal_regions");
  }
  line["viewpoints"] = results.value("viewpoints", Json());
  if (results.contains("imaged_percent")) line["imaged_percent"] = results.at("imaged_percent");
  line["seconds"] = measured.at("seconds");
  line["peak_memory_kb"] = measured.at("peak_memory_kb");
  return line;
}

Json read_complete_run(const std::filesystem::path& folder) {
  const std::string file = (folder / "run.json").string();
  std::ifstream stream(file);
  if (!stream) throw InputError(file, "cannot be read", "give the folder of a finished run");
  Json record = Json::parse(stream, nullptr, false);
  if (!record.is_object()) throw InputError(file, "is no JSON object", "");
  if (!record.value("complete", false)) {
    throw InputError(file, "says that the run is not complete", "let it end");
  }
  return record;
}

std::size_t visible_elements(const VisibilityMatrix& matrix) {
  return count_bits(matrix.bits.union_of_all());
}

}  // namespace viewcover
