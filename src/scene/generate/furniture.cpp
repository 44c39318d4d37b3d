#include "scene/generate/furniture.h"

#include <array>
#include <cassert>

namespace viewcover {

namespace {

void add_leg(SceneBuilder& scene, const Placement& at, double x, double y, double thickness,
             double low, double high) {
  const double h = thickness / 2;
  add_box(scene, at, {x - h, y - h, low}, {x + h, y + h, high});
}

void add_four_legs(SceneBuilder& scene, const Placement& at, double x, double y, double thickness,
                   double height) {
  for (const double sx : {-x, x}) {
    for (const double sy : {-y, y}) add_leg(scene, at, sx, sy, thickness, 0, height);
  }
}

// Triangles from the stem at height `low`, one for each sector of the octagon.
void add_leaves(SceneBuilder& scene, const Placement& at, int leaves, int reach, double low,
                double high) {
  assert(leaves <= static_cast<int>(kOctagon.size()));
  for (int leaf = 0; leaf < leaves; ++leaf) {
    const auto& [x0, y0] = kOctagon[static_cast<std::size_t>(leaf)];
    const auto& [x1, y1] = kOctagon[static_cast<std::size_t>(leaf + 1) % kOctagon.size()];
    const int near = reach / 2;
    const double tip = leaf % 2 == 0 ? high : high - 0.12;
    scene.add_face({at(0, 0, low),
                    at(x0 * near * kRingUnit, y0 * near * kRingUnit, (low + tip) / 2),
                    at(x1 * reach * kRingUnit, y1 * reach * kRingUnit, tip)});
  }
}

}  // namespace

void add_sofa(SceneBuilder& scene, const Placement& at, double width, int seats, Finish finish) {
  const double depth = 0.9;
  const double arm = 0.16;
  const double half = width / 2;
  const double seat = half - arm;
  add_box(scene, at, {-seat, -depth / 2, 0.06}, {seat, 0.23, 0.32});    // base
  add_box(scene, at, {-seat, 0.23, 0.06}, {seat, depth / 2, 0.88});     // back
  add_box(scene, at, {-half, -depth / 2, 0}, {-seat, depth / 2, 0.6});  // arms
  add_box(scene, at, {seat, -depth / 2, 0}, {half, depth / 2, 0.6});
  if (finish == Finish::kPlain) return;
  const double each = 2 * seat / seats;
  for (int i = 0; i < seats; ++i) {
    const double x = -seat + i * each;
    add_box(scene, at, {x + 0.01, -depth / 2 - 0.02, 0.32}, {x + each - 0.01, 0.22, 0.45});
  }
  const auto add_pillow = [&](double x) {
    add_slanted_box(scene, at, {x, 0.02, 0.46}, {0.4, 0, 0}, {0, 0.1, 0.03}, {0, 0.08, 0.34});
  };
  add_pillow(-seat + 0.06);
  if (seats > 1) add_pillow(seat - 0.46);
}

void add_table(SceneBuilder& scene, const Placement& at, const Point& size) {
  const double x = size.x() / 2;
  const double y = size.y() / 2;
  const double top = size.z() - 0.04;
  add_box(scene, at, {-x, -y, top}, {x, y, size.z()});
  add_four_legs(scene, at, x - 0.08, y - 0.08, 0.06, top);
}

void add_chair(SceneBuilder& scene, const Placement& at, Finish finish) {
  add_box(scene, at, {-0.22, -0.22, 0.42}, {0.22, 0.22, 0.46});
  if (finish == Finish::kPlain) {
    add_box(scene, at, {-0.22, -0.22, 0}, {-0.19, 0.22, 0.42});
    add_box(scene, at, {0.19, -0.22, 0}, {0.22, 0.22, 0.42});
    add_box(scene, at, {-0.22, 0.18, 0.46}, {0.22, 0.22, 0.95});
    return;
  }
  add_four_legs(scene, at, 0.19, 0.19, 0.04, 0.42);
  add_box(scene, at, {-0.22, 0.18, 0.46}, {-0.18, 0.22, 0.97});
  add_box(scene, at, {0.18, 0.18, 0.46}, {0.22, 0.22, 0.97});
  for (const double z : {0.56, 0.7, 0.84}) {
    add_box(scene, at, {-0.18, 0.19, z}, {0.18, 0.21, z + 0.08});
  }
}

void add_floor_lamp(SceneBuilder& scene, const Placement& at, Finish finish) {
  add_leg(scene, at, 0, 0, 0.3, 0, 0.04);
  add_leg(scene, at, 0, 0, 0.03, 0.04, 1.75);
  if (finish == Finish::kPlain) {
    add_frustum(scene, at, kHexagon, 8, 5, 1.62, 1.94, Caps::kNone);
  } else {
    add_frustum(scene, at, kOctagon, 5, 3, 1.62, 1.94, Caps::kNone);
  }
}

void add_pendant_lamp(SceneBuilder& scene, const Placement& at, double ceiling) {
  add_leg(scene, at, 0, 0, 0.02, ceiling - 0.5, ceiling);
  add_frustum(scene, at, kOctagon, 4, 2, ceiling - 0.6, ceiling - 0.4, Caps::kNone);
}

void add_table_lamp(SceneBuilder& scene, const Placement& at) {
  add_frustum(scene, at, kOctagon, 2, 1, 0, 0.06, Caps::kBoth);
  add_leg(scene, at, 0, 0, 0.02, 0.06, 0.3);
  add_frustum(scene, at, kOctagon, 3, 2, 0.25, 0.45, Caps::kNone);
}

void add_plant(SceneBuilder& scene, const Placement& at, int leaves, bool second_row) {
  add_frustum(scene, at, kHexagon, 4, 6, 0, 0.36, Caps::kBoth);
  add_leaves(scene, at, leaves, 7, 0.36, 1.1);
  if (second_row) add_leaves(scene, at, leaves, 4, 0.8, 1.5);
}

void add_books(SceneBuilder& scene, const Placement& at, const Point& inner, int books, int first) {
  // Thickness, height and depth of a book repeat after 5, 7 and 3 books.
  constexpr std::array<double, 5> kThickness = {0.03, 0.045, 0.024, 0.05, 0.035};
  constexpr std::array<double, 7> kHeight = {0.9, 0.72, 0.8, 0.66, 0.85, 0.75, 0.69};
  constexpr std::array<double, 3> kDepth = {0.7, 0.85, 0.6};
  double x = 0.01;
  for (int i = first; i < first + books; ++i) {
    const auto number = static_cast<std::size_t>(i);
    const double next = x + kThickness[number % kThickness.size()];
    assert(next < inner.x());
    const double front = inner.y() * (1 - kDepth[number % kDepth.size()]);
    add_box(scene, at, {x, front, 0}, {next, inner.y() - 0.02, inner.z() * kHeight[number % 7]});
    x = next;
  }
}

void add_picture(SceneBuilder& scene, const Placement& at, double width, double height,
                 Finish finish) {
  if (finish == Finish::kPlain) {
    add_box(scene, at, {0, -0.03, 0}, {width, 0, height});
  } else {
    add_carcass(scene, at.moved(0, -0.04, 0), {width, 0.04, height}, {1, 1, 0.05, 0.02});
  }
}

void add_curtain(SceneBuilder& scene, const Placement& at, double width, double low, double high,
                 int folds) {
  const double step = width / (2 * folds);
  for (int i = 0; i < 2 * folds; ++i) {
    const double y0 = i % 2 == 0 ? 0 : 0.06;
    const double y1 = 0.06 - y0;
    scene.add_face({at(i * step, y0, low), at((i + 1) * step, y1, low),
                    at((i + 1) * step, y1, high), at(i * step, y0, high)});
  }
}

void add_blinds(SceneBuilder& scene, const Placement& at, double width, double low, double high,
                int slats) {
  const double step = (high - low) / slats;
  for (int i = 0; i < slats; ++i) {
    add_slanted_box(scene, at, {0, 0, low + i * step}, {width, 0, 0}, {0, 0.05, 0.03},
                    {0, -0.004, 0.008});
  }
}

void add_radiator(SceneBuilder& scene, const Placement& at, double width, int ribs) {
  add_box(scene, at, {0, 0.03, 0.16}, {width, 0.07, 0.2});
  add_box(scene, at, {0, 0.03, 0.6}, {width, 0.07, 0.64});
  const double step = width / ribs;
  for (int i = 0; i < ribs; ++i) {
    const double x = (i + 0.5) * step;
    add_box(scene, at, {x - 0.02, 0, 0.2}, {x + 0.02, 0.1, 0.6});
  }
}

void add_television(SceneBuilder& scene, const Placement& at, double width) {
  const double half = width / 2;
  add_box(scene, at, {-0.2, -0.1, 0}, {0.2, 0.1, 0.02});
  add_box(scene, at, {-0.03, -0.02, 0.02}, {0.03, 0.02, 0.1});
  add_box(scene, at, {-half, -0.03, 0.1}, {half, 0.03, 0.1 + width * 0.6});
}

void add_place_setting(SceneBuilder& scene, const Placement& at) {
  add_frustum(scene, at, kOctagon, 2, 2, 0, 0.02, Caps::kBoth);
  add_frustum(scene, at.moved(0.17, 0, 0), kHexagon, 1, 1, 0, 0.09, Caps::kBottom);
}

void add_bowl(SceneBuilder& scene, const Placement& at) {
  add_frustum(scene, at, kOctagon, 1, 3, 0, 0.1, Caps::kBottom);
}

}  // namespace viewcover
