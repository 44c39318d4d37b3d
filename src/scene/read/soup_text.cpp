#include "scene/read/soup_text.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "scene/error.h"

namespace viewcover {
namespace {

constexpr std::string_view kBlanks = " \t\v\f\r\n";

bool is_blank(char c) { return kBlanks.find(c) != std::string_view::npos; }

// std::from_chars takes no plus sign.
std::string_view without_plus(std::string_view word) {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  return word;
}

}  // namespace

LineReader::LineReader(std::string_view text) : text_(text) {
  if (text_.starts_with("\xEF\xBB\xBF")) place_ = 3;
}

std::optional<std::string_view> LineReader::next() {
  if (place_ == text_.size()) return std::nullopt;
  ++line_;
  const std::size_t end = text_.find_first_of("\r\n", place_);
  const std::string_view line = text_.substr(place_, end - place_);
  if (end == std::string_view::npos) {
    place_ = text_.size();
  } else {
    place_ = end + (text_.substr(end).starts_with("\r\n") ? 2 : 1);
  }
  return line;
}

std::vector<std::string_view> LineReader::next_words() {
  while (const auto line = next()) {
    if (auto words = words_of(*line); !words.empty()) return words;
  }
  return {};
}

std::string_view WordReader::next() {
  while (place_ < text_.size() && is_blank(text_[place_])) line_ += text_[place_++] == '\n';
  const std::size_t begin = place_;
  while (place_ < text_.size() && !is_blank(text_[place_])) ++place_;
  return text_.substr(begin, place_ - begin);
}

std::string_view WordReader::rest_of_line() {
  const std::size_t end = text_.find_first_of("\r\n", place_);
  std::string_view rest = text_.substr(place_, end - place_);
  place_ += rest.size();
  while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  return rest;
}

std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  WordReader reader(line);
  for (auto word = reader.next(); !word.empty() && word[0] != '#'; word = reader.next()) {
    words.push_back(word);
  }
  return words;
}

std::optional<double> finite_number(std::string_view word) {
  word = without_plus(word);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
  // from_chars does not tell overflow from underflow.
  if (error == std::errc::result_out_of_range) {
    value = std::strtod(std::string(word).c_str(), nullptr);
  }
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<long long> whole_number(std::string_view word) {
  word = without_plus(word);
  long long value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error == std::errc::invalid_argument || end != word.data() + word.size()) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    using Limits = std::numeric_limits<long long>;
    return word[0] == '-' ? Limits::min() : Limits::max();
  }
  return value;
}

void refuse_utf16(std::string_view text, const std::string& file) {
  if (!text.starts_with("\xFF\xFE") && !text.starts_with("\xFE\xFF")) return;
  throw InputError(file, "is a text in UTF-16", "save it in UTF-8");
}

std::string lower_suffix(const std::filesystem::path& file) {
  std::string suffix = file.extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return suffix;
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kReadable = 40;
  std::string text = "'";
  for (const char c : word.substr(0, kReadable)) text += c >= ' ' && c <= '~' ? c : '?';
  if (word.size() > kReadable) text += "...";
  return text + "'";
}

}  // namespace viewcover
