#include <fmt/core.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <system_error>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_codes.h"
#include "app/interrupt.h"
#include "app/option_values.h"
#include "app/sight_json.h"
#include "app/skeleton_json.h"
#include "approx/ray_query.h"
#include "optim/stopwatch.h"
#include "scene/error.h"
#include "scene/predicates.h"
#include "scene/read/json_text.h"

namespace viewcover {
namespace {

struct SeesText {
  CommonOptions common;
  std::string file, backend = "exact", rays = "16";
  bool one_sided = false, skeleton = false;
};

struct SeesOptions {
  bool exact = true;
  int rays = 16;
  std::uint64_t seed = 1;
  bool one_sided = false, skeleton = false;

  explicit SeesOptions(const SeesText& text) : one_sided(text.one_sided), skeleton(text.skeleton) {
    using namespace std::string_view_literals;
    require_available("--backend", text.backend, std::array{"exact"sv, "rays"sv});
    exact = text.backend == "exact";
    if (skeleton && !exact) {
      throw InputError("--skeleton", "is exact; random rays find none", "use --backend exact");
    }
    rays = integer_option("--rays", text.rays, 1, 1'000'000);
    seed = count_option("--seed", text.common.seed, 0, UINT64_MAX);
    if (!text.common.threads.empty()) count_option("--threads", text.common.threads, 1, 1024);
  }
};

/// Random rays: visible is certain; fully only if there is nothing between.
SightAnswer ask_rays(const ReadQuery& read, const SeesOptions& options) {
  const SightQuery& query = read.query;
  const std::vector<std::span<const Point>> occluders(query.occluders.begin(),
                                                      query.occluders.end());
  const std::span<const Point> from =
      read.from_viewpoint ? std::span<const Point>(&query.viewpoint, 1) : query.region;
  SightAnswer answer;
  const auto side = [&](const Point& p) {
    const auto corners = turning_corners(query.element);
    return orientation(query.element[corners[0]], query.element[corners[1]],
                       query.element[corners[2]], p);
  };
  const bool facing = std::any_of(from.begin(), from.end(), [&](const Point& p) {
    return options.one_sided ? side(p) > 0 : side(p) != 0;
  });
  if (!facing) return answer;
  answer.witness = find_sight_line({from, query.element, occluders, options.one_sided},
                                   options.rays, options.seed);
  answer.verdict = !answer.witness     ? Verdict::kHiddenAllRaysBlocked
                   : occluders.empty() ? Verdict::kFullyVisible
                                       : Verdict::kVisibleWitness;
  return answer;
}

Json skeleton(const ReadQuery& read) {
  if (read.from_viewpoint) {
    throw InputError("viewpoint", "has no skeleton", "give a region");
  }
  return to_json(visibility_skeleton(read.query));
}

Json answer(const Json& object, const SeesOptions& options) {
  const Stopwatch time;
  ReadQuery read = read_query(object);
  read.query.one_sided = options.one_sided;
  if (options.skeleton) {
    Json json = {{"id", read.id}};
    json.update(skeleton(read));
    json["ms"] = 1e3 * time.seconds();
    return json;
  }
  PointAnswer found;
  if (!options.exact) {
    static_cast<SightAnswer&>(found) = ask_rays(read, options);
  } else if (read.from_viewpoint) {
    found = decide_from_point(read.query);
  } else {
    static_cast<SightAnswer&>(found) = decide_from_region(read.query);
  }
  Json json;
  json["id"] = read.id;
  json["visible"] = is_visible(found.verdict);
  json["fully"] = found.verdict == Verdict::kFullyVisible;
  json["by"] = name(found.verdict);
  if (found.witness) json["witness"] = to_json(*found.witness, read.query);
  if (options.exact && read.from_viewpoint) json["visible_fraction"] = found.visible_fraction;
  json["ms"] = 1e3 * time.seconds();
  return json;
}

int sees(const SeesText& text) {
  const SeesOptions options(text);
  std::ifstream file;
  if (!text.file.empty() && text.file != "-") {
    std::error_code ignored;
    if (std::filesystem::is_directory(text.file, ignored)) {
      throw InputError(text.file, "is a folder", "give a file of JSON lines");
    }
    file.open(text.file);
    if (!file) throw InputError(text.file, "cannot be read", "give a file of JSON lines");
  }
  std::istream& in = file.is_open() ? file : std::cin;
  bool any_bad = false;
  std::string line;
  while (std::getline(in, line)) {
    if (interrupt_flag()) throw Interrupted();
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    Json result, object;
    try {
      refuse_deep_json(line, "query");
      object = Json::parse(line);
      result = answer(object, options);
    } catch (const Json::exception& error) {
      result = {{"id", id_of(object)}, {"error", std::string("no JSON: ") + error.what()}};
    } catch (const InputError& error) {
      result = {{"id", id_of(object)}, {"error", error.what()}};
    }
    any_bad = any_bad || result.contains("error");
    print_out(result.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n");
  }
  if (in.bad()) throw InputError(text.file, "cannot be read to its end", "");
  return any_bad ? kBadInput : kDone;
}

}  // namespace

void add_sees_command(CLI::App& app, int& exit_code) {
  const auto text = std::make_shared<SeesText>();
  CLI::App* const command = app.add_subcommand(
      "sees",
      "answer single queries, JSON lines in, JSON lines out: does a region or a viewpoint "
      "see an element?");
  command->add_option("file", text->file, "the queries (default: standard input)")
      ->type_name("FILE");
  command->add_option("--backend", text->backend, "who decides: exact (default) or rays")
      ->type_name("NAME");
  command->add_option("--rays", text->rays, "random rays a query (default: 16)")->type_name("N");
  command->add_flag("--one-sided", text->one_sided,
                    "only the front of an element counts as visible");
  command->add_flag("--skeleton", text->skeleton,
                    "instead of verdicts: the visibility skeleton of each shaft as a graph");
  add_common_options(*command, text->common);
  command->callback([text, &exit_code] { exit_code = sees(*text); });
}

}  // namespace viewcover
