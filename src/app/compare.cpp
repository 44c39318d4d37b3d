#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "app/commands.h"
#include "app/console.h"
#include "app/exit_codes.h"
#include "compare/run_comparison.h"
#include "scene/error.h"

namespace viewcover {
namespace {

struct CompareText {
  CommonOptions common;
  std::string judged, reference, scene;
};

Json as_json(const PairCount& pairs) { return {{"count", pairs.count}, {"area", pairs.area}}; }

Json as_json(const PairsByVerdict& pairs) {
  Json by_verdict = Json::object();
  for (std::size_t i = 0; i < kVerdictCount; ++i) {
    if (pairs[i].count == 0) continue;
    by_verdict[std::string(name(static_cast<Verdict>(i)))] = as_json(pairs[i]);
  }
  return by_verdict;
}

Json as_json(const RunComparison& c) {
  return {{"Q_u", {{"count", c.missed_share()}, {"area", c.missed_area_share()}}},
          {"Q_o", {{"count", c.excess_share()}, {"area", c.excess_area_share()}}},
          {"pairs", {{"a", as_json(c.judged_pairs)}, {"b", as_json(c.reference_pairs)}}},
          {"missed", as_json(c.missed_by_verdict)},
          {"excess", as_json(c.excess_by_verdict)},
          {"optimum",
           {{"regions", c.optimum},
            {"covered_percent_by_a", c.claimed_percent},
            {"covered_percent_by_b", c.confirmed_percent},
            {"elements_left_out_by_b", c.left_out}}}};
}

/// Percent to two digits; what is not all never reads as 100.
double rounded_down(double percent) { return std::floor(100 * percent) / 100; }

std::string as_table(const RunComparison& c) {
  std::string text = fmt::format(
      "{:10} {:>10} {:>14}   of the pairs of B\n"
      "{:10} {:>9.4f}% {:>13.4f}%   missed by A (Q_u)\n"
      "{:10} {:>9.4f}% {:>13.4f}%   in A only (Q_o)\n",
      "", "by count", "by area", "Q_u", 100 * c.missed_share(), 100 * c.missed_area_share(), "Q_o",
      100 * c.excess_share(), 100 * c.excess_area_share());
  const auto list = [&](std::string_view what, const PairsByVerdict& pairs) {
    for (std::size_t i = 0; i < kVerdictCount; ++i) {
      if (pairs[i].count == 0) continue;
      text += fmt::format("{} pairs, {:.6g} of area: {} {}\n", pairs[i].count, pairs[i].area, what,
                          name(static_cast<Verdict>(i)));
    }
  };
  list("missed, in B", c.missed_by_verdict);
  list("in A only, there", c.excess_by_verdict);
  text += fmt::format(
      "the {} regions chosen in A cover {:.2f} % of what regions see in A, {:.2f} % in B",
      c.optimum, rounded_down(c.claimed_percent), rounded_down(c.confirmed_percent));
  if (c.left_out > 0) text += fmt::format(": {} elements left out", c.left_out);
  return text + "\n";
}

int compare_runs(const CompareText& text) {
  if (text.judged.empty() || text.reference.empty()) {
    throw InputError("DIR_A DIR_B", "are missing", "give the folders of two runs");
  }
  const RunData judged = load_run_data(text.judged, text.scene),
                reference = load_run_data(text.reference, text.scene);
  const RunComparison comparison =
      compare({judged, PairVerdicts(text.judged, judged)},
              {reference, PairVerdicts(text.reference, reference)}, text.reference);
  if (comparison.reference_pairs.count == 0) {
    throw InputError(text.reference, "no region sees any element", "give a run that has links");
  }
  if (!text.common.quiet) print_out(as_table(comparison));
  print_out(as_json(comparison).dump() + "\n");
  return kDone;
}

}  // namespace

void add_compare_command(CLI::App& app, int& exit_code) {
  const auto text = std::make_shared<CompareText>();
  CLI::App* const command =
      app.add_subcommand("compare", "how far a run is from another one that judges it");
  command->add_option("judged", text->judged, "the folder of the run to judge")->type_name("DIR_A");
  command->add_option("reference", text->reference, "the folder of the run that judges")
      ->type_name("DIR_B");
  command->add_option("--scene", text->scene, "the scene of the runs, where it has moved")
      ->type_name("FILE");
  add_common_options(*command, text->common);
  command->callback([text, &exit_code] { exit_code = compare_runs(*text); });
}

}  // namespace viewcover
