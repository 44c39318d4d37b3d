#pragma once

#include <optional>
#include <span>

#include "links/occluder_set.h"
#include "links/shaft.h"
#include "scene/small_list.h"

namespace viewcover {

using PointShaftOccluders = SmallList<OccluderId, 96>;

/// The cone between a viewpoint and an element (paper, section 2.4: point-polygon shaft culling),
/// bounded by the element's plane and the planes through the viewpoint and its edges.
///
/// An occluder hides a part of the element of positive area only if it meets the open cone and its
/// plane does not hold the viewpoint; only occluders that do not are dropped, on the word of exact
/// predicates. Requires that the difference of the viewpoint and any corner is an exact double.
class PointShaft {
 public:
  /// Keeps references to `occluders` and `element`.
  PointShaft(const OccluderSet& occluders, const Point& viewpoint, ElementAddress element_address,
             const PlanarPolygon& element, bool one_sided);

  const OccluderSet& occluder_set() const { return *occluders_; }
  const Point& viewpoint() const { return viewpoint_; }
  ElementAddress element_address() const { return element_address_; }
  const PlanarPolygon& element() const { return *element_; }
  bool one_sided() const { return one_sided_; }

  /// False iff the viewpoint is in the element's plane, or behind a one-sided element. Exact.
  bool is_facing() const { return facing_; }

  enum class Meets { kNo, kMaybe, kBlocksAll };
  /// kNo only if the occluder hides nothing of the element, kBlocksAll iff it hides all of it
  /// alone; both exact. Requires is_facing().
  Meets meets(OccluderId occluder) const;
  /// Writes to `kept` the candidates that may hide something, in their order. True, with `kept`
  /// unfinished, as soon as one hides everything. Requires is_facing().
  bool cull(std::span<const OccluderId> candidates, PointShaftOccluders& kept) const;

  /// The occluders left in the shaft, as set by `set_occluders`.
  std::span<const OccluderId> occluders() const { return left_; }
  void set_occluders(std::span<const OccluderId> left) { left_ = left; }

  /// A place on the element that is likely to be seen, for backends to try first.
  const std::optional<Point>& target() const { return target_; }
  void set_target(const Point& target) { target_ = target; }

 private:
  const OccluderSet* occluders_;
  Point viewpoint_;
  ElementAddress element_address_;
  const PlanarPolygon* element_;
  bool one_sided_;
  bool facing_;
  SmallList<Plane, 6> planes_;  // outside is in front
  std::span<const OccluderId> left_;
  std::optional<Point> target_;
};

}  // namespace viewcover
