#include "show/raster.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace viewcover {
namespace {

constexpr double kRegionOpacity = 0.56, kChosenOpacity = 0.92;
/// Share of the light that does not depend on how a surface is turned.
constexpr double kAmbientLight = 0.72;

/// Lines are dark on light elements and light on dark ones.
Colour with_line(Colour base, double opacity) {
  const int lightness = (2 * base.red + 5 * base.green + base.blue) / 8;
  return mixed(base, lightness < 40 ? Colour{150, 150, 150} : Colour{18, 20, 24}, opacity);
}

}  // namespace

RasterScene::RasterScene(std::span<const ConvexPolygon> elements, std::vector<Colour> colours,
                         std::vector<std::uint32_t> outlines,
                         std::span<const ConvexPolygon> regions, std::vector<bool> chosen,
                         const Point& light)
    : elements_(elements),
      regions_(regions),
      colours_(std::move(colours)),
      outlines_(std::move(outlines)),
      chosen_(std::move(chosen)) {
  for (const ConvexPolygon& element : elements) {
    facing_.push_back(element.size() < 3 ? 0
                                         : std::fabs(area_vector(element).normalized().dot(light)));
  }
}

Sample RasterScene::sample(const Camera& camera, double x, double y) const {
  const Point origin = camera.position(), direction = camera.direction(x, y);
  const RayScene::Hit element = elements_.hit(origin, direction),
                      region = regions_.hit(origin, direction);
  Sample sample{element.polygon, region.polygon};
  if (region.distance >= element.distance) sample.region = RayScene::kNone;
  return sample;
}

Colour RasterScene::colour(const Sample& sample, Colour background) const {
  Colour result = background;
  if (sample.element != RayScene::kNone) {
    result = mixed({0, 0, 0}, colours_[sample.element],
                   kAmbientLight + (1 - kAmbientLight) * facing_[sample.element]);
  }
  if (sample.region != RayScene::kNone) {
    const bool chosen = chosen_[sample.region];
    result = mixed(result, chosen ? kChosenColour : kRegionColour,
                   chosen ? kChosenOpacity : kRegionOpacity);
  }
  return result;
}

int RasterScene::line_between(const Sample& a, const Sample& b) const {
  const auto outline = [&](const Sample& s) {
    return s.element == RayScene::kNone ? RayScene::kNone : outlines_[s.element];
  };
  if (a.region != b.region) return 1;
  if (outline(a) == outline(b)) return 0;
  return a.region == RayScene::kNone ? 2 : 1;
}

void render(const RasterScene& scene, const Camera& camera, PixelSize size, int samples,
            Colour background, const std::function<void(int x, int y, Colour)>& set_pixel) {
  // A row of pixels needs its samples, and those beside them for the lines.
  const int columns = size.width * samples + 2;
  tbb::parallel_for(0, size.height, [&](int y) {
    std::vector<Sample> grid(static_cast<std::size_t>(columns * (samples + 2)));
    const auto at = [&](int column, int row) -> Sample& {
      return grid[static_cast<std::size_t>(row * columns + column)];
    };
    for (int row = 0; row < samples + 2; ++row) {
      for (int column = 0; column < columns; ++column) {
        at(column, row) = scene.sample(camera, (column - 0.5) / samples, y + (row - 0.5) / samples);
      }
    }
    for (int x = 0; x < size.width; ++x) {
      std::array<int, 3> sum{};
      for (int row = 1; row <= samples; ++row) {
        for (int column = x * samples + 1; column <= (x + 1) * samples; ++column) {
          const Sample& here = at(column, row);
          const int line = std::max({scene.line_between(here, at(column + 1, row)),
                                     scene.line_between(here, at(column - 1, row)),
                                     scene.line_between(here, at(column, row + 1)),
                                     scene.line_between(here, at(column, row - 1))});
          Colour colour = scene.colour(here, background);
          if (line > 0) colour = with_line(colour, line == 1 ? 0.45 : 0.8);
          sum[0] += colour.red;
          sum[1] += colour.green;
          sum[2] += colour.blue;
        }
      }
      const int count = samples * samples;
      const auto mean = [&](int s) { return static_cast<std::uint8_t>((s + count / 2) / count); };
      set_pixel(x, y, {mean(sum[0]), mean(sum[1]), mean(sum[2])});
    }
  });
}

}  // namespace viewcover
