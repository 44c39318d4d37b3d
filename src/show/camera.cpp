#include "show/camera.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace viewcover {
namespace {

constexpr double kPi = std::numbers::pi;

class OutsideCamera final : public Camera {
 public:
  OutsideCamera(std::span<const Point> points, const Frame& frame, ViewDirection view,
                PixelSize size) {
    constexpr double kDistance = 2.6;  // radii of the bounding sphere: a mild perspective
    constexpr double kMargin = 0.03;   // of the picture, on each side
    const double azimuth = view.azimuth * kPi / 180, elevation = view.elevation * kPi / 180;
    const Point level = std::cos(azimuth) * frame.east + std::sin(azimuth) * frame.north;
    backward_ = std::cos(elevation) * level + std::sin(elevation) * frame.up;
    right_ = std::cos(azimuth) * frame.north - std::sin(azimuth) * frame.east;
    up_ = backward_.cross(right_);
    Box box;
    for (const Point& p : points) box.extend(p);
    const double radius = std::max(box.diagonal().norm() / 2, std::numeric_limits<double>::min());
    position_ = box.center() + kDistance * radius * backward_;

    Eigen::AlignedBox2d plane;
    for (const Point& p : points) {
      if (const auto place = on_plane(p)) plane.extend(*place);
    }
    const Eigen::Vector2d extent = plane.sizes().cwiseMax(1e-9);
    const Eigen::Vector2d pixels(size.width, size.height);
    scale_ = (pixels.cwiseQuotient(extent) * (1 - 2 * kMargin)).minCoeff();
    offset_ = pixels / 2 - scale_ * Eigen::Vector2d(plane.center().x(), -plane.center().y());
  }

  Point position() const override { return position_; }
  Point direction(double x, double y) const override {
    return (x - offset_.x()) / scale_ * right_ - (y - offset_.y()) / scale_ * up_ - backward_;
  }
  std::optional<Eigen::Vector2d> project(const Point& point) const override {
    const auto place = on_plane(point);
    if (!place) return std::nullopt;
    return offset_ + scale_ * Eigen::Vector2d(place->x(), -place->y());
  }

 private:
  /// On the plane at distance 1 before the camera.
  std::optional<Eigen::Vector2d> on_plane(const Point& point) const {
    const Point from = point - position_;
    const double depth = -from.dot(backward_);
    if (!(depth > 0)) return std::nullopt;
    return Eigen::Vector2d(from.dot(right_) / depth, from.dot(up_) / depth);
  }

  Point position_, right_, up_, backward_;
  double scale_ = 1;  ///< pixels a unit of the plane
  Eigen::Vector2d offset_;
};

class PanoramaCamera final : public Camera {
 public:
  PanoramaCamera(const Point& position, const Frame& frame, PixelSize size)
      : position_(position), frame_(frame), size_(size) {}

  Point position() const override { return position_; }
  Point direction(double x, double y) const override {
    const double east_of_north = (x / size_.width - 0.5) * 2 * kPi;
    const double elevation = (0.5 - y / size_.height) * kPi;
    return std::cos(elevation) *
               (std::sin(east_of_north) * frame_.east + std::cos(east_of_north) * frame_.north) +
           std::sin(elevation) * frame_.up;
  }
  std::optional<Eigen::Vector2d> project(const Point& point) const override {
    const Point from = point - position_;
    if (from.isZero(0)) return std::nullopt;
    const double turn = std::atan2(from.dot(frame_.east), from.dot(frame_.north)),
                 elevation = std::asin(std::clamp(from.dot(frame_.up) / from.norm(), -1.0, 1.0));
    return Eigen::Vector2d((turn / (2 * kPi) + 0.5) * size_.width,
                           (0.5 - elevation / kPi) * size_.height);
  }

 private:
  Point position_;
  Frame frame_;
  PixelSize size_;
};

}  // namespace

Frame Frame::with_up(int up_axis) {
  switch (up_axis) {
    case 0:
      return {Point::UnitY(), Point::UnitZ(), Point::UnitX()};
    case 1:
      return {Point::UnitX(), -Point::UnitZ(), Point::UnitY()};
    default:
      return {Point::UnitX(), Point::UnitY(), Point::UnitZ()};
  }
}

std::unique_ptr<Camera> make_outside_camera(std::span<const Point> points, const Frame& frame,
                                            ViewDirection view, PixelSize size) {
  return std::make_unique<OutsideCamera>(points, frame, view, size);
}

std::unique_ptr<Camera> make_panorama_camera(const Point& position, const Frame& frame,
                                             PixelSize size) {
  return std::make_unique<PanoramaCamera>(position, frame, size);
}

}  // namespace viewcover
