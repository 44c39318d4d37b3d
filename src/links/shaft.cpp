#include "links/shaft.h"

#include <algorithm>
#include <utility>

namespace viewcover {

Shaft::Shaft(const OccluderSet& occluders, RegionAddress region_address,
             const PlanarPolygon& region, ElementAddress element_address,
             const PlanarPolygon& element, bool one_sided)
    : occluders_(&occluders),
      region_(&region),
      element_(&element),
      region_address_(region_address),
      element_address_(element_address),
      one_sided_(one_sided),
      box_(bounding_box(region.polygon).merged(bounding_box(element.polygon))),
      far_(element.polygon.begin(), element.polygon.end()) {
  const Sides of_region = add_support_planes(element, region.polygon);
  facing_ = one_sided ? of_region.front : !of_region.none_off();
  wholly_facing_ = facing_ && !(one_sided && of_region.back);
  if (facing_) add_support_planes(region, far_);
}

Shaft::Shaft(const OccluderSet& occluders, const PlanarPolygon& region, const Box& box)
    : occluders_(&occluders), region_(&region), box_(bounding_box(region.polygon).merged(box)) {
  for (const Point& corner : box_corners(box)) far_.push_back(corner);
  add_support_planes(region, far_);
}

Shaft::Sides Shaft::sides(const Plane& plane, std::span<const Point> points) {
  Sides result;
  for (const Point& point : points) result.add(plane.side(point));
  return result;
}

Shaft::Sides Shaft::add_support_planes(const PlanarPolygon& base, std::span<const Point> far) {
  SmallList<int, 8> side_of;
  Sides all;
  for (const Point& point : far) {
    side_of.push_back(base.plane.side(point));
    all.add(side_of.back());
  }
  if (all.front && !all.back) planes_.push_back(base.plane.reversed());
  if (all.back && !all.front) planes_.push_back(base.plane);

  // On one side of the base, the far point seen at the widest angle from an edge spans the plane;
  // points on the other side or in the plane of the base may still cut it.
  const std::size_t n = base.polygon.size();
  const auto add_through_edge = [&](const Point& a, const Point& b, int side) {
    const auto first =
        static_cast<std::size_t>(std::find(side_of.begin(), side_of.end(), side) - side_of.begin());
    Plane plane(a, b, far[first], occluders_->reach());
    for (std::size_t i = first + 1; i < far.size(); ++i) {
      if (side_of[i] == side && plane.side(far[i]) > 0) {
        plane = Plane(a, b, far[i], occluders_->reach());
      }
    }
    for (std::size_t i = 0; i < far.size(); ++i) {
      if (side_of[i] != side && plane.side(far[i]) > 0) return;
    }
    planes_.push_back(plane);
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Point &a = base.polygon[i], &b = base.polygon[(i + 1) % n];
    if (all.front) add_through_edge(a, b, 1);
    if (all.back) add_through_edge(b, a, -1);
  }
  return all;
}

bool Shaft::may_meet(const Box& box) const {
  return std::none_of(planes_.begin(), planes_.end(),
                      [&](const Plane& plane) { return plane.has_in_front(box); });
}

bool Shaft::box_overlaps(const Box& box) const {
  return (box.min().array() < box_.max().array()).all() &&
         (box.max().array() > box_.min().array()).all();
}

Shaft::Meets Shaft::meets(ShaftOccluder& occluder) const {
  const OccluderId id(occluders_->clusters().nodes()[occluder.node].first);
  const std::span<const Point> polygon = occluders_->polygon(id);
  for (const Plane& plane : planes_) {
    if (std::none_of(polygon.begin(), polygon.end(),
                     [&](const Point& corner) { return plane.side(corner) < 0; })) {
      return Meets::kNo;
    }
  }
  using Separates = ShaftOccluder::Separates;
  const Plane& plane = occluders_->plane(id);
  bool may_block = true;
  if (occluder.separates == Separates::kNotKnown) {
    const Sides near = sides(plane, region_->polygon);
    const Sides far = sides(plane, far_);
    if (near.none_off() || (element_ != nullptr && far.none_off())) return Meets::kNo;  // coplanar
    if (!(near.front || far.front) || !(near.back || far.back)) return Meets::kNo;  // on one side
    // A box may hold elements in the occluder's own plane, which it does not hide.
    if ((near.front && near.back) || (far.front && far.back) || (element_ == nullptr && far.on)) {
      may_block = false;
    } else {
      occluder.separates = near.front ? Separates::kRegionInFront : Separates::kRegionBehind;
    }
  }
  if (may_block && blocks_all(polygon, occluder.separates == Separates::kRegionInFront)) {
    return Meets::kBlocksAll;
  }
  return element_ != nullptr && passes_outside(polygon, plane) ? Meets::kNo : Meets::kMaybe;
}

bool Shaft::passes_outside(std::span<const Point> occluder, const Plane& plane) const {
  // The shaft's section with the occluder's plane is the hull of the points where lines between
  // corners on either side cross it. Two convex polygons in a plane are apart, but for contact, iff
  // one lies outside an edge of the other: the section's edges are in the shaft's planes.
  SmallList<const Point*, 16> front, back;
  const auto sort = [&](std::span<const Point> corners) {
    for (const Point& corner : corners) {
      const int side = plane.side(corner);
      if (side >= 0) front.push_back(&corner);
      if (side <= 0) back.push_back(&corner);
    }
  };
  sort(region_->polygon);
  sort(far_);
  const std::size_t n = occluder.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Point &a = occluder[k], &b = occluder[k + 1 < n ? k + 1 : 0];
    bool outside = true;
    for (auto x = front.begin(); x != front.end() && outside; ++x) {
      for (auto y = back.begin(); y != back.end() && outside; ++y) {
        outside = orientation(a, b, **x, **y) >= 0;
      }
    }
    if (outside) return true;
  }
  return false;
}

bool Shaft::blocks_all(std::span<const Point> occluder, bool region_in_front) const {
  // Region and far points are on different sides of the occluder's plane, so every sight line
  // crosses it; it crosses within the occluder iff all lines between corners pass every edge on
  // the inner side (or meet it): such lines are closed under combination with positive weights.
  const std::size_t n = occluder.size();
  const auto edge = [&](std::size_t k) {
    const Point &first = occluder[k], &second = occluder[k + 1 < n ? k + 1 : 0];
    return region_in_front ? std::pair<const Point&, const Point&>(first, second)
                           : std::pair<const Point&, const Point&>(second, first);
  };
  // Most occluders that do not block are betrayed by one of two lines between opposite corners.
  const ConvexPolygon& region = region_->polygon;
  for (std::size_t k = 0; k < n; ++k) {
    const auto [a, b] = edge(k);
    if (orientation(a, b, region[0], far_[0]) > 0) return false;
    if (orientation(a, b, region[region.size() / 2], far_[far_.size() / 2]) > 0) return false;
  }
  for (std::size_t k = 0; k < n; ++k) {
    const auto [a, b] = edge(k);
    for (const Point& near : region) {
      const Plane plane(near, a, b, occluders_->reach());
      for (const Point& far : far_) {
        if (plane.side(far) > 0) return false;
      }
    }
  }
  return true;
}

}  // namespace viewcover
