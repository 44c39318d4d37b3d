#pragma once

#include <CGAL/box_intersection_d.h>

#include "scene/types.h"

namespace viewcover {

/// A bounding box with a margin, and what it is of: for sweeps over what may be near each other
/// (CGAL::box_intersection_d).
template <class Info>
using GrownBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, Info>;

template <class Info>
GrownBox<Info> grown_box(const Box& box, double margin, const Info& info) {
  const Point low = box.min() - Point::Constant(margin), high = box.max() + Point::Constant(margin);
  return {CGAL::Bbox_3(low.x(), low.y(), low.z(), high.x(), high.y(), high.z()), info};
}

}  // namespace viewcover
