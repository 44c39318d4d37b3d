#include "links/occluder_set.h"

namespace viewcover {

OccluderSet::OccluderSet(const Scene& scene, const ClusterTree& clusters,
                         const ViewingRegion& region)
    : clusters_(clusters) {
  Box box = scene.bounds;
  for (const ConvexPolygon& part : region.parts) box.extend(bounding_box(part));
  reach_ = box.sizes().maxCoeff();
  first_corner_.reserve(clusters.size() + 1);
  planes_.reserve(clusters.size());
  for (std::size_t place = 0; place < clusters.size(); ++place) {
    const ConvexPolygon& polygon = scene[clusters.surface(OccluderId(place))].polygon;
    corners_.insert(corners_.end(), polygon.begin(), polygon.end());
    first_corner_.push_back(static_cast<std::uint32_t>(corners_.size()));
    planes_.emplace_back(polygon, reach_);
  }
}

}  // namespace viewcover
