#pragma once

#include <string>
#include <utility>
#include <vector>

#include "scene/convex_polygon.h"
#include "scene/scene.h"

namespace viewcover {

/// The six faces of a box with the front outward: across x, y, z in turn, at min then max.
inline std::vector<ConvexPolygon> box_outward(const Point& min, const Point& max) {
  std::vector<ConvexPolygon> faces;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool high : {false, true}) {
      ConvexPolygon face(4, min);
      face[1][u] = face[2][u] = max[u];
      face[2][v] = face[3][v] = max[v];
      for (Point& corner : face) corner[axis] = high ? max[axis] : min[axis];
      if (!high) face = ConvexPolygon(face.rbegin(), face.rend());
      faces.push_back(face);
    }
  }
  return faces;
}

inline std::vector<ConvexPolygon> reversed(std::vector<ConvexPolygon> faces) {
  for (ConvexPolygon& face : faces) face = ConvexPolygon(face.rbegin(), face.rend());
  return faces;
}

/// A scene on the unit lattice, one group after the other, one face a surface.
inline Scene made_scene(
    const std::vector<std::pair<std::string, std::vector<ConvexPolygon>>>& groups) {
  Scene scene;
  for (const auto& [name, polygons] : groups) {
    scene.groups.push_back(name);
    for (const ConvexPolygon& polygon : polygons) {
      scene.surfaces.push_back({polygon, GroupId(scene.groups.size() - 1),
                                static_cast<std::uint32_t>(scene.surfaces.size())});
      scene.bounds.extend(bounding_box(polygon));
    }
  }
  scene.faces = scene.surfaces.size();
  return scene;
}

}  // namespace viewcover
