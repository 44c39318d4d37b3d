#pragma once

#include <filesystem>

#include "show/page_data.h"

namespace viewcover {

/// Where Debian's package libjs-three, or another copy of three.js with the same folders, is.
std::filesystem::path three_folder();

/// Writes one page to explore the runs in a browser: opens from disk, asks nothing of a network.
/// three.js is copied into it from `three`.
///
/// Errors: InputError where three.js is missing or the file cannot be written.
/// Size: 0.8 MB for three.js and the program; about 80 bytes an element, and a bit each pair of a
/// region and an element.
void write_page(const PageContent& content, const std::filesystem::path& file,
                const std::filesystem::path& three = three_folder());

}  // namespace viewcover
