#include "viewpoints/region_positions.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "links/sampling.h"

namespace viewcover {
namespace {

constexpr int kSignificandBits = 53;
/// Finer positions tell nothing: a millionth of a region.
constexpr int kMostBits = 20;
/// Coordinates with so many bits can be decided about in 128-bit integers (exact/view_cone.h), and
/// what is enough to move about in a region.
constexpr int kCheapCoordinateBits = 40, kEnoughBits = 10, kLeastBits = 6;

/// The exponent of the lowest bit set.
int lowest_exponent(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const auto bits = static_cast<std::uint64_t>(std::ldexp(std::fabs(fraction), kSignificandBits));
  return exponent - kSignificandBits + std::countr_zero(bits);
}

}  // namespace

RegionPositions::RegionPositions(RegionShape region, const Box& scene, int lattice_exponent)
    : region_(std::move(region)) {
  int unit = -lattice_exponent;
  Box box = scene;
  const Box bounds = region_.bounds();
  const ConvexPolygon corners =
      region_.is_box() ? ConvexPolygon{bounds.min(), bounds.max()} : region_.polygon();
  for (const Point& corner : corners) {
    box.extend(corner);
    for (const double x : corner) {
      if (x != 0) unit = std::min(unit, lowest_exponent(x));
    }
  }
  // All numbers in nearest() that are not rounded and differences to corners are multiples of
  // 2^(unit - bits), below twice the largest coordinate.
  const double largest =
      2 * std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
  const int coordinate_bits = std::ilogb(largest) + 1 - unit;
  bits_ = std::clamp(kSignificandBits - coordinate_bits, 0, kMostBits);
  coarse_bits_ =
      std::min(bits_, std::clamp(kCheapCoordinateBits - coordinate_bits, kLeastBits, kEnoughBits));

  if (region_.is_box()) return;
  const Point normal = area_vector(corners).normalized();
  std::size_t farthest = 1;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    if ((corners[i] - corners[0]).norm() > (corners[farthest] - corners[0]).norm()) farthest = i;
  }
  axes_[0] = corners[farthest] - corners[0];
  axes_[1] = normal.cross(axes_[0]);
}

Point RegionPositions::nearest(const Point& point) const { return nearest(point, bits_); }

Point RegionPositions::nearest(const Point& point, int bits) const {
  if (region_.is_box()) return nearest_in_box(point, bits);
  const ConvexPolygon& region = region_.polygon();
  const Point normal = area_vector(region), from_a = point - region[0];
  // The triangle of the fan between whose edges through the first corner the point lies.
  std::size_t triangle = 0;
  while (triangle + 3 < region.size() &&
         (region[triangle + 2] - region[0]).cross(from_a).dot(normal) > 0) {
    ++triangle;
  }
  const Point b = region[triangle + 1] - region[0], c = region[triangle + 2] - region[0];
  const double whole = b.cross(c).dot(normal), steps = std::ldexp(1.0, bits);
  const double s = std::max(from_a.cross(c).dot(normal) / whole, 0.0),
               t = std::max(b.cross(from_a).dot(normal) / whole, 0.0);
  const double scale = std::max(s + t, 1.0);
  const double i = std::min(std::round(steps * (s / scale)), steps);
  const double j = std::min(std::round(steps * (t / scale)), steps - i);
  return region[0] + (i / steps) * b + (j / steps) * c;
}

Point RegionPositions::nearest_in_box(const Point& point, int bits) const {
  const Box& box = region_.box();
  const double steps = std::ldexp(1.0, bits);
  Point position;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = box.sizes()[axis];
    const double share = std::clamp((point[axis] - box.min()[axis]) / size, 0.0, 1.0);
    position[axis] = box.min()[axis] + std::round(steps * share) / steps * size;
  }
  return position;
}

Point RegionPositions::random(RandomNumbers& random) const {
  const double u = random.open_unit(), v = random.open_unit();
  if (region_.is_box()) {
    const Box& box = region_.box();
    const Point shares(u, v, random.open_unit());
    return nearest(box.min() + shares.cwiseProduct(box.sizes()), coarse_bits_);
  }
  return nearest(PolygonSampler(region_.polygon()).point(u, v), coarse_bits_);
}

Point RegionPositions::near(const Point& position, double scale, RandomNumbers& random) const {
  // The sum of three uniform numbers: bell-shaped, and the same on every platform.
  const auto step = [&] { return random.unit() + random.unit() + random.unit() - 1.5; };
  const double s = scale * step(), t = scale * step();
  // A step of 64 units at least, if there are as many bits.
  const int bits = std::clamp(kLeastBits - std::ilogb(scale), coarse_bits_, bits_);
  if (region_.is_box()) {
    const Point steps(s, t, scale * step());
    return nearest(position + steps.cwiseProduct(region_.box().sizes()), bits);
  }
  return nearest(position + s * axes_[0] + t * axes_[1], bits);
}

}  // namespace viewcover
