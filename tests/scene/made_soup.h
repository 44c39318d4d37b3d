#pragma once

#include <cstdint>
#include <vector>

#include "scene/read/polygon_soup.h"

namespace viewcover::testing {

/// Faces with corners of their own, as files have them that were not welded.
inline PolygonSoup soup_of(const std::vector<std::vector<Point>>& faces) {
  PolygonSoup soup;
  soup.file = "made";
  soup.groups = {""};
  for (const std::vector<Point>& corners : faces) {
    PolygonSoup::Face face;
    for (const Point& corner : corners) {
      face.push_back(static_cast<std::uint32_t>(soup.vertices.size()));
      soup.vertices.push_back(corner);
    }
    soup.faces.push_back(face);
    soup.face_groups.emplace_back(0);
  }
  return soup;
}

/// A square [0, 2] x [0, 2] and to its right two squares of half the size, whose common corner lies
/// `gap` beside the middle of the large one's edge.
inline PolygonSoup t_junction(double gap) {
  return soup_of({{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}},
                  {{2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2 + gap, 1, 0}},
                  {{2 + gap, 1, 0}, {3, 1, 0}, {3, 2, 0}, {2, 2, 0}}});
}

}  // namespace viewcover::testing
