#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "scene/generate/generated_scene.h"
#include "scene/types.h"

namespace viewcover {

/// Collects the faces of a generated scene. Corners with equal coordinates become one vertex;
/// vertices, faces and groups keep the order in which they came.
/// Not thread-safe. Cost: logarithmic in the number of vertices for each corner.
class SceneBuilder {
 public:
  explicit SceneBuilder(std::string title) { scene_.title = std::move(title); }

  /// From now on faces and regions are moved by `offset`, and names of groups begin with `prefix`.
  void move_to(const Point& offset, std::string prefix) {
    offset_ = offset;
    prefix_ = std::move(prefix);
  }
  /// Faces added from now on belong to the group `name`; an earlier group of that name goes on.
  void begin_group(const std::string& inner_name);
  /// Adds a face with its corners counter-clockwise from the front.
  /// REQUIRES: a group was begun; at least three corners.
  void add_face(std::span<const Point> corners);
  void add_face(std::initializer_list<Point> corners) {
    add_face(std::span<const Point>(corners.begin(), corners.size()));
  }
  /// Adds a polygon to the viewing region.
  void add_region(std::vector<Point> polygon) {
    for (Point& corner : polygon) corner += offset_;
    scene_.region.push_back(std::move(polygon));
  }

  std::size_t face_count() const { return scene_.faces.size(); }
  GeneratedScene finish() && { return std::move(scene_); }

 private:
  GeneratedScene scene_;
  Point offset_ = Point::Zero();
  std::string prefix_;
  std::uint32_t group_ = 0;
  std::map<std::array<double, 3>, std::uint32_t> vertices_;
  std::map<std::string, std::uint32_t> groups_;
};

}  // namespace viewcover
