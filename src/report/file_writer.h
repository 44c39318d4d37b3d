#pragma once

#include <concepts>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace viewcover {

/// A text file that appears whole or not at all: text goes to a temporary name beside the file,
/// which takes the file's name in commit(). A writer that is destroyed before leaves nothing.
///
/// Errors, from any call: InputError with the path and the system's reason.
class FileWriter {
 public:
  explicit FileWriter(std::filesystem::path file);
  ~FileWriter();
  FileWriter(const FileWriter&) = delete;
  FileWriter& operator=(const FileWriter&) = delete;

  FileWriter& operator<<(std::string_view text) {
    buffer_.append(text);
    if (buffer_.size() >= kBufferSize) flush();
    return *this;
  }
  FileWriter& operator<<(char character) { return *this << std::string_view(&character, 1); }
  /// The shortest decimal that reads back as the same double.
  FileWriter& operator<<(double number);
  template <std::integral Integer>
  requires(!std::same_as<Integer, char> && !std::same_as<Integer, bool>) FileWriter& operator<<(
      Integer number) {
    return *this << std::string_view(std::to_string(number));
  }

  /// Writes what is left to the disk, closes and gives the file its name.
  void commit();

 private:
  static constexpr std::size_t kBufferSize = std::size_t{1} << 18;

  void flush();
  [[noreturn]] void fail(std::string_view what);

  std::filesystem::path file_;
  std::filesystem::path temporary_;
  std::string buffer_;
  int descriptor_ = -1;
};

/// The path under which a file is made before it takes its name: beside it and with its suffix.
std::filesystem::path temporary_beside(const std::filesystem::path& file);

/// Removes such files of a folder. Errors: InputError.
void remove_temporary_files(const std::filesystem::path& folder);

/// Gives a finished temporary file its name. Errors: InputError.
void rename_into_place(const std::filesystem::path& temporary, const std::filesystem::path& file);

/// A field of a CSV file: quoted if it holds a comma, a quote or a line break (RFC 4180).
std::string csv_field(std::string_view text);

/// The shortest decimal that reads back as the same double.
std::string shortest_decimal(double number);

}  // namespace viewcover
