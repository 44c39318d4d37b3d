#include <CGAL/Gmpq.h>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <sstream>

#include "audit/element_views.h"
#include "audit/imaged_element.h"
#include "audit/made_audit.h"
#include "exact/view_cone.h"
#include "scene/random_numbers.h"
#include "support/sanitized.h"

namespace viewcover {
namespace {

using testing::audit_of;
using testing::RandomRoom;
using testing::Rational;
using testing::share_of;
using testing::shares_of;

const std::uint64_t kRooms = testing::sanitized() ? 4 : 25;

std::vector<double> all_areas(const Audit& audit) {
  std::vector<double> areas;
  for (const ElementAudit& element : audit.elements) {
    areas.insert(areas.end(), element.area_by_images.begin(), element.area_by_images.end());
  }
  return areas;
}

TEST(AuditProperties, AgreesWithViewsByCells) {
  // exact/view_cone.h finds shares by another way: cones of directions.
  std::size_t in_part = 0;
  for (std::uint64_t seed = 0; seed < kRooms; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRoom room(seed);
    std::vector<std::span<const Point>> occluders(room.polygons.begin(), room.polygons.end());
    for (const Point& viewpoint : room.viewpoints) {
      const Audit audit = audit_of(room.polygons, {&viewpoint, 1});
      for (std::size_t i = 0; i < room.polygons.size(); ++i) {
        ExactStatistics statistics;
        constexpr std::array kWeight = {1.0};
        const exact::ViewOfElement view =
            exact::view_element({&viewpoint, 1}, kWeight, room.polygons[i], occluders, statistics);
        std::ostringstream expected;
        expected << view.visible_fraction.numerator() << '/' << view.visible_fraction.denominator();
        EXPECT_EQ(share_of(audit.elements[i]), Rational(expected.str())) << i;
        in_part += audit.elements[i].seen == ElementAudit::Seen::kInPart;
      }
    }
  }
  EXPECT_GT(in_part, 10 * kRooms);
}

TEST(AuditProperties, AFurtherViewpointNeverTakesAway) {
  for (std::uint64_t seed = 0; seed < kRooms; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRoom room(seed);
    std::vector<Rational> before(room.polygons.size(), 0);
    for (std::size_t n = 1; n <= room.viewpoints.size(); ++n) {
      const Audit audit = audit_of(room.polygons, std::span(room.viewpoints).first(n));
      for (std::size_t i = 0; i < before.size(); ++i) {
        const Rational share = share_of(audit.elements[i]);
        EXPECT_GE(share, before[i]);
        EXPECT_LE(share, 1);
        before[i] = share;
      }
    }
  }
}

TEST(AuditProperties, ImagesAddUpToThoseOfSingleViewpoints) {
  for (std::uint64_t seed = 0; seed < kRooms; ++seed) {
    const RandomRoom room(seed);
    const Audit audit = audit_of(room.polygons, room.viewpoints);
    std::vector<double> sums(room.polygons.size(), 0);
    for (const Point& viewpoint : room.viewpoints) {
      const Audit one = audit_of(room.polygons, {&viewpoint, 1});
      for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += one.elements[i].images_mean();
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
      EXPECT_NEAR(audit.elements[i].images_mean(), sums[i], 1e-12) << seed << ' ' << i;
    }
  }
}

TEST(AuditProperties, TheOrderOfViewpointsChangesNoArea) {
  for (std::uint64_t seed = 0; seed < kRooms; ++seed) {
    SCOPED_TRACE(seed);
    RandomRoom room(seed);
    const Audit forward = audit_of(room.polygons, room.viewpoints);
    std::ranges::reverse(room.viewpoints);
    const Audit backward = audit_of(room.polygons, room.viewpoints);
    EXPECT_EQ(shares_of(forward), shares_of(backward));
    EXPECT_EQ(all_areas(forward), all_areas(backward));
  }
}

TEST(AuditProperties, ThreadsChangeNothing) {
  const RandomRoom room(1, 40);
  const auto with = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return audit_of(room.polygons, room.viewpoints, 2);
  };
  const Audit one = with(1), four = with(4);
  EXPECT_EQ(shares_of(one), shares_of(four));
  for (std::size_t i = 0; i < one.elements.size(); ++i) {
    const auto &a = one.elements[i].pieces, &b = four.elements[i].pieces;
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k) {
      EXPECT_EQ(a[k].images, b[k].images);
      EXPECT_TRUE(std::ranges::equal(a[k].polygon, b[k].polygon));
    }
  }
}

TEST(AuditProperties, AnOccluderInTwoPiecesHidesTheSame) {
  for (std::uint64_t seed = 0; seed < kRooms; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRoom room(seed);
    std::vector<ConvexPolygon> split = room.polygons;
    for (std::size_t i = 0; i + 2 < room.polygons.size(); ++i) {
      const ConvexPolygon triangle = split[i];
      const Point middle = (triangle[0] + triangle[1]) / 2;
      split[i] = {triangle[0], middle, triangle[2]};
      split.push_back({middle, triangle[1], triangle[2]});
    }
    const Audit whole = audit_of(room.polygons, room.viewpoints),
                halves = audit_of(split, room.viewpoints);
    for (const std::size_t plane : {room.polygons.size() - 2, room.polygons.size() - 1}) {
      EXPECT_EQ(whole.elements[plane].imaged_share, halves.elements[plane].imaged_share);
      EXPECT_EQ(whole.elements[plane].area_by_images, halves.elements[plane].area_by_images);
    }
  }
}

/// The elements of one surface with their exact pieces.
std::vector<ImagedElement> imaged(const PlanarScene& planar, const SurfacePlane& plane,
                                  SurfaceId surface, std::span<const Point> viewpoints) {
  const std::vector<ElementAddress> elements = {ElementAddress(surface)};
  std::vector<ImagedElement> result;
  result.emplace_back(plane, planar.scene()[surface].polygon);
  for (const Point& viewpoint : viewpoints) {
    view_elements(ViewpointScene(planar, viewpoint), surface, elements, false,
                  [&](std::size_t i, ElementView&& view) {
                    if (view.seen == ElementView::Seen::kWholly) {
                      result[i].add_whole();
                    } else {
                      result[i].add_parts(view.parts);
                    }
                  });
  }
  return result;
}

TEST(AuditProperties, PiecesTileTheElementAndPointsAreInAsManyImages) {
  std::size_t judged = 0, hidden = 0;
  for (std::uint64_t seed = 0; seed < kRooms; ++seed) {
    SCOPED_TRACE(seed);
    const RandomRoom room(seed);
    const Scene scene = testing::scene_of(room.polygons);
    const ClusterTree clusters(scene);
    const PlanarScene planar(scene, clusters);
    const SurfaceId floor(room.polygons.size() - 2);
    const ConvexPolygon& polygon = scene[floor].polygon;
    const SurfacePlane& plane = planar.surface_plane(floor);
    const ImagedElement element = imaged(planar, plane, floor, room.viewpoints)[0];
    const auto pieces = element.pieces();
    ASSERT_GT(pieces.size(), 1u);

    flat::Rational sum = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const flat::Rational area = flat::twice_area(pieces[i].polygon);
      EXPECT_GT(area, 0);
      sum += area;
      for (std::size_t k = 0; k < i; ++k) {
        EXPECT_TRUE(pieces[i].polygon.is_apart_from(pieces[k].polygon));
      }
    }
    EXPECT_EQ(sum, flat::twice_area(plane.flat(polygon)));

    RandomNumbers random(seed);
    for (int trial = 0; trial < 40; ++trial) {
      // A point of the unit square in multiples of 1 / 1009.
      const std::size_t x = 1 + random.below(1008), y = 1 + random.below(1008);
      const testing::ExactPoint q(Rational(x) / 1009, Rational(y) / 1009, 0);
      std::uint32_t images = 0;
      for (const Point& viewpoint : room.viewpoints) {
        images += std::ranges::none_of(room.polygons, [&](const ConvexPolygon& occluder) {
          return testing::segment_meets(testing::ExactPoint(viewpoint), q, occluder);
        });
      }
      const auto unit =
          static_cast<long>(planar.frame().operator()<BigInteger>({1, 0, 0})[0].to_double());
      const flat::FlatPoint flat_q(BigInteger(static_cast<long>(x) * unit),
                                   BigInteger(static_cast<long>(y) * unit), BigInteger(1009));
      for (const ImagedElement::Piece& piece : pieces) {
        const bool inside =
            std::ranges::all_of(piece.polygon.lines(),
                                [&](const flat::FlatLine& line) { return line.side(flat_q) > 0; });
        if (!inside) continue;
        EXPECT_EQ(piece.images + element.whole(), images) << x << ' ' << y;
        ++judged;
        hidden += images < room.viewpoints.size();
      }
    }
  }
  EXPECT_GT(judged, 38 * kRooms);
  EXPECT_GT(hidden, 10 * kRooms);
}

}  // namespace
}  // namespace viewcover
