#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "scene/generate/generated_scene.h"
#include "scene/generate/scene_builder.h"

namespace viewcover {

/// Rectangle [x0, x1] x [y0, y1] of a horizontal plane.
struct Rectangle {
  double x0, x1, y0, y1;
};

/// Horizontal rectangle at height `z` that faces up or down; one face.
void add_facing_up(SceneBuilder& scene, const Rectangle& r, double z);
void add_facing_down(SceneBuilder& scene, const Rectangle& r, double z);
/// Upright rectangle over the segment from `p` to `q`, facing to the left of the way; one face.
void add_upright(SceneBuilder& scene, std::array<double, 2> p, std::array<double, 2> q, double low,
                 double high);
/// Horizontal rectangle of the viewing region.
void add_region_part(SceneBuilder& scene, const Rectangle& r, double z);

/// Scenes in rooms, and scenes of free plates. In the order they are listed.
std::vector<AnalyticScene> analytic_rooms();
std::vector<AnalyticScene> analytic_plates();

}  // namespace viewcover
