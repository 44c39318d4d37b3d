#include "scene/generate/scene_builder.h"

#include <cassert>

namespace viewcover {

void SceneBuilder::begin_group(const std::string& inner_name) {
  const std::string name = prefix_ + inner_name;
  const auto [place, is_new] =
      groups_.try_emplace(name, static_cast<std::uint32_t>(scene_.groups.size()));
  if (is_new) scene_.groups.push_back(name);
  group_ = place->second;
}

void SceneBuilder::add_face(std::span<const Point> corners) {
  assert(!scene_.groups.empty() && corners.size() >= 3);
  GeneratedScene::Face face;
  face.group = group_;
  face.corners.reserve(corners.size());
  for (const Point& inner_corner : corners) {
    const Point corner = inner_corner + offset_;
    // Adding zero turns -0 into 0, so that equal points have equal decimals.
    const std::array<double, 3> key = {corner.x() + 0.0, corner.y() + 0.0, corner.z() + 0.0};
    const auto [place, is_new] =
        vertices_.try_emplace(key, static_cast<std::uint32_t>(scene_.vertices.size()));
    if (is_new) scene_.vertices.emplace_back(key[0], key[1], key[2]);
    face.corners.push_back(place->second);
  }
  scene_.faces.push_back(std::move(face));
}

}  // namespace viewcover
