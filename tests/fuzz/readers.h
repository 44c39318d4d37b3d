#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace viewcover::fuzz {

/// A reader of foreign content and what is made of it next.
struct Reader {
  std::string_view name;
  /// Reads; refusals are as good as results. Aborts where a refusal is not one line, or where what
  /// was read is not what the reader promises.
  void (*run)(std::string_view content);
};

std::span<const Reader> readers();
/// Aborts for a name that is none.
const Reader& reader(std::string_view name);

/// The corpus of a reader: one content a line of `FOLDER/NAME.txt`, with `\n`, `\r`, `\t`, `\\`
/// and `\xHH` for bytes that are not readable; lines that start with `#` say what was found.
std::vector<std::string> corpus_of(const Reader& reader, const std::string& folder);

/// Content as such a line, and back.
std::string as_line(std::string_view content);
std::string from_line(std::string_view line);

}  // namespace viewcover::fuzz
