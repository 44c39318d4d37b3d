#pragma once

#include <string>
#include <vector>

#include "exact/query_shapes.h"
#include "exact/sight_query.h"

namespace viewcover::testing {

/// A similarity whose matrix is exact on integers.
struct Pose {
  std::string name;
  Eigen::Matrix3d matrix;
};

/// The rotation of an integer quaternion, times its squared length: entries are integers.
inline Eigen::Matrix3d integer_rotation(double w, double x, double y, double z) {
  Eigen::Matrix3d m;
  m << w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y), 2 * (x * y + w * z),
      w * w - x * x + y * y - z * z, 2 * (y * z - w * x), 2 * (x * z - w * y), 2 * (y * z + w * x),
      w * w - x * x - y * y + z * z;
  return m;
}

inline std::vector<Pose> poses() {
  Eigen::Matrix3d mirror;
  mirror << 0, -1, 0, 0, 0, 1, 1, 0, 0;
  return {{"as given", Eigen::Matrix3d::Identity()},
          {"rotation times 7", integer_rotation(1, 1, 1, 2)},
          {"rotation times 9", integer_rotation(1, 2, 2, 0)},
          {"rotation times 15", integer_rotation(3, 2, 1, 1)},
          {"axes permuted and mirrored", mirror},
          {"scaled by 2^-13", 0x1p-13 * Eigen::Matrix3d::Identity()}};
}

inline ConvexPolygon posed(const ConvexPolygon& polygon, const Pose& pose) {
  ConvexPolygon result;
  for (const Point& corner : polygon) result.emplace_back(pose.matrix * corner);
  return result;
}

/// A mirror turns front into back: a one-sided element keeps its front by being reversed.
inline SightQuery posed(const SightQuery& query, const Pose& pose) {
  SightQuery result;
  result.region = posed(query.region, pose);
  result.viewpoint = pose.matrix * query.viewpoint;
  result.element = posed(query.element, pose);
  if (query.one_sided && pose.matrix.determinant() < 0) result.element = flipped(result.element);
  for (const ConvexPolygon& o : query.occluders) result.occluders.push_back(posed(o, pose));
  result.one_sided = query.one_sided;
  return result;
}

}  // namespace viewcover::testing
