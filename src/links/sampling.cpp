#include "links/sampling.h"

#include <bit>
#include <cmath>

namespace viewcover {
namespace {

/// Place of `index` in a random permutation of [0, count), without storing it: mix within the next
/// power of two and walk the cycle until inside (Kensler 2013).
std::uint32_t permuted(std::uint32_t index, std::uint32_t count, std::uint64_t seed) {
  const std::uint32_t mask = std::bit_ceil(count) - 1;
  do {
    for (int round = 0; round < 3; ++round) {
      // Each step is a bijection of [0, mask]: add, multiply by an odd number, fold high bits down.
      index = (index + static_cast<std::uint32_t>(seed >> (16 * round))) & mask;
      index = (index * 0x9e3779b1u) & mask;
      index ^= index >> (std::bit_width(mask) / 2 + 1);
    }
  } while (index >= count);
  return index;
}

}  // namespace

std::array<double, 4> Samples4::next() {
  std::array<double, 4> sample;
  for (double& u : sample) u = random_.open_unit();
  if (stratified_) {
    for (std::size_t axis = 0; axis < 4; ++axis) {
      const std::uint32_t stratum =
          permuted(static_cast<std::uint32_t>(index_), static_cast<std::uint32_t>(count_),
                   mixed(permutation_seed_ + axis));
      sample[axis] = (stratum + sample[axis]) / count_;
    }
  }
  ++index_;
  return sample;
}

PolygonSampler::PolygonSampler(const ConvexPolygon& polygon) : polygon_(polygon) {
  double total = 0;
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    total += (polygon[i - 1] - polygon[0]).cross(polygon[i] - polygon[0]).norm();
    area_up_to_.push_back(total);
  }
  for (double& share : area_up_to_) share /= total;
}

Point PolygonSampler::point(double u, double v) const {
  std::size_t triangle = 0;
  while (triangle + 1 < area_up_to_.size() && u >= area_up_to_[triangle]) ++triangle;
  const double begin = triangle == 0 ? 0 : area_up_to_[triangle - 1];
  const double w = std::sqrt((u - begin) / (area_up_to_[triangle] - begin));
  const Point &a = polygon_[0], &b = polygon_[triangle + 1], &c = polygon_[triangle + 2];
  return a + w * (b - a) + w * v * (c - b);
}

}  // namespace viewcover
