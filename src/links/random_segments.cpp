#include "links/random_segments.h"

#include <bit>

#include "links/rounded_segment.h"
#include "links/sampling.h"

namespace viewcover {
namespace {

bool is_blocked_by(const RoundedSegment& segment, const OccluderSet& occluders, OccluderId id) {
  return !segment.misses(occluders.polygon(id), occluders.plane(id));
}

/// Is the segment blocked by a surface of the cluster? A cluster that was not opened also holds
/// surfaces outside the shaft, such as the element itself: those count for nothing.
bool is_blocked_within(const RoundedSegment& segment, const Shaft& shaft, ClusterNode index) {
  const OccluderSet& occluders = shaft.occluder_set();
  const ClusterTree::Node& node = occluders.clusters().nodes()[index];
  if (node.is_leaf()) {
    ShaftOccluder occluder{.node = index};
    return is_blocked_by(segment, occluders, OccluderId(node.first)) &&
           shaft.meets(occluder) != Shaft::Meets::kNo;
  }
  return !segment.misses(node.box) && (is_blocked_within(segment, shaft, index + 1) ||
                                       is_blocked_within(segment, shaft, node.right));
}

bool is_blocked_by(const RoundedSegment& segment, const Shaft& shaft,
                   const ShaftOccluder& occluder) {
  const ClusterTree::Node& node = shaft.occluder_set().clusters().nodes()[occluder.node];
  if (node.is_leaf()) return is_blocked_by(segment, shaft.occluder_set(), OccluderId(node.first));
  return is_blocked_within(segment, shaft, occluder.node);
}

/// The bound on rounding for segments within a box, against all surfaces of a scene.
double error_within(const Box& box, const OccluderSet& occluders) {
  return RoundedSegment::position_error(box.merged(occluders.clusters().nodes()[0].box));
}

/// Tries segments from `next_segment` until one is free; `blocks(segment, i)`: does occluder i?
template <class NextSegment, class Blocks>
SegmentCounts count_segments(int most, std::size_t occluders, double error,
                             const NextSegment& next_segment, const Blocks& blocks) {
  std::size_t last_blocker = 0;  // likely to block the next one too
  SegmentCounts counts;
  for (int i = 0; i < most && !(counts.free > 0); ++i) {
    const std::optional<SightLine> ends = next_segment(i);
    if (!ends) continue;
    const RoundedSegment segment(ends->from, ends->to, error);
    std::size_t blocker = last_blocker;
    if (last_blocker >= occluders || !blocks(segment, last_blocker)) {
      for (blocker = 0; blocker < occluders && !blocks(segment, blocker);) ++blocker;
    }
    if (blocker == occluders) {
      ++counts.free;
      counts.sight_line = ends;
    } else {
      ++counts.blocked;
      last_blocker = blocker;
    }
  }
  return counts;
}

}  // namespace

SegmentCounts try_random_segments(const Shaft& shaft, const SegmentOptions& options) {
  const std::uint64_t seed = mixed(mixed(mixed(options.seed) ^ shaft.region_address().bits()) ^
                                   shaft.element_address().bits());
  Samples4 samples(seed, options.most, options.stratified);
  const PolygonSampler region(shaft.region().polygon), element(shaft.element().polygon);
  const double error = error_within(shaft.box(), shaft.occluder_set());
  return count_segments(
      options.most, shaft.occluders().size(), error,
      [&](int /*number*/) -> std::optional<SightLine> {
        const auto [u, v, s, t] = samples.next();
        const Point from = region.point(u, v);
        if (shaft.one_sided() && shaft.element().plane.side_within(from, error) <= 0) return {};
        return SightLine{from, element.point(s, t)};
      },
      [&](const RoundedSegment& segment, std::size_t occluder) {
        return is_blocked_by(segment, shaft, shaft.occluders()[occluder]);
      });
}

SegmentCounts try_random_segments(const PointShaft& shaft, const SegmentOptions& options) {
  std::uint64_t seed = mixed(mixed(options.seed) ^ shaft.element_address().bits());
  for (const double x : shaft.viewpoint()) seed = mixed(seed ^ std::bit_cast<std::uint64_t>(x));
  Samples4 samples(seed, options.most, options.stratified);
  const PolygonSampler element(shaft.element().polygon);
  const Box box = bounding_box(shaft.element().polygon).extend(shaft.viewpoint());
  const double error = error_within(box, shaft.occluder_set());
  const int targets = shaft.target() ? 1 : 0;
  return count_segments(
      options.most + targets, shaft.occluders().size(), error,
      [&](int number) -> std::optional<SightLine> {
        if (number < targets) return SightLine{shaft.viewpoint(), *shaft.target()};
        const auto [u, v, s, t] = samples.next();
        return SightLine{shaft.viewpoint(), element.point(s, t)};
      },
      [&](const RoundedSegment& segment, std::size_t occluder) {
        return is_blocked_by(segment, shaft.occluder_set(), shaft.occluders()[occluder]);
      });
}

}  // namespace viewcover
