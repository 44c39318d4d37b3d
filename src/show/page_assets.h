#pragma once

#include <string_view>

namespace viewcover {

/// The files of src/show/page, put into the program when it is built.
struct PageAssets {
  static const std::string_view html, style, script;
};

}  // namespace viewcover
