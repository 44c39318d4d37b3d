#include "app/option_values.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "scene/error.h"

namespace viewcover {
namespace {

template <class Number>
bool parse(std::string_view text, Number& number) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return error == std::errc() && end == text.data() + text.size();
}

template <class Integer>
Integer integer_in(std::string_view option, std::string_view text, Integer least, Integer most) {
  Integer number = 0;
  if (!parse(text, number) || number < least || number > most) {
    throw InputError(option, "'" + std::string(text) + "' is no whole number in range",
                     "give " + std::to_string(least) + " to " + std::to_string(most));
  }
  return number;
}

double finite_number(std::string_view option, std::string_view text, bool zero_allowed) {
  double number = 0;
  if (!parse(text, number) || !std::isfinite(number) || number < 0 ||
      (number == 0 && !zero_allowed)) {
    throw InputError(
        option, "'" + std::string(text) + "' is no number in range",
        zero_allowed ? "give a finite number, 0 or more" : "give a finite number greater than 0");
  }
  return number;
}

/// Numbers between commas.
template <std::size_t kCount>
std::array<double, kCount> numbers_in(std::string_view option, std::string_view text,
                                      std::string_view form) {
  std::array<double, kCount> numbers{};
  const std::vector<std::string_view> fields = fields_of(text);
  bool is_right = fields.size() == kCount;
  for (std::size_t i = 0; i < kCount && is_right; ++i) {
    is_right = parse(fields[i], numbers[i]) && std::isfinite(numbers[i]);
  }
  if (!is_right) {
    throw InputError(option, "'" + std::string(text) + "' is not " + std::string(form),
                     "give " + std::to_string(kCount) + " numbers");
  }
  return numbers;
}

}  // namespace

std::uint64_t count_option(std::string_view option, std::string_view text, std::uint64_t least,
                           std::uint64_t most) {
  return integer_in(option, text, least, most);
}

int integer_option(std::string_view option, std::string_view text, int least, int most) {
  return integer_in(option, text, least, most);
}

double number_option(std::string_view option, std::string_view text, double least, double most) {
  double number = 0;
  if (parse(text, number) && number >= least && number <= most) return number;
  throw InputError(option, "'" + std::string(text) + "' is no number in range",
                   fmt::format("give {} to {}", least, most));
}

double positive_option(std::string_view option, std::string_view text) {
  return finite_number(option, text, false);
}

double non_negative_option(std::string_view option, std::string_view text) {
  return finite_number(option, text, true);
}

std::uint64_t bytes_option(std::string_view option, std::string_view text) {
  constexpr std::string_view kSuffixes = "KMGT";
  constexpr double kLeast = 0x1p20, kMost = 0x1p60;
  std::string_view digits = text;
  double bytes = 0, unit = 1;
  if (!digits.empty()) {
    const std::size_t power = kSuffixes.find(digits.back());
    if (power != std::string_view::npos) {
      unit = std::ldexp(1, static_cast<int>(10 * (power + 1)));
      digits.remove_suffix(1);
    }
  }
  if (!parse(digits, bytes) || !(bytes * unit >= kLeast && bytes * unit <= kMost)) {
    throw InputError(option, "'" + std::string(text) + "' is no size of 1M or more",
                     "give a number of bytes, such as 500M or 8G");
  }
  return static_cast<std::uint64_t>(bytes * unit);
}

std::vector<std::string_view> fields_of(std::string_view text) {
  std::vector<std::string_view> fields;
  for (;;) {
    const std::size_t comma = text.find(',');
    fields.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    text.remove_prefix(comma + 1);
  }
}

Point place_option(std::string_view option, std::string_view text) {
  const auto numbers = numbers_in<3>(option, text, "X,Y,Z");
  return {numbers[0], numbers[1], numbers[2]};
}

Box box_option(std::string_view option, std::string_view text) {
  const auto numbers = numbers_in<6>(option, text, "X0,Y0,Z0,X1,Y1,Z1");
  Box box(Point(numbers[0], numbers[1], numbers[2]));
  box.extend(Point(numbers[3], numbers[4], numbers[5]));
  return box;
}

void require_available(std::string_view option, std::string_view value,
                       std::span<const std::string_view> available) {
  if (std::ranges::find(available, value) != available.end()) return;
  throw InputError(std::string(option) + " " + std::string(value), "not in this version",
                   "use " + alternatives(available));
}

std::string alternatives(std::span<const std::string_view> names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 == names.size() ? " or " : ", ";
    list += names[i];
  }
  return list;
}

}  // namespace viewcover
