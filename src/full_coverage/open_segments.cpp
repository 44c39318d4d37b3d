#include "full_coverage/open_segments.h"

#include "scene/predicates.h"
#include "scene/small_list.h"

namespace viewcover {
namespace {

/// Does the line pq, which crosses the plane of the polygon, meet the closed polygon? Exact.
bool stabs(const Point& p, const Point& q, std::span<const Point> polygon) {
  int first = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const int side = orientation(p, q, polygon[k], polygon[k + 1 < polygon.size() ? k + 1 : 0]);
    if (side * first < 0) return false;
    if (first == 0) first = side;
  }
  return true;
}

/// A segment and what its boxes are compared with, a margin included that rounding cannot use up.
class BoxTest {
 public:
  BoxTest(const Point& p, const Point& q, double reach)
      : middle_(0.5 * (p + q)),
        half_(0.5 * (q - p).cwiseAbs()),
        direction_(q - p),
        margin_(1e-12 * reach) {}

  /// False only if the segment misses the box.
  bool may_meet(const Box& box) const {
    const Point half = 0.5 * (box.max() - box.min());
    const Point offset = middle_ - 0.5 * (box.min() + box.max());
    for (int i = 0; i < 3; ++i) {
      if (std::fabs(offset[i]) > half[i] + half_[i] + margin_) return false;
    }
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3, k = (i + 2) % 3;
      const double u = std::fabs(direction_[j]), v = std::fabs(direction_[k]);
      if (std::fabs(direction_[j] * offset[k] - direction_[k] * offset[j]) >
          half[k] * u + half[j] * v + margin_ * (u + v)) {
        return false;
      }
    }
    return true;
  }

 private:
  Point middle_, half_, direction_;
  double margin_;
};

}  // namespace

bool OpenSegments::is_free(const Point& p, const Point& q) const {
  const BoxTest test(p, q, occluders_.reach());
  const auto nodes = occluders_.clusters().nodes();
  SmallList<ClusterNode, 64> open;
  open.push_back(0);
  while (!open.empty()) {
    const ClusterNode at = open.back();
    open.pop_back();
    const ClusterTree::Node& node = nodes[at];
    if (!test.may_meet(node.box)) continue;
    if (!node.is_leaf()) {
      open.push_back(node.right);
      open.push_back(at + 1);
      continue;
    }
    const OccluderId occluder(node.first);
    const Plane& plane = occluders_.plane(occluder);
    if (plane.side(p) * plane.side(q) < 0 && stabs(p, q, occluders_.polygon(occluder))) {
      return false;
    }
  }
  return true;
}

}  // namespace viewcover
