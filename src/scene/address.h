#pragma once

#include <bit>
#include <cassert>
#include <compare>
#include <cstdint>
#include <optional>

#include "scene/types.h"

namespace viewcover {

/// Deepest quadtree level whose vertices are exact doubles: 24-bit lattice coordinates and at most
/// two further bits a level (the centre of a quadrilateral) leave 53 - 24 = 29 bits.
inline constexpr int kMaxSubdivisionLevel = 14;

/// A node of the quadtree over one polygon: the polygon's index and the path from the root.
///
/// 64 bits: 24 for the owner (a surface or a region part), 40 for the path, written as a leading 1
/// followed by one base-4 digit a level. No tree is stored: vertices follow from the address
/// (`subdivided` in scene/convex_polygon.h), so refinement shares no mutable state.
template <class Owner>
class QuadAddress {
 public:
  static constexpr std::uint32_t kOwnerLimit = 1u << 24;

  constexpr QuadAddress() = default;
  /// The root of the quadtree over `owner`. Requires owner.value < kOwnerLimit.
  constexpr explicit QuadAddress(Owner owner)
      : bits_((static_cast<std::uint64_t>(owner.value) << kPathBits) | 1) {
    assert(owner.value < kOwnerLimit);
  }
  /// The node at `level` whose base-4 digits, the root's child first, are `path`.
  constexpr QuadAddress(Owner owner, int level, std::uint64_t path)
      : bits_((static_cast<std::uint64_t>(owner.value) << kPathBits) |
              (std::uint64_t{1} << (2 * level)) | path) {
    assert(owner.value < kOwnerLimit && level <= kMaxSubdivisionLevel);
  }

  /// The same from numbers of a file, whose owners count from 1; nothing where they name no node.
  static constexpr std::optional<QuadAddress> from_file(std::uint64_t owner, std::uint64_t level,
                                                        std::uint64_t path) {
    if (owner < 1 || owner > kOwnerLimit || level > std::uint64_t{kMaxSubdivisionLevel} ||
        path >> (2 * level) != 0) {
      return std::nullopt;
    }
    return QuadAddress(Owner(static_cast<std::size_t>(owner - 1)), static_cast<int>(level), path);
  }

  constexpr Owner owner() const { return Owner(static_cast<std::size_t>(bits_ >> kPathBits)); }
  /// 0 for the whole polygon.
  constexpr int level() const { return (static_cast<int>(std::bit_width(code())) - 1) / 2; }
  /// The digits as one number in [0, 4^level): the node's place among the nodes of its level.
  constexpr std::uint64_t path() const { return code() ^ (std::uint64_t{1} << (2 * level())); }
  /// Digit of the step from level `depth` to `depth + 1`, in 0..3.
  constexpr int digit(int depth) const {
    return static_cast<int>(code() >> (2 * (level() - depth - 1)) & 3);
  }

  /// Requires level() < kMaxSubdivisionLevel and 0 <= digit < 4.
  constexpr QuadAddress child(int digit) const {
    return QuadAddress(owner(), level() + 1, path() << 2 | static_cast<std::uint64_t>(digit));
  }
  /// Requires level() > 0.
  constexpr QuadAddress parent() const { return QuadAddress(owner(), level() - 1, path() >> 2); }
  /// True for the node itself and every node below it.
  constexpr bool contains(QuadAddress other) const {
    return owner() == other.owner() && level() <= other.level() &&
           other.path() >> (2 * (other.level() - level())) == path();
  }

  /// One number a node, for hashing and seeding.
  constexpr std::uint64_t bits() const { return bits_; }

  friend constexpr bool operator==(QuadAddress, QuadAddress) = default;
  /// Depth-first order: owners in turn, a node before its children, children in turn.
  friend constexpr std::strong_ordering operator<=>(QuadAddress a, QuadAddress b) {
    if (auto by_owner = a.owner() <=> b.owner(); by_owner != 0) return by_owner;
    if (auto by_place = a.first_leaf() <=> b.first_leaf(); by_place != 0) return by_place;
    return a.level() <=> b.level();
  }

 private:
  static constexpr int kPathBits = 40;

  constexpr std::uint64_t code() const { return bits_ & ((std::uint64_t{1} << kPathBits) - 1); }
  constexpr std::uint64_t first_leaf() const {
    return path() << (2 * (kMaxSubdivisionLevel - level()));
  }

  std::uint64_t bits_ = 1;
};

/// A surface element: (surface, quadtree path).
using ElementAddress = QuadAddress<SurfaceId>;
/// A viewing region: (region part, quadtree path).
using RegionAddress = QuadAddress<PartId>;

}  // namespace viewcover
