#pragma once

#include <cstdint>

#include "links/random_segments.h"
#include "links/visibility_backend.h"

namespace viewcover {

struct RayOptions {
  int rays = 16;            ///< random segments a shaft, at least 1
  std::uint64_t seed = 1;   ///< of the run; a shaft's generator depends on it and both addresses
  bool stratified = false;  ///< Latin hypercube samples instead of independent ones
};

/// Random rays as in the source paper, section 3: if several occluders are left in a shaft, random
/// segments between region and element are tried; if all are blocked the shaft counts as hidden.
///
/// A segment counts as free only if it misses every occluder by more than rounding could hide, so
/// a visible verdict is certain; hidden may be wrong.
/// Cost: rays x occluders, ending with the first free ray. Thread-safe.
class RayBackend final : public VisibilityBackend {
 public:
  explicit RayBackend(const RayOptions& options) : options_(options) {}

  std::string_view name() const override { return "rays"; }
  Guarantee guarantee() const override { return Guarantee::kVisibleIsCertain; }
  Verdict decide(const Shaft& shaft, Effort effort) const override;
  bool sees_part(const PointShaft& shaft) const override;
  std::optional<SightLine> find_sight_line(const Shaft& shaft) const override;

 private:
  SegmentOptions segments() const {
    return {.most = options_.rays, .seed = options_.seed, .stratified = options_.stratified};
  }

  RayOptions options_;
};

}  // namespace viewcover
