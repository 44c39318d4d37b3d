#include "report/csv_table.h"

#include <algorithm>
#include <charconv>
#include <fstream>

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
  if (record.ends_with('\r')) record.pop_back();
  return true;
}

std::vector<std::string> fields(const std::string& record) {
  std::vector<std::string> result(1);
  bool quoted = false;
  for (std::size_t i = 0; i < record.size(); ++i) {
    const char c = record[i];
    if (c == '"' && quoted && i + 1 < record.size() && record[i + 1] == '"') {
      result.back() += record[i++];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      result.emplace_back();
    } else {
      result.back() += c;
    }
  }
  return result;
}

template <class Number>
Number number_of(const std::string& place, const std::string& word) {
  Number value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) {
    throw InputError(place, "\"" + word + "\" is no number", "");
  }
  return value;
}

}  // namespace

std::ifstream open_for_check(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream)
    throw InputError(file.string(), "cannot be read", "give the folder of a finished run");
  return stream;
}

CsvTable::CsvTable(const std::filesystem::path& file, std::string_view advice)
    : file_(file.string()) {
  std::ifstream stream(file);
  std::string line;
  while (read_record(stream, line)) {
    (titles_.empty() ? titles_ : rows_.emplace_back()) = fields(line);
  }
  if (titles_.empty()) throw InputError(file_, "cannot be read or is empty", advice);
}

std::string CsvTable::place(std::size_t row) const { return InputError::at_line(file_, row + 2); }

bool CsvTable::has(std::string_view title) const {
  return std::ranges::find(titles_, title) != titles_.end();
}

const std::string& CsvTable::text(std::size_t row, std::string_view title) const {
  const auto column = static_cast<std::size_t>(std::ranges::find(titles_, title) - titles_.begin());
  if (column >= rows_[row].size()) {
    throw InputError(place(row), "has no " + std::string(title), "");
  }
  return rows_[row][column];
}

double CsvTable::number(std::size_t row, std::string_view title) const {
  return number_of<double>(place(row), text(row, title));
}

std::size_t CsvTable::count(std::size_t row, std::string_view title) const {
  return number_of<std::size_t>(place(row), text(row, title));
}

std::vector<std::size_t> CsvTable::counts(std::size_t row, std::string_view title) const {
  std::vector<std::size_t> all;
  const std::string& words = text(row, title);
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find(' ', begin), words.size());
    all.push_back(number_of<std::size_t>(place(row), words.substr(begin, end - begin)));
    begin = end + 1;
  }
  return all;
}

}  // namespace viewcover
