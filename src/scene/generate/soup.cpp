#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "scene/error.h"
#include "scene/generate/generated_scene.h"
#include "scene/lattice.h"
#include "scene/random_numbers.h"

namespace viewcover {

namespace {

using Vector = std::array<double, 3>;

constexpr Lattice kLattice{20};
constexpr std::size_t kMostTriangles = 100'000'000;  // still some 200 lattice steps across
constexpr double kLowest = 0.1;                      // nothing below: the region lies at z = 0
constexpr double kCrossings = 3;  // of a vertical line through the cube, expected
constexpr double kLargestRadius = 0.25;
constexpr double kLeastSquare = 0.01;  // shorter vectors are drawn anew: they lose digits

double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// Uniform on the unit sphere: a point of the ball by rejection. Only +, -, *, / and sqrt, which
// IEEE 754 rounds the same everywhere; sine and cosine are not.
Vector direction(RandomNumbers& random) {
  while (true) {
    Vector v{};
    for (double& x : v) x = random.between(-1, 1);
    const double squared = dot(v, v);
    if (squared > 1 || squared < kLeastSquare) continue;
    const double length = std::sqrt(squared);
    for (double& x : v) x /= length;
    return v;
  }
}

// A unit vector perpendicular to the unit vector `n`, uniform in direction.
Vector perpendicular(RandomNumbers& random, const Vector& n) {
  while (true) {
    Vector v = direction(random);
    const double along = dot(v, n);
    for (std::size_t i = 0; i < 3; ++i) v[i] -= along * n[i];
    const double squared = dot(v, v);
    if (squared < kLeastSquare) continue;
    const double length = std::sqrt(squared);
    for (double& x : v) x /= length;
    return v;
  }
}

}  // namespace

GeneratedScene triangle_soup(std::size_t triangles, std::uint64_t seed) {
  if (triangles == 0 || triangles > kMostTriangles) {
    throw InputError("--triangles", fmt::format("{} is out of range", triangles),
                     fmt::format("a number from 1 to {}", kMostTriangles));
  }
  // A triangle of area A in random direction has the mean shadow A/2 on a unit square, so n of
  // them are crossed n A / 2 times; A = 3 sqrt(3) / 4 r^2 for the radius r of the circle round it.
  const double n = static_cast<double>(triangles);
  const double radius =
      std::min(kLargestRadius, std::sqrt(2 * kCrossings / n / (0.75 * std::numbers::sqrt3)));

  GeneratedScene scene;
  scene.title = fmt::format("viewcover soup of {} triangles, seed {}", triangles, seed);
  scene.groups = {"soup"};
  scene.region = {{{0.25, 0.25, 0}, {0.75, 0.25, 0}, {0.75, 0.75, 0}, {0.25, 0.75, 0}}};
  scene.vertices.reserve(3 * triangles);
  scene.faces.reserve(triangles);

  RandomNumbers random(seed);
  // One lattice step more than the radius keeps rounded corners inside too.
  const double margin = radius + kLattice.step();
  for (std::size_t triangle = 0; triangle < triangles; ++triangle) {
    const Vector centre = {random.between(margin, 1 - margin), random.between(margin, 1 - margin),
                           random.between(kLowest + margin, 1 - margin)};
    const Vector normal = direction(random);
    const Vector u = perpendicular(random, normal);
    const Vector w = {normal[1] * u[2] - normal[2] * u[1], normal[2] * u[0] - normal[0] * u[2],
                      normal[0] * u[1] - normal[1] * u[0]};
    std::array<Point, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      const double a = i == 0 ? 1 : -0.5;
      const double b = i == 0 ? 0 : (i == 1 ? 0.5 : -0.5) * std::numbers::sqrt3;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        corners[i][static_cast<int>(axis)] =
            kLattice.round(centre[axis] + radius * (a * u[axis] + b * w[axis]));
      }
    }
    const auto first = static_cast<std::uint32_t>(scene.vertices.size());
    scene.vertices.insert(scene.vertices.end(), corners.begin(), corners.end());
    scene.faces.push_back({{first, first + 1, first + 2}, 0});
  }
  return scene;
}

}  // namespace viewcover
