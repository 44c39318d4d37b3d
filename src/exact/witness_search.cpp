#include "exact/witness_search.h"

#include <cmath>

#include "exact/view_cone.h"

namespace viewcover::exact {
namespace {

using Components = std::array<double, 6>;

constexpr int kTries = 32;
constexpr int kExactTries = 16;
constexpr int kTriesInPart = 4;

double norm(const Components& x) {
  double largest = 0;
  for (const double component : x) largest = std::max(largest, std::fabs(component));
  return largest;
}

double polar_form(const Components& x, const Components& y) {
  double sum = 0;
  for (std::size_t i = 0; i < 6; ++i) sum += x[i] * y[(i + 3) % 6];
  return sum;
}

/// Weights whose combination is uniform over a triangle, and everywhere positive over any polygon.
std::vector<double> random_weights(std::size_t count, RandomNumbers& random) {
  std::vector<double> weights(count);
  for (double& weight : weights) weight = -std::log(random.open_unit());
  return weights;
}

/// x + s y with Klein form 0, s > 0. Requires forms of opposite signs.
Components real_line_between(const Components& x, const Components& y) {
  // qy s^2 + 2 b s + qx = 0 has one positive root; computed without cancellation.
  const double qx = klein_form(x), qy = klein_form(y), b = polar_form(x, y);
  const double w = -b - std::copysign(std::sqrt(b * b - qx * qy), b);
  const double s = b * qy < 0 ? w / qy : qx / w;
  Components line;
  for (std::size_t i = 0; i < 6; ++i) line[i] = x[i] + s * y[i];
  return line;
}

/// A polygon in the units of a part's lines.
class UnitPolygon {
 public:
  UnitPolygon(std::span<const Point> polygon, const ShaftPart& part) {
    for (const Point& corner : polygon) {
      const Point moved = corner - part.origin;
      corners_.push_back({std::ldexp(moved.x(), -part.unit_exponent),
                          std::ldexp(moved.y(), -part.unit_exponent),
                          std::ldexp(moved.z(), -part.unit_exponent)});
    }
    normal_ = area_vector(corners_);
  }
  /// Weights of the point where a line meets the polygon's plane.
  std::vector<double> weights(const Components& line) const {
    const Point d(line[0], line[1], line[2]), m(line[3], line[4], line[5]);
    const Point point = (normal_.cross(m) + normal_.dot(corners_[0]) * d) / normal_.dot(d);
    return interior_weights(corners_, point);
  }

 private:
  ConvexPolygon corners_;
  Point normal_;
};

/// Positive combinations of a cell's rays.
Components interior_vector(const LineCell& cell, RandomNumbers& random) {
  Components sum{};
  for (const LineVector* ray : cell.rays()) {
    const double weight = -std::log(random.open_unit());
    for (std::size_t i = 0; i < 6; ++i) sum[i] += weight * ray->approximate().x[i];
  }
  return sum;
}

/// Occluders that a segment seems to meet, by rounded arithmetic: saves most exact classifications.
class LikelyBlockers {
 public:
  explicit LikelyBlockers(std::span<const std::span<const Point>> occluders)
      : occluders_(occluders) {
    for (const std::span<const Point> occluder : occluders) {
      normals_.push_back((occluder[1] - occluder[0]).cross(occluder[2] - occluder[0]));
    }
  }

  std::optional<std::size_t> find(const Point& p, const Point& q) {
    if (occluders_.empty()) return std::nullopt;
    if (meets(p, q, last_)) return last_;  // likely to block the next one too
    for (std::size_t i = 0; i < occluders_.size(); ++i) {
      if (meets(p, q, i)) return last_ = i;
    }
    return std::nullopt;
  }

 private:
  bool meets(const Point& p, const Point& q, std::size_t i) const {
    const std::span<const Point> polygon = occluders_[i];
    const double at_p = normals_[i].dot(p - polygon[0]), at_q = normals_[i].dot(q - polygon[0]);
    if (at_p * at_q >= 0) return false;
    const Point d = at_p > 0 ? q - p : p - q;  // from the front to the back
    Point first = polygon.back() - p;
    for (const Point& corner : polygon) {
      const Point second = corner - p;
      if (d.dot(first.cross(second)) > 0) return false;
      first = second;
    }
    return true;
  }

  std::span<const std::span<const Point>> occluders_;
  std::vector<Point> normals_;
  std::size_t last_ = 0;
};

}  // namespace

RandomSegments try_exact_segments(const ShaftPolygons& shaft, int tries, RandomNumbers& random) {
  RandomSegments result;
  LikelyBlockers occluders(shaft.occluders);
  for (int i = 0; i < tries && !(result.witness && result.any_blocked); ++i) {
    Witness segment{random_weights(shaft.region.size(), random),
                    random_weights(shaft.element.size(), random)};
    // Classified against what is likely to block it, if anything is.
    ShaftPolygons with_likely = shaft;
    const auto blocker = occluders.find(weighted_point(shaft.region, segment.region_weights),
                                        weighted_point(shaft.element, segment.element_weights));
    if (blocker && result.any_blocked) continue;
    if (blocker) with_likely.occluders = shaft.occluders.subspan(*blocker, 1);
    switch (classify_segment(with_likely, segment)) {
      case SegmentKind::kSightLine:
        if (!result.witness && !blocker) result.witness = std::move(segment);
        break;
      case SegmentKind::kBlocked:
        result.any_blocked = true;
        break;
      case SegmentKind::kNotBetween:
        break;
    }
  }
  return result;
}

namespace {

RationalPoint rational_point(const Point& p) {
  return {CGAL::Gmpq(p.x()), CGAL::Gmpq(p.y()), CGAL::Gmpq(p.z())};
}

/// Weights of a point of the polygon given exactly: a triangle of its fan that holds it, with
/// weights rounded, and next to nothing for the other corners.
std::vector<double> exact_interior_weights(std::span<const Point> polygon,
                                           const RationalPoint& point) {
  const Point normal = area_vector(polygon);
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  const auto u = static_cast<std::size_t>((axis + 1) % 3),
             v = static_cast<std::size_t>((axis + 2) % 3);
  const auto twice_area = [&](const RationalPoint& a, const RationalPoint& b,
                              const RationalPoint& c) -> CGAL::Gmpq {
    return (b[u] - a[u]) * (c[v] - a[v]) - (b[v] - a[v]) * (c[u] - a[u]);
  };
  const RationalPoint a = rational_point(polygon[0]);
  std::vector<double> weights(polygon.size(), 0x1p-200);
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    const RationalPoint b = rational_point(polygon[k]), c = rational_point(polygon[k + 1]);
    const CGAL::Gmpq whole = twice_area(a, b, c);
    const CGAL::Gmpq at_a = twice_area(point, b, c) / whole, at_b = twice_area(a, point, c) / whole;
    const CGAL::Gmpq at_c = 1 - at_a - at_b;
    if (at_a < 0 || at_b < 0 || at_c < 0) continue;
    weights[0] += CGAL::to_double(at_a);
    weights[k] += CGAL::to_double(at_b);
    weights[k + 1] += CGAL::to_double(at_c);
    break;
  }
  return weights;
}

}  // namespace

std::optional<Witness> witness_in_parts(const ShaftPolygons& shaft,
                                        const std::vector<double>& region_weights,
                                        std::span<const RationalPolygon> parts) {
  RandomNumbers random(1);
  for (const RationalPolygon& part : parts) {
    for (int i = 0; i < kTriesInPart; ++i) {
      // An interior point of the part, its exact weights, then rounding.
      RationalPoint point = {0, 0, 0};
      CGAL::Gmpq total = 0;
      for (const RationalPoint& corner : part) {
        const CGAL::Gmpq weight(i == 0 ? 1.0 : random.open_unit());
        total += weight;
        for (std::size_t k = 0; k < 3; ++k) point[k] += weight * corner[k];
      }
      for (CGAL::Gmpq& x : point) x /= total;
      const Point rounded(CGAL::to_double(point[0]), CGAL::to_double(point[1]),
                          CGAL::to_double(point[2]));
      for (auto&& weights : {interior_weights(shaft.element, rounded),
                             exact_interior_weights(shaft.element, point)}) {
        Witness witness{region_weights, weights};
        if (classify_segment(shaft, witness) == SegmentKind::kSightLine) return witness;
      }
    }
  }
  return std::nullopt;
}

std::optional<Witness> witness_in_cell(const ShaftPolygons& shaft, const ShaftPart& part,
                                       const LineCell& cell, const RealLineBracket& bracket,
                                       RandomNumbers& random, ExactStatistics& statistics) {
  const UnitPolygon region(shaft.region, part), element(shaft.element, part);
  double share = 1;  // of the bracket beside an interior vector
  const auto next_line = [&] {
    const Components inside = interior_vector(cell, random);
    const double form = klein_form(inside);
    // Toward the end of the bracket on the other side of the quadric; not all the way, so that the
    // line stays in the interior.
    const Components& other = form > 0 ? bracket.negative : bracket.positive;
    const double weight = share * norm(inside) / norm(other);
    Components mixed;
    for (std::size_t k = 0; k < 6; ++k) mixed[k] = inside[k] + weight * other[k];
    if (klein_form(mixed) * form >= 0) {
      share *= 2;
      mixed = other;
    }
    return real_line_between(inside, mixed);
  };
  for (int i = 0; i < kTries; ++i) {
    const Components line = next_line();
    Witness witness{region.weights(line), element.weights(line)};
    if (classify_segment(shaft, witness) == SegmentKind::kSightLine) return witness;
  }
  for (int i = 0; i < kExactTries; ++i) {
    const std::vector<double> weights = region.weights(next_line());
    const ViewOfElement view =
        view_element(shaft.region, weights, shaft.element, shaft.occluders, statistics);
    if (auto witness = witness_in_parts(shaft, weights, view.visible_parts)) return witness;
  }
  return std::nullopt;
}

}  // namespace viewcover::exact
