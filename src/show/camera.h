#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>

#include "scene/types.h"

namespace viewcover {

/// Where up is: three unit vectors along axes of the scene, right-handed.
struct Frame {
  Point east, north, up;

  /// `up_axis`: 0, 1 or 2 for x, y or z.
  static Frame with_up(int up_axis);
};

struct PixelSize {
  int width = 0, height = 0;
};

/// Maps between pixels and directions. x runs right, y down; pixel (i, j) covers [i, i + 1] x
/// [j, j + 1]. Thread-safe.
class Camera {
 public:
  virtual ~Camera() = default;

  virtual Point position() const = 0;
  /// The direction seen at a place of the picture; any length.
  virtual Point direction(double x, double y) const = 0;
  /// Where a point is seen; nothing if it is behind the camera.
  virtual std::optional<Eigen::Vector2d> project(const Point& point) const = 0;
};

/// From where a scene is looked at, degrees: azimuth from east over north, elevation above the
/// horizon.
struct ViewDirection {
  double azimuth = 235, elevation = 38;
};

/// Looks at a scene from outside in perspective: `points` fill the picture but for a margin.
std::unique_ptr<Camera> make_outside_camera(std::span<const Point> points, const Frame& frame,
                                            ViewDirection view, PixelSize size);

/// All directions from one place (equirectangular): the middle of the picture is north, x runs
/// over 360 degrees, y from straight up to straight down.
std::unique_ptr<Camera> make_panorama_camera(const Point& position, const Frame& frame,
                                             PixelSize size);

}  // namespace viewcover
