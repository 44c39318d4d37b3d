#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iostream>
#include <numeric>

#include "exact/sight_query.h"
#include "links/point_shaft.h"
#include "scene/error.h"
#include "support/generated.h"
#include "support/sanitized.h"
#include "viewpoints/solved_scene.h"

namespace viewcover {
namespace {

using testing::SolvedScene;
using Words = std::vector<BitRows::Word>;

bool has(const Words& row, std::size_t column) { return row[column / 64] >> (column % 64) & 1; }

/// The simple living room; elements are larger than by default.
Scene living_room_scene() {
  return testing::load_generated(living_room(RoomDetail::kSimple), 1).scene;
}
double coarse_area(const Scene& scene) { return 16 * default_element_area(scene); }

bool is_free(const Scene& scene, const ViewingRegion& region) {
  try {
    check_region_is_free("region", scene, region);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Boxes of random sizes in the free space of a scene.
std::vector<Box> random_boxes(const Scene& scene, std::size_t count, RandomNumbers& random) {
  std::vector<Box> boxes;
  while (boxes.size() < count) {
    Point least, size;
    for (int axis = 0; axis < 3; ++axis) {
      size[axis] = std::ldexp(1.2, -static_cast<int>(random.below(4))) * (0.5 + random.unit());
      least[axis] = scene.bounds.min()[axis] + random.unit() * scene.bounds.sizes()[axis];
    }
    const Box box(scene.lattice.round(least), scene.lattice.round(least + size));
    if (is_free(scene, make_viewing_region({}, {box}, 0))) boxes.push_back(box);
  }
  return boxes;
}

std::vector<OccluderId> all_surfaces(const Scene& scene) {
  std::vector<OccluderId> all;
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) all.emplace_back(i);
  return all;
}

/// From the whole scene: knows nothing of regions, links and stored occluders.
bool point_sees(const SolvedScene& solved, std::span<const OccluderId> all, const Point& position,
                std::size_t column) {
  const ElementAddress address = solved.matrix.elements[column];
  const PlanarPolygon element{
      subdivided(solved.scene[address.owner()].polygon, address),
      solved.views.occluders().plane(solved.clusters.place(address.owner()))};
  PointShaft shaft(solved.views.occluders(), position, address, element, solved.one_sided);
  PointShaftOccluders kept;
  if (!shaft.is_facing() || shaft.cull(all, kept)) return false;
  if (kept.empty()) return true;
  shaft.set_occluders(kept);
  return solved.backend->sees_part(shaft);
}

/// Pairs of a region and an element on the common refinement of both runs' elements.
struct Difference {
  std::size_t only_first = 0, only_second = 0, both = 0;
};

Difference difference(const VisibilityMatrix& a, const VisibilityMatrix& b) {
  Difference result;
  for (std::size_t i = 0, j = 0; i < a.elements.size() && j < b.elements.size();) {
    for (std::size_t row = 0; row < a.bits.rows(); ++row) {
      const bool in_a = a.bits.test(row, i), in_b = b.bits.test(row, j);
      result.only_first += in_a && !in_b;
      result.only_second += in_b && !in_a;
      result.both += in_a && in_b;
    }
    const bool a_is_finer = b.elements[j].contains(a.elements[i]);
    const std::size_t next_i = i + (a_is_finer ? 1 : 0), next_j = j + (a_is_finer ? 0 : 1);
    if (a_is_finer) {
      j += next_i == a.elements.size() || !b.elements[j].contains(a.elements[next_i]);
      i = next_i;
    } else {
      i += next_j == b.elements.size() || !a.elements[i].contains(b.elements[next_j]);
      j = next_j;
    }
  }
  return result;
}

Box box_round(const ConvexPolygon& rectangle, double height) {
  Box box = bounding_box(rectangle);
  box.min().z() -= height / 2;
  box.max().z() += height / 2;
  return box;
}

/// The rows of boxes in the order of the polygons that they hold.
VisibilityMatrix in_order_of(const ViewingRegion& polygons, const SolvedScene& boxes) {
  VisibilityMatrix ordered = boxes.matrix;
  for (std::size_t i = 0; i < polygons.region_count(); ++i) {
    const Point middle = polygons.shape(polygons.address(i)).middle();
    std::size_t box = 0;
    while (!boxes.region.shape(boxes.region.address(box)).contains(middle)) ++box;
    std::ranges::copy(boxes.matrix.bits.row(box), ordered.bits.row(i).begin());
  }
  return ordered;
}

TEST(Volume, AFlatBoxTendsToItsPolygon) {
  if (testing::sanitized()) GTEST_SKIP() << "half a minute with sanitizers";
  const Scene scene = living_room_scene();
  const ConvexPolygon eye_height =
      testing::load_generated(living_room(RoomDetail::kSimple), 1).region.parts.front();
  const int level = testing::sanitized() ? 0 : 1;
  const SolvedScene flat(scene, testing::region_of(eye_height, level), coarse_area(scene));
  std::size_t before = SIZE_MAX;
  for (const double height : {0.4, 0x1p-5, 0x1p-16}) {
    const SolvedScene box(scene, make_viewing_region({}, {box_round(eye_height, height)}, level),
                          coarse_area(scene));
    ASSERT_EQ(box.matrix.bits.rows(), flat.matrix.bits.rows());
    const Difference pairs = difference(flat.matrix, in_order_of(flat.region, box));
    EXPECT_EQ(pairs.only_first, 0u) << "a box sees what the polygon in it sees, height " << height;
    EXPECT_GT(pairs.both, 200u);
    EXPECT_LE(pairs.only_second, before);
    before = pairs.only_second;
    std::cout << "height " << height << ": " << pairs.both << " pairs of the polygon, "
              << pairs.only_second << " more; " << box.cover.size() << " boxes, "
              << flat.cover.size() << " polygons\n";
    if (height == 0.4) {
      EXPECT_GT(before, 0u);
    }
    if (height == 0x1p-16) {
      EXPECT_EQ(before, 0u);
      EXPECT_EQ(box.cover.size(), flat.cover.size());
    }
  }
}

TEST(Volume, ABoxSeesWhatItsFacesSee) {
  const Scene scene = living_room_scene();
  RandomNumbers random(31);
  std::size_t less = 0;
  for (const Box& box : random_boxes(scene, testing::sanitized() ? 1 : 3, random)) {
    const SolvedScene volume(scene, make_viewing_region({}, {box}, 0), coarse_area(scene));
    ViewingRegion faces;
    for (const ConvexPolygon& face : box_faces(box)) faces.parts.push_back(face);
    const SolvedScene flat(scene, faces, coarse_area(scene));
    EXPECT_EQ(volume.matrix.elements, flat.matrix.elements);
    ASSERT_EQ(volume.matrix.bits.rows(), 1u);
    EXPECT_EQ(volume.matrix.bits.union_of_all(), flat.matrix.bits.union_of_all());
    for (std::size_t face = 0; face < 6; ++face) {
      less += count_bits(flat.matrix.bits.row(face)) < count_bits(volume.matrix.bits.row(0));
    }
  }
  EXPECT_GT(less, 0u) << "one face alone does";
}

// 10^5 points, of which each is asked about a few elements that its box is said not to see, half of
// them such as another box sees.
TEST(Volume, NoPointInsideSeesMoreThanTheBox) {
  const Scene scene = living_room_scene();
  RandomNumbers random(32);
  const std::size_t boxes = testing::sanitized() ? 2 : 8,
                    points = testing::sanitized() ? 200 : 100'000;
  constexpr std::size_t kAsked = 4;
  const SolvedScene solved(scene, make_viewing_region({}, random_boxes(scene, boxes, random), 0),
                           4 * default_element_area(scene));
  const std::vector<OccluderId> all = all_surfaces(scene);
  const BitRows& bits = solved.matrix.bits;
  const Words seen_by_some = bits.union_of_all();
  std::vector<std::vector<std::size_t>> hidden(boxes), of_others(boxes);
  for (std::size_t box = 0; box < boxes; ++box) {
    for (std::size_t column = 0; column < bits.columns(); ++column) {
      if (bits.test(box, column)) continue;
      hidden[box].push_back(column);
      if (has(seen_by_some, column)) of_others[box].push_back(column);
    }
    ASSERT_GT(of_others[box].size(), 20u) << "nothing to be wrong about";
  }
  std::atomic<std::size_t> asked = 0, seen = 0, within = 0;
  tbb::parallel_for(std::size_t{0}, points, [&](std::size_t i) {
    RandomNumbers own(mixed(i));
    const std::size_t box = i % boxes;
    const RegionPositions& positions = solved.views.positions(box);
    Point position = positions.random(own);
    // The border is a part of the box.
    if (i % 5 == 0) position[static_cast<int>(i % 3)] = positions.region().box().max()[i % 3];
    if (!solved.views.is_free(box, position)) return;
    for (std::size_t k = 0; k < kAsked; ++k) {
      const auto& columns = k % 2 == 0 ? of_others[box] : hidden[box];
      const std::size_t column = columns[own.below(columns.size())];
      EXPECT_FALSE(point_sees(solved, all, position, column))
          << "box " << box << " element " << column;
      ++asked;
    }
    if (own.below(points / 50) == 0) {  // the question has both answers
      const std::size_t column = own.below(bits.columns());
      within += bits.test(box, column);
      seen += bits.test(box, column) && point_sees(solved, all, position, column);
    }
  });
  std::cout << points << " points in " << boxes << " boxes, " << asked << " questions; of "
            << within << " elements of their boxes they see " << seen << '\n';
  EXPECT_GT(asked, points * 3);
  EXPECT_GT(seen, within / 4);
  EXPECT_LT(seen, within);
}

TEST(Volume, ViewsFromInsideAgreeWithTheWholeScene) {
  const Scene scene = living_room_scene();
  RandomNumbers random(33);
  for (const bool one_sided : {false, true}) {
    const SolvedScene solved(
        scene,
        make_viewing_region({}, random_boxes(scene, testing::sanitized() ? 1 : 4, random), 0),
        coarse_area(scene), std::make_unique<ExactBackend>(1), one_sided);
    std::size_t seen = 0, unseen = 0;
    for (std::size_t box = 0; box < solved.views.region_count(); ++box) {
      const Point position = solved.views.positions(box).random(random);
      if (!solved.views.is_free(box, position)) continue;
      Words row(solved.matrix.bits.words_per_row());
      solved.views.look(box, position, row);
      for (int i = 0; i < 80; ++i) {
        const std::size_t column = random.below(solved.views.column_count());
        const ElementAddress address = solved.matrix.elements[column];
        SightQuery query;
        query.viewpoint = position;
        query.element = subdivided(solved.scene[address.owner()].polygon, address);
        query.one_sided = one_sided;
        for (std::size_t s = 0; s < solved.scene.surfaces.size(); ++s) {
          if (s != address.owner().value) {
            query.occluders.push_back(solved.scene.surfaces[s].polygon);
          }
        }
        const bool truth = is_visible(decide_from_point(query).verdict);
        EXPECT_EQ(has(row, column), truth) << "box " << box << " column " << column;
        (truth ? seen : unseen)++;
      }
    }
    EXPECT_GE(seen, testing::sanitized() ? 5u : 40u);
    EXPECT_GE(unseen, testing::sanitized() ? 5u : 40u);
  }
}

TEST(Volume, PartsOfABoxSeeWhatTheirPointsSee) {
  const Scene scene = living_room_scene();
  RandomNumbers random(34);
  const SolvedScene solved(scene, make_viewing_region({}, random_boxes(scene, 2, random), 0),
                           coarse_area(scene));
  const std::vector<OccluderId> all = all_surfaces(scene);
  std::size_t less = 0, seen = 0;
  for (int i = 0; i < (testing::sanitized() ? 20 : 600); ++i) {
    const std::size_t box = random.below(2), column = random.below(solved.views.column_count());
    if (!solved.matrix.bits.test(box, column)) continue;
    RegionCell cell{solved.region.address(box), box, solved.views.positions(box).region()};
    for (int depth = 0; depth < 3; ++depth) {
      const int digit = static_cast<int>(random.below(4));
      cell = {cell.address.child(digit), box, cell.shape.quarters()[std::size_t(digit)]};
      EXPECT_EQ(cell.shape, solved.region.shape(cell.address));
    }
    const bool sees = solved.views.cell_sees(cell, column);
    less += !sees;
    const RegionPositions positions(cell.shape, scene.bounds, scene.lattice.exponent);
    for (int k = 0; k < 4; ++k) {
      const Point position = positions.random(random);
      if (!point_sees(solved, all, position, column)) continue;
      EXPECT_TRUE(sees);
      ++seen;
    }
  }
  EXPECT_GT(less, testing::sanitized() ? 0u : 5u);
  EXPECT_GT(seen, testing::sanitized() ? 5u : 100u);
}

// Two boxes on a plate, with a screen of no thickness between them; of a strip that goes down past
// the plate only the upper half can be seen.
TEST(Volume, AFaceOnASurfaceLooksAwayFromIt) {
  const auto upright = [](double x, double from, double to) {
    return ConvexPolygon{{x, 0, from}, {x, 2, from}, {x, 2, to}, {x, 0, to}};
  };
  const std::vector<ConvexPolygon> polygons{
      testing::horizontal(-9, -9, 9, 9, 0),                         // plate
      ConvexPolygon{{0, -9, 0}, {0, 9, 0}, {0, 9, 9}, {0, -9, 9}},  // screen
      upright(-4, 1, 2),
      upright(4, 1, 2),                       // one on each side
      testing::horizontal(-2, 0, -1, 1, -1),  // below the plate
      upright(6, -2, 2),                      // a strip
  };
  const ViewingRegion region = make_viewing_region(
      {}, {Box(Point(-2, 0, 0), Point(0, 1, 1)), Box(Point(0, 0, 0), Point(2, 1, 1))}, 0);
  const SolvedScene solved(testing::scene_of(polygons), region, 1);
  std::array<std::array<std::size_t, 6>, 2> seen{};
  for (std::size_t column = 0; column < solved.views.column_count(); ++column) {
    const ElementAddress address = solved.matrix.elements[column];
    const ConvexPolygon& polygon = polygons[address.owner().value];
    const double top = bounding_box(subdivided(polygon, address)).max().z();
    for (std::size_t box = 0; box < 2; ++box) {
      if (!solved.matrix.bits.test(box, column)) continue;
      ++seen[box][address.owner().value];
      EXPECT_TRUE(top > 0 || address.owner().value == 0) << "below the plate";
    }
  }
  for (std::size_t box = 0; box < 2; ++box) {
    EXPECT_GT(seen[box][0], 0u) << "the plate";
    EXPECT_GT(seen[box][1], 0u) << "the screen";
    EXPECT_EQ(seen[box][2] > 0, box == 0);
    EXPECT_EQ(seen[box][3] > 0, box == 1);
    EXPECT_EQ(seen[box][4], 0u);
    EXPECT_EQ(seen[box][5] > 0, box == 1) << "no strip through the screen";
  }
}

// A plate under a part of a box: past its edge the box sees what is below, its corner on the plate
// does not.
TEST(Volume, APartOnASurfaceLooksAwayFromIt) {
  const std::vector<ConvexPolygon> polygons{testing::horizontal(-9, -9, 1, 9, 0),
                                            testing::horizontal(-3, 0, -1, 1, -3)};
  const Box box(Point(0, 0, 0), Point(4, 1, 1));
  const SolvedScene solved(testing::scene_of(polygons), make_viewing_region({}, {box}, 0), 100);
  RegionCell cell{solved.region.address(0), 0, RegionShape(box)};
  for (std::size_t column = 0; column < 2; ++column) {
    ASSERT_TRUE(solved.matrix.bits.test(0, column));
    EXPECT_TRUE(solved.views.cell_sees(cell, column));
  }
  for (int depth = 0; depth < 2; ++depth) {
    cell = {cell.address.child(0), 0, cell.shape.quarters()[0]};
  }
  ASSERT_TRUE(cell.shape.contains({0, 0, 0}));
  ASSERT_LE(cell.shape.box().max().x(), 1);
  EXPECT_TRUE(solved.views.cell_sees(cell, 0));
  EXPECT_FALSE(solved.views.cell_sees(cell, 1));
}

TEST(Volume, ViewpointsLieInTheirBoxes) {
  // One viewpoint under each chimney; the box is one region, and the bound is raised from there.
  const int count = testing::sanitized() ? 2 : 3;
  const Box under(Point(0, 0, -1), Point(count, 1, 0));
  for (const int level : {0, 1}) {
    const SolvedScene solved(testing::scene_of(testing::chimneys(count)),
                             make_viewing_region({}, {under}, level), 1);
    ViewpointOptions options = solved.options();
    options.gap_rounds = 40;
    const ViewpointSet set = find_viewpoints(solved.views, options);
    EXPECT_TRUE(set.missing.empty());
    EXPECT_EQ(set.viewpoints.size(), static_cast<std::size_t>(count));
    EXPECT_LE(set.lower_bound, set.viewpoints.size());
    EXPECT_GT(set.lower_bound, solved.cover.lower_bound - (level > 0));
    std::size_t inside = 0;
    for (const auto& [position, region] : set.viewpoints) {
      const Box box = solved.region.shape(solved.region.address(region)).box();
      EXPECT_TRUE(box.contains(position));
      inside += (position.array() > box.min().array()).all() &&
                (position.array() < box.max().array()).all();
    }
    EXPECT_GT(inside, 0u);
    std::cout << "level " << level << ": " << set.viewpoints.size() << " viewpoints, at least "
              << set.lower_bound << '\n';
  }
}

/// A chimney of width 1/2 and length 8, closed by a lid, before the middle of each face of the box
/// [0, 3/2]^3 at distance 1. A lid is seen only along lines of slope below 1/16, so of points in
/// the box only from less than 1/4 + 3/16 beside the middle line of its face: these lines meet no
/// face but that one and the opposite one.
std::vector<ConvexPolygon> six_chimneys() {
  std::vector<ConvexPolygon> polygons;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const auto add = [&](ConvexPolygon polygon) {
        for (Point& p : polygon) {
          Point q;
          q[axis] = 0.75 + sign * (0.75 + p.z());
          q[(axis + 1) % 3] = 0.5 + p.x();
          q[(axis + 2) % 3] = 0.5 + p.y();
          p = q;
        }
        polygons.push_back(std::move(polygon));
      };
      for (const ConvexPolygon& wall : testing::box_walls({0, 0, 1}, {0.5, 0.5, 9})) add(wall);
      add(testing::horizontal(0, 0, 0.5, 0.5, 9));
    }
  }
  return polygons;
}

TEST(Volume, AViewpointInsideSeesWhatNoneOnAFaceDoes) {
  constexpr double kWhole = 100;  // no polygon is subdivided
  const Box box(Point(0, 0, 0), Point(1.5, 1.5, 1.5));
  const SolvedScene solved(testing::scene_of(six_chimneys()), make_viewing_region({}, {box}, 0),
                           kWhole);
  EXPECT_EQ(count_bits(solved.matrix.bits.row(0)), 30u) << "the lids and the walls";
  const ViewpointSet set = find_viewpoints(solved.views, solved.options());
  EXPECT_EQ(set.lower_bound, 1u);
  ASSERT_EQ(set.viewpoints.size(), 1u);
  for (const double x : set.viewpoints.front().position) EXPECT_NEAR(x, 0.75, 0.25 + 3.0 / 16);

  // A face sees the lid before it and the one behind it only.
  ViewingRegion faces;
  for (const ConvexPolygon& face : box_faces(box)) faces.parts.push_back(face);
  const SolvedScene flat(testing::scene_of(six_chimneys()), faces, kWhole);
  for (std::size_t row = 0; row < 6; ++row) {
    std::size_t lids = 0;
    for (std::size_t lid = 4; lid < 30; lid += 5) lids += flat.matrix.bits.test(row, lid);
    EXPECT_EQ(lids, 2u);
  }
  EXPECT_EQ(flat.cover.size(), 3u);
}

TEST(Volume, PolygonsAndBoxesMayBeMixed) {
  if (testing::sanitized()) GTEST_SKIP() << "half a minute with sanitizers";
  const Scene scene = living_room_scene();
  const ConvexPolygon eye_height =
      testing::load_generated(living_room(RoomDetail::kSimple), 1).region.parts.front();
  RandomNumbers random(35);
  const std::vector<Box> boxes = random_boxes(scene, 1, random);
  const SolvedScene mixed(scene, make_viewing_region({eye_height}, boxes, 1), coarse_area(scene));
  const SolvedScene polygons(scene, testing::region_of(eye_height, 1), coarse_area(scene));
  const SolvedScene volume(scene, make_viewing_region({}, boxes, 1), coarse_area(scene));
  ASSERT_EQ(mixed.matrix.bits.rows(), 8u);
  // The rows of each alone, but for elements that the other made finer.
  const auto rows = [&](std::size_t first) {
    VisibilityMatrix some{mixed.matrix.elements, mixed.matrix.areas,
                          BitRows(4, mixed.matrix.elements.size())};
    for (std::size_t i = 0; i < 4; ++i) {
      std::ranges::copy(mixed.matrix.bits.row(first + i), some.bits.row(i).begin());
    }
    return some;
  };
  const Difference of_polygons = difference(rows(0), polygons.matrix),
                   of_boxes = difference(rows(4), volume.matrix);
  EXPECT_EQ(of_polygons.only_first + of_polygons.only_second, 0u);
  EXPECT_EQ(of_boxes.only_first + of_boxes.only_second, 0u);
  EXPECT_GT(of_polygons.both, 100u);
  EXPECT_GT(of_boxes.both, 100u);
}

TEST(Volume, LinksDoNotDependOnThreads) {
  if (testing::sanitized()) GTEST_SKIP() << "half a minute with sanitizers";
  const Scene scene = living_room_scene();
  RandomNumbers random(36);
  const ViewingRegion region = make_viewing_region({}, random_boxes(scene, 1, random), 1);
  const ClusterTree clusters(scene);
  const ExactBackend backend(1);
  std::vector<std::vector<std::uint64_t>> runs;
  for (const std::size_t threads : {1u, 3u}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const LinkSet links =
        refine(scene, clusters, region, backend, {.element_area = coarse_area(scene)});
    std::vector<std::uint64_t> all;
    for (std::size_t i = 0; i < links.size(); ++i) {
      all.push_back(links[i].region.bits());
      all.push_back(links[i].element.bits());
      for (const OccluderId occluder : links.occluders(i)) all.push_back(occluder.value);
    }
    runs.push_back(std::move(all));
  }
  EXPECT_GT(runs[0].size(), 1000u);
  EXPECT_EQ(runs[0], runs[1]);
}

}  // namespace
}  // namespace viewcover
