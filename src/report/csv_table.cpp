#include "report/csv_table.h"

#include <algorithm>
#include <charconv>

#include "scene/error.h"

namespace viewcover {
namespace {

/// Line breaks may be quoted.
bool read_record(std::istream& stream, std::string& record) {
  if (!std::getline(stream, record)) return false;
  std::string more;
  while (std::ranges::count(record, '"') % 2 == 1 && std::getline(stream, more)) {
    record += "\n" + more;
  }
  return true;
}

std::vector<std::string> fields(const std::string& record) {
  std::vector<std::string> result(1);
  bool quoted = false;
  for (const char c : record) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

}  // namespace

std::ifstream open_for_check(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream)
    throw InputError(file.string(), "cannot be read", "give the folder of a finished run");
  return stream;
}

CsvTable::CsvTable(const std::filesystem::path& file) : file_(file.string()) {
  std::ifstream stream = open_for_check(file);
  std::string line;
  while (read_record(stream, line)) {
    (titles_.empty() ? titles_ : rows_.emplace_back()) = fields(line);
  }
}

bool CsvTable::has(std::string_view title) const {
  return std::ranges::find(titles_, title) != titles_.end();
}

const std::string& CsvTable::text(std::size_t row, std::string_view title) const {
  const auto place = static_cast<std::size_t>(std::ranges::find(titles_, title) - titles_.begin());
  if (place >= rows_[row].size()) {
    throw InputError(InputError::at_line(file_, row + 2), "has no " + std::string(title), "");
  }
  return rows_[row][place];
}

double CsvTable::number(std::size_t row, std::string_view title) const {
  return read_number<double>(row, text(row, title));
}

std::size_t CsvTable::whole_number(std::size_t row, std::string_view title) const {
  return read_number<std::size_t>(row, text(row, title));
}

std::vector<std::size_t> CsvTable::numbers(std::size_t row, std::string_view title) const {
  std::vector<std::size_t> all;
  const std::string& words = text(row, title);
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    all.push_back(read_number<std::size_t>(row, words.substr(begin, end - begin)));
    begin = end + 1;
  }
  return all;
}

template <class Number>
Number CsvTable::read_number(std::size_t row, const std::string& word) const {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    throw InputError(InputError::at_line(file_, row + 2), "\"" + word + "\" is no number", "");
  }
  return value;
}

}  // namespace viewcover
