#include "scene/generate/solids.h"

#include <algorithm>
#include <vector>

namespace viewcover {

namespace {

// Left and lower edges of the compartments: n openings between n + 1 boards. The rest of the
// width that rounding leaves goes to the last board, so that openings are equal.
double opening(double extent, double frame, int count) {
  return Placement::rounded((extent - frame * (count + 1)) / count);
}
double opening_start(double extent, double frame, int count, int index) {
  return Placement::rounded(frame) +
         index * (opening(extent, frame, count) + Placement::rounded(frame));
}

// Rectangle of the frame parallel to the x-z plane, facing the front (-y).
void add_front(SceneBuilder& scene, const Placement& at, double y, double x0, double x1, double z0,
               double z1) {
  scene.add_face({at(x0, y, z0), at(x1, y, z0), at(x1, y, z1), at(x0, y, z1)});
}

}  // namespace

void add_box(SceneBuilder& scene, const Placement& at, const Point& low, const Point& high) {
  const auto rounded = [](const Point& p) -> Point {
    return {Placement::rounded(p.x()), Placement::rounded(p.y()), Placement::rounded(p.z())};
  };
  const Point size = rounded(high) - rounded(low);
  add_slanted_box(scene, at, low, {size.x(), 0, 0}, {0, size.y(), 0}, {0, 0, size.z()});
}

void add_slanted_box(SceneBuilder& scene, const Placement& at, const Point& low, const Point& a,
                     const Point& b, const Point& c) {
  const Point origin = at(low);
  const Point zero = at(0, 0, 0);
  const Point da = at(a) - zero;
  const Point db = at(b) - zero;
  const Point dc = at(c) - zero;
  const auto corner = [&](int i, int j, int k) -> Point {
    return origin + i * da + j * db + k * dc;
  };
  scene.add_face({corner(0, 0, 0), corner(0, 1, 0), corner(1, 1, 0), corner(1, 0, 0)});
  scene.add_face({corner(0, 0, 1), corner(1, 0, 1), corner(1, 1, 1), corner(0, 1, 1)});
  scene.add_face({corner(0, 0, 0), corner(1, 0, 0), corner(1, 0, 1), corner(0, 0, 1)});
  scene.add_face({corner(1, 1, 0), corner(0, 1, 0), corner(0, 1, 1), corner(1, 1, 1)});
  scene.add_face({corner(0, 1, 0), corner(0, 0, 0), corner(0, 0, 1), corner(0, 1, 1)});
  scene.add_face({corner(1, 0, 0), corner(1, 1, 0), corner(1, 1, 1), corner(1, 0, 1)});
}

void add_frustum(SceneBuilder& scene, const Placement& at, Ring ring, int bottom, int top,
                 double low, double high, Caps caps) {
  const auto corner = [&](std::size_t i, int scale, double z) {
    const auto& [x, y] = ring[i % ring.size()];
    return at(x * scale * kRingUnit, y * scale * kRingUnit, z);
  };
  std::vector<Point> floor;
  std::vector<Point> ceiling;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    scene.add_face({corner(i, bottom, low), corner(i + 1, bottom, low), corner(i + 1, top, high),
                    corner(i, top, high)});
    floor.push_back(corner(i, bottom, low));
    ceiling.push_back(corner(i, top, high));
  }
  std::reverse(floor.begin(), floor.end());
  if (caps != Caps::kNone) scene.add_face(floor);
  if (caps == Caps::kBoth) scene.add_face(ceiling);
}

void add_carcass(SceneBuilder& scene, const Placement& at, const Point& size,
                 const Compartments& compartments) {
  const double w = size.x();
  const double d = size.y();
  const double h = size.z();
  scene.add_face({at(0, 0, 0), at(0, d, 0), at(w, d, 0), at(w, 0, 0)});
  scene.add_face({at(0, 0, h), at(w, 0, h), at(w, d, h), at(0, d, h)});
  scene.add_face({at(w, d, 0), at(0, d, 0), at(0, d, h), at(w, d, h)});
  scene.add_face({at(0, d, 0), at(0, 0, 0), at(0, 0, h), at(0, d, h)});
  scene.add_face({at(w, 0, 0), at(w, d, 0), at(w, d, h), at(w, 0, h)});

  const double frame = compartments.frame;
  const int columns = compartments.columns;
  const int rows = compartments.rows;
  const double cell_width = opening(w, frame, columns);
  const double cell_height = opening(h, frame, rows);
  const auto left = [&](int column) { return opening_start(w, frame, columns, column); };
  const auto lower = [&](int row) { return opening_start(h, frame, rows, row); };

  for (int column = 0; column <= columns; ++column) {  // stiles
    const double from = column == 0 ? 0 : left(column - 1) + cell_width;
    add_front(scene, at, 0, from, column == columns ? w : left(column), 0, h);
  }
  for (int column = 0; column < columns; ++column) {
    const double x0 = left(column);
    const double x1 = x0 + cell_width;
    for (int row = 0; row <= rows; ++row) {  // rails
      const double from = row == 0 ? 0 : lower(row - 1) + cell_height;
      add_front(scene, at, 0, x0, x1, from, row == rows ? h : lower(row));
    }
    for (int row = 0; row < rows; ++row) {
      const double z0 = lower(row);
      const double z1 = z0 + cell_height;
      const double y = compartments.depth;
      add_front(scene, at, y, x0, x1, z0, z1);
      scene.add_face({at(x0, 0, z0), at(x1, 0, z0), at(x1, y, z0), at(x0, y, z0)});
      scene.add_face({at(x0, 0, z1), at(x0, y, z1), at(x1, y, z1), at(x1, 0, z1)});
      scene.add_face({at(x0, 0, z0), at(x0, y, z0), at(x0, y, z1), at(x0, 0, z1)});
      scene.add_face({at(x1, 0, z0), at(x1, 0, z1), at(x1, y, z1), at(x1, y, z0)});
    }
  }
}

Placement compartment(const Placement& carcass, const Point& size, const Compartments& compartments,
                      int column, int row, Point& inner) {
  inner = {opening(size.x(), compartments.frame, compartments.columns), compartments.depth,
           opening(size.z(), compartments.frame, compartments.rows)};
  return carcass.moved(opening_start(size.x(), compartments.frame, compartments.columns, column), 0,
                       opening_start(size.z(), compartments.frame, compartments.rows, row));
}

}  // namespace viewcover
