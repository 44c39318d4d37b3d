#include "exact/sight_query.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <utility>

#include "exact/sight_decision.h"
#include "exact/view_cone.h"
#include "exact/witness_search.h"
#include "scene/predicates.h"

namespace viewcover {
namespace {

/// A polygon without the corners that lie within edges, and where the others were.
struct StrictPolygon {
  ConvexPolygon corners;
  std::vector<std::size_t> places;

  explicit StrictPolygon(const ConvexPolygon& polygon) : places(turning_corners(polygon)) {
    for (const std::size_t place : places) corners.push_back(polygon[place]);
  }
};

/// The query without corners within edges.
struct StrictQuery {
  StrictPolygon region, element;
  std::vector<ConvexPolygon> occluder_polygons;
  std::vector<std::span<const Point>> occluders;

  explicit StrictQuery(const SightQuery& query) : region(query.region), element(query.element) {
    for (const ConvexPolygon& occluder : query.occluders) {
      occluder_polygons.push_back(StrictPolygon(occluder).corners);
    }
    occluders.assign(occluder_polygons.begin(), occluder_polygons.end());
  }
};

/// Positive weights for all corners that were given; those within edges get so little that the
/// segment stays a sight line, which is confirmed.
void spread_weights(const ConvexPolygon& polygon, const StrictPolygon& strict,
                    std::vector<double>& weights) {
  if (strict.places.size() == polygon.size()) return;
  std::vector<double> all(polygon.size(), 0x1p-200);
  for (std::size_t i = 0; i < strict.places.size(); ++i) all[strict.places[i]] = weights[i];
  weights = std::move(all);
}

void complete_witness(const SightQuery& query, const StrictQuery& strict, SightAnswer& answer) {
  if (!answer.witness) return;
  if (!answer.witness->region_weights.empty()) {
    spread_weights(query.region, strict.region, answer.witness->region_weights);
  }
  spread_weights(query.element, strict.element, answer.witness->element_weights);
}

}  // namespace

SightAnswer decide_from_region(const SightQuery& query) {
  const StrictQuery strict(query);
  SightAnswer answer = exact::decide_shaft(
      {strict.region.corners, strict.element.corners, strict.occluders, query.one_sided});
  complete_witness(query, strict, answer);
  return answer;
}

PointAnswer decide_from_point(const SightQuery& query) {
  const StrictQuery strict(query);
  const ConvexPolygon& element = strict.element.corners;
  PointAnswer answer;
  const int side = orientation(element[0], element[1], element[2], query.viewpoint);
  if (side == 0 || (query.one_sided && side < 0)) return answer;
  const std::array<Point, 1> viewpoint = {query.viewpoint};
  const std::array<double, 1> weight = {1};
  const exact::ViewOfElement view =
      exact::view_element(viewpoint, weight, element, strict.occluders, answer.statistics);
  answer.visible_fraction = CGAL::to_double(view.visible_fraction);
  if (view.visible_parts.empty()) {
    answer.verdict = view.hidden_by_one ? Verdict::kHiddenByOne : Verdict::kHiddenBySet;
    return answer;
  }
  answer.verdict = view.fully ? Verdict::kFullyVisible : Verdict::kVisibleWitness;
  for (const exact::RationalPolygon& part : view.visible_parts) {
    ConvexPolygon& polygon = answer.visible_parts.emplace_back();
    for (const exact::RationalPoint& corner : part) {
      polygon.push_back(
          {CGAL::to_double(corner[0]), CGAL::to_double(corner[1]), CGAL::to_double(corner[2])});
    }
  }
  answer.witness = exact::witness_in_parts({viewpoint, element, strict.occluders, query.one_sided},
                                           {}, view.visible_parts);
  complete_witness(query, strict, answer);
  return answer;
}

}  // namespace viewcover
