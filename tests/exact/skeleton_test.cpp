#include "exact/skeleton/skeleton.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/graph/connected_components.hpp>
#include <map>
#include <set>

#include "exact/query_cases.h"
#include "exact/query_poses.h"
#include "exact/root_numbers.h"
#include "exact/skeleton_brute_force.h"
#include "scene/random_numbers.h"
#include "support/sanitized.h"

namespace viewcover {
namespace {

using namespace testing;  // NOLINT: polygons of queries and exact numbers

using Kinds = std::map<std::string, int>;
using LineText = std::array<RootNumber, 6>;

auto nodes(const SkeletonGraph& graph) {
  return boost::make_iterator_range(boost::vertices(graph));
}
auto arcs(const SkeletonGraph& graph) { return boost::make_iterator_range(boost::edges(graph)); }

Kinds node_kinds(const SkeletonGraph& graph) {
  Kinds kinds;
  for (const auto node : nodes(graph)) ++kinds[graph[node].kind];
  return kinds;
}
Kinds arc_kinds(const SkeletonGraph& graph) {
  Kinds kinds;
  for (const auto arc : arcs(graph)) ++kinds[graph[arc].kind];
  return kinds;
}

std::set<LineText> lines(const SkeletonGraph& graph) {
  std::set<LineText> result;
  for (const auto node : nodes(graph)) result.insert(graph[node].line);
  return result;
}
/// Arcs by the lines that they join.
std::multiset<std::array<LineText, 2>> joints(const SkeletonGraph& graph) {
  std::multiset<std::array<LineText, 2>> result;
  for (const auto arc : arcs(graph)) {
    std::array<LineText, 2> ends = {graph[boost::source(arc, graph)].line,
                                    graph[boost::target(arc, graph)].line};
    std::sort(ends.begin(), ends.end());
    result.insert(ends);
  }
  return result;
}

std::size_t components(const SkeletonGraph& graph) {
  std::vector<std::size_t> numbers(boost::num_vertices(graph));
  return numbers.empty() ? 0 : boost::connected_components(graph, numbers.data());
}

SightQuery query_of(ConvexPolygon region, ConvexPolygon element, Polygons occluders = {}) {
  SightQuery query;
  query.region = std::move(region);
  query.viewpoint.setZero();
  query.element = std::move(element);
  query.occluders = std::move(occluders);
  return query;
}

// ---------------------------------------------------------------- what holds of every skeleton

Line<Root> exact_line(const LineText& text) {
  Line<Root> line;
  for (std::size_t k = 0; k < 6; ++k) {
    line[k] = Root(Fraction(text[k].a), Fraction(text[k].b), Fraction(text[k].root));
  }
  return line;
}

const ConvexPolygon& polygon(const SightQuery& query, const PolygonName& name) {
  switch (name.role) {
    case PolygonName::Role::kRegion:
      return query.region;
    case PolygonName::Role::kElement:
      return query.element;
    default:
      return query.occluders[name.number];
  }
}

/// m - x cross d: 0 iff the line passes through x.
Vec<Root> offset(const Line<Root>& line, const Vec<Fraction>& x) {
  const auto [d, m] = halves(line);
  return minus(m, cross(roots(x), d));
}
bool is_zero(const Vec<Root>& v) {
  return std::ranges::all_of(v, [](const Root& x) { return sign_of(x) == 0; });
}

/// Exact: does the line touch the closed generator? True for those made by a cut.
bool touches(const SightQuery& query, const Line<Root>& line, const Generator& generator) {
  if (generator.cut != Generator::Cut::kNone) return true;
  const ConvexPolygon& corners = polygon(query, generator.polygon);
  const Vec<Fraction> a = vec(corners[generator.index]);
  if (generator.feature == Generator::Feature::kVertex) return is_zero(offset(line, a));
  // To the next corner that is not within an edge.
  std::size_t next = generator.index;
  Point turn;
  do {
    next = (next + 1) % corners.size();
    const Point &here = corners[next], &after = corners[(next + 1) % corners.size()];
    turn = (here - corners[generator.index]).cross(after - here);  // of integers
  } while (turn.isZero(0));
  const Vec<Fraction> b = vec(corners[next]);
  if (sign_of(form(line, through(a, b))) != 0) return false;
  return sign_of(dot(offset(line, a), offset(line, b))) <= 0;
}

/// How many lines through the point p and in the plane with this normal are those of edges with an
/// end there.
std::size_t edge_directions(const SightQuery& query, const Point& p, const Vec<Root>& normal) {
  Polygons all = query.occluders;
  all.push_back(query.region);
  all.push_back(query.element);
  Polygons found;  // directions
  for (const ConvexPolygon& corners : all) {
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Point &end = corners[k], &other = corners[(k + 1) % corners.size()];
      if (end != p && other != p) continue;
      const Point d = other - end;  // of integers, as are the products
      if (sign_of(dot(normal, vec(d))) != 0) continue;
      const bool is_new = std::ranges::none_of(
          found, [&](const ConvexPolygon& known) { return known[0].cross(d).isZero(0); });
      if (is_new) found.push_back({d});
    }
  }
  return found.size();
}

void expect_sound(const SightQuery& query, const SkeletonGraph& graph) {
  EXPECT_EQ(lines(graph).size(), boost::num_vertices(graph)) << "a line occurs twice";
  for (const auto number : nodes(graph)) {
    const SkeletonNode& node = graph[number];
    const Line<Root> line = exact_line(node.line);
    EXPECT_EQ(sign_of(form(line, line)), 0) << "not a real line";
    std::string kind;
    for (const Generator& generator : node.generators) {
      EXPECT_TRUE(touches(query, line, generator)) << "node " << number;
      kind += generator.feature == Generator::Feature::kVertex ? 'V' : 'E';
    }
    std::ranges::sort(kind, std::greater<>());
    EXPECT_EQ(node.kind, kind);
    EXPECT_TRUE(std::ranges::is_sorted(node.generators));
    for (std::size_t k = 0; k < 6; ++k) {
      EXPECT_NEAR(node.rounded[k], line[k].rounded(), 1e-9 * (1 + std::fabs(node.rounded[k])));
    }
  }
  for (const auto arc : arcs(graph)) {
    const SkeletonNode &a = graph[boost::source(arc, graph)], &b = graph[boost::target(arc, graph)];
    EXPECT_NE(boost::source(arc, graph), boost::target(arc, graph));
    std::size_t edges = 0;  // a vertex counts as two
    for (const Generator& generator : graph[arc].generators) {
      edges += generator.feature == Generator::Feature::kVertex ? 2 : 1;
      EXPECT_TRUE(touches(query, exact_line(a.line), generator));
      EXPECT_TRUE(touches(query, exact_line(b.line), generator));
    }
    if (edges >= 3) continue;
    // Lines through a vertex in a plane: that of two edges through it.
    ASSERT_EQ(graph[arc].kind, "V");
    const Generator& vertex = graph[arc].generators[0];
    if (vertex.cut != Generator::Cut::kNone) continue;
    const Point p = polygon(query, vertex.polygon)[vertex.index];
    const Vec<Root> normal = cross(halves(exact_line(a.line))[0], halves(exact_line(b.line))[0]);
    EXPECT_GE(edge_directions(query, p, normal), 2u);
  }
}

/// Four generators that are independent leave one direction for each of them that is let go: an
/// edge on its free side, a vertex along either of its edges. So VV has four arcs VE, VEE two of
/// them and two arcs EEE, EEEE four of those.
void expect_generic(const SkeletonGraph& graph, SkeletonGraph::vertex_descriptor node) {
  std::map<std::string, int> around;
  for (const auto arc : boost::make_iterator_range(boost::out_edges(node, graph))) {
    ++around[graph[arc].kind];
  }
  static const std::map<std::string, Kinds> kExpected = {
      {"VV", {{"VE", 4}}}, {"VEE", {{"VE", 2}, {"EEE", 2}}}, {"EEEE", {{"EEE", 4}}}};
  const auto expected = kExpected.find(graph[node].kind);
  ASSERT_NE(expected, kExpected.end()) << graph[node].kind;
  EXPECT_EQ(around, expected->second) << graph[node].kind;
}
void expect_generic(const SkeletonGraph& graph) {
  for (const auto node : nodes(graph)) expect_generic(graph, node);
}

/// Sound in all poses and both ways, with the same counts.
void expect_counts(const SightQuery& query, const Kinds& node_counts, const Kinds& arc_counts) {
  for (const Pose& pose : poses()) {
    SCOPED_TRACE("pose: " + pose.name);
    SightQuery posed_query = posed(query, pose);
    for (const bool swapped : {false, true}) {
      SCOPED_TRACE(swapped ? "region and element swapped" : "");
      if (swapped) std::swap(posed_query.region, posed_query.element);
      const SkeletonGraph graph = visibility_skeleton(posed_query);
      EXPECT_EQ(node_kinds(graph), node_counts);
      EXPECT_EQ(arc_kinds(graph), arc_counts);
      expect_sound(posed_query, graph);
    }
  }
}

// ---------------------------------------------------------------- nothing between

/// Convex, with corners (u, v) on a circle or so.
ConvexPolygon polygon_of(std::size_t corners, double z) {
  switch (corners) {
    case 3:
      return level(z, {{-70, -60}, {80, -50}, {10, 90}});
    case 4:
      return level(z, {{-70, -60}, {80, -50}, {60, 70}, {-50, 90}});
    case 5:
      return pentagon(30, z);
    case 6:
      return level(z, {{90, 10}, {40, 80}, {-50, 70}, {-100, 0}, {-40, -90}, {50, -70}});
    default:
      return octagon(90, 40, z);
  }
}

/// Every line from corner to corner is a limit of free lines and touches nothing else; a line that
/// touches no corner of the region touches at most one of its edges, and so for the element, which
/// does not pin it. So there are m n nodes. From (r, e) lines through r move along the two edges at
/// e, and the reverse: degree 4.
TEST(Skeleton, OpenShaftHasAllPairsOfCorners) {
  for (const auto& [m, n] : std::vector<std::array<std::size_t, 2>>{
           {3, 3}, {3, 4}, {4, 4}, {5, 3}, {6, 4}, {5, 6}, {8, 3}, {8, 8}}) {
    SCOPED_TRACE(std::to_string(m) + " x " + std::to_string(n));
    ConvexPolygon tilted = polygon_of(n, 200);
    for (Point& corner : tilted) corner.z() += corner.x() / 2 - corner.y() / 4;
    const SightQuery query = query_of(polygon_of(m, 0), tilted);
    const int count = static_cast<int>(m * n);
    expect_counts(query, {{"VV", count}}, {{"VE", 2 * count}});
    const SkeletonGraph graph = visibility_skeleton(query);
    expect_generic(graph);
    EXPECT_EQ(components(graph), 1u);
  }
}

TEST(Skeleton, ParallelSquaresAreNotSpecial) {
  expect_counts(query_of(square(8, 0), square(8, 16)), {{"VV", 16}}, {{"VE", 32}});
  expect_counts(query_of(square(8, 0), square(4, 16)), {{"VV", 16}}, {{"VE", 32}});
  expect_counts(query_of(square(8, 0), horizontal(-8, 0, 8, 16, 16)), {{"VV", 16}}, {{"VE", 32}});
}

TEST(Skeleton, PointsOfNodesLieOnTheLine) {
  const SkeletonGraph graph = visibility_skeleton(query_of(square(8, 0), square(4, 16)));
  for (const auto number : nodes(graph)) {
    const SkeletonNode& node = graph[number];
    EXPECT_EQ(node.region_point.cwiseAbs(), Point(8, 8, 0));
    EXPECT_EQ(node.element_point.cwiseAbs(), Point(4, 4, 16));
    const Point along(node.rounded[0], node.rounded[1], node.rounded[2]);
    const Point moment(node.rounded[3], node.rounded[4], node.rounded[5]);
    EXPECT_GT(along.dot(node.element_point - node.region_point), 0);
    EXPECT_TRUE(node.region_point.cross(along).isApprox(moment));
  }
}

/// A corner within an edge is no corner.
TEST(Skeleton, StraightCornersAreLeftOut) {
  ConvexPolygon region = square(8, 0);
  region.insert(region.begin() + 1, Point(0, -8, 0));
  const SkeletonGraph graph = visibility_skeleton(query_of(region, square(4, 16)));
  EXPECT_EQ(node_kinds(graph), (Kinds{{"VV", 16}}));
  for (const auto number : nodes(graph)) {
    EXPECT_NE(graph[number].generators[0].index, 1u) << "places are those of the query";
  }
}

// ---------------------------------------------------------------- one triangle

/// Squares of half side 8 at heights 0 and 16, a triangle T at height 8 inside the hull. From p
/// through t a line reaches 2 t - p.
///  - Corners r, e: through (r + e) / 2, one of the points with coordinates -8, 0, 8 each, the
///    origin four times. Blocked iff T covers it.
///  - A corner r and a vertex t inside the hull, off the axes: 2 t - r is inside the element iff t
///    is in the quadrant of r. One r for each t, and one e.
///  - t, an edge of the region and one of the element: a square and the same moved by 2 t cross in
///    two points.
///  - r, an edge of T, one of the element: the square from the origin to r, seen from r in front of
///    the element's boundary, crosses the boundary of T; and so for e.
/// Two edges of T, or of the region, are touched only in their planes. So there is nothing else.
TEST(Skeleton, TriangleInOneQuadrant) {
  // No middle covered; T is inside a square from the origin: no crossings.
  const SightQuery query =
      query_of(square(8, 0), square(8, 16), {level(8, {{1, 2}, {5, 3}, {3, 6}})});
  expect_counts(query, {{"VV", 16 + 3 + 3}, {"VEE", 3 * 2}}, {{"VE", 50}, {"EEE", 6}});
  expect_generic(visibility_skeleton(query));
}

TEST(Skeleton, TriangleRoundTheAxis) {
  // The origin is covered: 4 lines less. Each square from the origin crosses T's boundary twice, on
  // two half-axes.
  const SightQuery query =
      query_of(square(8, 0), square(8, 16), {level(8, {{-2, -1}, {2, -2}, {1, 3}})});
  expect_counts(query, {{"VV", 12 + 3 + 3}, {"VEE", 3 * 2 + 4 * 2 + 4 * 2}},
                {{"VE", 58}, {"EEE", 22}});
  expect_generic(visibility_skeleton(query));
}

// ---------------------------------------------------------------- slits

/// Walls with slits along y are the same problem at every y: free lines are the product of those
/// pairs (px, qx) that pass, a polygon, and all (py, qy), a square. Nodes are pairs of corners,
/// arcs a corner with a side. Here px + qx is between 2 and 4: corners (-6, 8), (-4, 8) and the
/// reverse, on an edge of the element or of the region and one of the slit; with a corner of the
/// square, VEE.
///
/// Sides of the first polygon with corners of the second: 2 along an edge of region or element,
/// with a corner there VE; 2 along an edge of the slit, EEE; 4 corners each. Corners of the first
/// with sides of the second, for an edge of the element: py = -8 or 8 leaves a corner of the
/// element and the slit, VE; qy = -8 or 8 leaves edges of all three, EEE.
TEST(Skeleton, SlitIsAProduct) {
  const SightQuery query = query_of(square(8, 0), square(8, 16), slit_x(40, 8, 1, 2));
  expect_counts(query, {{"VEE", 16}}, {{"VE", 8 + 8}, {"EEE", 8 + 8}});
  const SkeletonGraph graph = visibility_skeleton(query);
  expect_generic(graph);
  EXPECT_EQ(components(graph), 1u);
}

/// px + qx between 0 and 2: corners (-8, 8) and (8, -8) touch both squares and one wall.
TEST(Skeleton, SlitThroughTheMiddleIsDegenerate) {
  const SkeletonGraph graph =
      visibility_skeleton(query_of(square(8, 0), square(8, 16), slit_x(40, 8, 0, 1)));
  EXPECT_EQ(node_kinds(graph), (Kinds{{"VEE", 8}, {"VVE", 8}}));
  EXPECT_EQ(boost::num_edges(graph), 32u);
}

/// The lines of either slit bounded by a polygon of four sides: 5 px + 3 qx between 0 and 8 has
/// corners on qx = -8 and 8 only, and so 3 py + 5 qy on py = -8 and 8. Every node touches an edge
/// along y of the element, one along x of the region, and one of either slit.
TEST(Skeleton, CrossedSlitsAreAProduct) {
  const SightQuery query =
      query_of(square(8, 0), square(8, 16), joined({slit_x(40, 6, 0, 1), slit_y(40, 10, 0, 1)}));
  expect_counts(query, {{"EEEE", 16}}, {{"EEE", 32}});
  expect_generic(visibility_skeleton(query));
}

/// A wall between two slits parts the free lines: no limit of lines through the one is a limit of
/// lines through the other.
TEST(Skeleton, EveryComponentHasNodes) {
  const Polygons walls = {horizontal(-40, -40, -2, 40, 8), horizontal(-1, -40, 1, 40, 8),
                          horizontal(2, -40, 40, 40, 8)};
  const SightQuery query = query_of(square(8, 0), square(8, 16), walls);
  expect_counts(query, {{"VEE", 32}}, {{"VE", 32}, {"EEE", 32}});
  EXPECT_EQ(components(visibility_skeleton(query)), 2u);
}

TEST(Skeleton, HiddenHasNoNodes) {
  EXPECT_EQ(boost::num_vertices(
                visibility_skeleton(query_of(square(8, 0), square(8, 16), {square(20, 8)}))),
            0u);
  EXPECT_EQ(boost::num_vertices(visibility_skeleton(
                query_of(square(8, 0), square(8, 16), cut_square(8, 8, {-3, 1})))),
            0u);
}

TEST(Skeleton, BackOfAOneSidedElementHasNone) {
  SightQuery query = query_of(square(8, 0), flipped(square(8, 16)));
  query.one_sided = true;
  EXPECT_EQ(boost::num_vertices(visibility_skeleton(query)), 16u);
  query.element = flipped(query.element);
  EXPECT_EQ(boost::num_vertices(visibility_skeleton(query)), 0u);
}

// ---------------------------------------------------------------- two transversals

/// Lines (a + c z, b + d z, z) through (x, 0, 1), (0, y, 2), (x, x, 3) have b = -d, a = -2 c and
/// 2 d = c. Through (t, 1, 4 + t) as well: d (3 + t) = 1 and 2 d (2 + t) = t, so t^2 + t - 4 = 0:
/// t = (-1 +- sqrt(17)) / 2. Both lines touch an edge of four triangles that reach away from it.
TEST(Skeleton, BothTransversalsOfFourEdgesAreNodes) {
  const Polygons triangles = {{{-30, 0, 1}, {30, 0, 1}, {0, -60, 1}},
                              {{0, -30, 2}, {0, 30, 2}, {60, 0, 2}},
                              {{-30, -30, 3}, {30, 30, 3}, {-60, 60, 3}},
                              {{-3, 1, 1}, {3, 1, 7}, {0, 40, 4}}};
  const SightQuery query = query_of(square(40, 0), square(40, 8), triangles);
  const SkeletonGraph graph = visibility_skeleton(query);
  expect_sound(query, graph);
  std::vector<Generator> edges;
  for (std::size_t i = 0; i < 4; ++i) {
    edges.push_back(
        {{PolygonName::Role::kOccluder, i}, Generator::Feature::kEdge, Generator::Cut::kNone, 0});
  }
  std::vector<Line<Root>> found;
  for (const auto number : nodes(graph)) {
    const SkeletonNode& node = graph[number];
    if (node.generators != edges) continue;
    EXPECT_EQ(node.kind, "EEEE");
    const Line<Root>& line = found.emplace_back(exact_line(node.line));
    EXPECT_EQ(sign_of(form(line, line)), 0);
    bool irrational = false;
    for (std::size_t k = 0; k < 6; ++k) {
      irrational |= line[k].b != 0;
      if (line[k].b == 0) continue;
      // 17 times a square.
      const Fraction square = line[k].root / 17;
      const Integer above = numerator(square), below = denominator(square);
      EXPECT_EQ(sqrt(above) * sqrt(above), above);
      EXPECT_EQ(sqrt(below) * sqrt(below), below);
    }
    EXPECT_TRUE(irrational);
    for (const ConvexPolygon& triangle : triangles) {
      const Root side = form(line, through(vec(triangle[0]), vec(triangle[1])));
      EXPECT_EQ(side.a, 0);
      EXPECT_EQ(side.b, 0);
    }
  }
  ASSERT_EQ(found.size(), 2u);
  // d / c = 1 / 2 on both; different places on the first edge.
  for (const Line<Root>& line : found) {
    EXPECT_EQ(sign_of(line[0] - line[1] * Root(Fraction(2))), 0);
  }
  EXPECT_NE(sign_of(found[0][2] / found[0][0] - found[1][2] / found[1][0]), 0);
}

// ---------------------------------------------------------------- a second opinion

std::string text(const LineText& line) {
  std::string result;
  for (const RootNumber& x : line) result += x.a + "," + x.b + "," + x.root + ";";
  return result;
}

bool is_in_front(const ConvexPolygon& plane, const ConvexPolygon& other) {
  const Point normal = (plane[1] - plane[0]).cross(plane[2] - plane[0]);
  const double first = normal.dot(other[0] - plane[0]);
  return std::ranges::all_of(
      other, [&](const Point& corner) { return normal.dot(corner - plane[0]) * first > 0; });
}

/// Triangles with small integers as coordinates, up to `range` and for occluders up to half of
/// that, on either side of the others' planes as the brute force needs it.
SightQuery random_triangles(RandomNumbers& random, std::size_t occluders, int range) {
  const auto between = [&](int low, int high) {
    return low + static_cast<int>(random.below(static_cast<std::size_t>(high - low + 1)));
  };
  const auto triangle = [&](int reach, int low, int high) {
    ConvexPolygon result;
    do {
      result.clear();
      for (int k = 0; k < 3; ++k) {
        result.emplace_back(between(-reach, reach), between(-reach, reach), between(low, high));
      }
    } while ((result[1] - result[0]).cross(result[2] - result[0]).isZero());
    return result;
  };
  while (true) {
    SightQuery query = query_of(triangle(range, -1, 1), triangle(range, 11, 13));
    for (std::size_t i = 0; i < occluders; ++i)
      query.occluders.push_back(triangle((range + 1) / 2, 3, 9));
    bool fits =
        is_in_front(query.region, query.element) && is_in_front(query.element, query.region);
    for (const ConvexPolygon& occluder : query.occluders) {
      fits = fits && is_in_front(query.region, occluder) && is_in_front(query.element, occluder);
    }
    if (fits) return query;
  }
}

void expect_brute_force(std::uint64_t seed, std::size_t occluders, int range, Kinds& kinds) {
  SCOPED_TRACE("seed " + std::to_string(seed) + ", range " + std::to_string(range));
  RandomNumbers random(seed);
  const SightQuery query = random_triangles(random, occluders, range);
  const SkeletonGraph graph = visibility_skeleton(query);
  std::map<std::string, std::string> found;
  for (const auto number : nodes(graph)) {
    found[text(graph[number].line)] = graph[number].kind;
    ++kinds[graph[number].kind];
  }
  EXPECT_EQ(found, brute_force_nodes(query));
  expect_sound(query, graph);
}

TEST(Skeleton, AgreesWithBruteForce) {
  Kinds kinds;
  for (std::uint64_t seed = 1; seed <= (sanitized() ? 6 : 30); ++seed)
    expect_brute_force(seed, 1 + seed % 3, 9, kinds);
  if (sanitized()) return;  // too few to hold every kind
  for (const char* kind : {"VV", "VEE", "EEEE", "VE"}) EXPECT_GT(kinds[kind], 5) << kind;
}

/// Many coincidences: triangles that pierce and touch each other, lines that touch more than they
/// need to.
TEST(Skeleton, AgreesWithBruteForceOnSmallGrids) {
  Kinds kinds;
  for (std::uint64_t seed = 1; seed <= (sanitized() ? 6 : 16); ++seed)
    expect_brute_force(seed, 1 + seed % 2, 3, kinds);
  int degenerate = 0;
  for (const auto& [kind, count] : kinds) {
    if (kind != "VV" && kind != "VEE" && kind != "EEEE") degenerate += count;
  }
  EXPECT_GT(degenerate, sanitized() ? 3 : 10);
}

TEST(Skeleton, GenericNodesHaveFourArcs) {
  int count = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomNumbers random(seed);
    const SkeletonGraph graph = visibility_skeleton(random_triangles(random, 1 + seed % 5, 1000));
    for (const auto number : nodes(graph)) {
      const SkeletonNode& node = graph[number];
      if (!node.faces.empty()) continue;
      ASSERT_NO_FATAL_FAILURE(expect_generic(graph, number));
      ++count;
    }
  }
  EXPECT_GT(count, 500);
}

// ---------------------------------------------------------------- changes that change nothing

/// The same query in other words: nodes and arcs do not depend on how cells are cut.
TEST(Skeleton, OccludersMayBeShuffledAndRepeated) {
  for (std::uint64_t seed = 1; seed <= (sanitized() ? 5 : 20); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomNumbers random(seed);
    const SightQuery query = random_triangles(random, 4, 6);
    const SkeletonGraph graph = visibility_skeleton(query);
    SightQuery changed = query;
    std::ranges::reverse(changed.occluders);
    const SkeletonGraph shuffled = visibility_skeleton(changed);
    EXPECT_EQ(lines(shuffled), lines(graph));
    EXPECT_EQ(joints(shuffled), joints(graph));
    changed.occluders = repeated(query.occluders, 2);
    const SkeletonGraph twice = visibility_skeleton(changed);
    EXPECT_EQ(lines(twice), lines(graph));
    EXPECT_EQ(joints(twice), joints(graph));
    EXPECT_EQ(node_kinds(twice), node_kinds(graph)) << "coincident generators count once";
  }
}

/// A diagonal is one more edge: it may pin lines in the quadrilateral's plane, never fewer.
TEST(Skeleton, TriangulationKeepsNodes) {
  for (std::uint64_t seed = 1; seed <= (sanitized() ? 5 : 20); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    RandomNumbers random(seed);
    SightQuery query = query_of(square(8, 0), square(8, 16)), triangulated = query;
    for (int i = 0; i < 4; ++i) {
      const auto small = [&] { return static_cast<double>(random.below(7)) - 3; };
      const Point corner(2 * small(), 2 * small(), 8 + small() / 2), u(small(), small(), 1),
          v(small(), small(), -1);
      if (u.cross(v).isZero()) continue;
      const ConvexPolygon quad = {corner, corner + u, corner + u + v, corner + v};
      query.occluders.push_back(quad);
      triangulated.occluders.push_back({quad[0], quad[1], quad[2]});
      triangulated.occluders.push_back({quad[0], quad[2], quad[3]});
    }
    const auto few = lines(visibility_skeleton(query));
    const auto many = lines(visibility_skeleton(triangulated));
    EXPECT_TRUE(std::ranges::includes(many, few));
  }
}

/// A region that reaches through the element's plane: its nodes are those of its two parts, but for
/// the ones that the cut pins.
TEST(Skeleton, RegionCutByTheElementsPlane) {
  const ConvexPolygon element = horizontal(0, -5, 9, 6, 0);
  const ConvexPolygon region = upright_x(-20, -7, -6, 8, 9);
  const Polygons occluders = {{{-9, -3, -4}, {-10, 4, -2}, {-8, 1, 7}},
                              {{-5, 2, -5}, {-6, 3, 6}, {-4, -2, 3}}};
  const SightQuery query = query_of(region, element, occluders);
  const SkeletonGraph whole = visibility_skeleton(query);
  expect_sound(query, whole);
  std::set<LineText> all, kept;
  for (const bool upper : {false, true}) {
    SightQuery part = query;
    part.region = upper ? upright_x(-20, -7, 0, 8, 9) : upright_x(-20, -7, -6, 8, 0);
    const SkeletonGraph graph = visibility_skeleton(part);
    for (const auto number : nodes(graph)) {
      const SkeletonNode& node = graph[number];
      all.insert(node.line);
      // Edge 0 is the lower one, edge 2 the upper one.
      const std::size_t cut = upper ? 0 : 2;
      const bool by_cut = std::ranges::any_of(node.generators, [&](const Generator& g) {
        if (g.polygon.role != PolygonName::Role::kRegion) return false;
        return g.index == cut ||
               (g.feature == Generator::Feature::kVertex && g.index == (cut + 1) % 4);
      });
      if (!by_cut) kept.insert(node.line);
    }
  }
  const auto found = lines(whole);
  EXPECT_GT(kept.size(), 60u);
  EXPECT_LT(kept.size(), found.size());
  EXPECT_TRUE(std::ranges::includes(all, found));
  EXPECT_TRUE(std::ranges::includes(found, kept));
}

/// A wall that stands in the region is crossed or not as the lines begin on either side of it: the
/// edge along which it meets the region's plane is a generator.
TEST(Skeleton, WallThroughTheRegionHasAnEdgeThere) {
  const SightQuery query = query_of(square(8, 0), square(8, 16), {upright_x(1, -40, -3, 40, 2)});
  const SkeletonGraph graph = visibility_skeleton(query);
  expect_sound(query, graph);
  std::set<std::size_t> starting;
  for (const auto number : nodes(graph)) {
    const SkeletonNode& node = graph[number];
    const bool by_cut = std::ranges::any_of(
        node.generators, [](const Generator& g) { return g.cut == Generator::Cut::kRegionPlane; });
    if (!by_cut) continue;
    EXPECT_EQ(node.region_point.x(), 1);
    starting.insert(number);
  }
  EXPECT_GT(starting.size(), 0u);
}

/// Cases of all sorts: contact, rooms, planes that cut, enclosures.
TEST(Skeleton, IsEmptyIffHiddenAndTheSameInAllPoses) {
  std::size_t count = 0, number = 0;
  for (const QueryCase& c : query_cases()) {
    if (sanitized() && number++ % 4 != 0) continue;
    SCOPED_TRACE("case: " + c.name);
    const SkeletonGraph graph = visibility_skeleton(c.query);
    EXPECT_EQ(boost::num_vertices(graph) > 0, c.visible);
    expect_sound(c.query, graph);
    count += boost::num_vertices(graph);
    for (std::size_t i = 1; i < poses().size() && !sanitized(); i += 2) {
      const Pose pose = poses()[i];
      SCOPED_TRACE("pose: " + pose.name);
      SightQuery query = posed(c.query, pose);
      if (!query.one_sided) std::swap(query.region, query.element);
      const SkeletonGraph other = visibility_skeleton(query);
      EXPECT_EQ(node_kinds(other), node_kinds(graph));
      EXPECT_EQ(arc_kinds(other), arc_kinds(graph));
    }
  }
  EXPECT_GT(count, sanitized() ? 100u : 1000u);
}

}  // namespace
}  // namespace viewcover
