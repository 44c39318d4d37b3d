#include "scene/read/json_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "scene/error.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

constexpr std::size_t kDeepest = 64;

std::size_t line_at(std::string_view text, std::size_t position) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(position, text.size()));
  return 1 + static_cast<std::size_t>(std::count(text.begin(), end, '\n'));
}

}  // namespace

void refuse_deep_json(std::string_view text, std::string_view place) {
  std::size_t depth = 0;
  bool in_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (in_string) {
      if (c == '\\') ++i;
      in_string = c != '"';
    } else if (c == '"') {
      in_string = true;
    } else if (c == '[' || c == '{') {
      if (++depth > kDeepest) {
        throw InputError(place, fmt::format("JSON nested deeper than {}", kDeepest),
                         "nothing here needs that");
      }
    } else if ((c == ']' || c == '}') && depth > 0) {
      --depth;
    }
  }
}

nlohmann::json parse_json(std::string_view text, const std::string& file) {
  refuse_utf16(text, file);
  refuse_deep_json(text, file);
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    // The byte is the 1-based number of the last one read; what() is "[id] parse error at line
    // L, column C: reason".
    const std::string_view what = error.what();
    const std::size_t colon = what.find(": ");
    throw InputError(InputError::at_line(file, line_at(text, error.byte - (error.byte > 0))),
                     colon == std::string_view::npos ? what : what.substr(colon + 2),
                     "write valid JSON");
  } catch (const nlohmann::json::out_of_range& error) {
    // "[id] number overflow parsing 'TOKEN'", the only such error of the parser.
    const std::string_view what = error.what();
    const std::size_t open = what.find('\''), close = what.rfind('\'');
    const std::string token(what.substr(open + 1, close - open - 1));
    throw InputError(InputError::at_line(file, line_at(text, text.find(token))),
                     fmt::format("the number {} is not finite as a double", token),
                     "use smaller numbers");
  }
}

}  // namespace viewcover
