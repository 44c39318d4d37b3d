#pragma once

#include "exact/skeleton/skeleton.h"
#include "report/run_record.h"

namespace viewcover {

/// The graph as `{"nodes": [...], "arcs": [...]}`.
///
/// A node: `{"kind", "line": six exact numbers as text, "rounded": the same as doubles, "from",
/// "to", "generators"}`, and `"faces"` if polygons hold it. Exact numbers read `-3/7` or
/// `1/2+3/4*sqrt(17)`. An arc: `{"nodes": [i, j], "kind", "generators"}`, with positions in the
/// list of nodes.
/// A generator: `{"polygon": "region" | "element" | "occluder", "occluder", "vertex" or "edge"}`,
/// edge i from corner i to the next, with `"cut": "region_plane" | "element_plane"` where one of
/// these planes made it. All numbers count from 0 in the lists of the query.
Json to_json(const SkeletonGraph& graph);

}  // namespace viewcover
