#pragma once

#include <cairo.h>

#include <filesystem>
#include <memory>
#include <string>

#include "show/camera.h"
#include "show/colour.h"

namespace viewcover {

enum class TextAlign { kLeft, kCentre, kRight };

/// A picture in memory to draw on (Cairo); coordinates are pixels, y runs down. Included by sources
/// of this folder only.
class Image {
 public:
  explicit Image(PixelSize size, Colour background = {255, 255, 255});

  PixelSize size() const { return size_; }
  /// Threads may set different pixels at once, while nothing else is drawn.
  void set_pixel(int x, int y, Colour colour);
  Colour pixel(int x, int y) const;

  void fill_rectangle(double x, double y, double width, double height, Colour colour);
  void outline_rectangle(double x, double y, double width, double height, Colour colour,
                         double line);
  void draw_line(Eigen::Vector2d a, Eigen::Vector2d b, Colour colour, double opacity, double width);
  void fill_polygon(std::span<const Eigen::Vector2d> corners, Colour colour, double opacity);
  void outline_polygon(std::span<const Eigen::Vector2d> corners, Colour colour, double opacity,
                       double width);
  void draw_dot(Eigen::Vector2d centre, double radius, Colour fill, Colour rim, double rim_width);
  /// `y` is the base line. Text that is no UTF-8 is drawn without the bytes at fault.
  void draw_text(double x, double y, const std::string& text, double height, Colour colour,
                 TextAlign align = TextAlign::kLeft, bool bold = false);
  double text_width(const std::string& text, double height, bool bold = false);

  /// Writes a PNG file, whole or not at all. Errors: InputError.
  void write_png(const std::filesystem::path& file) const;

 private:
  void select_font(double height, bool bold);

  struct Destroy {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* context) const { cairo_destroy(context); }
  };
  PixelSize size_;
  std::unique_ptr<cairo_surface_t, Destroy> surface_;
  std::unique_ptr<cairo_t, Destroy> context_;
};

}  // namespace viewcover
