#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "exact/sight_query.h"
#include "exact/witness_judge.h"

namespace viewcover::testing {

/// Is the witness of a query from a region a sight line? By rationals, with no code of the library.
inline bool is_sight_line(const SightQuery& query, const Witness& witness) {
  const auto are_inner = [](std::span<const double> weights, std::size_t corners) {
    return weights.size() == corners && std::all_of(weights.begin(), weights.end(), [](double w) {
             return w > 0 && std::isfinite(w);
           });
  };
  if (!are_inner(witness.region_weights, query.region.size())) return false;
  if (!are_inner(witness.element_weights, query.element.size())) return false;
  const ExactPoint p = weighted(query.region, witness.region_weights);
  const ExactPoint q = weighted(query.element, witness.element_weights);
  const int side = exact_side(query.element, p);
  if (query.one_sided ? side <= 0 : side == 0) return false;
  return exact_side(query.region, q) != 0 &&
         std::none_of(
             query.occluders.begin(), query.occluders.end(),
             [&](const ConvexPolygon& occluder) { return open_segment_meets(p, q, occluder); });
}

}  // namespace viewcover::testing
