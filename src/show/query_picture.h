#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/convex_polygon.h"
#include "show/camera.h"

namespace viewcover {

/// A line of the skeleton between the planes of region and element.
struct StabbingLine {
  Point from = Point::Zero(), to = Point::Zero();
  std::string kind;  ///< "VV", "VEE", "EEEE" or a degenerate one
};

/// One query of `sees` and what was found.
struct QueryPicture {
  ConvexPolygon region;  ///< empty for a query from a viewpoint
  Point viewpoint = Point::Zero();
  ConvexPolygon element;
  std::vector<ConvexPolygon> occluders;
  std::vector<ConvexPolygon> visible_parts;  ///< of the element, from a viewpoint
  std::optional<std::pair<Point, Point>> witness;
  std::vector<StabbingLine> lines;
  std::string caption;
};

/// Draws it from beside the shaft, region on the left and element on the right; `view` turns from
/// there. Polygons are translucent; a line is paler where one is in front of it.
/// Errors: InputError where the file cannot be written.
void draw_query(const QueryPicture& query, const std::optional<ViewDirection>& view, PixelSize size,
                const std::filesystem::path& file);

}  // namespace viewcover
