#include "approx/ray_backend.h"

#include "links/random_segments.h"

namespace viewcover {

Verdict RayBackend::decide(const Shaft& shaft, Effort /*effort*/) const {
  const SegmentCounts counts = try_random_segments(
      shaft, {.most = options_.rays, .seed = options_.seed, .stratified = options_.stratified});
  return counts.free > 0 ? Verdict::kVisibleWitness : Verdict::kHiddenAllRaysBlocked;
}

}  // namespace viewcover
