#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "exact/sight_query.h"
#include "scene/convex_polygon.h"
#include "support/second_opinion/space.h"

// Is E visible from R? Decided in the plane of R: no lines as points, no cells of lines.
//
// From a point p of R off the occluders' planes an occluder T hides the cone over it: the q of
// plane(E) on the inner side of each plane through p and an edge of T. On plane(E) these are lines
// whose coefficients are affine in p = (x, y). Subtracting cone after cone from E leaves nothing of
// positive area (E is hidden from p) or something (then a neighbourhood of (p, q) is free: visible,
// proved). Occluders count where they are strictly on E's side of plane(R) and on R's side of
// plane(E); R and E are cut by each other's plane first, and each pair of parts is decided alone.
//
// Certificate. If E is hidden from p, every piece left over by the subtraction has been found empty
// because a line t >= 0 on it although t < 0 there by construction. By Farkas two sides a, b of the
// piece prove it: D(a,b) t = D(t,b) a + D(a,t) b + M(a,b,t), where D, M are the 2x2 and 3x3
// determinants of the lines' coefficients and all four have the same sign. D and M are polynomials
// in p of degree <= 2 (M once the factor "height of p over plane(E)" is divided out). So E is
// hidden from every point of R that is joined to p without crossing a zero of their irreducible
// factors, common factors left out, nor of the planes of the occluders used.
//
// Sweep (a cylindrical algebraic covering, see Abraham, Davenport, England and Kremer 2021, with
// open cells only). On the vertical line x = x0 a certificate at y0 holds between the next zeros of
// its curves below and above. Repeating this in the gaps covers the line. The covering stays valid
// for all x around x0 up to the next zero of (1) discriminant and leading coefficient of each curve
// that bounds an interval, (2) the discriminant of every other curve of its certificate and the
// resultants of that curve with the two bounding ones, (3) the resultant of the two bounding curves
// of an interval and of those of neighbours in the covering. Proof: up to there bounds are
// continuous and never meet or pass each other; a curve enters the interval only across a bound,
// a zero of (2), or as a new double root, a zero of its discriminant. Repeating this in the gaps
// covers R.
//
// Complete: "hidden" leaves out finitely many x and, for every other x, finitely many y; the free
// set is open, hence empty. Terminates: each sample settles a cell of the finite arrangement of all
// possible curves. Factors are irreducible over the rationals, so that different ones are coprime
// and no resultant or discriminant is identically zero. A sample at which some polynomial is zero
// is replaced by another.

namespace viewcover::testing::second_opinion {

/// One side of plane(R) and one side of plane(E).
template <class N>
class Sweep {
 public:
  /// `from`, the part of R on the side `side_e` of plane(E), has an area; E has points on the side
  /// `side_r` of plane(R).
  Sweep(const Plane<N>& plane_r, const Corners<N>& from, const Plane<N>& plane_e,
        const Corners<N>& element, const std::vector<Corners<N>>& occluders, int side_r, int side_e)
      : plane_r_(plane_r), plane_e_(plane_e) {
    set_region(from);
    height_ = plane_r.restricted_height_over(plane_e);
    if (side_e < 0) height_ = {-height_.x, -height_.y, -height_.c};
    set_element(element, side_r);
    for (const Corners<N>& occluder : occluders) add_occluder(occluder, side_r, side_e);
  }

  bool sees() {
    if (element_.size() < 3) return false;
    if (try_some_points()) return true;
    std::vector<std::pair<RealRoot<N>, RealRoot<N>>> gaps = {
        {RealRoot<N>::rational(low_x_), RealRoot<N>::rational(high_x_)}};
    while (!gaps.empty()) {
      auto [low, high] = std::move(gaps.back());
      gaps.pop_back();
      if (compare(low, high) >= 0) continue;
      if (sees_between(low, high, gaps)) return true;
    }
    return false;
  }

  std::size_t points = 0;  ///< of R looked from
  std::size_t lines = 0;   ///< x = constant

 private:
  enum class Look { kSeen, kHidden, kDegenerate };

  /// A line of plane(E), >= 0 where it may hide; coefficients of first, second axis and 1.
  struct Line {
    std::array<Affine<N>, 3> coefficients;
    int blocker = -1;  ///< whose side of p gives the line's sign; none for E's own
    bool moves = false;
  };
  struct Blocker {
    Affine<N> side;  ///< > 0 for p where its lines have the right sign
    int fixed_sign = 0;
    int curve = -1;
    std::vector<int> lines;
  };
  struct Curve {
    Conic<N> f;
    std::array<double, 6> approximate{};
    bool has_y = false, has_yy = false;
    bool crosses_region = true;
  };
  /// Signed lines, twice the line plus 1 if it is turned, counter-clockwise round the cell.
  using Cell = std::vector<int>;
  struct Bound {
    QuadraticRoot<N> root;
    int curve = -1, branch = 0;
    bool same_branch(const Bound& other) const {
      return curve == other.curve && branch == other.branch;
    }
  };
  struct Interval {
    Bound low, high;
    std::vector<int> curves;  ///< of the proof that E is hidden from it
  };
  /// Of the points of R with one x: neighbours overlap or share a bound.
  struct Cover {
    Bound bottom, top;  ///< where R ends
    std::vector<Interval> intervals;
  };

  // ---- set-up

  void set_region(const Corners<N>& from) {
    std::vector<std::array<N, 2>> corners;
    for (const Vector<N>& v : from) corners.push_back({v[plane_r_.first], v[plane_r_.second]});
    region_ = turned_left(std::move(corners));
    low_x_ = high_x_ = region_[0][0];
    low_y_ = high_y_ = region_[0][1];
    for (std::size_t i = 0; i < region_.size(); ++i) {
      const auto &a = region_[i], &b = region_[(i + 1) % region_.size()];
      low_x_ = std::min(low_x_, a[0]);
      high_x_ = std::max(high_x_, a[0]);
      low_y_ = std::min(low_y_, a[1]);
      high_y_ = std::max(high_y_, a[1]);
      if (a[0] == b[0]) continue;
      (a[0] < b[0] ? floor_ : ceiling_).push_back(curve_of(conic_of(line_through(a, b))));
    }
  }

  static std::vector<std::array<N, 2>> turned_left(std::vector<std::array<N, 2>> polygon) {
    N twice_area{};
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const auto &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      twice_area += a[0] * b[1] - a[1] * b[0];
    }
    if (twice_area < 0) std::reverse(polygon.begin(), polygon.end());
    return polygon;
  }

  /// >= 0 on the left of ab
  static Affine<N> line_through(const std::array<N, 2>& a, const std::array<N, 2>& b) {
    return {a[1] - b[1], b[0] - a[0], a[0] * b[1] - a[1] * b[0]};
  }

  int add_line(std::array<Affine<N>, 3> coefficients, int blocker) {
    std::array<N, 9> all;
    for (std::size_t i = 0; i < 3; ++i) {
      all[3 * i] = coefficients[i].x;
      all[3 * i + 1] = coefficients[i].y;
      all[3 * i + 2] = coefficients[i].c;
    }
    Numbers<N>::reduce(all);
    Line line;
    for (std::size_t i = 0; i < 3; ++i) {
      line.coefficients[i] = {all[3 * i], all[3 * i + 1], all[3 * i + 2]};
      line.moves = line.moves || !line.coefficients[i].is_constant();
    }
    line.blocker = blocker;
    lines_.push_back(std::move(line));
    return static_cast<int>(lines_.size()) - 1;
  }

  int add_fixed_line(const Affine<N>& line, int blocker) {
    return add_line({Affine<N>{0, 0, line.x}, Affine<N>{0, 0, line.y}, Affine<N>{0, 0, line.c}},
                    blocker);
  }

  void set_element(const Corners<N>& element, int side_r) {
    std::vector<std::array<N, 2>> corners;
    bool cut = false;
    for (const Vector<N>& v : element) {
      corners.push_back({v[plane_e_.first], v[plane_e_.second]});
      cut = cut || sign_of(plane_r_.height(v)) * side_r < 0;
    }
    corners = turned_left(std::move(corners));
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const auto line = line_through(corners[i], corners[(i + 1) % corners.size()]);
      element_.push_back(2 * add_fixed_line(line, -1));
    }
    if (!cut) return;
    Affine<N> height = plane_e_.restricted_height_over(plane_r_);
    if (side_r < 0) height = {-height.x, -height.y, -height.c};
    const int line = 2 * add_fixed_line(height, -1);
    set_point(region_[0][0], region_[0][1]);
    element_ = clipped(element_, line, signs_at_corners(element_, line));
  }

  void add_occluder(const Corners<N>& corners, int side_r, int side_e) {
    const Plane<N> plane(corners);
    const auto in_plane = [&](const Plane<N>& other) {
      return std::ranges::all_of(corners,
                                 [&](const Vector<N>& v) { return sign_of(other.height(v)) == 0; });
    };
    if (in_plane(plane_r_) || in_plane(plane_e_)) return;
    if (!has_area(part_above(part_above(corners, plane_r_, side_r), plane_e_, side_e))) return;
    const int id = static_cast<int>(blockers_.size());
    Blocker blocker;
    blocker.side = plane_r_.restricted_height_over(plane);
    std::array<bool, 2> seen{};
    for (const auto& corner : region_) {
      const int sign = sign_of(blocker.side.at(corner[0], corner[1]));
      if (sign != 0) seen[sign > 0] = true;
    }
    if (seen[0] != seen[1]) {
      blocker.fixed_sign = seen[1] ? 1 : -1;
    } else {
      blocker.curve = curve_of(conic_of(blocker.side));
    }
    // What can hide is the part of the occluder strictly on both sides. Other edges do not bound
    // it; plane(E) does where it cuts; plane(R) need not be a side as all of E is beyond it.
    bool reaches_element = false;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vector<N>&a = corners[i], &b = corners[(i + 1) % corners.size()];
      const auto below = [&](const Plane<N>& other, int side) {
        return sign_of(other.height(a)) * side <= 0 && sign_of(other.height(b)) * side <= 0;
      };
      reaches_element =
          reaches_element || sign_of(plane_e_.height(a)) * side_e < 0 || below(plane_e_, side_e);
      if (below(plane_r_, side_r) || below(plane_e_, side_e)) continue;
      blocker.lines.push_back(2 * add_line(edge_shadow(a, b), id));
    }
    if (reaches_element) {
      const Affine<N> height = plane_e_.restricted_height_over(plane);
      blocker.lines.push_back(2 * add_fixed_line({-height.x, -height.y, -height.c}, id));
    }
    blockers_.push_back(std::move(blocker));
  }

  /// The plane through p and ab where it meets plane(E); >= 0 on the inner side for p in front.
  std::array<Affine<N>, 3> edge_shadow(const Vector<N>& a, const Vector<N>& b) const {
    // (b - p) x (a - p) = m + p x c is the normal, -m . p the constant
    const Vector<N> m = cross(b, a), c = minus(b, a);
    const N zero{};
    const std::array<Affine<N>, 4> plane = {
        plane_r_.restricted({zero, c[2], N(-c[1])}, m[0]),
        plane_r_.restricted({N(-c[2]), zero, c[0]}, m[1]),
        plane_r_.restricted({c[1], N(-c[0]), zero}, m[2]),
        plane_r_.restricted({N(-m[0]), N(-m[1]), N(-m[2])}, zero)};
    std::array<Affine<N>, 3> line;
    for (N Affine<N>::*part : {&Affine<N>::x, &Affine<N>::y, &Affine<N>::c}) {
      const Affine<N> on_element =
          plane_e_.restricted({plane[0].*part, plane[1].*part, plane[2].*part}, plane[3].*part);
      line[0].*part = on_element.x;
      line[1].*part = on_element.y;
      line[2].*part = on_element.c;
    }
    return line;
  }

  // ---- curves in the plane of R

  int curve_of(Conic<N> f) {
    Numbers<N>::reduce(f);
    const auto lead = std::ranges::find_if(f, [](const N& c) { return sign_of(c) != 0; });
    if (lead != f.end() && *lead < 0) {
      for (N& c : f) c = -c;
    }
    const auto [place, is_new] = curve_ids_.emplace(f, static_cast<int>(curves_.size()));
    if (is_new) {
      Curve curve;
      curve.f = f;
      for (std::size_t i = 0; i < 6; ++i) curve.approximate[i] = Numbers<N>::approximate(f[i]);
      curve.has_yy = sign_of(f[5]) != 0;
      curve.has_y = curve.has_yy || sign_of(f[2]) != 0 || sign_of(f[4]) != 0;
      curve.crosses_region = may_cross_region(f);
      curves_.push_back(std::move(curve));
    }
    return place->second;
  }

  /// False only if f >= 0 on all of R or f <= 0: by Bernstein coefficients on a fan of triangles.
  bool may_cross_region(const Conic<N>& f) const {
    std::array<bool, 2> seen{};
    const auto look = [&](std::size_t i, std::size_t j) {
      const auto &p = region_[i], &q = region_[j];
      const N polar = 2 * f[0] + f[1] * (p[0] + q[0]) + f[2] * (p[1] + q[1]) +
                      2 * f[3] * p[0] * q[0] + f[4] * (p[0] * q[1] + p[1] * q[0]) +
                      2 * f[5] * p[1] * q[1];
      const int sign = sign_of(polar);
      if (sign != 0) seen[sign > 0] = true;
    };
    for (std::size_t i = 0; i < region_.size(); ++i) {
      look(i, i);
      look(i, (i + 1) % region_.size());
      look(0, i);
    }
    return seen[0] && seen[1];
  }

  int sign_at(const Curve& curve, const N& x, const N& y, double dx, double dy) const {
    if constexpr (Numbers<N>::kExact) {
      const std::array<double, 6> terms = {
          curve.approximate[0],           curve.approximate[1] * dx,
          curve.approximate[2] * dy,      curve.approximate[3] * dx * dx,
          curve.approximate[4] * dx * dy, curve.approximate[5] * dy * dy};
      double sum = 0, size = 0;
      for (const double term : terms) {
        sum += term;
        size += std::abs(term);
      }
      if (std::abs(sum) > 32 * kRounding * size) return sum > 0 ? 1 : -1;
    }
    return sign_of(curve.f.at(x, y));
  }

  const Conic<N>& two_lines(int a, int b) {
    const auto [place, is_new] = two_lines_.try_emplace({a, b});
    if (is_new) {
      place->second = {};
      place->second.add(lines_[a].coefficients[0], lines_[b].coefficients[1], 1);
      place->second.add(lines_[a].coefficients[1], lines_[b].coefficients[0], -1);
    }
    return place->second;
  }

  /// Their determinant for a < b < c, divided by the height of p over plane(E) if all move.
  const Conic<N>& three_lines(int a, int b, int c) {
    const auto [place, is_new] = three_lines_.try_emplace({a, b, c});
    if (is_new) {
      Cubic<N> sum{};
      const std::array<int, 3> ids = {a, b, c};
      for (std::size_t k = 0; k < 3; ++k) {
        const Line &u = lines_[ids[(k + 1) % 3]], &v = lines_[ids[(k + 2) % 3]];
        Conic<N> minor{};
        minor.add(u.coefficients[0], v.coefficients[1], 1);
        minor.add(u.coefficients[1], v.coefficients[0], -1);
        sum.add(minor, lines_[ids[k]].coefficients[2]);
      }
      if (lines_[a].moves && lines_[b].moves && lines_[c].moves) {
        place->second = sum.over(height_);
      } else {
        std::copy_n(sum.begin(), 6, place->second.begin());
      }
    }
    return place->second;
  }

  struct ProofCurves {
    std::vector<int> bounding;  ///< where the signs may stop being equal
    std::vector<int> all;       ///< where one of the signs is zero
  };

  /// Of the Farkas proof with these three lines.
  const ProofCurves& curves_of_proof(int a, int b, int c) {
    std::array<int, 3> ids = {a, b, c};
    std::ranges::sort(ids);
    const auto [place, is_new] = curves_of_proof_.try_emplace({ids[0], ids[1], ids[2]});
    if (is_new) {
      ProofCurves& curves = place->second;
      std::vector<std::vector<int>> changing_sign;
      for (const Conic<N>* f : {&two_lines(ids[0], ids[1]), &two_lines(ids[1], ids[2]),
                                &two_lines(ids[0], ids[2]), &three_lines(ids[0], ids[1], ids[2])}) {
        if (f->is_zero()) continue;
        changing_sign.emplace_back();
        const Factors<N> factors = irreducible_factors(*f);
        for (const Conic<N>& factor : factors.factors) {
          curves.all.push_back(curve_of(factor));
          if (!factors.is_square) changing_sign.back().push_back(curves.all.back());
        }
      }
      for (const auto& one : changing_sign) {
        for (const int id : one) {
          const bool changes_all = std::ranges::all_of(
              changing_sign, [&](const auto& other) { return std::ranges::count(other, id) > 0; });
          if (!changes_all) curves.bounding.push_back(id);
        }
      }
      make_set(curves.bounding);
      make_set(curves.all);
    }
    return place->second;
  }

  template <class T>
  static void make_set(std::vector<T>& values) {
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
  }

  // ---- from a point

  struct Approximate {
    std::array<double, 3> value, size;
  };

  bool set_point(const N& x, const N& y) {
    x_ = x;
    y_ = y;
    dx_ = Numbers<N>::approximate(x);
    dy_ = Numbers<N>::approximate(y);
    blocker_signs_.clear();
    for (const Blocker& blocker : blockers_) {
      const int sign =
          blocker.fixed_sign != 0 ? blocker.fixed_sign : sign_of(blocker.side.at(x, y));
      if (sign == 0) return false;
      blocker_signs_.push_back(sign);
    }
    approximate_.resize(lines_.size());
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Affine<N>& c = lines_[i].coefficients[k];
        const double px = Numbers<N>::approximate(c.x) * dx_,
                     py = Numbers<N>::approximate(c.y) * dy_, pc = Numbers<N>::approximate(c.c);
        approximate_[i].value[k] = px + py + pc;
        approximate_[i].size[k] = std::abs(px) + std::abs(py) + std::abs(pc);
      }
    }
    return true;
  }

  int orientation(int signed_line) const {
    const int blocker = lines_[signed_line / 2].blocker;
    return (blocker < 0 ? 1 : blocker_signs_[blocker]) * (signed_line % 2 == 0 ? 1 : -1);
  }

  /// Sign of D(a, b): b is a turned to the left.
  int turn(int a, int b) {
    const int i = a / 2, j = b / 2, flips = orientation(a) * orientation(b);
    if (i == j) return 0;
    const Approximate &u = approximate_[i], &v = approximate_[j];
    const double value = u.value[0] * v.value[1] - u.value[1] * v.value[0];
    const double size = u.size[0] * v.size[1] + u.size[1] * v.size[0];
    if (!Numbers<N>::kExact || std::abs(value) > 32 * kRounding * size) {
      return sign_of(value) * flips;
    }
    return sign_of(two_lines(i, j).at(x_, y_)) * flips;
  }

  /// Sign of line c where a and b meet, if turn(a, b) > 0.
  int side(int a, int b, int c) {
    std::array<int, 3> ids = {a / 2, b / 2, c / 2};
    int flips = orientation(a) * orientation(b) * orientation(c);
    if (ids[0] == ids[1] || ids[1] == ids[2] || ids[0] == ids[2]) return 0;
    const Approximate &u = approximate_[ids[0]], &v = approximate_[ids[1]],
                      &w = approximate_[ids[2]];
    double value = 0, size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
      value += w.value[k] * (u.value[l] * v.value[m] - u.value[m] * v.value[l]);
      size += w.size[k] * (u.size[l] * v.size[m] + u.size[m] * v.size[l]);
    }
    if (!Numbers<N>::kExact || std::abs(value) > 64 * kRounding * size) {
      return sign_of(value) * flips;
    }
    for (const auto& [i, j] : {std::pair{0, 1}, {1, 2}, {0, 1}}) {
      if (ids[i] > ids[j]) {
        std::swap(ids[i], ids[j]);
        flips = -flips;
      }
    }
    return sign_of(three_lines(ids[0], ids[1], ids[2]).at(x_, y_)) * flips;
  }

  /// The corner i is where lines i and i + 1 meet.
  std::vector<int> signs_at_corners(const Cell& cell, int line) {
    std::vector<int> signs(cell.size());
    for (std::size_t i = 0; i < cell.size(); ++i) {
      signs[i] = side(cell[i], cell[(i + 1) % cell.size()], line);
    }
    return signs;
  }

  /// The part where line >= 0; empty if it has no area. `signs` are those of the line at the
  /// corners.
  static Cell clipped(const Cell& cell, int line, const std::vector<int>& signs) {
    if (std::ranges::none_of(signs, [](int s) { return s > 0; })) return {};
    if (std::ranges::none_of(signs, [](int s) { return s < 0; })) return cell;
    Cell result;
    const std::size_t n = cell.size();
    for (std::size_t i = 0; i < n; ++i) {
      // Line i runs from corner i - 1 to corner i.
      const int from = signs[(i + n - 1) % n], to = signs[i];
      if (from <= 0 && to <= 0) continue;
      result.push_back(cell[i]);
      if (from > 0 && to <= 0) result.push_back(line);
    }
    return result;
  }

  /// Is all of the cell hidden by the remaining occluders? Notes the proofs.
  bool covered(Cell cell, unsigned remaining) {
    int best = -1, best_hidden = -1;
    for (std::size_t b = 0; b < blockers_.size(); ++b) {
      if ((remaining >> b & 1) == 0) continue;
      bool misses = false;
      std::vector<bool> hidden(cell.size(), true);
      for (const int line : blockers_[b].lines) {
        const std::vector<int> signs = signs_at_corners(cell, line);
        misses = std::ranges::none_of(signs, [](int s) { return s > 0; });
        if (misses) break;
        for (std::size_t i = 0; i < cell.size(); ++i) hidden[i] = hidden[i] && signs[i] >= 0;
      }
      if (misses) {
        remaining &= ~(1u << b);
        continue;
      }
      const int count = static_cast<int>(std::ranges::count(hidden, true));
      const int score = count == static_cast<int>(cell.size()) ? 1000 : count;
      if (score > best_hidden) {
        best_hidden = score;
        best = static_cast<int>(b);
      }
    }
    if (best < 0) return false;
    remaining &= ~(1u << best);
    if (const int curve = blockers_[best].curve; curve >= 0) proof_.push_back(curve);
    for (const int line : blockers_[best].lines) {
      std::vector<int> signs = signs_at_corners(cell, line);
      if (std::ranges::none_of(signs, [](int s) { return s < 0; })) {
        note_proof(cell, line);
        continue;
      }
      const Cell inside = clipped(cell, line, signs);
      for (int& sign : signs) sign = -sign;
      if (!covered(clipped(cell, line ^ 1, signs), remaining)) return false;
      if (inside.empty()) return true;
      cell = inside;
    }
    return true;
  }

  /// Why line >= 0 on the cell: the two sides that meet at its lowest corner, seen from the line.
  void note_proof(const Cell& cell, int line) {
    for (std::size_t i = 0; i < cell.size(); ++i) {
      const int a = cell[i], b = cell[(i + 1) % cell.size()];
      if (turn(line, b) < 0 || turn(a, line) < 0) continue;
      const ProofCurves& curves = curves_of_proof(a / 2, b / 2, line / 2);
      proof_.insert(proof_.end(), curves.bounding.begin(), curves.bounding.end());
      zero_free_.insert(zero_free_.end(), curves.all.begin(), curves.all.end());
      return;
    }
    throw Undecided("no lowest corner");
  }

  /// E from the point (x, y) of R. If hidden, proof_ holds the curves to be crossed before that can
  /// change. Degenerate if a sign of the proof is zero by chance, or in the plane of an occluder.
  Look look_from(const N& x, const N& y) {
    if (++points > 100'000) throw Undecided("number of points");
    if (!set_point(x, y)) return Look::kDegenerate;
    proof_.clear();
    zero_free_.clear();
    if (!covered(element_, (1u << blockers_.size()) - 1)) return Look::kSeen;
    make_set(proof_);
    make_set(zero_free_);
    for (const int id : zero_free_) {
      if (sign_at(curves_[id], x_, y_, dx_, dy_) == 0) return Look::kDegenerate;
    }
    std::erase_if(proof_, [&](int id) { return !curves_[id].crosses_region; });
    return Look::kHidden;
  }

  bool try_some_points() {
    std::uint64_t state = 1;
    for (int trial = 0; trial < 8; ++trial) {
      N x{}, y{}, total{};
      for (const auto& corner : region_) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        const N weight(static_cast<int>(state >> 58) + 1);
        x += weight * corner[0];
        y += weight * corner[1];
        total += weight;
      }
      if (look_from(x / total, y / total) == Look::kSeen) return true;
    }
    return false;
  }

  // ---- along a line x = constant

  std::vector<Bound> roots_at(int id, const N& x) const {
    const Conic<N>& f = curves_[id].f;
    const N c = f[0] + x * (f[1] + x * f[3]), b = f[2] + x * f[4];
    const N& a = f[5];
    if (sign_of(a) == 0) {
      if (sign_of(b) == 0) return {};
      return {{QuadraticRoot<N>::rational(-c / b), id, 0}};
    }
    const N radicand = b * b - 4 * a * c;
    if (sign_of(radicand) < 0) return {};
    const N centre = -b / (2 * a);
    N factor = N(1) / (2 * a);
    if (factor < 0) factor = -factor;
    return {{QuadraticRoot<N>(centre, N(-factor), radicand), id, 0},
            {QuadraticRoot<N>(centre, factor, radicand), id, 1}};
  }

  /// A short number strictly between, by halving [low, high].
  template <class Root, class Order>
  static N between(Root& from, Root& to, N low, N high, const Order& order) {
    for (int step = 0; step < 2000; ++step) {
      const N middle = (low + high) / 2;
      if (order(from, middle) >= 0) {
        low = middle;
      } else if (order(to, middle) <= 0) {
        high = middle;
      } else {
        return middle;
      }
    }
    throw Undecided("number between two roots");
  }

  /// Covers R on the line x = x0 by intervals on which E is hidden.
  Look cover_line(const N& x, Cover& cover) {
    Bound &bottom = cover.bottom, &top = cover.top;
    for (const int id : floor_) {
      const Bound bound = roots_at(id, x).at(0);
      if (bottom.curve < 0 || compare(bound.root, bottom.root) > 0) bottom = bound;
    }
    for (const int id : ceiling_) {
      const Bound bound = roots_at(id, x).at(0);
      if (top.curve < 0 || compare(bound.root, top.root) < 0) top = bound;
    }
    std::vector<Interval> found;
    std::vector<std::pair<Bound, Bound>> gaps = {{bottom, top}};
    while (!gaps.empty()) {
      const auto [from, to] = std::move(gaps.back());
      gaps.pop_back();
      if (compare(from.root, to.root) >= 0) continue;
      Interval interval;
      const Look look = look_between(x, from, to, interval.curves);
      if (look != Look::kHidden) return look;
      const auto here = QuadraticRoot<N>::rational(y_);
      interval.low = bottom;
      interval.high = top;
      for (const int id : interval.curves) {
        for (const Bound& bound : roots_at(id, x)) {
          const int order = compare(bound.root, here);
          if (order == 0) return Look::kDegenerate;
          Bound& nearest = order < 0 ? interval.low : interval.high;
          if (compare(bound.root, nearest.root) == -order) nearest = bound;
        }
      }
      gaps.push_back({from, interval.low});
      gaps.push_back({interval.high, to});
      found.push_back(std::move(interval));
    }
    // Few intervals that still cover, in order.
    const Bound* reached = &bottom;
    while (compare(reached->root, top.root) < 0) {
      const Interval* next = nullptr;
      for (const Interval& interval : found) {
        if (compare(interval.low.root, reached->root) <= 0 &&
            (next == nullptr || compare(interval.high.root, next->high.root) > 0)) {
          next = &interval;
        }
      }
      if (next == nullptr || compare(next->high.root, reached->root) <= 0) {
        throw Undecided("gap in a covering");
      }
      cover.intervals.push_back(*next);
      reached = &next->high;
    }
    return Look::kHidden;
  }

  Look look_between(const N& x, const Bound& from, const Bound& to, std::vector<int>& curves) {
    const auto order = [](const QuadraticRoot<N>& root, const N& y) {
      return compare(root, QuadraticRoot<N>::rational(y));
    };
    QuadraticRoot<N> low = from.root, high = to.root;
    for (int attempt = 0; attempt < 5; ++attempt) {
      const N y = between(low, high, low_y_, high_y_, order);
      const Look look = look_from(x, y);
      if (look == Look::kHidden) curves = proof_;
      if (look != Look::kDegenerate) return look;
      high = QuadraticRoot<N>::rational(y);
    }
    return Look::kDegenerate;
  }

  // ---- along x

  enum class Event { kItself, kLeading, kDiscriminant, kResultant };
  using EventKey = std::tuple<Event, int, int>;

  /// The zeros in R's range of x.
  std::vector<RealRoot<N>>& zeros(const EventKey& key) {
    const auto [place, is_new] = zeros_.try_emplace(key);
    if (is_new) {
      const auto [event, i, j] = key;
      const Conic<N>& f = curves_[i].f;
      Univariate<N> polynomial;
      switch (event) {
        case Event::kItself:
          polynomial = f.by_y()[0];
          break;
        case Event::kLeading:
          polynomial = f.by_y()[curves_[i].has_yy ? 2 : 1];
          break;
        case Event::kDiscriminant:
          polynomial = discriminant(f);
          break;
        case Event::kResultant:
          polynomial = resultant(f, curves_[j].f);
          break;
      }
      if (polynomial.empty()) throw Undecided("identically zero");
      Numbers<N>::reduce(polynomial);
      isolate(std::make_shared<const Univariate<N>>(std::move(polynomial)), false, low_x_, high_x_,
              0, place->second);
    }
    return place->second;
  }

  void add_resultant(std::vector<EventKey>& events, int i, int j) const {
    if (i != j) events.push_back({Event::kResultant, std::min(i, j), std::max(i, j)});
  }

  void add_bound(std::vector<EventKey>& events, const Bound& bound) const {
    events.push_back({Event::kLeading, bound.curve, 0});
    if (curves_[bound.curve].has_yy) events.push_back({Event::kDiscriminant, bound.curve, 0});
  }

  std::vector<EventKey> events_of(const Cover& cover) const {
    std::vector<EventKey> events;
    add_bound(events, cover.bottom);
    add_bound(events, cover.top);
    const Bound* reached = &cover.bottom;
    for (const Interval& interval : cover.intervals) {
      if (!reached->same_branch(interval.low)) {
        add_resultant(events, reached->curve, interval.low.curve);
      }
      reached = &interval.high;
      add_bound(events, interval.low);
      add_bound(events, interval.high);
      add_resultant(events, interval.low.curve, interval.high.curve);
      for (const int id : interval.curves) {
        if (!curves_[id].has_y) {
          events.push_back({Event::kItself, id, 0});
          continue;
        }
        if (id == interval.low.curve || id == interval.high.curve) continue;
        if (curves_[id].has_yy) events.push_back({Event::kDiscriminant, id, 0});
        add_resultant(events, id, interval.low.curve);
        add_resultant(events, id, interval.high.curve);
      }
    }
    if (!reached->same_branch(cover.top)) {
      add_resultant(events, reached->curve, cover.top.curve);
    }
    make_set(events);
    return events;
  }

  /// Looks along one line between the two; appends what is left of the gap.
  bool sees_between(RealRoot<N>& low, RealRoot<N>& high,
                    std::vector<std::pair<RealRoot<N>, RealRoot<N>>>& gaps) {
    const auto order = [](RealRoot<N>& root, const N& x) { return compare(root, x); };
    RealRoot<N> limit = high;
    for (int attempt = 0; attempt < 50; ++attempt) {
      const N x = between(low, limit, low_x_, high_x_, order);
      limit = RealRoot<N>::rational(x);
      ++lines;
      Cover cover;
      const Look look = cover_line(x, cover);
      if (look == Look::kSeen) return true;
      if (look == Look::kDegenerate) continue;
      RealRoot<N> below = low, above = high;
      if (!holds_around(x, events_of(cover), below, above)) continue;
      gaps.push_back({low, below});
      gaps.push_back({above, high});
      return false;
    }
    throw Undecided("no line in general position");
  }

  /// Moves the two to the next zeros below and above x, if between; false if x is a zero.
  bool holds_around(const N& x, const std::vector<EventKey>& events, RealRoot<N>& below,
                    RealRoot<N>& above) {
    for (const EventKey& key : events) {
      for (RealRoot<N>& root : zeros(key)) {
        const int order = compare(root, x);
        if (order == 0) return false;
        RealRoot<N>& nearest = order < 0 ? below : above;
        if (compare(root, nearest) == -order) nearest = root;
      }
    }
    return true;
  }

  Plane<N> plane_r_, plane_e_;
  std::vector<std::array<N, 2>> region_;  ///< counter-clockwise
  N low_x_, high_x_, low_y_, high_y_;
  Affine<N> height_;  ///< of p over plane(E), > 0, times a constant
  std::vector<int> floor_, ceiling_;
  std::vector<Line> lines_;
  Cell element_;
  std::vector<Blocker> blockers_;

  std::vector<Curve> curves_;
  std::map<std::array<N, 6>, int> curve_ids_;
  std::map<std::pair<int, int>, Conic<N>> two_lines_;
  std::map<std::tuple<int, int, int>, Conic<N>> three_lines_;
  std::map<std::tuple<int, int, int>, ProofCurves> curves_of_proof_;
  std::map<EventKey, std::vector<RealRoot<N>>> zeros_;

  N x_, y_;
  double dx_ = 0, dy_ = 0;
  std::vector<int> blocker_signs_;
  std::vector<Approximate> approximate_;
  std::vector<int> proof_, zero_free_;
};

struct Effort {
  std::size_t points = 0, lines = 0;
};

/// The decision in numbers of type N. Throws Undecided; if N is exact, only after 100,000 points.
template <class N>
bool sees(const SightQuery& query, Effort* effort = nullptr) {
  const Corners<N> region = corners_of<N>(query.region), element = corners_of<N>(query.element);
  std::vector<Corners<N>> occluders;
  for (const ConvexPolygon& polygon : query.occluders) occluders.push_back(corners_of<N>(polygon));
  if (occluders.size() > 30) throw std::invalid_argument("more than 30 occluders");
  const Plane<N> plane_r(region), plane_e(element);
  for (const int side_e : {1, -1}) {
    const Corners<N> from = part_above(region, plane_e, side_e);
    if (!has_area(from) || std::ranges::all_of(from, [&](const Vector<N>& v) {
          return sign_of(plane_e.height(v)) == 0;
        })) {
      continue;
    }
    for (const int side_r : {1, -1}) {
      if (std::ranges::none_of(element, [&](const Vector<N>& v) {
            return sign_of(plane_r.height(v)) * side_r > 0;
          })) {
        continue;
      }
      Sweep<N> sweep(plane_r, from, plane_e, element, occluders, side_r, side_e);
      const bool result = sweep.sees();
      if (effort != nullptr) {
        effort->points += sweep.points;
        effort->lines += sweep.lines;
      }
      if (result) return true;
    }
  }
  return false;
}

}  // namespace viewcover::testing::second_opinion
