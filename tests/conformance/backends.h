#pragma once

#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "approx/ray_backend.h"
#include "exact/exact_backend.h"
#include "links/visibility_backend.h"

namespace viewcover::testing {

/// A backend and how to make it from the seed of a run.
struct TestedBackend {
  std::string name;  ///< letters and digits only
  std::unique_ptr<VisibilityBackend> (*make)(std::uint64_t seed);
};

inline void PrintTo(const TestedBackend& backend, std::ostream* out) { *out << backend.name; }

template <class Backend, class... Options>
std::unique_ptr<VisibilityBackend> made(Options... options) {
  return std::make_unique<Backend>(options...);
}

/// What tests/conformance runs over; a new backend is one line here.
inline std::vector<TestedBackend> tested_backends() {
  return {
      {"Exact", [](auto seed) { return made<ExactBackend>(seed); }},
      {"Rays", [](auto seed) { return made<RayBackend>(RayOptions{.rays = 64, .seed = seed}); }},
      {"StratifiedRays",
       [](auto seed) {
         return made<RayBackend>(RayOptions{.rays = 64, .seed = seed, .stratified = true});
       }},
  };
}

}  // namespace viewcover::testing
