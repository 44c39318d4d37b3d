#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "scene/generate/generated_scene.h"

namespace viewcover {

__extension__ typedef __int128 Int128;  // -Wpedantic knows no such type

/// Exact checks of generated faces in whole numbers, independent of scene/predicates.h.
/// Coordinates are multiples of 2^-20 below 2^5, so differences fit 26 bits and determinants of
/// three of them 81 bits: 128 are enough.
using WholePoint = std::array<Int128, 3>;
using WholeFace = std::vector<WholePoint>;

inline WholePoint whole(const Point& p) {
  WholePoint result{};
  for (int axis = 0; axis < 3; ++axis) {
    const double scaled = std::ldexp(p[axis], 20);
    if (scaled != std::floor(scaled) || std::abs(p[axis]) >= 32) {
      throw std::range_error("not on the lattice: " + std::to_string(p[axis]));
    }
    result[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(scaled);
  }
  return result;
}

inline std::vector<WholeFace> whole_faces(const GeneratedScene& scene) {
  std::vector<WholeFace> faces;
  for (const GeneratedScene::Face& face : scene.faces) {
    faces.emplace_back();
    for (const std::uint32_t corner : face.corners) {
      faces.back().push_back(whole(scene.vertices.at(corner)));
    }
  }
  return faces;
}

inline WholePoint cross(const WholePoint& o, const WholePoint& p, const WholePoint& q) {
  const auto d = [&o](const WholePoint& x, std::size_t axis) { return x[axis] - o[axis]; };
  return {d(p, 1) * d(q, 2) - d(p, 2) * d(q, 1), d(p, 2) * d(q, 0) - d(p, 0) * d(q, 2),
          d(p, 0) * d(q, 1) - d(p, 1) * d(q, 0)};
}

inline Int128 dot(const WholePoint& a, const WholePoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// Sign of the volume of o, p, q, r: 1 if r lies before the side from which o, p, q run
/// counter-clockwise.
inline int side(const WholePoint& o, const WholePoint& p, const WholePoint& q,
                const WholePoint& r) {
  const Int128 volume = dot(cross(o, p, q), {r[0] - o[0], r[1] - o[1], r[2] - o[2]});
  return (volume > 0) - (volume < 0);
}

inline bool is_planar(const WholeFace& face) {
  return std::all_of(face.begin(), face.end(), [&](const WholePoint& corner) {
    return side(face[0], face[1], face[2], corner) == 0;
  });
}

/// For a planar face: every corner lies strictly to the left of every edge it is not on.
inline bool is_strictly_convex(const WholeFace& face) {
  const WholePoint normal = cross(face[0], face[1], face[2]);
  for (std::size_t i = 0; i < face.size(); ++i) {
    const std::size_t next = (i + 1) % face.size();
    for (std::size_t k = 0; k < face.size(); ++k) {
      if (k == i || k == next) continue;
      const WholePoint turn = cross(face[i], face[next], face[k]);
      // The turn is parallel to the normal; compare along an axis where the normal is not 0.
      const std::size_t axis = normal[0] != 0 ? 0 : normal[1] != 0 ? 1 : 2;
      if (normal[axis] == 0 || turn[axis] == 0 || (turn[axis] > 0) != (normal[axis] > 0)) {
        return false;
      }
    }
  }
  return face.size() >= 3;
}

/// True iff an edge of `a` passes from one side of `b` to the other through its interior.
inline bool pierces(const WholeFace& a, const WholeFace& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const WholePoint& p = a[i];
    const WholePoint& q = a[(i + 1) % a.size()];
    if (side(b[0], b[1], b[2], p) * side(b[0], b[1], b[2], q) >= 0) continue;
    int turns = 0;
    for (std::size_t k = 0; k < b.size(); ++k) turns += side(p, q, b[k], b[(k + 1) % b.size()]);
    if (static_cast<std::size_t>(std::abs(turns)) == b.size()) return true;
  }
  return false;
}

/// What is wrong with the faces, one line each; empty for strictly convex, exactly planar faces
/// without duplicates, none of which crosses another.
inline std::vector<std::string> faults(const GeneratedScene& scene) {
  std::vector<std::string> found;
  const std::vector<WholeFace> faces = whole_faces(scene);
  const auto name = [&](std::size_t i) {
    return "face " + std::to_string(i + 1) + " of " + scene.groups.at(scene.faces[i].group);
  };
  struct Bounds {
    WholePoint low, high;
  };
  std::vector<Bounds> bounds;
  std::set<WholeFace> seen;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (!is_planar(faces[i])) found.push_back(name(i) + " is not planar");
    if (!is_strictly_convex(faces[i])) found.push_back(name(i) + " is not strictly convex");
    WholeFace sorted = faces[i];
    std::sort(sorted.begin(), sorted.end());
    if (!seen.insert(sorted).second) found.push_back(name(i) + " is a duplicate");
    Bounds box{faces[i][0], faces[i][0]};
    for (const WholePoint& corner : faces[i]) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        box.low[axis] = std::min(box.low[axis], corner[axis]);
        box.high[axis] = std::max(box.high[axis], corner[axis]);
      }
    }
    bounds.push_back(box);
  }
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      bool apart = false;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        apart = apart || bounds[i].low[axis] > bounds[k].high[axis] ||
                bounds[k].low[axis] > bounds[i].high[axis];
      }
      if (!apart && (pierces(faces[i], faces[k]) || pierces(faces[k], faces[i]))) {
        found.push_back(name(i) + " crosses " + name(k));
      }
    }
  }
  return found;
}

/// True iff the face and the horizontal rectangular `part` have no point in common, or only points
/// of the part's outline: decided by the face's bounding box, so false may be a false alarm.
inline bool is_clear_of(const WholeFace& face, const std::vector<Point>& part) {
  WholePoint low = whole(part[0]);
  WholePoint high = low;
  for (const Point& corner : part) {
    const WholePoint p = whole(corner);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low[axis] = std::min(low[axis], p[axis]);
      high[axis] = std::max(high[axis], p[axis]);
    }
  }
  if (low[2] != high[2]) throw std::invalid_argument("the part is not horizontal");
  const auto all = [&face](auto&& holds) { return std::all_of(face.begin(), face.end(), holds); };
  for (std::size_t axis = 0; axis < 2; ++axis) {
    if (all([&](const WholePoint& p) { return p[axis] <= low[axis]; })) return true;
    if (all([&](const WholePoint& p) { return p[axis] >= high[axis]; })) return true;
  }
  return all([&](const WholePoint& p) { return p[2] < low[2]; }) ||
         all([&](const WholePoint& p) { return p[2] > low[2]; });
}

}  // namespace viewcover
