#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "optim/region_cover.h"

namespace viewcover {

/// A method of choosing rows and how to make it; a new method is one line in cover_methods.cpp.
struct CoverMethodEntry {
  std::string_view name;  ///< what `--optimizer` and result files call it
  std::unique_ptr<CoverMethod> (*make)();
};

/// All methods; the first one is the default.
std::span<const CoverMethodEntry> cover_methods();

/// The method of that name; null if there is none.
std::unique_ptr<CoverMethod> make_cover_method(std::string_view name);

}  // namespace viewcover
