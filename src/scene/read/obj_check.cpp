#include <string>
#include <vector>

#include "scene/error.h"
#include "scene/read/soup_check.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

// One statement may be written on several lines, each but the last ending in a backslash.
class StatementReader {
 public:
  explicit StatementReader(std::string_view text) : lines_(text) {}

  bool next() {
    const auto first = lines_.next();
    if (!first) return false;
    line_ = lines_.line();
    words_ = words_of(*first);
    // A comment that happens to end in a backslash (a path, say) does not swallow the next line.
    if (!first->ends_with('\\') || words_.empty()) return true;
    joined_.assign(*first);
    while (joined_.ends_with('\\')) {
      joined_.back() = ' ';
      const auto more = lines_.next();
      if (!more) break;
      joined_.append(*more);
    }
    words_ = words_of(joined_);
    return true;
  }

  const std::vector<std::string_view>& words() const { return words_; }
  /// The first line of the statement, 1-based.
  std::size_t line() const { return line_; }

 private:
  LineReader lines_;
  std::size_t line_ = 0;
  std::string joined_;
  std::vector<std::string_view> words_;
};

std::string joined_names(const std::vector<std::string_view>& words) {
  std::string names;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (i > 1) names += ' ';
    names.append(words[i]);
  }
  return names;
}

class ObjChecker {
 public:
  ObjChecker(std::string_view text, const std::string& file) : statements_(text), file_(file) {}

  CheckedSoup run() {
    while (statements_.next()) {
      const auto& words = statements_.words();
      if (words.empty()) continue;
      if (words[0] == "v") {
        add_vertex(words);
      } else if (words[0] == "f" || words[0] == "fo") {  // "fo": the same in old files
        add_face(words);
      } else if (words[0] == "o") {
        object_ = joined_names(words);
        is_named_ = false;
      } else if (words[0] == "g") {
        group_ = joined_names(words);
        is_named_ = false;
      }
    }
    if (highest_ > soup_.vertices) {
      throw InputError(InputError::at_line(file_, highest_line_),
                       "vertex " + std::to_string(highest_) + " does not exist",
                       "the file has " + std::to_string(soup_.vertices));
    }
    return std::move(soup_);
  }

 private:
  [[noreturn]] void fail(const std::string& wrong, const std::string& right) const {
    throw InputError(InputError::at_line(file_, statements_.line()), wrong, right);
  }

  void add_vertex(const std::vector<std::string_view>& words) {
    if (words.size() < 4) {
      fail("a vertex with " + std::to_string(words.size() - 1) + " coordinates", "3 are needed");
    }
    soup_.text += 'v';
    for (std::size_t i = 1; i <= 3; ++i) {
      if (!finite_number(words[i])) {
        fail("coordinate " + in_quotes(words[i]) + " is not a finite number",
             "such as 1.5 or -2e-3");
      }
      soup_.text.append(" ").append(words[i]);
    }
    soup_.text += '\n';
    ++soup_.vertices;
    soup_.vertex_lines.push_back(statements_.line());
  }

  void add_face(const std::vector<std::string_view>& words) {
    soup_.text += 'f';
    for (std::size_t i = 1; i < words.size(); ++i) {
      soup_.text.append(" ").append(std::to_string(corner(words[i])));
    }
    soup_.text += '\n';
    ++soup_.faces;
    soup_.face_lines.push_back(statements_.line());
    if (!is_named_) {
      group_id_ = soup_.groups.id(group_name(object_, group_));
      is_named_ = true;
    }
    soup_.face_groups.push_back(group_id_);
  }

  // The vertex number of a corner V, V/T, V//N or V/T/N, 1-based. Vertices may follow later.
  std::size_t corner(std::string_view word) {
    const auto number = whole_number(word.substr(0, word.find('/')));
    if (!number) {
      fail("corner " + in_quotes(word) + " is no vertex number", "such as 7, 7/1, 7//1 or 7/1/1");
    }
    if (*number == 0) fail("vertex number 0", "vertices are numbered from 1, or from -1 backwards");
    if (*number < 0) {
      const auto back = 0 - static_cast<unsigned long long>(*number);
      if (back > soup_.vertices) {
        fail("vertex " + std::to_string(*number) + " does not exist",
             std::to_string(soup_.vertices) + " come before it");
      }
      return soup_.vertices + 1 - back;
    }
    const auto vertex = static_cast<std::size_t>(*number);
    if (vertex > highest_) {
      highest_ = vertex;
      highest_line_ = statements_.line();
    }
    return vertex;
  }

  StatementReader statements_;
  const std::string& file_;
  CheckedSoup soup_;
  std::string object_, group_;
  GroupId group_id_;
  bool is_named_ = false;  // group_id_ stands for the present object and group
  std::size_t highest_ = 0, highest_line_ = 0;
};

}  // namespace

CheckedSoup check_obj(std::string_view text, const std::string& file) {
  return ObjChecker(text, file).run();
}

}  // namespace viewcover
