#include <gtest/gtest.h>

#include "audit/made_audit.h"

namespace viewcover {
namespace {

using testing::audit_of;
using testing::horizontal;
using Seen = ElementAudit::Seen;

/// A floor of side 4 and a plate over it at height 1; the floor comes first.
const std::vector<ConvexPolygon> kPlateOverFloor = {horizontal(0, 0, 4, 4, 0),
                                                    horizontal(1, 1, 2, 2, 1)};

ConvexPolygon flipped(ConvexPolygon polygon) {
  std::reverse(polygon.begin(), polygon.end());
  return polygon;
}

ElementAudit floor_from(std::vector<Point> viewpoints,
                        const std::vector<ConvexPolygon>& polygons = kPlateOverFloor,
                        bool one_sided = false) {
  return audit_of(polygons, viewpoints, 0, one_sided).elements[0];
}

TEST(Audit, AShadowHasItsExactArea) {
  // From height h over its middle the unit plate at height 1 casts a square of side h / (h - 1).
  EXPECT_EQ(floor_from({{1.5, 1.5, 2}}).imaged_share, "3/4");
  EXPECT_EQ(floor_from({{1.5, 1.5, 3}}).imaged_share, "55/64");
  EXPECT_EQ(floor_from({{1.5, 1.5, 4}}).imaged_share, "8/9");
  const ElementAudit floor = floor_from({{1.5, 1.5, 2}});
  EXPECT_EQ(floor.seen, Seen::kInPart);
  EXPECT_EQ(floor.area, 16);
  EXPECT_EQ(floor.imaged_area, 12);
  EXPECT_EQ(floor.area_by_images, (std::vector<double>{4, 12}));
}

TEST(Audit, TwoViewpointsAreJoinedAndCounted) {
  // Shadows [0.5, 2.5]^2 and [0, 1.5] x [0.5, 2.5], which share [0.5, 1.5] x [0.5, 2.5].
  const ElementAudit floor = floor_from({{1.5, 1.5, 2}, {2.5, 1.5, 2}});
  EXPECT_EQ(floor.imaged_share, "7/8");
  EXPECT_EQ(floor.area_by_images, (std::vector<double>{2, 3, 11}));
  EXPECT_EQ(floor.images_max(), 2u);
  EXPECT_DOUBLE_EQ(floor.images_mean(), 25.0 / 16);
}

TEST(Audit, WhatOneHidesAnotherMayShow) {
  // Shadows [0.5, 2.5]^2 and [2, 4] x [0.5, 2.5]: [2, 2.5] x [0.5, 2.5] is in both.
  EXPECT_EQ(floor_from({{1.5, 1.5, 2}, {0, 1.5, 2}}).imaged_share, "15/16");
  // From far aside the shadow falls on [8, 10], off the floor.
  EXPECT_EQ(floor_from({{1.5, 1.5, 2}, {-6, 1.5, 2}}).seen, Seen::kWholly);
}

TEST(Audit, AnElementSeenEdgeOnIsNotSeen) {
  const ElementAudit floor = floor_from({{8, 2, 0}});
  EXPECT_EQ(floor.seen, Seen::kNot);
  EXPECT_EQ(floor.imaged_share, "0");
  EXPECT_EQ(floor.images_max(), 0u);
  EXPECT_EQ(floor.imaged_area, 0);
}

TEST(Audit, AnOccluderSeenEdgeOnHidesNothing) {
  const Audit audit = audit_of(kPlateOverFloor, std::vector<Point>{{3, 3, 1}});
  EXPECT_EQ(audit.elements[0].seen, Seen::kWholly);
  EXPECT_EQ(audit.elements[0].imaged_share, "1");
  EXPECT_EQ(audit.elements[1].seen, Seen::kNot);
}

TEST(Audit, OneOccluderMayHideAll) {
  const std::vector<ConvexPolygon> polygons = {horizontal(0, 0, 4, 4, 0),
                                               horizontal(0, 0, 4, 4, 1)};
  EXPECT_EQ(floor_from({{2, 2, 2}}, polygons).seen, Seen::kNot);
  // As may two that abut, and three quarters of it that meet in a corner leave a quarter.
  const std::vector<ConvexPolygon> halves = {horizontal(0, 0, 4, 4, 0), horizontal(1, 1, 2, 3, 1),
                                             horizontal(2, 1, 3, 3, 1)};
  EXPECT_EQ(floor_from({{2, 2, 2}}, halves).seen, Seen::kNot);
  const std::vector<ConvexPolygon> quarters = {horizontal(0, 0, 4, 4, 0), horizontal(1, 1, 2, 2, 1),
                                               horizontal(2, 1, 3, 2, 1),
                                               horizontal(1, 2, 2, 3, 1)};
  EXPECT_EQ(floor_from({{2, 2, 2}}, quarters).imaged_share, "1/4");
}

TEST(Audit, AWallThroughTheFloorShadesWhatIsBehind) {
  // From (6, 2, 2) the wall in x = 2 shades 0 <= x <= 2, |y - 2| <= (6 - x) / 4: area 5 of 32; what
  // of it is under the floor shades nothing.
  const std::vector<ConvexPolygon> polygons = {horizontal(0, 0, 8, 4, 0),
                                               {{2, 1, -1}, {2, 3, -1}, {2, 3, 1}, {2, 1, 1}}};
  EXPECT_EQ(floor_from({{6, 2, 2}}, polygons).imaged_share, "27/32");
}

TEST(Audit, OneSidedSurfacesAreSeenFromTheFrontAndHideFromBothSides) {
  std::vector<ConvexPolygon> polygons = kPlateOverFloor;
  polygons[1] = flipped(polygons[1]);
  const std::vector<Point> above = {{1.5, 1.5, 2}};
  const Audit audit = audit_of(polygons, above, 0, true);
  EXPECT_EQ(audit.elements[0].imaged_share, "3/4");
  EXPECT_EQ(audit.elements[1].seen, Seen::kNot);
  polygons[0] = flipped(polygons[0]);
  EXPECT_EQ(floor_from(above, polygons, true).seen, Seen::kNot);
  EXPECT_EQ(floor_from(above, polygons, false).imaged_share, "3/4");
}

TEST(Audit, NoViewpointShowsNothing) {
  const ElementAudit floor = floor_from({});
  EXPECT_EQ(floor.seen, Seen::kNot);
  EXPECT_EQ(floor.area_by_images, (std::vector<double>{16}));
}

TEST(Audit, SubdivisionAddsUp) {
  const std::vector<Point> viewpoints = {{1.5, 1.25, 2}, {2.3, 1.7, 3.1}};
  const ElementAudit whole = floor_from(viewpoints);
  const Audit parts = audit_of(kPlateOverFloor, viewpoints, 2);
  testing::Rational sum = 0;
  for (std::size_t i = 0; i < 16; ++i) sum += testing::share_of(parts.elements[i]) / 16;
  EXPECT_EQ(sum, testing::share_of(whole));
}

TEST(Audit, AffineMapsKeepShares) {
  // x -> A x with whole numbers: no axis is special, no plane level.
  const auto moved = [](const Point& p) {
    return Point(2 * p.x() + p.y() - p.z(), p.x() + 3 * p.y() + 2 * p.z(),
                 p.x() - p.y() + 5 * p.z());
  };
  std::vector<ConvexPolygon> polygons = kPlateOverFloor;
  for (ConvexPolygon& polygon : polygons) {
    for (Point& corner : polygon) corner = moved(corner);
  }
  const ElementAudit floor = floor_from({moved({1.5, 1.5, 2}), moved({2.5, 1.5, 2})}, polygons);
  EXPECT_EQ(floor.imaged_share, "7/8");
  EXPECT_NEAR(floor.area_by_images[1] / floor.area, 3.0 / 16, 1e-15);
}

}  // namespace
}  // namespace viewcover
