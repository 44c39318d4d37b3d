#include <array>
#include <string>
#include <vector>

#include "scene/error.h"
#include "scene/read/soup_check.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

using Words = std::vector<std::string_view>;

[[noreturn]] void fail(const std::string& file, const LineReader& lines, const std::string& wrong,
                       const std::string& right) {
  throw InputError(InputError::at_line(file, lines.line()), wrong, right);
}

bool is_keyword(std::string_view word) {
  for (const std::string_view optional : {"ST", "C", "N"}) {
    if (word.starts_with(optional)) word.remove_prefix(optional.size());
  }
  return word == "OFF";
}

// Numbers of vertices and faces; the number of edges that follows is not used by anyone.
std::array<std::size_t, 2> read_counts(const std::string& file, LineReader& lines) {
  Words words = lines.next_words();
  if (words.empty() || !is_keyword(words[0])) {
    fail(file, lines, words.empty() ? "no OFF header" : in_quotes(words[0]) + " is no OFF header",
         "text files that start with OFF, COFF, NOFF, CNOFF or ST in front of these are read");
  }
  words.erase(words.begin());
  if (words.empty()) words = lines.next_words();
  std::array<std::size_t, 2> counts{};
  for (std::size_t i = 0; i < 2; ++i) {
    const auto count = i < words.size() ? whole_number(words[i]) : std::nullopt;
    if (!count || *count < 0) {
      fail(file, lines, "the header does not give the numbers of vertices and faces",
           "two or three whole numbers (binary OFF is not read)");
    }
    counts[i] = static_cast<std::size_t>(*count);
  }
  return counts;
}

[[noreturn]] void fail_short(const std::string& file, const char* what, std::size_t found,
                             std::size_t claimed) {
  throw InputError(file,
                   "the file ends after " + std::to_string(found) + " of " +
                       std::to_string(claimed) + " " + what,
                   "the header's counts and the lines must agree");
}

}  // namespace

CheckedSoup check_off(std::string_view text, const std::string& file) {
  LineReader lines(text);
  const auto [vertices, faces] = read_counts(file, lines);
  CheckedSoup soup;
  soup.text = "OFF\n" + std::to_string(vertices) + " " + std::to_string(faces) + " 0\n";
  for (; soup.vertices < vertices; ++soup.vertices) {
    const Words words = lines.next_words();
    if (words.empty()) fail_short(file, "vertices", soup.vertices, vertices);
    if (words.size() < 3) {
      fail(file, lines, "a vertex with " + std::to_string(words.size()) + " coordinates",
           "3 are needed");
    }
    for (std::size_t i = 0; i < 3; ++i) {
      if (!finite_number(words[i])) {
        fail(file, lines, "coordinate " + in_quotes(words[i]) + " is not a finite number",
             "such as 1.5 or -2e-3");
      }
      soup.text.append(words[i]).append(i < 2 ? " " : "\n");
    }
    soup.vertex_lines.push_back(lines.line());
  }
  for (; soup.faces < faces; ++soup.faces) {
    const Words words = lines.next_words();
    if (words.empty()) fail_short(file, "faces", soup.faces, faces);
    const auto corners = whole_number(words[0]);
    if (!corners || *corners < 0) {
      fail(file, lines, in_quotes(words[0]) + " is no number of corners", "such as 3");
    }
    if (static_cast<unsigned long long>(*corners) > words.size() - 1) {
      fail(file, lines,
           "a face of " + std::to_string(*corners) + " corners on a line with " +
               std::to_string(words.size() - 1) + " numbers after it",
           "the corners of a face stand on one line");
    }
    const auto end = static_cast<std::size_t>(*corners);
    soup.text += std::to_string(end);
    for (std::size_t i = 1; i <= end; ++i) {
      const auto vertex = whole_number(words[i]);
      if (!vertex) fail(file, lines, in_quotes(words[i]) + " is no vertex number", "such as 7");
      if (*vertex < 0 || static_cast<unsigned long long>(*vertex) >= vertices) {
        fail(file, lines, "vertex " + std::to_string(*vertex) + " does not exist",
             "the file has " + std::to_string(vertices) + ", numbered from 0");
      }
      soup.text.append(" ").append(std::to_string(*vertex));
    }
    soup.text += '\n';
    soup.face_lines.push_back(lines.line());
  }
  if (!lines.next_words().empty()) {
    fail(file, lines,
         "more lines than the " + std::to_string(vertices) + " vertices and " +
             std::to_string(faces) + " faces of the header",
         "the header's counts and the lines must agree");
  }
  return soup;
}

}  // namespace viewcover
