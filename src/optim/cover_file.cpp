#include "optim/cover_file.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "scene/error.h"
#include "scene/read/soup_text.h"

namespace viewcover {
namespace {

constexpr std::size_t kMostSide = std::size_t{1} << 31;

std::string text_of(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) throw InputError(file.string(), "no such file", "");
  if (std::filesystem::is_directory(file)) {
    throw InputError(file.string(), "is a folder", "give a file with a matrix");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw InputError(file.string(), "the file cannot be opened", "is it readable?");
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (stream.bad()) throw InputError(file.string(), "the file cannot be read", "");
  return text;
}

/// Words of a text and the lines they are on.
class Words {
 public:
  Words(const std::filesystem::path& file, std::string text)
      : file_(file.string()), text_(std::move(text)) {}

  /// The rest of the line, or of the next one if it is at its end.
  std::string_view line() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view found = std::string_view(text_).substr(at_, end - at_);
    if (!found.empty() && found.back() == '\r') found.remove_suffix(1);
    line_ = next_line_;
    if (end < text_.size()) ++next_line_;
    at_ = std::min(end + 1, text_.size());
    return found;
  }
  bool at_end() {
    skip_space();
    return at_ == text_.size();
  }
  /// Lines that begin with a mark.
  void skip_lines(char mark) {
    while (!at_end() && text_[at_] == mark) line();
  }
  bool at_end_of_line() {
    while (at_ < text_.size() && is_space(text_[at_]) && text_[at_] != '\n') ++at_;
    return at_ == text_.size() || text_[at_] == '\n';
  }
  /// Empty at the end.
  std::string_view word() {
    skip_space();
    line_ = next_line_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return std::string_view(text_).substr(begin, at_ - begin);
  }
  template <class Number>
  Number number(std::string_view what) {
    const std::string_view word = this->word();
    if (word.empty()) fail("the file ends before " + std::string(what), "is it whole?");
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) {
      fail(in_quotes(word) + " is not " + std::string(what), "give a number");
    }
    return value;
  }
  /// A number in [1, most], as an index from 0.
  std::size_t index(std::size_t most, std::string_view what) {
    const auto value = number<std::size_t>(what);
    if (value < 1 || value > most) {
      fail(std::to_string(value) + " is not " + std::string(what),
           "give a number from 1 to " + std::to_string(most));
    }
    return value - 1;
  }
  void expect_end() {
    if (at_end()) return;
    line_ = next_line_;
    fail("there is more than the header announces", "");
  }
  [[noreturn]] void fail(std::string_view wrong, std::string_view right) const {
    throw InputError(InputError::at_line(file_, line_), wrong, right);
  }

 private:
  static bool is_space(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
  }
  void skip_space() {
    for (; at_ < text_.size() && is_space(text_[at_]); ++at_) next_line_ += text_[at_] == '\n';
  }

  std::string file_, text_;
  std::size_t at_ = 0, line_ = 1, next_line_ = 1;
};

/// What a file says, before the matrix is made: a malformed file costs no more than its size,
/// whatever it claims.
struct Entries {
  std::size_t rows = 0, columns = 0;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> set;

  void add(std::size_t row, std::size_t column) {
    set.emplace_back(static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column));
  }
};

/// None yet. Refuses sizes that no matrix can have.
Entries entries_of(const Words& words, std::size_t rows, std::size_t columns,
                   std::size_t most_entries) {
  if (rows > kMostSide || columns > kMostSide ||
      (rows > 0 && (columns + 63) / 64 * 64 > most_entries / rows)) {
    words.fail("a matrix of " + std::to_string(rows) + " times " + std::to_string(columns) +
                   " is too large",
               "at most 2^36 entries");
  }
  return {rows, columns, {}};
}

Entries read_matrix_market(Words& words, std::size_t most_entries) {
  const std::string_view banner = words.line();
  if (banner != "%%MatrixMarket matrix coordinate pattern general") {
    words.fail("no pattern matrix",
               "the first line is \"%%MatrixMarket matrix coordinate pattern general\"");
  }
  words.skip_lines('%');
  const auto rows = words.number<std::size_t>("a number of rows"),
             columns = words.number<std::size_t>("a number of columns"),
             count = words.number<std::size_t>("a number of entries");
  Entries entries = entries_of(words, rows, columns, most_entries);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t row = words.index(rows, "a row"), column = words.index(columns, "a column");
    entries.add(row, column);
  }
  words.expect_end();
  return entries;
}

Entries read_scp(Words& words, std::size_t most_entries) {
  const auto covered = words.number<std::size_t>("a number of rows"),
             chosen = words.number<std::size_t>("a number of columns");
  Entries entries = entries_of(words, chosen, covered, most_entries);
  for (std::size_t i = 0; i < chosen; ++i) words.number<double>("a cost");
  for (std::size_t i = 0; i < covered; ++i) {
    const auto count = words.number<std::size_t>("a number of columns");
    for (std::size_t k = 0; k < count; ++k) entries.add(words.index(chosen, "a column"), i);
  }
  words.expect_end();
  return entries;
}

Entries read_rail(Words& words, std::size_t most_entries) {
  const auto covered = words.number<std::size_t>("a number of rows"),
             chosen = words.number<std::size_t>("a number of columns");
  Entries entries = entries_of(words, chosen, covered, most_entries);
  for (std::size_t i = 0; i < chosen; ++i) {
    words.number<double>("a cost");
    const auto count = words.number<std::size_t>("a number of rows");
    for (std::size_t k = 0; k < count; ++k) entries.add(i, words.index(covered, "a row"));
  }
  words.expect_end();
  return entries;
}

Entries read_hitting_set(Words& words, std::size_t most_entries) {
  words.skip_lines('c');
  if (words.word() != "p" || words.word() != "hs") {
    words.fail("no header", "\"p hs ELEMENTS SETS\"");
  }
  const auto chosen = words.number<std::size_t>("a number of elements"),
             covered = words.number<std::size_t>("a number of sets");
  Entries entries = entries_of(words, chosen, covered, most_entries);
  words.line();
  std::size_t set = 0;
  for (words.skip_lines('c'); !words.at_end(); words.skip_lines('c')) {
    if (set == covered) words.expect_end();
    do {
      entries.add(words.index(chosen, "an element"), set);
    } while (!words.at_end_of_line());
    ++set;
  }
  if (set < covered) {
    words.fail(
        "the file ends after " + std::to_string(set) + " of " + std::to_string(covered) + " sets",
        "is it whole?");
  }
  return entries;
}

Entries read_entries(Words& words, CoverFormat format, std::size_t most_entries) {
  switch (format) {
    case CoverFormat::kMatrixMarket:
      return read_matrix_market(words, most_entries);
    case CoverFormat::kScp:
      return read_scp(words, most_entries);
    case CoverFormat::kRail:
      return read_rail(words, most_entries);
    case CoverFormat::kHittingSet:
      break;
  }
  return read_hitting_set(words, most_entries);
}

}  // namespace

BitRows read_cover_file(const std::filesystem::path& file, CoverFormat format) {
  return parse_cover(text_of(file), file, format);
}

BitRows parse_cover(std::string content, const std::filesystem::path& file, CoverFormat format,
                    std::size_t most_entries) {
  Words words(file, std::move(content));
  const Entries entries = read_entries(words, format, most_entries);
  BitRows matrix(entries.rows, entries.columns);
  for (const auto& [row, column] : entries.set) matrix.set(row, column);
  return matrix;
}

CoverFormat detect_cover_format(const std::filesystem::path& file) {
  const std::string text = text_of(file);
  if (text.starts_with("%%MatrixMarket")) return CoverFormat::kMatrixMarket;
  if (text.starts_with("p hs ") || text.starts_with("c ") || text.starts_with("c\n")) {
    return CoverFormat::kHittingSet;
  }
  throw InputError(file.string(), "neither a Matrix Market nor a hitting set file",
                   "OR-Library files need --format scp or --format rail");
}

std::vector<double> read_weights(const std::filesystem::path& file, std::size_t columns) {
  Words words(file, text_of(file));
  std::vector<double> weights;
  double sum = 0;
  for (std::size_t i = 0; i < columns; ++i) {
    const auto weight = words.number<double>("a weight");
    sum += weight;
    if (!(weight >= 0) || !std::isfinite(sum)) {
      words.fail("a weight is negative, not a number or too large", "give a finite number >= 0");
    }
    weights.push_back(weight);
  }
  words.expect_end();
  return weights;
}

}  // namespace viewcover
