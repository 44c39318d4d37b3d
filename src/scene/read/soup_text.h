#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace viewcover {

/// The lines of a text one after the other; they end in LF, CRLF or CR.
class LineReader {
 public:
  /// Skips a byte order mark. The text must outlive the reader and the lines.
  explicit LineReader(std::string_view text);

  /// The next line without its end, or nothing at the end of the text.
  std::optional<std::string_view> next();
  /// The next line that has a word before any `#`, as words; empty at the end of the text.
  std::vector<std::string_view> next_words();
  /// Number of the line last returned, 1-based.
  std::size_t line() const { return line_; }
  /// What has not been read yet.
  std::string_view rest() const { return text_.substr(place_); }

 private:
  std::string_view text_;
  std::size_t place_ = 0;
  std::size_t line_ = 0;
};

/// The words of a text one after the other, whatever the lines.
class WordReader {
 public:
  /// `line` is the number of the line on which the text starts.
  explicit WordReader(std::string_view text, std::size_t line = 1) : text_(text), line_(line) {}

  /// The next word; empty at the end of the text.
  std::string_view next();
  /// The rest of the line after the word last returned, without blanks at its ends.
  std::string_view rest_of_line();
  /// Number of the line of the word last returned, 1-based.
  std::size_t line() const { return line_; }

 private:
  std::string_view text_;
  std::size_t place_ = 0;
  std::size_t line_;
};

/// The words of a line, up to a word that starts with `#`.
std::vector<std::string_view> words_of(std::string_view line);

/// The word as a finite double (decimal, `+` allowed, rounded to nearest, underflow to 0), if the
/// whole word is one.
std::optional<double> finite_number(std::string_view word);
/// The word as a whole number, if the whole word is one; saturated at the limits of the type.
std::optional<long long> whole_number(std::string_view word);

/// Refuses a text that starts with the byte order mark of UTF-16. Errors: InputError.
void refuse_utf16(std::string_view text, const std::string& file);

/// What a file's name ends with, such as ".obj", in small letters.
std::string lower_suffix(const std::filesystem::path& file);

/// The word in quotes, on one line and cut to a readable length, for messages.
std::string in_quotes(std::string_view word);

}  // namespace viewcover
