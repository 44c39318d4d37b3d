#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace viewcover {

/// A file of a finished run. Errors: InputError if it cannot be read.
std::ifstream open_for_check(const std::filesystem::path& file);

/// A CSV file with a line of titles; fields may be quoted. Errors: InputError with file and line
/// for titles that are missing and fields that are no numbers.
class CsvTable {
 public:
  explicit CsvTable(const std::filesystem::path& file);

  std::size_t size() const { return rows_.size(); }
  bool has(std::string_view title) const;
  const std::string& text(std::size_t row, std::string_view title) const;
  double number(std::size_t row, std::string_view title) const;
  std::size_t whole_number(std::size_t row, std::string_view title) const;
  /// Whole numbers separated by spaces.
  std::vector<std::size_t> numbers(std::size_t row, std::string_view title) const;

 private:
  template <class Number>
  Number read_number(std::size_t row, const std::string& word) const;

  std::string file_;
  std::vector<std::string> titles_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace viewcover
