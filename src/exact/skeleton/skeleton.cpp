#include "exact/skeleton/skeleton.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <sstream>

#include "exact/shaft_parts.h"
#include "exact/sight_decision.h"
#include "exact/skeleton/swath_search.h"

namespace viewcover {
namespace exact {
namespace {

using Rational = CGAL::Gmpq;

std::string text(const Rational& x) {
  std::ostringstream out;
  out << x.numerator();
  if (x.denominator() != 1) out << '/' << x.denominator();
  return out.str();
}

/// A polygon without corners within edges, in doubles and integers.
struct StrictPolygon {
  ConvexPolygon corners;
  std::vector<std::size_t> places;

  explicit StrictPolygon(const ConvexPolygon& polygon) {
    IntegerFrame frame;
    frame.include(polygon);
    frame.set_origin(polygon[0]);
    std::vector<Vector3<BigInteger>> x;
    for (const Point& corner : polygon) x.push_back(frame.operator()<BigInteger>(corner));
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
      const auto turn = cross(x[i] - x[(i + n - 1) % n], x[(i + 1) % n] - x[i]);
      if (std::all_of(turn.begin(), turn.end(), [](const auto& t) { return sign(t) == 0; })) {
        continue;
      }
      corners.push_back(polygon[i]);
      places.push_back(i);
    }
  }

  NamedPolygon named(const IntegerFrame& frame, const PolygonName& name) const {
    std::vector<BigPoint> points;
    for (const Point& corner : corners) {
      points.push_back({frame.operator()<BigInteger>(corner), BigInteger(1)});
    }
    NamedPolygon result{name, BigPlane(points), points, {}, {}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto feature = [&](Generator::Feature f) {
        return Generator{name, f, Generator::Cut::kNone, places[i]};
      };
      result.corner_names.emplace_back(feature(Generator::Feature::kVertex));
      result.edge_names.emplace_back(feature(Generator::Feature::kEdge));
    }
    return result;
  }
};

/// Collects free cells.
struct FreeLineCells {
  LinePool& pool;
  FreeCells& cells;

  bool holds_anything(const LineCell& cell) { return find_real_lines(pool, cell).has_value(); }
  bool on_free(const LineCell& cell) {
    cells.add(cell);
    return false;
  }
};

class SkeletonBuilder {
 public:
  explicit SkeletonBuilder(const SightQuery& query)
      : region_(query.region), element_(query.element), pool_(statistics_) {
    for (const ConvexPolygon& occluder : query.occluders) occluders_.emplace_back(occluder);
    shaft_.region = region_.corners;
    shaft_.element = element_.corners;
    for (const StrictPolygon& occluder : occluders_) spans_.emplace_back(occluder.corners);
    shaft_.occluders = spans_;
    shaft_.one_sided = query.one_sided;
    frame_.include(shaft_.region);
    frame_.include(shaft_.element);
    for (const std::span<const Point> occluder : spans_) frame_.include(occluder);
    frame_.set_origin(shaft_.region[0]);
    arithmetic_.emplace(pool_, frame_.bits());
    for (std::size_t k = 0; k < 3; ++k) origin_[k] = frame_.absolute(Rational(0), k);
    step_ = frame_.absolute(Rational(1), 0) - origin_[0];
  }

  SkeletonGraph run() {
    visit_shaft_parts(pool_, shaft_, [&](const ShaftPart& part) {
      add(part);
      return false;
    });
    for (auto& [ways, half] : halves_) add(half);
    return std::move(graph_);
  }

 private:
  /// Lines that cross both planes one way.
  struct Half {
    std::unique_ptr<FreeCells> cells;
    std::set<std::size_t> occluders;  // that block any of them
    BigPlane from, to;
  };

  struct Arc {
    std::array<std::size_t, 2> ends;
    std::vector<Generator> generators;

    friend bool operator==(const Arc&, const Arc&) = default;
  };

  void add(const ShaftPart& part) {
    BigPlane from = region().plane, to = element().plane;
    const int from_way = way(part, from), to_way = way(part, to);
    if (from_way < 0) from.reverse();
    if (to_way > 0) to.reverse();
    auto [place, is_new] = halves_.try_emplace({from_way, to_way}, Half{nullptr, {}, from, to});
    Half& half = place->second;
    if (is_new) half.cells = std::make_unique<FreeCells>(*arithmetic_, from, to);
    for (const LineCell& root : part.roots) {
      std::vector<LineBlocker> blockers;
      for (std::size_t i = 0; i < part.blockers.size(); ++i) {
        if (!blocks_anything(pool_, root, part.blockers[i])) continue;
        blockers.push_back(part.blockers[i]);
        half.occluders.insert(part.occluder_of_blocker[i]);
      }
      FreeLineCells rules{pool_, *half.cells};
      Subtraction<6, FreeLineCells>(pool_, blockers, rules).run(root);
    }
  }

  /// 1 if the part's lines cross the plane to its front.
  int way(const ShaftPart& part, const BigPlane& plane) {
    const BigInteger zero(0);
    const auto& n = plane.normal;
    const LineVector* along =
        pool_.add(Role::kFunctional, LineComponents{n[0], n[1], n[2], zero, zero, zero});
    for (const LineCell& root : part.roots) {
      for (const LineVector* ray : root.rays()) {
        const int sign = pool_.sign_of_product(*along, *ray);
        if (sign != 0) return sign;
      }
    }
    return 1;
  }

  NamedPolygon region() const { return region_.named(frame_, {PolygonName::Role::kRegion, 0}); }
  NamedPolygon element() const { return element_.named(frame_, {PolygonName::Role::kElement, 0}); }

  void add(Half& half) {
    if (half.cells->empty()) return;
    std::vector<NamedPolygon> occluders;
    for (const std::size_t number : half.occluders) {
      occluders.push_back(occluders_[number].named(frame_, {PolygonName::Role::kOccluder, number}));
    }
    const ShaftFeatures features(*arithmetic_, region(), element(), occluders, half.from, half.to);
    SwathSearch search(*arithmetic_, features, *half.cells);
    search.run();
    std::vector<std::size_t> numbers;
    for (const SwathSearch::Node& node : search.nodes()) numbers.push_back(add(node, features));
    // The other half may have found the same swaths in the planes of region and element.
    const std::size_t known = arcs_.size();
    for (const SwathSearch::Arc& arc : search.arcs()) {
      Arc made{{numbers[arc.from], numbers[arc.to]}, features.generators(arc.touch)};
      std::sort(made.ends.begin(), made.ends.end());
      if (std::find(arcs_.begin(), arcs_.begin() + static_cast<std::ptrdiff_t>(known), made) !=
          arcs_.begin() + static_cast<std::ptrdiff_t>(known)) {
        continue;
      }
      arcs_.push_back(made);
      boost::add_edge(made.ends[0], made.ends[1],
                      SkeletonArc{kind_of(made.generators), made.generators}, graph_);
    }
  }

  static std::string kind_of(const std::vector<Generator>& generators) {
    std::string kind;
    for (const Generator& g : generators) {
      kind += g.feature == Generator::Feature::kVertex ? 'V' : 'E';
    }
    std::sort(kind.begin(), kind.end(), std::greater<>());
    return kind;
  }

  std::size_t add(const SwathSearch::Node& node, const ShaftFeatures& features) {
    SkeletonNode made;
    std::array<RootNumber, 6> key = write(node.line, made);
    made.generators = features.generators(node.touch);
    for (const std::size_t face : node.touch.faces) {
      made.faces.push_back(features.faces()[face].name);
    }
    made.region_point = absolute(features.region_point(node.line));
    made.element_point = absolute(features.element_point(node.line));
    const auto [place, is_new] = node_of_line_.try_emplace(key, 0);
    if (is_new) {
      place->second = boost::add_vertex(graph_);
      graph_[place->second] = std::move(made);
    } else {
      // A line in the plane of region or element bounds free lines on both sides.
      SkeletonNode& known = graph_[place->second];
      merge(known.generators, made.generators);
      merge(known.faces, made.faces);
    }
    SkeletonNode& stored = graph_[place->second];
    stored.kind = kind_of(stored.generators);
    return place->second;
  }

  template <class Name>
  static void merge(std::vector<Name>& into, const std::vector<Name>& from) {
    std::vector<Name> all;
    std::set_union(into.begin(), into.end(), from.begin(), from.end(), std::back_inserter(all));
    into = std::move(all);
  }

  /// In scene coordinates; returns the text of the line without its direction.
  std::array<RootNumber, 6> write(const StabbingLine& line, SkeletonNode& node) const {
    // (d, m) in integers i, x = step i + origin: (d, step m + origin x d) up to a factor.
    const std::array<Surd, 3> d = line.direction();
    std::array<Surd, 6> x;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t u = (k + 1) % 3, v = (k + 2) % 3;
      x[k] = d[k];
      x[3 + k] = line[3 + k] * step_ + d[v] * origin_[u] - d[u] * origin_[v];
    }
    const Surd first =
        *std::find_if(x.begin(), x.end(), [](const Surd& c) { return c.sign() != CGAL::ZERO; });
    const int way = first.sign() == CGAL::POSITIVE ? 1 : -1;
    Rational factor(0);  // of the root in the first irrational component
    for (Surd& component : x) {
      component /= first;
      if (factor == 0 && component.is_extended()) factor = CGAL::abs(component.a1());
    }
    std::array<RootNumber, 6> key;
    for (std::size_t k = 0; k < 6; ++k) {
      key[k].a = text(x[k].a0());
      node.line[k].a = text(way * x[k].a0());
      node.rounded[k] = way * CGAL::to_double(x[k]);
      if (factor == 0) continue;
      const Surd& any = *std::find_if(x.begin(), x.end(),
                                      [](const Surd& c) { return c.is_extended() && c.a1() != 0; });
      key[k].root = node.line[k].root = text(factor * factor * any.root());
      if (!x[k].is_extended()) continue;
      key[k].b = text(x[k].a1() / factor);
      node.line[k].b = text(way * x[k].a1() / factor);
    }
    return key;
  }

  Point absolute(const std::array<Surd, 3>& x) const {
    Point result;
    for (std::size_t k = 0; k < 3; ++k) {
      result[static_cast<Eigen::Index>(k)] = CGAL::to_double(x[k] * step_ + origin_[k]);
    }
    return result;
  }

  ExactStatistics statistics_;
  StrictPolygon region_, element_;
  std::vector<StrictPolygon> occluders_;
  std::vector<std::span<const Point>> spans_;
  ShaftPolygons shaft_;
  IntegerFrame frame_;
  Rational step_;  // from integers to scene units
  std::array<Rational, 3> origin_;
  LinePool pool_;
  std::optional<LineArithmetic> arithmetic_;
  std::map<std::array<int, 2>, Half> halves_;
  std::map<std::array<RootNumber, 6>, std::size_t> node_of_line_;
  std::vector<Arc> arcs_;
  SkeletonGraph graph_;
};

}  // namespace
}  // namespace exact

SkeletonGraph visibility_skeleton(const SightQuery& query) {
  return exact::SkeletonBuilder(query).run();
}

}  // namespace viewcover
