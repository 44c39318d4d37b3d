#include "scene/address.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace viewcover {
namespace {

TEST(QuadAddress, ChildrenRememberTheirWay) {
  const ElementAddress root{SurfaceId(123456)};
  EXPECT_EQ(root.level(), 0);
  EXPECT_EQ(root.path(), 0u);
  const ElementAddress node = root.child(3).child(0).child(2);
  EXPECT_EQ(node.owner(), SurfaceId(123456));
  EXPECT_EQ(node.level(), 3);
  EXPECT_EQ(node.path(), 3u * 16 + 0 * 4 + 2);
  EXPECT_EQ(node.digit(0), 3);
  EXPECT_EQ(node.digit(1), 0);
  EXPECT_EQ(node.digit(2), 2);
  EXPECT_EQ(node.parent().parent(), root.child(3));
  EXPECT_EQ(node, ElementAddress(SurfaceId(123456), 3, 50));
}

TEST(QuadAddress, HoldsTheDeepestLevelOfTheLastOwner) {
  ElementAddress node{SurfaceId(ElementAddress::kOwnerLimit - 1)};
  for (int level = 0; level < kMaxSubdivisionLevel; ++level) node = node.child(3);
  EXPECT_EQ(node.level(), kMaxSubdivisionLevel);
  EXPECT_EQ(node.owner().value, ElementAddress::kOwnerLimit - 1);
  EXPECT_EQ(node.path(), (std::uint64_t{1} << (2 * kMaxSubdivisionLevel)) - 1);
}

TEST(QuadAddress, OrderIsDepthFirst) {
  std::vector<ElementAddress> visited;
  const auto visit = [&](const auto& self, ElementAddress node) -> void {
    visited.push_back(node);
    if (node.level() == 3) return;
    for (int digit = 0; digit < 4; ++digit) self(self, node.child(digit));
  };
  visit(visit, ElementAddress(SurfaceId(1)));
  visit(visit, ElementAddress(SurfaceId(2)));
  EXPECT_TRUE(std::is_sorted(visited.begin(), visited.end()));
  EXPECT_EQ(std::adjacent_find(visited.begin(), visited.end()), visited.end());
}

TEST(QuadAddress, ContainsItsSubtreeOnly) {
  const ElementAddress node = ElementAddress(SurfaceId(5)).child(1).child(2);
  EXPECT_TRUE(node.contains(node));
  EXPECT_TRUE(node.contains(node.child(0).child(3)));
  EXPECT_FALSE(node.contains(node.parent()));
  EXPECT_FALSE(node.contains(node.parent().child(3)));
  EXPECT_FALSE(node.contains(ElementAddress(SurfaceId(6)).child(1).child(2)));
}

}  // namespace
}  // namespace viewcover
