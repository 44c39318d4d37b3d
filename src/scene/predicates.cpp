#include "scene/predicates.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace viewcover {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

constexpr double kUnitRoundoff = std::numeric_limits<double>::epsilon() / 2;

// Shewchuk 1997, section 4.3: with rounded differences and the determinant expanded along one row,
// |computed - true| <= (7 + 56 u) u * permanent for orient3d and (3 + 16 u) u * permanent for
// orient2d, where `permanent` is the same expression with absolute values, rounded.
constexpr double kOrientationBound = (7 + 56 * kUnitRoundoff) * kUnitRoundoff;
constexpr double kTurnBound = (3 + 16 * kUnitRoundoff) * kUnitRoundoff;

__extension__ using Wide = __int128;

constexpr int sign(auto x) { return (x > 0) - (x < 0); }

// x = a - b, if that is exact.
bool exact_difference(double a, double b, double& x) {
  x = a - b;
  const double b_virtual = a - x;
  const double a_virtual = x + b_virtual;
  return (b_virtual - b) + (a - a_virtual) == 0;
}

// The values as integers below 2^Bits times a common power of two; none if they are not.
template <int Bits, std::size_t N>
std::optional<std::array<std::int64_t, N>> as_integers(const std::array<double, N>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::fabs(value));
  // largest < 2^(biased - 1022); the scale 2^(Bits + 1022 - biased) must be a normal number.
  const auto biased = static_cast<int>(std::bit_cast<std::uint64_t>(largest) >> 52);
  const int scale_biased = Bits + 1022 - biased + 1023;
  if (scale_biased < 1 || scale_biased > 2046) return std::nullopt;
  const double scale = std::bit_cast<double>(static_cast<std::uint64_t>(scale_biased) << 52);
  std::array<std::int64_t, N> integers;
  for (std::size_t i = 0; i < N; ++i) {
    const double scaled = values[i] * scale;
    integers[i] = static_cast<std::int64_t>(scaled);
    if (static_cast<double>(integers[i]) != scaled) return std::nullopt;
  }
  return integers;
}

// Six products of three 41-bit factors: |sum| < 6 * 2^123 < 2^127.
std::optional<int> integer_orientation(const std::array<double, 9>& m) {
  const auto integers = as_integers<41>(m);
  if (!integers) return std::nullopt;
  const auto& [bx, by, bz, cx, cy, cz, dx, dy, dz] = *integers;
  const Wide x = Wide(by) * cz - Wide(bz) * cy;
  const Wide y = Wide(bz) * cx - Wide(bx) * cz;
  const Wide z = Wide(bx) * cy - Wide(by) * cx;
  return sign(x * dx + y * dy + z * dz);
}

Kernel::Point_3 to_cgal(const Point& p) { return {p.x(), p.y(), p.z()}; }

// For the few calls that the filter leaves open.
int exact_orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  std::array<double, 9> m;
  bool exact = true;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    exact = exact && exact_difference(b[i], a[i], m[k]) && exact_difference(c[i], a[i], m[3 + k]) &&
            exact_difference(d[i], a[i], m[6 + k]);
  }
  if (exact) {
    if (const auto known = integer_orientation(m)) return *known;
  }
  return static_cast<int>(CGAL::orientation(to_cgal(a), to_cgal(b), to_cgal(c), to_cgal(d)));
}

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  // det(b - a, c - a, d - a) = ((d - c) x (b - a)) . (c - a): with edges ab and cd as rows,
  // parallel edges along an axis give products that are exactly 0.
  const double ux = d.x() - c.x(), uy = d.y() - c.y(), uz = d.z() - c.z();
  const double vx = b.x() - a.x(), vy = b.y() - a.y(), vz = b.z() - a.z();
  const double wx = c.x() - a.x(), wy = c.y() - a.y(), wz = c.z() - a.z();
  const double uyvz = uy * vz, uzvy = uz * vy;
  const double uzvx = uz * vx, uxvz = ux * vz;
  const double uxvy = ux * vy, uyvx = uy * vx;
  const double det = (uyvz - uzvy) * wx + (uzvx - uxvz) * wy + (uxvy - uyvx) * wz;
  const double permanent = (std::fabs(uyvz) + std::fabs(uzvy)) * std::fabs(wx) +
                           (std::fabs(uzvx) + std::fabs(uxvz)) * std::fabs(wy) +
                           (std::fabs(uxvy) + std::fabs(uyvx)) * std::fabs(wz);
  const double bound = kOrientationBound * permanent;
  if (det > bound) return 1;
  if (det < -bound) return -1;
  if (permanent == 0) return 0;  // every product has a factor that is exactly 0
  return exact_orientation(a, b, c, d);
}

int turn(const Point& a, const Point& b, const Point& c, int axis) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const double left = (b[u] - a[u]) * (c[v] - a[v]);
  const double right = (b[v] - a[v]) * (c[u] - a[u]);
  const double det = left - right;
  const double permanent = std::fabs(left) + std::fabs(right);
  const double bound = kTurnBound * permanent;
  if (det > bound) return 1;
  if (det < -bound) return -1;
  if (permanent == 0) return 0;
  return static_cast<int>(CGAL::orientation(
      Kernel::Point_2(a[u], a[v]), Kernel::Point_2(b[u], b[v]), Kernel::Point_2(c[u], c[v])));
}

bool are_collinear(const Point& a, const Point& b, const Point& c) {
  return turn(a, b, c, 0) == 0 && turn(a, b, c, 1) == 0 && turn(a, b, c, 2) == 0;
}

}  // namespace viewcover
