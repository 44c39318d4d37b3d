#pragma once

#include <functional>
#include <span>
#include <vector>

#include "show/camera.h"
#include "show/colour.h"
#include "show/ray_scene.h"

namespace viewcover {

/// What a ray of a picture meets: numbers in the lists of the scene, or RayScene::kNone.
struct Sample {
  std::uint32_t element = RayScene::kNone;
  std::uint32_t region = RayScene::kNone;  ///< only before the element

  friend bool operator==(const Sample&, const Sample&) = default;
};

/// The scene of a picture. Elements and regions that rays shall pass have no corners.
class RasterScene {
 public:
  /// `light`: unit vector; surfaces across it are lit most, from either side.
  /// `outlines`: a line is drawn between two elements whose numbers here differ; #elements.
  RasterScene(std::span<const ConvexPolygon> elements, std::vector<Colour> colours,
              std::vector<std::uint32_t> outlines, std::span<const ConvexPolygon> regions,
              std::vector<bool> chosen, const Point& light);

  Sample sample(const Camera& camera, double x, double y) const;
  Colour colour(const Sample& sample, Colour background) const;
  /// 0: no line between two neighbouring samples; 1: between regions; 2: between surfaces.
  int line_between(const Sample& a, const Sample& b) const;

 private:
  RayScene elements_, regions_;
  std::vector<Colour> colours_;
  std::vector<std::uint32_t> outlines_;
  std::vector<double> facing_;  ///< of the elements: |normal . light|
  std::vector<bool> chosen_;
};

/// Colours each pixel with the mean of samples x samples rays, and lines one sample wide on both
/// sides of outlines. `set_pixel` is called from several threads, once a pixel; what it is given
/// does not depend on their number.
void render(const RasterScene& scene, const Camera& camera, PixelSize size, int samples,
            Colour background, const std::function<void(int x, int y, Colour)>& set_pixel);

}  // namespace viewcover
