#include "approx/ray_backend.h"

namespace viewcover {

Verdict RayBackend::decide(const Shaft& shaft, Effort /*effort*/) const {
  return try_random_segments(shaft, segments()).free > 0 ? Verdict::kVisibleWitness
                                                         : Verdict::kHiddenAllRaysBlocked;
}

bool RayBackend::sees_part(const PointShaft& shaft) const {
  return shaft.occluders().empty() || try_random_segments(shaft, segments()).free > 0;
}

std::optional<SightLine> RayBackend::find_sight_line(const Shaft& shaft) const {
  return try_random_segments(shaft, segments()).sight_line;
}

}  // namespace viewcover
