#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exact/query_shapes.h"
#include "exact/sight_query.h"

namespace viewcover::testing {

/// A query from a viewpoint whose answer is known by an argument. All coordinates are integers.
struct PointCase {
  std::string name;
  SightQuery query;
  double seen = 0, of = 1;    ///< the visible fraction of the element is seen / of; both integers
  std::optional<bool> fully;  ///< empty where an occluder in the shaft is seen edge-on
  std::string argument;
};

std::vector<PointCase> point_cases();

}  // namespace viewcover::testing
