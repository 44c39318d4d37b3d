#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace viewcover {

/// A point or vector in scene units. Coordinates of a loaded scene are exact multiples of the
/// lattice step (scene/lattice.h), so differences of points are exact in double.
using Point = Eigen::Vector3d;

/// Closed axis-parallel box. `Box()` is empty.
using Box = Eigen::AlignedBox3d;

/// An index that only compares with its own kind: a SurfaceId is not a GroupId.
template <class Tag>
struct StrongIndex {
  std::uint32_t value = 0;

  constexpr StrongIndex() = default;
  constexpr explicit StrongIndex(std::size_t index) : value(static_cast<std::uint32_t>(index)) {}
  friend constexpr auto operator<=>(StrongIndex, StrongIndex) = default;
};

/// A convex polygon of the scene, in the order of the file's faces.
using SurfaceId = StrongIndex<struct SurfaceTag>;
/// A named group of surfaces (OBJ `g` or `o`).
using GroupId = StrongIndex<struct GroupTag>;
/// A polygon or box of the viewing region, or a face of one (scene/viewing_region.h).
using PartId = StrongIndex<struct PartTag>;
/// A surface seen as an occluder: its place in the leaf order of the cluster tree.
using OccluderId = StrongIndex<struct OccluderTag>;

}  // namespace viewcover
