#pragma once

#include <string>

#include "exact/sight_query.h"
#include "report/run_record.h"

namespace viewcover {

/// A query of `sees`, read and checked.
struct ReadQuery {
  Json id;  ///< as given, null if there is none
  bool from_viewpoint = false;
  SightQuery query;
};

/// Reads one JSON object `{"id", "region" | "viewpoint", "element", "occluders"}`.
///
/// Errors: InputError at the key concerned for anything that is not as described in the interface:
/// missing or misspelt keys, numbers that no double holds exactly or that lie beyond 2^300,
/// polygons with fewer than 3 corners, without area, not planar or not convex.
ReadQuery read_query(const Json& object);

/// The id of a query that may be bad otherwise; null if there is none.
Json id_of(const Json& object);

/// `{"from", "to", "region_weights", "element_weights"}`.
Json to_json(const Witness& witness, const SightQuery& query);

}  // namespace viewcover
