#pragma once

#include <fmt/format.h>

#include "report/csv_table.h"
#include "scene/convex_polygon.h"

namespace viewcover {

/// The corners x0, y0, z0, x1, ... of a row, as tables.h writes them.
inline ConvexPolygon polygon_in(const CsvTable& table, std::size_t row) {
  ConvexPolygon polygon;
  for (std::size_t k = 0; table.has(fmt::format("x{}", k)); ++k) {
    if (table.text(row, fmt::format("x{}", k)).empty()) break;
    polygon.push_back({table.number(row, fmt::format("x{}", k)),
                       table.number(row, fmt::format("y{}", k)),
                       table.number(row, fmt::format("z{}", k))});
  }
  return polygon;
}

}  // namespace viewcover
