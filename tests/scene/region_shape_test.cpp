#include "scene/region_shape.h"

#include <gtest/gtest.h>

#include <map>
#include <tuple>

#include "scene/plane.h"
#include "scene/viewing_region.h"

namespace viewcover {
namespace {

const Box kSlab(Point(1, 2, 3), Point(5, 5, 3.5));

std::tuple<double, double, double> sizes(const RegionShape& shape) {
  const Point size = shape.box().sizes();
  return {size.x(), size.y(), size.z()};
}

TEST(RegionShape, QuartersOfABoxTileIt) {
  const RegionShape slab(kSlab);
  double volume = 0;
  for (const RegionShape& cell : slab.quarters()) {
    EXPECT_TRUE(kSlab.contains(cell.box()));
    EXPECT_EQ(sizes(cell), std::tuple(2, 1.5, 0.5));
    volume += cell.box().volume();
    for (const RegionShape& other : slab.quarters()) {
      if (cell == other) continue;
      EXPECT_EQ(cell.box().intersection(other.box()).volume(), 0);
    }
  }
  EXPECT_EQ(volume, kSlab.volume());
}

TEST(RegionShape, CellsBecomeCubes) {
  // 4 x 4 x 1 first; then the height is the longest side.
  const RegionShape slab(Box(Point(0, 0, 0), Point(4, 4, 1)));
  const auto cell = [&](int level) {
    return subdivided(slab, RegionAddress(PartId(std::size_t{0}), level, 0));
  };
  EXPECT_EQ(sizes(cell(1)), std::tuple(2, 2, 1));
  EXPECT_EQ(sizes(cell(2)), std::tuple(1, 1, 1));
  EXPECT_EQ(sizes(cell(3)), std::tuple(0.5, 0.5, 1));
  EXPECT_EQ(sizes(cell(4)), std::tuple(0.25, 0.5, 0.5));
}

TEST(RegionShape, HoldsItsBorder) {
  const RegionShape slab(kSlab);
  EXPECT_TRUE(slab.contains({1, 2, 3}));
  EXPECT_TRUE(slab.contains({3, 5, 3.25}));
  EXPECT_FALSE(slab.contains({3, 5 + 0x1p-50, 3.25}));
  EXPECT_FALSE(slab.contains({3, 4, 3 - 0x1p-51}));
  EXPECT_EQ(slab.middle(), Point(3, 3.5, 3.25));
  EXPECT_EQ(slab.surface_area(), 2 * (4 * 3 + 3 * 0.5 + 4 * 0.5));
  EXPECT_EQ(slab.picture().front().z(), 3.25);
  EXPECT_GT(area_vector(slab.picture()).z(), 0);
  EXPECT_EQ(area(slab.picture()), 12);
}

TEST(ViewingRegionOfBoxes, HasTheFacesOfEachCell) {
  const ViewingRegion region = make_viewing_region({}, {Box(Point(0, 0, 0), Point(4, 4, 1))}, 2);
  EXPECT_EQ(region.region_count(), 16u);
  EXPECT_EQ(region.polygon_count(), 0u);
  ASSERT_EQ(region.parts.size(), 16u * 6);
  std::vector<std::size_t> faces_of(16);
  for (std::size_t part = 0; part < region.parts.size(); ++part) {
    const RegionAddress address{PartId(part)};
    EXPECT_TRUE(region.is_face(address));
    EXPECT_EQ(region.index_count(address), 1u);
    const std::size_t number = region.first_index(address);
    ++faces_of[number];
    const RegionShape cell = region.shape(region.address(number));
    const Plane plane(region.parts[part]);
    for (const Point& corner : region.parts[part]) EXPECT_TRUE(cell.contains(corner));
    EXPECT_EQ(plane.side(cell.middle()), 1) << "the front is inward";
  }
  for (const std::size_t count : faces_of) EXPECT_EQ(count, 6u);
}

TEST(ViewingRegionOfBoxes, NumbersPolygonsThenBoxes) {
  const ConvexPolygon square{{0, 0, 9}, {1, 0, 9}, {1, 1, 9}, {0, 1, 9}};
  const ViewingRegion region = make_viewing_region(
      {square}, {Box(Point(0, 0, 0), Point(1, 1, 1)), Box(Point(1, 0, 0), Point(2, 1, 1))}, 1);
  EXPECT_EQ(region.region_count(), 12u);
  EXPECT_EQ(region.polygon_count(), 1u);
  std::map<bool, std::size_t> kinds;
  RegionAddress before;
  for (std::size_t i = 0; i < 12; ++i) {
    const RegionAddress address = region.address(i);
    EXPECT_EQ(region.first_index(address), i);
    EXPECT_EQ(region.index_count(address), 1u);
    EXPECT_EQ(region.first_index(address.parent()), i / 4 * 4);
    EXPECT_EQ(region.index_count(address.parent()), 4u);
    EXPECT_EQ(region.is_in_box(address), i >= 4);
    EXPECT_EQ(region.shape(address).is_box(), i >= 4);
    EXPECT_FALSE(region.is_face(address));
    if (i > 0) {
      EXPECT_LT(before, address);
    }
    before = address;
  }
  EXPECT_EQ(region.shape(region.address(11)).box().max(), Point(2, 1, 1));
}

}  // namespace
}  // namespace viewcover
