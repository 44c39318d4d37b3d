#include "scene/region_shape.h"

#include "scene/predicates.h"

namespace viewcover {
namespace {

int shortest_side(const Box& box) {
  int axis = 0;
  box.sizes().minCoeff(&axis);
  return axis;
}

std::pair<Box, Box> halves_of(const Box& box) {
  int axis = 0;
  box.sizes().maxCoeff(&axis);
  std::pair<Box, Box> halves(box, box);
  const double middle = 0.5 * (box.min()[axis] + box.max()[axis]);
  halves.first.max()[axis] = middle;
  halves.second.min()[axis] = middle;
  return halves;
}

}  // namespace

std::array<ConvexPolygon, 6> box_faces(const Box& box) {
  std::array<ConvexPolygon, 6> faces;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    ConvexPolygon low(4, box.min());
    low[1][u] = low[2][u] = box.max()[u];
    low[2][v] = low[3][v] = box.max()[v];
    ConvexPolygon high(low.rbegin(), low.rend());
    for (Point& corner : high) corner[axis] = box.max()[axis];
    faces[static_cast<std::size_t>(2 * axis)] = std::move(low);
    faces[static_cast<std::size_t>(2 * axis + 1)] = std::move(high);
  }
  return faces;
}

double RegionShape::surface_area() const {
  if (!box_) return area(polygon_);
  const Point size = box_->sizes();
  return 2 * (size.x() * size.y() + size.y() * size.z() + size.z() * size.x());
}

bool RegionShape::contains(const Point& point) const {
  return box_ ? box_->contains(point) : lies_in(point, polygon_);
}

std::vector<ConvexPolygon> RegionShape::faces() const {
  if (!box_) return {polygon_};
  const auto faces = box_faces(*box_);
  return {faces.begin(), faces.end()};
}

std::array<RegionShape, 4> RegionShape::quarters() const {
  if (!box_) {
    auto parts = viewcover::quarters(polygon_);
    return {std::move(parts[0]), std::move(parts[1]), std::move(parts[2]), std::move(parts[3])};
  }
  const auto [first, second] = halves_of(*box_);
  const auto [a, b] = halves_of(first);
  const auto [c, d] = halves_of(second);
  return {a, b, c, d};
}

ConvexPolygon RegionShape::picture() const {
  if (!box_) return polygon_;
  const int axis = shortest_side(*box_);
  ConvexPolygon section = box_faces(*box_)[static_cast<std::size_t>(2 * axis)];
  for (Point& corner : section) corner[axis] = 0.5 * (box_->min()[axis] + box_->max()[axis]);
  return section;
}

bool lies_in(const Point& point, std::span<const Point> polygon) {
  if (orientation(polygon[0], polygon[1], polygon[2], point) != 0) return false;
  const int axis = projection_axis(polygon);
  const int inside = turn(polygon[0], polygon[1], polygon[2], axis);
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    if (turn(polygon[k], polygon[(k + 1) % polygon.size()], point, axis) == -inside) return false;
  }
  return true;
}

}  // namespace viewcover
