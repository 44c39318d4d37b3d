#pragma once

#include "exact/shaft_parts.h"
#include "exact/sight_query.h"

namespace viewcover::exact {

/// Is there a sight line through the shaft? Exact; a witness comes with a visible verdict.
///
/// Random segments first: what they show needs no decision. Then blocking cones are subtracted from
/// the root cells (papers/exact.md).
SightAnswer decide_shaft(const ShaftPolygons& shaft);

}  // namespace viewcover::exact
