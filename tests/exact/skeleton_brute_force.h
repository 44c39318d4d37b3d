#pragma once

#include <map>
#include <string>

#include "exact/sight_query.h"

namespace viewcover::testing {

/// The nodes of a skeleton by enumeration, with no code of the library: all lines through two
/// vertices, through a vertex and two edges, on four edges, through a vertex in its polygon's plane
/// and an edge; kept if they touch those segments, if nothing near touches the same, and if a free
/// segment is found within 2^-60 of them. Occluders that miss the interior of the hull of region
/// and element are left out. From the text of a line, as in `SkeletonNode`, to its kind.
///
/// Requires that region and element lie strictly in front of each other's planes, that all
/// occluders lie strictly between these planes, and that no two polygons have a common point.
/// Cost: the fourth power of the edges; a second for 20.
std::map<std::string, std::string> brute_force_nodes(const SightQuery& query);

}  // namespace viewcover::testing
