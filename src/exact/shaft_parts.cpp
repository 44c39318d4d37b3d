#include "exact/shaft_parts.h"

#include <bit>

#include "exact/double_description.h"
#include "exact/integer_geometry.h"
#include "scene/random_numbers.h"

namespace viewcover::exact {
namespace {

/// Root cells of larger polygons have too many facets.
constexpr std::size_t kMostCorners = 6;
/// So that the sides of a blocker, two cuts included, are counted in 64 bits.
constexpr std::size_t kMostOccluderCorners = 60;

/// Vectors of the lines through edges, one for both directions: mesh neighbours share them.
class EdgeLines {
 public:
  EdgeLines(LinePool& pool, std::size_t edges)
      : pool_(pool), entries_(std::bit_ceil(2 * edges + 1)) {}

  template <class Number>
  Side<6> operator()(const Point& a, const Point& b, const Vector3<Number>& integer_a,
                     const Vector3<Number>& integer_b) {
    const std::size_t mask = entries_.size() - 1;
    for (std::size_t place = hash(a) + hash(b);; ++place) {
      Entry& entry = entries_[place & mask];
      if (entry.line == nullptr) {
        const Vector3<Number> d = integer_b - integer_a, m = cross(integer_a, integer_b);
        // As a functional on lines: direction and moment change places.
        entry = {&a, &b,
                 pool_.add(Role::kFunctional,
                           std::array<Number, 6>{m[0], m[1], m[2], d[0], d[1], d[2]})};
        return {entry.line, 1};
      }
      if (*entry.a == a && *entry.b == b) return {entry.line, 1};
      if (*entry.a == b && *entry.b == a) return {entry.line, -1};
    }
  }

 private:
  struct Entry {
    const Point* a = nullptr;
    const Point* b = nullptr;
    const LineVector* line = nullptr;
  };
  static std::size_t hash(const Point& p) {
    // + 0.0 makes one zero of two.
    const auto bits = [&](int i) { return std::bit_cast<std::uint64_t>(p[i] + 0.0); };
    return mixed(bits(0) + 3 * std::rotl(bits(1), 21) + 5 * std::rotl(bits(2), 42));
  }

  LinePool& pool_;
  std::vector<Entry> entries_;  // open addressing, a power of two, never more than half full
};

// Samples cost more than they save below, and pay for more of them above.
constexpr std::size_t kFewOccluders = 32, kManyOccluders = 128, kFewSamples = 64;

template <class Number>
class ShaftCutter {
 public:
  using Polygon = std::vector<HomogeneousPoint<Number>>;
  using Plane = IntegerPlane<Number>;

  ShaftCutter(LinePool& pool, const ShaftPolygons& shaft, const IntegerFrame& frame)
      : pool_(pool),
        shaft_(shaft),
        frame_(frame),
        region_(polygon(shaft.region)),
        element_(polygon(shaft.element)),
        region_plane_(region_),
        element_plane_(element_) {}

  bool run(const std::function<bool(const ShaftPart&)>& visit) {
    const Sides of_region = Sides::of<Number>(element_plane_, region_);
    const Sides of_element = Sides::of<Number>(region_plane_, element_);
    if (!of_element.front && !of_element.back) return false;
    add_occluders();
    for (const int element_side : {1, -1}) {
      if (!(element_side > 0 ? of_element.front : of_element.back)) continue;
      const auto elements = pieces(cut(element_, region_plane_, of_element, element_side));
      for (const int region_side : {1, -1}) {
        if (!(region_side > 0 ? of_region.front : of_region.back)) continue;
        if (shaft_.one_sided && region_side < 0) continue;
        const auto regions = pieces(cut(region_, element_plane_, of_region, region_side));
        // Lines run from region to element: both planes are crossed from behind to the front.
        Plane from = region_plane_, to = element_plane_;
        if (element_side < 0) from.reverse();
        if (region_side > 0) to.reverse();
        for (const Polygon& region : regions) {
          for (const Polygon& element : elements) {
            if (visit(part(region, element, from, to))) return true;
          }
        }
      }
    }
    return false;
  }

 private:
  struct Occluder {
    Polygon polygon;
    Plane plane;
    std::vector<Side<6>> edges;
    std::size_t number;
  };

  Polygon polygon(std::span<const Point> points) const {
    Polygon result;
    for (const Point& point : points)
      result.push_back({frame_.operator()<Number>(point), Number(1)});
    return result;
  }

  static Polygon cut(const Polygon& polygon, const Plane& plane, const Sides& sides, int keep) {
    return sides.front && sides.back ? cut_polygon<Number>(polygon, plane, keep) : polygon;
  }

  static std::vector<Polygon> pieces(const Polygon& polygon) {
    std::vector<Polygon> result;
    for (std::size_t first = 1; first + 1 < polygon.size(); first += kMostCorners - 2) {
      const std::size_t last = std::min(first + kMostCorners - 2, polygon.size() - 1);
      Polygon& piece = result.emplace_back();
      piece.push_back(polygon[0]);
      for (std::size_t i = first; i <= last; ++i) piece.push_back(polygon[i]);
    }
    return result;
  }

  void add_occluders() {
    std::size_t edges = 0;
    for (const std::span<const Point> occluder : shaft_.occluders) {
      edges += occluder.size() + 2 * (occluder.size() / (kMostOccluderCorners - 2));
    }
    EdgeLines lines(pool_, edges);
    for (std::size_t number = 0; number < shaft_.occluders.size(); ++number) {
      const std::span<const Point> corners = shaft_.occluders[number];
      const Polygon whole = polygon(corners);
      // Abutting pieces block the same.
      for (std::size_t first = 1; first + 1 < corners.size(); first += kMostOccluderCorners - 2) {
        const std::size_t last = std::min(first + kMostOccluderCorners - 2, corners.size() - 1);
        std::vector<std::size_t> places = {0};
        for (std::size_t i = first; i <= last; ++i) places.push_back(i);
        Polygon piece;
        for (const std::size_t place : places) piece.push_back(whole[place]);
        Occluder& occluder = occluders_.emplace_back(Occluder{piece, Plane(piece), {}, number});
        for (std::size_t k = 0; k < places.size(); ++k) {
          const std::size_t a = places[k], b = places[(k + 1) % places.size()];
          occluder.edges.push_back(lines(corners[a], corners[b], whole[a].x, whole[b].x));
        }
      }
    }
  }

  ShaftPart part(const Polygon& region, const Polygon& element, const Plane& from,
                 const Plane& to) {
    ShaftPart result;
    result.origin = frame_.origin();
    result.unit_exponent = frame_.unit_exponent();
    result.roots = roots(region, element, from, to);
    add_samples(region, element, result);
    for (const Occluder& occluder : occluders_) {
      const Sides near = Sides::of<Number>(occluder.plane, region);
      const Sides far = Sides::of<Number>(occluder.plane, element);
      for (const int way : {1, -1}) {  // 1: from the front of the occluder to its back
        if (!(way > 0 ? near.front && far.back : near.back && far.front)) continue;
        LineBlocker& blocker = result.blockers.emplace_back();
        result.occluder_of_blocker.push_back(occluder.number);
        // A line that enters by the front passes counter-clockwise edges on their negative side.
        for (const Side<6>& edge : occluder.edges) {
          blocker.sides.push_back({edge.functional, -way * edge.sign});
        }
        if (near.front && near.back) blocker.sides.push_back({meeting(occluder, from), way});
        if (far.front && far.back) blocker.sides.push_back({meeting(occluder, to), -way});
      }
    }
    return result;
  }

  /// Every sample is held against every blocker.
  void add_samples(const Polygon& region, const Polygon& element, ShaftPart& part) const {
    RandomNumbers random(1);
    const std::size_t count = occluders_.size() < kFewOccluders    ? 0
                              : occluders_.size() < kManyOccluders ? kFewSamples
                                                                   : Samples<6>::kMost;
    const auto unit_points = [&](const Polygon& polygon) {
      std::vector<Point> points;
      for (const auto& corner : polygon) points.push_back(frame_.unit_point(corner));
      return points;
    };
    const std::vector<Point> from = unit_points(region), to = unit_points(element);
    const auto random_point = [&](const std::vector<Point>& corners) {
      Point sum = Point::Zero();
      double total = 0;
      for (const Point& corner : corners) {
        const double weight = -std::log(random.open_unit());
        sum += weight * corner;
        total += weight;
      }
      return Point(sum / total);
    };
    for (std::size_t i = 0; i < count; ++i) {
      const Point a = random_point(from), b = random_point(to);
      const Point d = b - a, m = a.cross(b);
      part.samples.push_back({d.x(), d.y(), d.z(), m.x(), m.y(), m.z()});
    }
  }

  /// The side of the occluder's plane on which a line meets the plane `other`, as a functional on
  /// lines (d, m) with other.normal . d > 0: the point is (normal x m + offset d) / (normal . d).
  const LineVector* meeting(const Occluder& occluder, const Plane& other) {
    const Plane& plane = occluder.plane;
    const Vector3<Number> d = other.offset * plane.normal - plane.offset * other.normal;
    const Vector3<Number> m = cross(plane.normal, other.normal);
    return pool_.add(Role::kFunctional, std::array<Number, 6>{d[0], d[1], d[2], m[0], m[1], m[2]});
  }

  std::vector<LineCell> roots(const Polygon& region, const Polygon& element, const Plane& from,
                              const Plane& to) {
    // Lines within both planes: if some run one way and some the other, the cone of all lines is
    // not pointed, and is cut in two by that direction.
    const Vector3<Number> along = cross(from.normal, to.normal);
    std::vector<const LineVector*> lines;
    bool forward = false, backward = false;
    for (std::size_t i = 0; i < region.size(); ++i) {
      for (std::size_t j = 0; j < element.size(); ++j) {
        const HomogeneousPoint<Number>&a = region[i], &b = element[j];
        const Vector3<Number> d = a.w * b.x - b.w * a.x, m = cross(a.x, b.x);
        const LineVector* line =
            pool_.add(Role::kRay, std::array<Number, 6>{d[0], d[1], d[2], m[0], m[1], m[2]},
                      std::uint64_t{1} << i | std::uint64_t{1} << (kMostCorners + j));
        if (line == nullptr) continue;  // a common corner
        lines.push_back(line);
        if (to.side(a) != 0 || from.side(b) != 0) continue;
        const int way = sign(dot(along, d));
        forward |= way > 0;
        backward |= way < 0;
      }
    }
    std::vector<LineCell> cells;
    if (!(forward && backward)) {
      if (auto cell = cone_of<6>(pool_, lines)) cells.push_back(std::move(*cell));
      return cells;
    }
    const Number zero(0);
    const std::array<Number, 6> direction = {along[0], along[1], along[2], zero, zero, zero};
    const LineVector* const cut = pool_.add(Role::kFunctional, direction);
    for (const LineVector* const side : {cut, pool_.negated(cut)}) {
      if (auto cell = cone_of<6>(pool_, half(lines, side))) cells.push_back(std::move(*cell));
    }
    return cells;
  }

  /// Generators of the part of a cone where `side` >= 0.
  std::vector<const LineVector*> half(std::span<const LineVector* const> lines,
                                      const LineVector* side) {
    std::vector<const LineVector*> result, outside;
    for (const LineVector* line : lines) {
      (pool_.sign_of_product(*line, *side) >= 0 ? result : outside).push_back(line);
    }
    const std::size_t inside = result.size();
    for (std::size_t i = 0; i < inside; ++i) {
      if (pool_.sign_of_product(*result[i], *side) == 0) continue;
      for (const LineVector* line : outside) {
        const LineVector* made = pool_.combine(result[i], line, side);
        if (!pool_.is_zero(*made)) result.push_back(made);
      }
    }
    return result;
  }

  LinePool& pool_;
  const ShaftPolygons& shaft_;
  const IntegerFrame& frame_;
  Polygon region_, element_;
  Plane region_plane_, element_plane_;
  std::vector<Occluder> occluders_;
};

}  // namespace

bool visit_shaft_parts(LinePool& pool, const ShaftPolygons& shaft,
                       const std::function<bool(const ShaftPart&)>& visit) {
  IntegerFrame frame;
  frame.include(shaft.region);
  frame.include(shaft.element);
  for (const std::span<const Point> occluder : shaft.occluders) frame.include(occluder);
  frame.set_origin(shaft.region[0]);
  pool.set_unit(frame.bits());
  if (frame.is_narrow()) {
    try {
      return ShaftCutter<CheckedWide>(pool, shaft, frame).run(visit);
    } catch (const CheckedWide::Overflow&) {
      // Once more with integers of any size. Parts visited before the overflow are visited again:
      // they had no sight line.
    }
  }
  return ShaftCutter<BigInteger>(pool, shaft, frame).run(visit);
}

}  // namespace viewcover::exact
