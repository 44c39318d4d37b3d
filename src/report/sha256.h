#pragma once

#include <filesystem>
#include <string>

namespace viewcover {

/// SHA-256 of a file's bytes, 64 hexadecimal digits. Errors: InputError if it cannot be read.
std::string sha256_of_file(const std::filesystem::path& file);

}  // namespace viewcover
