#pragma once

#include <array>
#include <cstdint>

#include "scene/convex_polygon.h"
#include "scene/random_numbers.h"

namespace viewcover {

/// Four numbers in (0, 1) for each of `count` samples, either independent or stratified: a Latin
/// hypercube, in which each of the four has one sample in each of `count` equal strata. Samples are
/// made one by one, so stopping early costs nothing.
class Samples4 {
 public:
  Samples4(std::uint64_t seed, int count, bool stratified)
      : random_(seed), permutation_seed_(mixed(~seed)), count_(count), stratified_(stratified) {}

  std::array<double, 4> next();

 private:
  RandomNumbers random_;
  std::uint64_t permutation_seed_;
  int count_;
  int index_ = 0;
  bool stratified_;
};

/// Maps the unit square to a convex polygon, uniformly by area.
class PolygonSampler {
 public:
  /// Keeps a reference to the polygon.
  explicit PolygonSampler(const ConvexPolygon& polygon);
  /// A point for u, v in (0, 1]: a combination of three corners with weights >= 0 that sum to 1,
  /// rounded. With unit roundoff 2^-53 each coordinate is off by at most 12 units times the largest
  /// magnitude among the corners' coordinates.
  Point point(double u, double v) const;

 private:
  const ConvexPolygon& polygon_;
  SmallList<double, 4> area_up_to_;  // of the fan's triangles, as shares
};

}  // namespace viewcover
