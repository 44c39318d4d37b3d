#pragma once

#include <string>
#include <utility>
#include <vector>

#include "exact/query_shapes.h"
#include "exact/sight_query.h"

namespace viewcover::testing {

/// A query from a region whose answer is known by an argument. All coordinates are integers; the
/// unit of "one unit short" is 1.
struct QueryCase {
  std::string name;
  SightQuery query;
  bool visible = false;
  bool fully = false;  ///< no occluder meets the interior of the shaft
  std::string argument;
};

struct Ends {
  ConvexPolygon region, element;
};

/// The hull meant by the arguments is conv(region u element). "Profile" is the section at a fixed
/// y of a scene whose occluders reach through the hull along y: a segment is free iff its
/// projection to the profile is.
class QueryCaseList {
 public:
  QueryCase& hidden(std::string name, const Ends& ends, Polygons occluders, std::string argument) {
    return add(std::move(name), ends, std::move(occluders), std::move(argument));
  }
  /// Some occluder is in the shaft.
  QueryCase& visible(std::string name, const Ends& ends, Polygons occluders, std::string argument) {
    QueryCase& added = add(std::move(name), ends, std::move(occluders), std::move(argument));
    added.visible = true;
    return added;
  }
  QueryCase& fully(std::string name, const Ends& ends, Polygons occluders, std::string argument) {
    QueryCase& added = add(std::move(name), ends, std::move(occluders), std::move(argument));
    added.visible = added.fully = true;
    return added;
  }
  std::vector<QueryCase> take() { return std::move(cases_); }

 private:
  QueryCase& add(std::string name, const Ends& ends, Polygons occluders, std::string argument) {
    QueryCase added;
    added.name = std::move(name);
    added.query.region = ends.region;
    added.query.viewpoint.setZero();
    added.query.element = ends.element;
    added.query.occluders = std::move(occluders);
    added.argument = std::move(argument);
    return cases_.emplace_back(std::move(added));
  }

  std::vector<QueryCase> cases_;
};

std::vector<QueryCase> open_cases();       ///< nothing between; which side faces which
std::vector<QueryCase> contact_cases();    ///< covers in one plane, boxes, umbras
std::vector<QueryCase> slit_cases();       ///< slits, half walls, louvres, windows
std::vector<QueryCase> plane_cases();      ///< shared edges and vertices, planes that cut, piercing
std::vector<QueryCase> enclosure_cases();  ///< boxes, tubes, domes, rooms

/// All of them.
std::vector<QueryCase> query_cases();

}  // namespace viewcover::testing
