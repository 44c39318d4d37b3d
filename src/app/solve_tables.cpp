#include "app/solve_tables.h"

#include <fmt/core.h>

#include "report/machine.h"

namespace viewcover {

std::string solve_tables(const Solution& solution, const RunSeconds& seconds) {
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
  return text;
}

}  // namespace viewcover
