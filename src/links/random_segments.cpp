#include "links/random_segments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "links/sampling.h"

namespace viewcover {
namespace {

constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;

/// A segment whose ends were rounded: each true end is within `error` of the stored one in every
/// coordinate. Tests say "misses" only when every such segment does.
class RoundedSegment {
 public:
  RoundedSegment(const Point& from, const Point& to, double error)
      : from_(from), to_(to), direction_(to - from), error_(error) {}

  bool misses(const Box& box) const {
    // Separating axes of a segment and a box. A box grown by `error_` outweighs the rounding too:
    // it adds error_ * |direction| to products that err by 4 u * |coordinates| * |direction|.
    const Point half = (0.5 * box.sizes()).array() + error_;
    const Point middle = 0.5 * (from_ + to_) - box.center();
    const Point reach = 0.5 * direction_.cwiseAbs();
    if (((middle.cwiseAbs() - reach).array() > half.array()).any()) return true;
    const Point d = 0.5 * direction_;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      if (std::fabs(middle[j] * d[k] - middle[k] * d[j]) >
          half[j] * reach[k] + half[k] * reach[j]) {
        return true;
      }
    }
    return false;
  }

  bool misses(std::span<const Point> polygon, const Plane& plane) const {
    const int side_from = plane.side_within(from_, error_);
    const int side_to = plane.side_within(to_, error_);
    if (side_from * side_to > 0) return true;
    if (side_from * side_to == 0) return false;  // an end may lie in the plane: count as blocked

    // The segment crosses the plane; it misses the polygon iff it passes an edge on the outer side:
    // det(direction, a - from, b - from) has not the sign of side_to for the edge a, b.
    const std::size_t n = polygon.size();
    double outermost = 0;
    Point first = polygon[n - 1] - from_;
    for (const Point& corner : polygon) {
      const Point second = corner - from_;
      outermost = std::min(outermost, side_to * direction_.dot(first.cross(second)));
      first = second;
    }
    return outermost < 0 && outermost < -determinant_error(polygon);
  }

 private:
  /// |det(a, b, c)| <= |a|_1 |b|_1 |c|_1. Rows err by at most 2 error_ a coordinate (both ends),
  /// 6 error_ in the 1-norm, so the determinant by 18 error_ size^2; evaluating it adds at most
  /// 10 u size^3, where error_ is at least 16 u times the largest coordinate and size at most six
  /// times that.
  double determinant_error(std::span<const Point> polygon) const {
    double size = direction_.lpNorm<1>();
    for (const Point& corner : polygon) size = std::max(size, (corner - from_).lpNorm<1>());
    return 24 * error_ * size * size;
  }

  Point from_, to_, direction_;
  double error_;
};

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

/// A bound on the rounding of sampled points (16 u times the largest coordinate), and on what
/// `Plane::side_within` and the tests above ask for.
double position_error(const Shaft& shaft) {
  const Box box = shaft.box().merged(shaft.occluder_set().clusters().nodes()[0].box);
  const double largest = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  return 16 * kUnitRoundoff * largest;
}

}  // namespace

SegmentCounts try_random_segments(const Shaft& shaft, const SegmentOptions& options) {
  const std::uint64_t seed = mixed(mixed(mixed(options.seed) ^ shaft.region_address().bits()) ^
                                   shaft.element_address().bits());
  Samples4 samples(seed, options.most, options.stratified);
  const PolygonSampler region(shaft.region().polygon), element(shaft.element().polygon);
  const double error = position_error(shaft);
  const auto occluders = shaft.occluders();
  std::size_t last_blocker = 0;  // likely to block the next one too
  SegmentCounts counts;
  for (int i = 0; i < options.most && !(counts.free > 0); ++i) {
    const auto [u, v, s, t] = samples.next();
    const Point from = region.point(u, v);
    if (shaft.one_sided() && shaft.element().plane.side_within(from, error) <= 0) continue;
    const RoundedSegment segment(from, element.point(s, t), error);
    if (is_blocked_by(segment, shaft, occluders[last_blocker])) {
      ++counts.blocked;
      continue;
    }
    const auto blocker = std::find_if(
        occluders.begin(), occluders.end(),
        [&](const ShaftOccluder& occluder) { return is_blocked_by(segment, shaft, occluder); });
    if (blocker == occluders.end()) {
      ++counts.free;
    } else {
      ++counts.blocked;
      last_blocker = static_cast<std::size_t>(blocker - occluders.begin());
    }
  }
  return counts;
}

}  // namespace viewcover
