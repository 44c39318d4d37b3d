#include "approx/ray_query.h"

#include "links/sampling.h"

namespace viewcover {

std::optional<Witness> find_sight_line(const ShaftPolygons& shaft, int rays, std::uint64_t seed) {
  const bool from_region = shaft.region.size() > 1;
  const ConvexPolygon element(shaft.element.begin(), shaft.element.end());
  const ConvexPolygon region(shaft.region.begin(), shaft.region.end());
  const PolygonSampler to(element), from(from_region ? region : element);
  Samples4 samples(seed, rays, false);
  for (int ray = 0; ray < rays; ++ray) {
    const auto [u, v, s, t] = samples.next();
    Witness witness;
    if (from_region) witness.region_weights = interior_weights(region, from.point(u, v));
    witness.element_weights = interior_weights(element, to.point(s, t));
    if (classify_segment(shaft, witness) == SegmentKind::kSightLine) return witness;
  }
  return std::nullopt;
}

}  // namespace viewcover
