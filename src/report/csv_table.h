#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace viewcover {

/// A file of a finished run. Errors: InputError if it cannot be read.
std::ifstream open_for_check(const std::filesystem::path& file);

/// A CSV file (RFC 4180: fields may be quoted) with titles in its first line, read whole.
///
/// Errors, from any call: InputError with the file, and its line where one is to blame (counted in
/// records, the titles being the first).
class CsvTable {
 public:
  /// `advice`: what to do where the file cannot be read.
  explicit CsvTable(const std::filesystem::path& file,
                    std::string_view advice = "give the folder of a finished run");

  std::size_t size() const { return rows_.size(); }
  bool has(std::string_view title) const;
  const std::string& text(std::size_t row, std::string_view title) const;
  double number(std::size_t row, std::string_view title) const;
  /// A whole number >= 0.
  std::size_t count(std::size_t row, std::string_view title) const;
  /// Whole numbers >= 0, separated by spaces.
  std::vector<std::size_t> counts(std::size_t row, std::string_view title) const;
  /// The place of a row, for messages.
  std::string place(std::size_t row) const;

 private:
  std::string file_;
  std::vector<std::string> titles_;
  std::vector<std::vector<std::string>> rows_;
};

}  // namespace viewcover
