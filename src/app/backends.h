#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "links/visibility_backend.h"

namespace viewcover {

/// What backends are made from; each takes what concerns it.
struct BackendOptions {
  int rays = 16;
  bool stratified = false;
  std::uint64_t seed = 1;
};

/// A backend and how to make it; a new backend is one line in backends.cpp.
struct BackendEntry {
  std::string_view name;  ///< what `--backend` calls it
  std::unique_ptr<VisibilityBackend> (*make)(const BackendOptions&);
};

/// All backends; the first one is the default.
std::span<const BackendEntry> backends();

}  // namespace viewcover
