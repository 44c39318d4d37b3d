#include "app/backends.h"

#include <array>

#include "approx/ray_backend.h"

namespace viewcover {
namespace {

std::unique_ptr<VisibilityBackend> make_rays(const BackendOptions& options) {
  return std::make_unique<RayBackend>(
      RayOptions{.rays = options.rays, .seed = options.seed, .stratified = options.stratified});
}

constexpr std::array kBackends = {
    BackendEntry{"rays", make_rays},
};

}  // namespace

std::span<const BackendEntry> backends() { return kBackends; }

}  // namespace viewcover
