#pragma once

#include "support/second_opinion/sweep.h"

namespace viewcover::testing {

/// Decides exactly whether the element is visible from the region, whatever one_sided says.
/// REQUIRES: at most 30 occluders, polygons that are convex, planar and have an area.
/// Cost: 1 ms or so for up to six occluders on a small integer grid; grows fast with both.
inline bool sees_by_second_opinion(const SightQuery& query) {
  return second_opinion::sees<second_opinion::Fraction>(query);
}

/// The same in double: an answer without any guarantee. Throws second_opinion::Undecided.
inline bool sees_by_second_opinion_in_double(const SightQuery& query) {
  return second_opinion::sees<double>(query);
}

}  // namespace viewcover::testing
