#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

#include "scene/error.h"
#include "scene/read/soup_check.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

// Binary STL: 80 bytes of anything, the number of triangles, then for each 12 floats (normal and
// three vertices) and 2 bytes of attributes.
constexpr std::size_t kBinaryHeader = 84;
constexpr std::size_t kBinaryTriangle = 50;

std::uint64_t binary_size(std::string_view text) {
  std::uint32_t triangles = 0;
  std::memcpy(&triangles, text.data() + kBinaryHeader - sizeof triangles, sizeof triangles);
  return kBinaryHeader + std::uint64_t{kBinaryTriangle} * triangles;
}

CheckedSoup check_binary(std::string_view text, const std::string& file) {
  CheckedSoup soup;
  soup.text.assign(text);
  // CGAL takes a file whose header starts with "solid" for text at first, and keeps what it read.
  soup.text.replace(0, 5, "STLB ");
  soup.faces = (text.size() - kBinaryHeader) / kBinaryTriangle;
  for (std::size_t face = 0; face < soup.faces; ++face) {
    float numbers[12];
    std::memcpy(numbers, text.data() + kBinaryHeader + face * kBinaryTriangle, sizeof numbers);
    for (std::size_t i = 3; i < 12; ++i) {
      if (!std::isfinite(numbers[i])) {
        throw InputError(InputError::at_face(file, face + 1), "a coordinate is not finite", "");
      }
    }
  }
  return soup;
}

class StlTextChecker {
 public:
  StlTextChecker(std::string_view text, const std::string& file) : words_(text), file_(file) {}

  CheckedSoup run() {
    soup_.text = "solid\n";
    for (auto word = words_.next(); !word.empty(); word = words_.next()) {
      if (word != "solid") fail(word, "'solid'");
      read_solid();
    }
    soup_.text += "endsolid\n";
    return std::move(soup_);
  }

 private:
  [[noreturn]] void fail(std::string_view found, const std::string& expected) const {
    throw InputError(
        InputError::at_line(file_, words_.line()),
        found.empty() ? "the file is cut short" : in_quotes(found) + " is out of place",
        "here stands " + expected);
  }
  void expect(std::string_view word) {
    if (const auto found = words_.next(); found != word) fail(found, in_quotes(word));
  }

  void read_solid() {
    const std::string name(words_.rest_of_line());
    std::optional<GroupId> group;
    for (auto word = words_.next(); word != "endsolid"; word = words_.next()) {
      if (word != "facet") fail(word, "'facet' or 'endsolid'");
      soup_.face_lines.push_back(words_.line());
      words_.rest_of_line();  // the normal, which follows from the corners
      read_facet();
      if (!group) group = soup_.groups.id(name);
      soup_.face_groups.push_back(*group);
      ++soup_.faces;
    }
    words_.rest_of_line();
  }

  void read_facet() {
    expect("outer");
    expect("loop");
    soup_.text += "facet\n";
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      soup_.text += "vertex";
      for (int i = 0; i < 3; ++i) {
        const auto word = words_.next();
        if (!finite_number(word)) fail(word, "a finite number, such as 1.5 or -2e-3");
        soup_.text.append(" ").append(word);
      }
      soup_.text += '\n';
    }
    expect("endloop");
    expect("endfacet");
    soup_.text += "endfacet\n";
  }

  WordReader words_;
  const std::string& file_;
  CheckedSoup soup_;
};

}  // namespace

CheckedSoup check_stl(std::string_view text, const std::string& file) {
  const bool can_be_binary = text.size() >= kBinaryHeader;
  if (can_be_binary && binary_size(text) == text.size()) return check_binary(text, file);
  if (WordReader(text).next() == "solid") return StlTextChecker(text, file).run();
  if (!can_be_binary) {
    throw InputError(file, "neither a text nor a binary STL file",
                     "a text starts with 'solid', a binary file has at least 84 bytes");
  }
  throw InputError(file, "the file has " + std::to_string(text.size()) + " bytes",
                   "a binary STL file of the number of triangles it claims has " +
                       std::to_string(binary_size(text)));
}

}  // namespace viewcover
