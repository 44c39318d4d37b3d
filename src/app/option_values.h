#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/types.h"

namespace viewcover {

// Option values from their text. Errors: InputError at the option for text that is not wholly a
// number or is out of range.

/// A whole number in [least, most].
std::uint64_t count_option(std::string_view option, std::string_view text, std::uint64_t least,
                           std::uint64_t most);
int integer_option(std::string_view option, std::string_view text, int least, int most);
/// A number in [least, most].
double number_option(std::string_view option, std::string_view text, double least, double most);
/// A finite number > 0.
double positive_option(std::string_view option, std::string_view text);
/// A finite number >= 0.
double non_negative_option(std::string_view option, std::string_view text);

/// A size of at least 1 MiB as bytes: a number and, for powers of 1024, K, M, G or T.
std::uint64_t bytes_option(std::string_view option, std::string_view text);
/// The texts between commas; one where there is no comma.
std::vector<std::string_view> fields_of(std::string_view text);
/// Three finite numbers X,Y,Z.
Point place_option(std::string_view option, std::string_view text);
/// The box between two corners, X0,Y0,Z0,X1,Y1,Z1, in any order.
Box box_option(std::string_view option, std::string_view text);

/// Refuses a value that is not among `available`, as `--option value: not in this version; use
/// ...`.
void require_available(std::string_view option, std::string_view value,
                       std::span<const std::string_view> available);

/// "a, b or c".
std::string alternatives(std::span<const std::string_view> names);

}  // namespace viewcover
