#include "app/backends.h"

#include <array>

#include "approx/ray_backend.h"
#include "exact/exact_backend.h"

namespace viewcover {
namespace {

std::unique_ptr<VisibilityBackend> make_rays(const BackendOptions& options) {
  return std::make_unique<RayBackend>(
      RayOptions{.rays = options.rays, .seed = options.seed, .stratified = options.stratified});
}

std::unique_ptr<VisibilityBackend> make_exact(const BackendOptions& options) {
  return std::make_unique<ExactBackend>(options.seed);
}

constexpr std::array kBackends = {
    BackendEntry{"exact", make_exact},
    BackendEntry{"rays", make_rays},
};

}  // namespace

std::span<const BackendEntry> backends() { return kBackends; }

}  // namespace viewcover
