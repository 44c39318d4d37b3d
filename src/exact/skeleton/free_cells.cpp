#include "exact/skeleton/free_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace viewcover::exact {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The polar form of the Klein form, and a bound on its error.
struct Product {
  double value = 0, bound = 0;

  Product() = default;
  Product(const Approximation<6, double>& x, const Approximation<6, double>& y)
      : bound(LinePool::bound(x.size, x.error, y.size, y.error, LinePool::kUnit)) {
    for (std::size_t k = 0; k < 6; ++k) value += x.x[k] * y.x[(k + 3) % 6];
  }
};

/// The real lines s x + t y between two vectors, rounded: with s = |qy|, t = -+b +- root solves
/// qx s^2 + 2 b s t + qy t^2 = 0.
struct RootsOnFace {
  /// For either sign of the root; none where doubles do not tell.
  std::array<std::optional<Approximation<6, double>>, 2> lines;
  bool may_be_two = true;

  RootsOnFace(const Approximation<6, double>& x, const Approximation<6, double>& y,
              bool x_is_real) {
    constexpr double u = LinePool::kUnit;
    const Product qx = x_is_real ? Product{} : Product(x, x), qy(y, y), b(x, y);
    if (!(std::fabs(qx.value) > qx.bound || x_is_real) || !(std::fabs(qy.value) > qy.bound)) return;
    may_be_two = !x_is_real && (qx.value > 0) == (qy.value > 0);
    const double square = b.value * b.value - qx.value * qy.value;
    const double square_error =
        2 * (2 * std::fabs(b.value) * b.bound + b.bound * b.bound + std::fabs(qx.value) * qy.bound +
             std::fabs(qy.value) * qx.bound + qx.bound * qy.bound +
             4 * u * (b.value * b.value + std::fabs(qx.value * qy.value)));
    if (!(square > 2 * square_error)) return;
    const double root = std::sqrt(square);
    const double s = std::fabs(qy.value), middle = qy.value > 0 ? -b.value : b.value;
    const double t_error = b.bound + square_error / root + 4 * u * (std::fabs(b.value) + root);
    for (const int way : {1, -1}) {
      const double t = middle + way * root;
      Approximation<6, double> line;
      double largest = 0;
      for (std::size_t k = 0; k < 6; ++k) {
        line.x[k] = s * x.x[k] + t * y.x[k];
        largest = std::max(largest, std::fabs(line.x[k]));
      }
      // Components are below 1; twice what the errors of the four factors and roundings add.
      line.error = 2 * (s * x.error + std::fabs(t) * y.error + qy.bound + t_error +
                        4 * u * (s + std::fabs(t)));
      if (!(line.error < largest / 16)) continue;
      int exponent = 0;
      std::frexp(largest, &exponent);
      line.size = 0;
      for (double& component : line.x) {
        component = std::ldexp(component, -exponent);
        line.size += std::fabs(component);
      }
      line.size *= LinePool::kRoundUp;
      line.error = std::ldexp(line.error, -exponent);
      lines[way > 0 ? 0 : 1] = line;
    }
  }
};

std::size_t largest_axis(const Vector3<BigInteger>& v) {
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (CGAL::abs(v[k]) > CGAL::abs(v[axis])) axis = k;
  }
  return axis;
}

}  // namespace

FreeCells::FreeCells(LineArithmetic& arithmetic, const IntegerPlane<BigInteger>& from,
                     const IntegerPlane<BigInteger>& to)
    : arithmetic_(arithmetic) {
  std::size_t place = 0;
  const BigInteger zero(0);
  for (const IntegerPlane<BigInteger>* plane : {&from, &to}) {
    const auto& n = plane->normal;
    const LineVector* below = arithmetic.pool().add(
        Role::kFunctional, LineComponents{n[0], n[1], n[2], zero, zero, zero});
    const std::size_t axis = largest_axis(n);
    for (const std::size_t k : {(axis + 1) % 3, (axis + 2) % 3}) {
      // (normal x m + offset d) / (normal . d)
      LineComponents above;
      above.fill(zero);
      above[k] = plane->offset;
      above[3 + (k + 2) % 3] = n[(k + 1) % 3];
      above[3 + (k + 1) % 3] = -n[(k + 2) % 3];
      places_[place++] = {arithmetic.pool().add(Role::kFunctional, above), below};
    }
  }
}

/// Bounds of the places, in a unit that is the same for all lines.
FreeCells::Box FreeCells::box_of(const Approximation<6, double>& x) const {
  Box box;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    std::array<double, 2> value{}, bound{};
    std::size_t which = 0;
    for (const LineVector* functional : {places_[i].numerator, places_[i].denominator}) {
      const auto& f = functional->approximate();
      for (std::size_t k = 0; k < 6; ++k) value[which] += f.x[k] * x.x[k];
      bound[which++] = LinePool::bound(f.size, f.error, x.size, x.error, LinePool::kUnit);
    }
    if (!(std::fabs(value[1]) > 2 * bound[1])) {
      box.low[i] = -kInfinity;
      box.high[i] = kInfinity;
      continue;
    }
    // |(v + e) / (w + f) - v / w| <= (e + f |v / w|) / (|w| - f), and twice that for roundings.
    const double quotient = value[0] / value[1];
    const double error =
        2 * (bound[0] + (bound[1] + LinePool::kUnit * std::fabs(value[1])) * std::fabs(quotient)) /
        (std::fabs(value[1]) - bound[1]);
    box.low[i] = quotient - error;
    box.high[i] = quotient + error;
  }
  return box;
}

void FreeCells::add(const LineCell& cell) {
  Entry& entry = entries_.emplace_back(Entry{cell, {}, {}});
  entry.box.low.fill(kInfinity);
  entry.box.high.fill(-kInfinity);
  for (const LineVector* ray : cell.rays()) {
    // A sum of rays has the quotient of sums of numerators and of denominators, all of one sign.
    const Box box = box_of(ray->approximate());
    for (std::size_t i = 0; i < places_.size(); ++i) {
      entry.box.low[i] = std::min(entry.box.low[i], box.low[i]);
      entry.box.high[i] = std::max(entry.box.high[i], box.high[i]);
    }
  }
  for (std::size_t f = 0; f < cell.facets().size(); ++f) {
    int& sign = entry.facet_signs.emplace_back(0);
    for (std::size_t i = 0; i < cell.size() && cell.facets()[f] != nullptr && sign == 0; ++i) {
      if (cell.is_tight(i, f)) continue;
      sign = arithmetic_.pool().sign_of_product(*cell.facets()[f], *cell.ray(i));
    }
  }
}

bool FreeCells::is_limit(const StabbingLine& line) {
  const Box box = box_of(line.approximate);
  return std::any_of(entries_.begin(), entries_.end(), [&](const Entry& entry) {
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (box.high[i] < entry.box.low[i] || box.low[i] > entry.box.high[i]) return false;
    }
    return is_limit_in(line, entry);
  });
}

bool FreeCells::is_limit_in(const StabbingLine& line, const Entry& entry) {
  const LineCell& cell = entry.cell;
  for (std::size_t f = 0; f < cell.facets().size(); ++f) {
    const int sign = entry.facet_signs[f];
    if (sign != 0 && arithmetic_.sign(line, *cell.facets()[f]) == -sign) return false;
  }
  bool positive = false, negative = false;
  std::vector<std::size_t> zeros;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    const int side = arithmetic_.side(line, *cell.ray(i));
    positive |= side > 0;
    negative |= side < 0;
    if (positive && negative) return true;
    if (side == 0) zeros.push_back(i);
  }
  LineCell face;
  std::vector<std::size_t> facets, places;
  for (std::size_t f = 0; f < cell.facets().size(); ++f) {
    if (cell.facets()[f] == nullptr) continue;
    facets.push_back(f);
    places.push_back(face.add_facet(cell.facets()[f]));
  }
  for (const std::size_t i : zeros) {
    const std::size_t ray = face.add_ray(cell.ray(i));
    for (std::size_t f = 0; f < facets.size(); ++f) {
      if (cell.is_tight(i, facets[f])) face.set_tight(ray, places[f]);
    }
  }
  return takes_sign(arithmetic_.pool(), face, positive ? -1 : 1);
}

void FreeCells::visit_extremal(const Filter& may_matter, const Visitor& visit) {
  LinePool& pool = arithmetic_.pool();
  // Cells share faces, by the addresses of their rays.
  std::set<std::array<const LineVector*, 2>> seen;
  for (const Entry& entry : entries_) {
    const LineCell& cell = entry.cell;
    const std::size_t n = cell.size();
    std::vector<int> forms(n);
    for (std::size_t i = 0; i < n; ++i) {
      const LineVector* const ray = cell.ray(i);
      forms[i] = pool.sign_of_polar_form(*ray, *ray);
      if (forms[i] == 0 && seen.insert({ray, ray}).second)
        visit(arithmetic_.line(pool.exact(*ray)));
    }
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        // With x, y > 0 the form is qi x^2 + 2 b x y + qj y^2.
        if (forms[i] == 0 && forms[j] == 0) continue;
        if (forms[i] * forms[j] >= 0) {
          const int b = pool.sign_of_polar_form(*cell.ray(i), *cell.ray(j));
          if (b * (forms[i] + forms[j]) >= 0) continue;
        }
        if (!cell.are_adjacent(i, j)) continue;
        const LineVector *x = cell.ray(i), *y = cell.ray(j);
        if (forms[j] == 0 || (forms[i] != 0 && std::less<>()(y, x))) std::swap(x, y);
        if (!seen.insert({x, y}).second) continue;
        visit_face(*x, *y, forms[i] == 0 || forms[j] == 0, may_matter, visit);
      }
    }
  }
}

/// The pool makes do with rough doubles.
const Approximation<6, double>& FreeCells::precise(const LineVector& ray) {
  if (ray.approximate().error <= 4 * LinePool::kUnit) return ray.approximate();
  const auto [place, is_new] = precise_.try_emplace(&ray);
  if (is_new) place->second = arithmetic_.approximate(arithmetic_.pool().exact(ray));
  return place->second;
}

/// Where the face of two adjacent rays meets the quadric; if an end is real, it is x.
void FreeCells::visit_face(const LineVector& x, const LineVector& y, bool x_is_real,
                           const Filter& may_matter, const Visitor& visit) {
  const RootsOnFace rounded(precise(x), precise(y), x_is_real);
  // The greater t is positive; the other one is if both ends have one strict sign.
  std::array<bool, 2> wanted = {true, !x_is_real && rounded.may_be_two};
  for (std::size_t i = 0; i < 2; ++i) {
    if (wanted[i] && rounded.lines[i]) wanted[i] = may_matter(*rounded.lines[i]);
  }
  if (!wanted[0] && !wanted[1]) return;

  LinePool& pool = arithmetic_.pool();
  const BigInteger qx = pool.exact_product<3>(x, x), qy = pool.exact_product<3>(y, y),
                   b = pool.exact_product<3>(x, y);
  const BigInteger square = b * b - qx * qy;
  if (sign(square) < 0) return;
  const int way = sign(qy);
  const auto &rx = pool.exact(x), &ry = pool.exact(y);
  LineComponents rational, root = ry;
  for (std::size_t i = 0; i < 6; ++i) {
    rational[i] = way > 0 ? qy * rx[i] - b * ry[i] : b * ry[i] - qy * rx[i];
  }
  if (wanted[0]) visit(arithmetic_.line(rational, root, square));
  if (!wanted[1] || sign(square) == 0 || sign(qx) != way) return;
  for (BigInteger& component : root) component = -component;
  visit(arithmetic_.line(rational, root, square));
}

}  // namespace viewcover::exact
