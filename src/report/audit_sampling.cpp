#include "report/audit_sampling.h"

#include <algorithm>

#include "links/sampling.h"
#include "links/sight_line.h"
#include "scene/random_numbers.h"

namespace viewcover {
namespace {

/// False only if the segment misses the box: separating axes, with a margin far above rounding and
/// below any box.
bool may_meet(const Box& box, const Point& from, const Point& to, double margin) {
  const Point centre = (from + to) / 2 - box.center();
  const Point half = (to - from) / 2, reach = half.cwiseAbs();
  const Point size = box.sizes() / 2 + Point::Constant(margin);
  if ((centre.cwiseAbs() - reach - size).maxCoeff() > 0) return false;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const Eigen::Index j = (i + 1) % 3, k = (i + 2) % 3;
    const double apart = std::fabs(centre[j] * half[k] - centre[k] * half[j]);
    if (apart >
        (size[j] + margin) * (reach[k] + margin) + (size[k] + margin) * (reach[j] + margin)) {
      return false;
    }
  }
  return true;
}

}  // namespace

SampleCounts SightSampler::sample(SurfaceId surface, const ConvexPolygon& part, std::size_t samples,
                                  std::uint64_t seed) const {
  SampleCounts counts;
  counts.samples = samples;
  RandomNumbers random(seed);
  const PolygonSampler sampler(part);
  for (std::size_t i = 0; i < samples; ++i) {
    const double u = random.open_unit(), v = random.open_unit();
    const std::vector<double> weights = interior_weights(part, sampler.point(u, v));
    const auto images =
        static_cast<std::size_t>(std::ranges::count_if(viewpoints_, [&](const Point& viewpoint) {
          return sees(surface, part, weights, viewpoint);
        }));
    counts.imaged += images > 0;
    counts.images += images;
    counts.most = std::max(counts.most, images);
  }
  return counts;
}

bool SightSampler::sees(SurfaceId surface, const ConvexPolygon& part,
                        const std::vector<double>& weights, const Point& viewpoint) const {
  constexpr double kMargin = 0x1p-40;
  const Point target = weighted_point(part, weights);
  Box between = scene_.bounds;
  between.extend(viewpoint);
  const double margin =
      kMargin * std::max(between.min().cwiseAbs().maxCoeff(), between.max().cwiseAbs().maxCoeff());
  const auto nodes = clusters_.nodes();
  SmallList<std::span<const Point>, 32> occluders;
  SmallList<std::uint32_t, 64> open = {0};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    const ClusterTree::Node& node = nodes[at];
    if (!may_meet(node.box, viewpoint, target, margin)) continue;
    if (!node.is_leaf()) {
      open.push_back(node.right);
      open.push_back(at + 1);
      continue;
    }
    const SurfaceId id = clusters_.surface(OccluderId(node.first));
    if (id != surface) occluders.push_back(scene_[id].polygon);
  }
  const ShaftPolygons shaft{{&viewpoint, 1}, part, occluders, one_sided_};
  return classify_segment(shaft, {{}, weights}) == SegmentKind::kSightLine;
}

}  // namespace viewcover
