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
constexpr double kRegionHeight = 0.5;
constexpr double kFree = 0.05;                 // nothing nearer to the region's plane
constexpr double kRadiusTimesCubeRoot = 0.68;  // 3 crossings of a line through 1,000 triangles
constexpr double kLargestRadius = 0.2;         // leaves room above and below the region
constexpr double kLeastSquare = 0.01;          // shorter vectors are drawn anew: they lose digits

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

// By Newton's method from above: std::cbrt may differ between platforms. Requires x >= 1.
double cube_root(double x) {
  double root = x;
  for (double last = root + 1; root < last;) {
    last = root;
    root = (2 * root + x / (root * root)) / 3;
  }
  return root;
}

}  // namespace

GeneratedScene triangle_soup(std::size_t triangles, std::uint64_t seed) {
  if (triangles == 0 || triangles > kMostTriangles) {
    throw InputError("--triangles", fmt::format("{} is out of range", triangles),
                     fmt::format("a number from 1 to {}", kMostTriangles));
  }
  const double radius =
      std::min(kLargestRadius, kRadiusTimesCubeRoot / cube_root(static_cast<double>(triangles)));

  GeneratedScene scene;
  scene.title = fmt::format("viewcover soup of {} triangles, seed {}", triangles, seed);
  scene.groups = {"soup"};
  scene.region = {{{0.375, 0.375, kRegionHeight},
                   {0.625, 0.375, kRegionHeight},
                   {0.625, 0.625, kRegionHeight},
                   {0.375, 0.625, kRegionHeight}}};
  scene.vertices.reserve(3 * triangles);
  scene.faces.reserve(triangles);

  RandomNumbers random(seed);
  // One lattice step more than the radius keeps rounded corners inside too.
  const double margin = radius + kLattice.step();
  for (std::size_t triangle = 0; triangle < triangles; ++triangle) {
    Vector centre = {random.between(margin, 1 - margin), random.between(margin, 1 - margin),
                     random.between(margin, 1 - 2 * kFree - 3 * margin)};
    // Above the region, that much is skipped.
    if (centre[2] > kRegionHeight - kFree - margin) centre[2] += 2 * (kFree + margin);
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
