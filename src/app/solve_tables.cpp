#include "app/solve_tables.h"

#include <fmt/core.h>

#include <algorithm>

#include "full_coverage/full_coverage.h"
#include "report/machine.h"

namespace viewcover {

namespace {

std::string viewpoint_tables(const ViewpointSet& set, std::size_t regions, Guarantee guarantee,
                             double seconds) {
  const FullCoverage* full = set.full.get();
  std::string text = fmt::format("\n{:>10} {:>16} {:>14}{}\n", "viewpoints", "percent",
                                 "found at (s)", full != nullptr ? "   area imaged (%)" : "");
  for (std::size_t i = 0; i < set.viewpoints.size(); ++i) {
    text +=
        fmt::format("{:>10} {:>16.4f} {:>14.3f}", i + 1, set.covered_percent[i], set.seconds[i]);
    if (full != nullptr) text += fmt::format(" {:>17.4f}", full->imaged_percent[i]);
    text += '\n';
  }
  if (full != nullptr) {
    text += fmt::format("No further viewpoint that was found adds more than {:.4f} %.\n",
                        full->further_gain_percent);
  }
  text += fmt::format("\n{:>10} {:>16} {:>14} {:>10} {:>16}\n", "regions", "viewpoints",
                      "lower bound", "gap", "search (s)");
  const bool proved = guarantee == Guarantee::kExact;
  text += fmt::format("{:>10} {:>16} {:>14} {:>10} {:>16.3f}\n", regions, set.viewpoints.size(),
                      proved ? std::to_string(set.lower_bound) : "none",
                      proved ? std::to_string(set.viewpoints.size() -
                                              std::min(set.lower_bound, set.viewpoints.size()))
                             : "",
                      seconds);
  return text;
}

}  // namespace

std::string solve_tables(const Solution& solution, Guarantee guarantee, const RunSeconds& seconds) {
  std::string text =
      fmt::format("{:>10} {:>16} {:>10} {:>16} {:>18} {:>12}\n", "elements", "visibility (s)",
                  "links", "optimal regions", "optimization (s)", "memory (kb)");
  text += fmt::format("{:>10} {:>16.3f} {:>10} {:>16} {:>18.3f} {:>12}\n\n",
                      solution.matrix.elements.size(), seconds.visibility, solution.links.size(),
                      solution.cover.size(), seconds.cover, peak_memory_kb());
  text += fmt::format("{:>10} {:>16} {:>22} {:>14}\n", "regions", "percent",
                      "visibility evaluations", "time (s)");
  for (const CoverStep& step : solution.cover.steps) {
    text += fmt::format("{:>10} {:>16.4f} {:>22} {:>14.3f}\n", step.k, step.covered_percent,
                        step.evaluations, step.seconds);
  }
  if (solution.wide != nullptr) {
    const WideVisibility& wide = solution.wide->visibility;
    text += fmt::format(
        "Without what is visible only through {} patches of gaps narrower than {}: {} elements of "
        "{}, {} regions.\n",
        wide.gaps.size(), wide.width, count_bits(wide.bits.union_of_all()),
        count_bits(solution.matrix.bits.union_of_all()), solution.wide->cover.size());
  }
  if (solution.viewpoints != nullptr) {
    text += viewpoint_tables(*solution.viewpoints, solution.cover.size(), guarantee,
                             seconds.viewpoints);
  }
  return text;
}

}  // namespace viewcover
