#include <fstream>
#include <iterator>
#include <system_error>

#include "scene/error.h"
#include "scene/generate/gallery.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

void end_loop(const std::string& file, FloorPlan& plan) {
  if (plan.empty()) return;
  std::vector<PlanCorner>& loop = plan.back();
  if (loop.size() > 1 && loop.front().position == loop.back().position) loop.pop_back();
  if (loop.size() < 3) {
    throw InputError(InputError::at_line(file, loop.back().line),
                     "the loop that ends here has fewer than 3 corners", "give a corner a line");
  }
}

}  // namespace

FloorPlan read_floor_plan(const std::filesystem::path& path) {
  const std::string file = path.string();
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    throw InputError(file, "is a folder", "give a file with a corner `x y` a line");
  }
  std::ifstream stream(path, std::ios::binary);
  const std::string text((std::istreambuf_iterator<char>(stream)), {});
  if (!stream) throw InputError(file, "cannot be read", "give a file with a corner `x y` a line");
  return parse_floor_plan(text, file);
}

FloorPlan parse_floor_plan(std::string_view content, const std::string& file) {
  refuse_utf16(content, file);
  FloorPlan plan;
  bool in_loop = false;
  LineReader lines(content);
  while (const auto line = lines.next()) {
    const std::vector<std::string_view> words = words_of(*line);
    if (words.empty() && !line->empty() && line->find('#') != line->npos) continue;
    if (words.empty() || words[0] == "hole") {
      if (in_loop) end_loop(file, plan);
      in_loop = false;
      if (words.size() <= 1) continue;
    }
    const auto x = finite_number(words[0]),
               y = words.size() == 2 ? finite_number(words[1]) : std::nullopt;
    if (!x || !y) {
      throw InputError(InputError::at_line(file, lines.line()), in_quotes(*line) + " is no corner",
                       "give two numbers `x y`, or `hole` or a blank line before a hole");
    }
    if (!in_loop) plan.emplace_back();
    in_loop = true;
    plan.back().push_back({Point(*x, *y, 0), lines.line()});
  }
  if (in_loop) end_loop(file, plan);
  if (plan.empty()) throw InputError(file, "has no corners", "give a corner `x y` a line");
  return plan;
}

}  // namespace viewcover
