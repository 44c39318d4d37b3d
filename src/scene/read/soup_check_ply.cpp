#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "scene/error.h"
#include "scene/read/soup_check.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

enum class Format { kText, kLittleEndian, kBigEndian };

struct NumberType {
  std::string_view name;     // as CGAL knows it
  std::string_view synonym;  // the other name in use
  std::size_t bytes;
  bool is_integer;
  bool is_signed;
};
constexpr std::array<NumberType, 8> kTypes = {{{"char", "int8", 1, true, true},
                                               {"uchar", "uint8", 1, true, false},
                                               {"short", "int16", 2, true, true},
                                               {"ushort", "uint16", 2, true, false},
                                               {"int", "int32", 4, true, true},
                                               {"uint", "uint32", 4, true, false},
                                               {"float", "float32", 4, false, true},
                                               {"double", "float64", 8, false, true}}};

struct Property {
  std::string name;
  const NumberType* type = nullptr;
  const NumberType* count_type = nullptr;  // of a list; null for a single number
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;

  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool is_face() const { return name == "face" || name == "faces"; }
};

bool is_corner_list(const Property& property) {
  return property.count_type != nullptr &&
         (property.name == "vertex_indices" || property.name == "vertex_index");
}

// 0, 1, 2 for x, y, z; 3 for any other property.
std::size_t coordinate(const Property& property) {
  if (property.count_type != nullptr || property.name.size() != 1) return 3;
  return std::min<std::size_t>(std::string_view("xyz").find(property.name), 3);
}

struct Header {
  Format format = Format::kText;
  std::vector<Element> elements;
};

class HeaderReader {
 public:
  HeaderReader(LineReader& lines, const std::string& file) : lines_(lines), file_(file) {}

  Header read() {
    if (lines_.next_words() != std::vector<std::string_view>{"ply"}) {
      fail("no PLY header", "a PLY file starts with the line 'ply'");
    }
    bool has_format = false;
    for (auto words = lines_.next_words(); words != std::vector<std::string_view>{"end_header"};
         words = lines_.next_words()) {
      if (words.empty()) fail("the header does not end", "it ends with the line 'end_header'");
      if (words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "format" && words.size() == 3) {
        header_.format = format(words[1]);
        has_format = true;
      } else if (words[0] == "element" && words.size() == 3) {
        add_element(words);
      } else if (words[0] == "property" && (words.size() == 3 || words.size() == 5)) {
        add_property(words);
      } else {
        fail(in_quotes(words[0]) + " is out of place or incomplete",
             "a header has the lines format, element, property, comment, end_header");
      }
    }
    if (!has_format) fail("the header names no format", "such as 'format ascii 1.0'");
    check_elements();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& wrong, const std::string& right) const {
    throw InputError(InputError::at_line(file_, lines_.line()), wrong, right);
  }

  Format format(std::string_view word) const {
    if (word == "ascii") return Format::kText;
    if (word == "binary_little_endian") return Format::kLittleEndian;
    if (word == "binary_big_endian") return Format::kBigEndian;
    fail("the format " + in_quotes(word) + " is not known",
         "ascii, binary_little_endian or binary_big_endian");
  }
  const NumberType* type(std::string_view word) const {
    for (const NumberType& type : kTypes) {
      if (word == type.name || word == type.synonym) return &type;
    }
    fail("the type " + in_quotes(word) + " is not known", "such as int, uchar, float or double");
  }

  void add_element(const std::vector<std::string_view>& words) {
    const auto count = whole_number(words[2]);
    if (!count || *count < 0) fail(in_quotes(words[2]) + " is no count", "such as 8");
    header_.elements.push_back({std::string(words[1]), static_cast<std::uint64_t>(*count), {}});
  }

  void add_property(const std::vector<std::string_view>& words) {
    if (header_.elements.empty()) fail("a property of no element", "'element' comes before it");
    Property property{std::string(words.back()), nullptr, nullptr};
    if (words.size() == 5) {
      if (words[1] != "list") fail(in_quotes(words[1]) + " is out of place", "'list' stands there");
      property.count_type = type(words[2]);
      property.type = type(words[3]);
      if (!property.count_type->is_integer) {
        fail("a list counted by " + in_quotes(words[2]), "counts are whole numbers");
      }
    } else {
      property.type = type(words[1]);
    }
    header_.elements.back().properties.push_back(property);
  }

  // Exactly one element of vertices with coordinates that CGAL reads, then one of faces.
  void check_elements() const {
    std::array<int, 4> coordinates{};
    int vertex_elements = 0, face_elements = 0, corner_lists = 0;
    for (const Element& element : header_.elements) {
      vertex_elements += element.is_vertex();
      face_elements += element.is_face();
      if (element.is_face() && vertex_elements == 0) {
        fail("the faces come before the vertices", "vertices come first");
      }
      for (const Property& property : element.properties) {
        if (element.is_vertex() && coordinate(property) < 3) {
          ++coordinates[coordinate(property)];
          if (property.type->is_integer) {
            fail("coordinates of type " + std::string(property.type->name),
                 "they are of type float or double");
          }
        }
        if (element.is_face() && is_corner_list(property)) {
          ++corner_lists;
          if (!property.type->is_integer || property.type->bytes != 4) {
            fail("corners of type " + std::string(property.type->name),
                 "they are of type int or uint");
          }
        }
      }
    }
    if (vertex_elements != 1 || coordinates[0] != 1 || coordinates[1] != 1 || coordinates[2] != 1) {
      fail("the header does not declare vertices once with x, y and z",
           "'element vertex N' and properties x, y, z");
    }
    if (face_elements != 1 || corner_lists != 1) {
      fail("the header does not declare faces once with their corners",
           "'element face N' and 'property list uchar int vertex_indices'");
    }
  }

  LineReader& lines_;
  const std::string& file_;
  Header header_;
};

// What CGAL gets: the vertices' coordinates and the faces' corners, nothing else.
std::string plain_header(const Header& header) {
  constexpr std::array<const char*, 3> kFormatNames = {"ascii", "binary_little_endian",
                                                       "binary_big_endian"};
  std::string text = "ply\nformat ";
  text.append(kFormatNames[static_cast<std::size_t>(header.format)]).append(" 1.0\n");
  for (const Element& element : header.elements) {
    if (!element.is_vertex() && !element.is_face()) continue;
    text += element.is_vertex() ? "element vertex " : "element face ";
    text.append(std::to_string(element.count)).append("\n");
    for (const Property& property : element.properties) {
      if (element.is_vertex() && coordinate(property) < 3) {
        text.append("property ").append(property.type->name).append(" ");
        text.append(property.name).append("\n");
      } else if (element.is_face() && is_corner_list(property)) {
        text.append("property list ").append(property.count_type->name).append(" ");
        text.append(property.type->name).append(" vertex_indices\n");
      }
    }
  }
  return text + "end_header\n";
}

class BodyChecker {
 public:
  BodyChecker(const Header& header, LineReader& lines, const std::string& file)
      : header_(header), body_(lines.rest()), words_(body_, lines.line() + 1), file_(file) {
    soup_.text = plain_header(header);
  }

  CheckedSoup run() {
    for (const Element& element : header_.elements) {
      if (element.properties.empty()) continue;
      for (std::uint64_t item = 0; item < element.count; ++item) read_item(element, item);
      if (element.is_vertex()) soup_.vertices = element.count;
      if (element.is_face()) soup_.faces = element.count;
    }
    const bool has_more = is_text() ? !words_.next().empty() : place_ != body_.size();
    if (has_more) {
      throw InputError(is_text() ? InputError::at_line(file_, words_.line()) : file_,
                       "the file goes on after the last element of the header",
                       "the header's counts and the content must agree");
    }
    return std::move(soup_);
  }

 private:
  bool is_text() const { return header_.format == Format::kText; }

  [[noreturn]] void fail_short(const Element& element, std::uint64_t item) const {
    throw InputError(file_,
                     "the file ends in " + element.name + " " + std::to_string(item + 1) + " of " +
                         std::to_string(element.count),
                     "the header's counts and the content must agree");
  }

  void read_item(const Element& element, std::uint64_t item) {
    bool is_first = true;
    for (const Property& property : element.properties) {
      const bool is_kept = (element.is_vertex() && coordinate(property) < 3) ||
                           (element.is_face() && is_corner_list(property));
      std::uint64_t numbers = 1;
      if (property.count_type != nullptr) {
        const auto [count, written] = read_number(element, item, *property.count_type);
        if (count < 0) {
          throw InputError(place(element, item), "a list of " + std::to_string(count) + " numbers",
                           "");
        }
        numbers = static_cast<std::uint64_t>(count);
        if (is_kept) keep(written);
        if (element.is_face() && is_text() && is_kept) soup_.face_lines.push_back(words_.line());
      }
      if (!is_text() && numbers > (body_.size() - place_) / property.type->bytes) {
        fail_short(element, item);
      }
      for (std::uint64_t i = 0; i < numbers; ++i) {
        const std::string_view written = is_text()
                                             ? read_word(element, item, *property.type, is_kept)
                                             : read_bytes(property.type->bytes);
        if (is_kept) keep(written);
      }
      if (element.is_vertex() && is_text() && is_first) {
        soup_.vertex_lines.push_back(words_.line());
      }
      is_first = false;
    }
    if (is_text()) soup_.text += '\n';
  }

  void keep(std::string_view written) {
    soup_.text.append(written);
    if (is_text()) soup_.text += ' ';
  }

  std::string place(const Element& element, std::uint64_t item) const {
    if (is_text()) return InputError::at_line(file_, words_.line());
    return file_ + ": " + element.name + " " + std::to_string(item + 1);
  }

  std::string_view read_bytes(std::size_t bytes) {
    const std::string_view read = body_.substr(place_, bytes);
    place_ += bytes;
    return read;
  }

  std::string_view read_word(const Element& element, std::uint64_t item, const NumberType& type,
                             bool is_kept) {
    const std::string_view word = words_.next();
    if (word.empty()) fail_short(element, item);
    if (!is_kept) return word;
    if (type.is_integer && !whole_number(word)) {
      throw InputError(place(element, item), in_quotes(word) + " is no whole number", "such as 7");
    }
    if (!type.is_integer && !finite_number(word)) {
      throw InputError(place(element, item),
                       "coordinate " + in_quotes(word) + " is not a finite number",
                       "such as 1.5 or -2e-3");
    }
    return word;
  }

  // A list's count and how it is written.
  std::pair<long long, std::string_view> read_number(const Element& element, std::uint64_t item,
                                                     const NumberType& type) {
    if (is_text()) {
      const std::string_view word = read_word(element, item, type, true);
      return {*whole_number(word), word};
    }
    if (type.bytes > body_.size() - place_) fail_short(element, item);
    const std::string_view bytes = read_bytes(type.bytes);
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < type.bytes; ++i) {
      const std::size_t at = header_.format == Format::kBigEndian ? i : type.bytes - 1 - i;
      value = value << 8 | static_cast<unsigned char>(bytes[at]);
    }
    const std::uint64_t sign_bit = std::uint64_t{1} << (8 * type.bytes - 1);
    auto number = static_cast<long long>(value);
    if (type.is_signed && (value & sign_bit) != 0) number -= static_cast<long long>(2 * sign_bit);
    return {number, bytes};
  }

  const Header& header_;
  std::string_view body_;
  WordReader words_;
  std::size_t place_ = 0;
  const std::string& file_;
  CheckedSoup soup_;
};

}  // namespace

CheckedSoup check_ply(std::string_view text, const std::string& file) {
  LineReader lines(text);
  const Header header = HeaderReader(lines, file).read();
  return BodyChecker(header, lines, file).run();
}

}  // namespace viewcover
