#include <iterator>

#include "scene/generate/analytic_parts.h"

namespace viewcover {

void add_facing_up(SceneBuilder& scene, const Rectangle& r, double z) {
  scene.add_face({{r.x0, r.y0, z}, {r.x1, r.y0, z}, {r.x1, r.y1, z}, {r.x0, r.y1, z}});
}

void add_facing_down(SceneBuilder& scene, const Rectangle& r, double z) {
  scene.add_face({{r.x0, r.y0, z}, {r.x0, r.y1, z}, {r.x1, r.y1, z}, {r.x1, r.y0, z}});
}

void add_upright(SceneBuilder& scene, std::array<double, 2> p, std::array<double, 2> q, double low,
                 double high) {
  scene.add_face({{p[0], p[1], low}, {p[0], p[1], high}, {q[0], q[1], high}, {q[0], q[1], low}});
}

void add_region_part(SceneBuilder& scene, const Rectangle& r, double z) {
  scene.add_region({{r.x0, r.y0, z}, {r.x1, r.y0, z}, {r.x1, r.y1, z}, {r.x0, r.y1, z}});
}

std::vector<AnalyticScene> analytic_scenes() {
  std::vector<AnalyticScene> scenes = analytic_rooms();
  std::vector<AnalyticScene> plates = analytic_plates();
  scenes.insert(scenes.end(), std::make_move_iterator(plates.begin()),
                std::make_move_iterator(plates.end()));
  return scenes;
}

}  // namespace viewcover
