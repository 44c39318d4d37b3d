#include "audit/viewpoint_scene.h"

#include <algorithm>

namespace viewcover {

using exact::cross;
using exact::dot;
using exact::operator-;
using exact::operator*;

PlanarScene::PlanarScene(const Scene& scene, const ClusterTree& clusters)
    : scene_(scene), clusters_(clusters) {
  const double reach = scene.bounds.sizes().maxCoeff();
  planes_.reserve(scene.surfaces.size());
  for (const Surface& surface : scene.surfaces) {
    planes_.emplace_back(surface.polygon, reach);
    frame_.include(surface.polygon);
  }
  for (const Surface& surface : scene.surfaces)
    surface_planes_.emplace_back(frame_, surface.polygon);
}

ViewedPolygon::ViewedPolygon(const Point& viewpoint, int side, std::span<const Point> polygon,
                             double reach) {
  edges_.reserve(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    // From the front the corners run counter-clockwise, clockwise as seen along the directions.
    if (side > 0) {
      edges_.emplace_back(viewpoint, b, a, reach);
    } else {
      edges_.emplace_back(viewpoint, a, b, reach);
    }
  }
}

bool ViewedPolygon::may_meet(const Box& box) const {
  return std::ranges::none_of(edges_, [&](const SightPlane& edge) { return edge.has_behind(box); });
}

bool ViewedPolygon::has_outside(std::span<const Point> points) const {
  return std::ranges::any_of(edges_, [&](const SightPlane& edge) {
    return std::ranges::all_of(points, [&](const Point& x) { return edge.side(x) <= 0; });
  });
}

ViewpointScene::ViewpointScene(const PlanarScene& planar, const Point& viewpoint)
    : planar_(planar), viewpoint_(viewpoint), frame_(planar.frame()) {
  const Scene& scene = planar.scene();
  Box box = scene.bounds;
  box.extend(viewpoint);
  reach_ = box.sizes().maxCoeff();
  sides_.reserve(scene.surfaces.size());
  for (const Surface& surface : scene.surfaces) {
    const ConvexPolygon& polygon = surface.polygon;
    sides_.push_back(orientation(polygon[0], polygon[1], polygon[2], viewpoint));
  }
  frame_.include({&viewpoint, 1});
  origin_ = frame_.operator()<BigInteger>(viewpoint);
  mpz_setbit(finer_.mpz(),
             static_cast<mp_bitcnt_t>(unit_exponent(planar.frame()) - unit_exponent(frame_)));
}

std::optional<std::vector<ViewedOccluder>> ViewpointScene::occluders(
    SurfaceId id, const ViewedPolygon& view) const {
  const ClusterTree& clusters = planar_.clusters();
  const Scene& scene = planar_.scene();
  const ConvexPolygon& polygon = scene[id].polygon;
  const Plane& plane = planar_.plane(id);
  // What blocks lies nearer than the surface.
  Box between = bounding_box(polygon);
  between.extend(viewpoint_);
  const auto lies_beyond = [&](const Point& corner) { return plane.side(corner) * side(id) <= 0; };
  std::vector<ViewedOccluder> found;
  // Does the surface hide everything? If not, it is found, or in nobody's way.
  const auto hides = [&](SurfaceId place) {
    const ConvexPolygon& corners = scene[place].polygon;
    if (side(place) == 0 || std::ranges::all_of(corners, lies_beyond)) return false;
    const ViewedOccluder occluder{place, view_of(place, corners)};
    const Blocks how = blocks(occluder, polygon, view);
    if (how == Blocks::kPart) found.push_back(occluder);
    return how == Blocks::kEverything;
  };
  if (hides(SurfaceId(last_hider_.load(std::memory_order_relaxed)))) return std::nullopt;
  found.clear();
  const auto nodes = clusters.nodes();
  std::vector<std::uint32_t> open = {0};
  while (!open.empty()) {
    const std::uint32_t at = open.back();
    open.pop_back();
    const ClusterTree::Node& node = nodes[at];
    if (!between.intersects(node.box) || !view.may_meet(node.box)) continue;
    if (!node.is_leaf()) {
      open.push_back(node.right);
      open.push_back(at + 1);
      continue;
    }
    const SurfaceId place = clusters.surface(OccluderId(node.first));
    if (hides(place)) {
      last_hider_.store(place.value, std::memory_order_relaxed);
      return std::nullopt;
    }
  }
  return found;
}

Blocks ViewpointScene::blocks(const ViewedOccluder& occluder, std::span<const Point> part,
                              const ViewedPolygon& view) const {
  const int near = side(occluder.id);
  const Plane& plane = planar_.plane(occluder.id);
  bool before = false, behind = false;
  for (const Point& corner : part) {
    const int at = plane.side(corner) * near;
    before |= at > 0;
    behind |= at < 0;
  }
  if (!behind || view.has_outside(planar_.scene()[occluder.id].polygon)) return Blocks::kNothing;
  bool passes = before;
  for (const SightPlane& edge : occluder.view.edges()) {
    bool inside = false;
    for (const Point& corner : part) {
      const int at = edge.side(corner);
      inside |= at > 0;
      passes |= at < 0;
    }
    if (!inside) return Blocks::kNothing;
  }
  return passes ? Blocks::kPart : Blocks::kEverything;
}

template <class Number>
IntegerPoint ViewpointScene::edge_normal(const Point& from, const Point& to) const {
  const auto origin = frame_.operator()<Number>(viewpoint_);
  const auto normal =
      cross(frame_.operator()<Number>(from) - origin, frame_.operator()<Number>(to) - origin);
  return {exact::to_big(normal[0]), exact::to_big(normal[1]), exact::to_big(normal[2])};
}

SpacePlane ViewpointScene::edge_plane(SurfaceId occluder, std::size_t edge) const {
  const ConvexPolygon& polygon = planar_.scene()[occluder].polygon;
  const Point *from = &polygon[edge], *to = &polygon[(edge + 1) % polygon.size()];
  if (side(occluder) > 0) std::swap(from, to);
  // Differences of numbers of 60 bits have 61, and their cross product 124.
  const IntegerPoint normal = frame_.is_narrow() ? edge_normal<exact::CheckedWide>(*from, *to)
                                                 : edge_normal<BigInteger>(*from, *to);
  BigInteger offset = dot(normal, origin_);
  return {finer_ * normal, std::move(offset)};
}

SpacePlane ViewpointScene::own_plane(SurfaceId occluder) const {
  SpacePlane plane = planar_.surface_plane(occluder).plane();
  if (side(occluder) < 0) return plane;
  return {-plane.normal, -plane.offset};
}

}  // namespace viewcover
