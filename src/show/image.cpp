#include "show/image.h"

#include <cerrno>
#include <cstring>
#include <new>
#include <system_error>

#include "report/file_writer.h"
#include "scene/error.h"

namespace viewcover {
namespace {

void set_source(cairo_t* context, Colour colour, double opacity = 1) {
  cairo_set_source_rgba(context, colour.red / 255.0, colour.green / 255.0, colour.blue / 255.0,
                        opacity);
}

void trace(cairo_t* context, std::span<const Eigen::Vector2d> corners) {
  cairo_new_path(context);
  for (const Eigen::Vector2d& corner : corners) cairo_line_to(context, corner.x(), corner.y());
  cairo_close_path(context);
}

/// Length of the UTF-8 character that starts the text, 0 if none does.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::size_t length = byte(0) < 0x80                      ? 1
                             : byte(0) >= 0xC2 && byte(0) < 0xE0 ? 2
                             : byte(0) >= 0xE0 && byte(0) < 0xF0 ? 3
                             : byte(0) >= 0xF0 && byte(0) < 0xF5 ? 4
                                                                 : 0;
  if (length == 0 || length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  return length;
}

/// Cairo refuses to draw anything more after text that is no UTF-8.
std::string drawable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const bool control = length == 1 && static_cast<unsigned char>(text[0]) < 0x20;
    if (length > 0 && !control) result += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result;
}

}  // namespace

Image::Image(PixelSize size, Colour background)
    : size_(size),
      surface_(cairo_image_surface_create(CAIRO_FORMAT_RGB24, size.width, size.height)),
      context_(cairo_create(surface_.get())) {
  if (cairo_status(context_.get()) != CAIRO_STATUS_SUCCESS) throw std::bad_alloc();
  set_source(context_.get(), background);
  cairo_paint(context_.get());
  cairo_surface_flush(surface_.get());
  cairo_set_line_cap(context_.get(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(context_.get(), CAIRO_LINE_JOIN_ROUND);
}

void Image::set_pixel(int x, int y, Colour colour) {
  unsigned char* const row =
      cairo_image_surface_get_data(surface_.get()) +
      static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface_.get());
  const std::uint32_t value = static_cast<std::uint32_t>(colour.red) << 16 |
                              static_cast<std::uint32_t>(colour.green) << 8 | colour.blue;
  std::memcpy(row + 4 * static_cast<std::ptrdiff_t>(x), &value, sizeof(value));
}

Colour Image::pixel(int x, int y) const {
  cairo_surface_flush(surface_.get());
  const unsigned char* const row =
      cairo_image_surface_get_data(surface_.get()) +
      static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface_.get());
  std::uint32_t value = 0;
  std::memcpy(&value, row + 4 * static_cast<std::ptrdiff_t>(x), sizeof(value));
  return {static_cast<std::uint8_t>(value >> 16), static_cast<std::uint8_t>(value >> 8),
          static_cast<std::uint8_t>(value)};
}

void Image::fill_rectangle(double x, double y, double width, double height, Colour colour) {
  cairo_surface_mark_dirty(surface_.get());
  set_source(context_.get(), colour);
  cairo_rectangle(context_.get(), x, y, width, height);
  cairo_fill(context_.get());
}

void Image::outline_rectangle(double x, double y, double width, double height, Colour colour,
                              double line) {
  set_source(context_.get(), colour);
  cairo_set_line_width(context_.get(), line);
  cairo_rectangle(context_.get(), x, y, width, height);
  cairo_stroke(context_.get());
}

void Image::draw_line(Eigen::Vector2d a, Eigen::Vector2d b, Colour colour, double opacity,
                      double width) {
  cairo_surface_mark_dirty(surface_.get());
  set_source(context_.get(), colour, opacity);
  cairo_set_line_width(context_.get(), width);
  cairo_move_to(context_.get(), a.x(), a.y());
  cairo_line_to(context_.get(), b.x(), b.y());
  cairo_stroke(context_.get());
}

void Image::fill_polygon(std::span<const Eigen::Vector2d> corners, Colour colour, double opacity) {
  set_source(context_.get(), colour, opacity);
  trace(context_.get(), corners);
  cairo_fill(context_.get());
}

void Image::outline_polygon(std::span<const Eigen::Vector2d> corners, Colour colour, double opacity,
                            double width) {
  set_source(context_.get(), colour, opacity);
  cairo_set_line_width(context_.get(), width);
  trace(context_.get(), corners);
  cairo_stroke(context_.get());
}

void Image::draw_dot(Eigen::Vector2d centre, double radius, Colour fill, Colour rim,
                     double rim_width) {
  cairo_surface_mark_dirty(surface_.get());
  cairo_new_path(context_.get());
  cairo_arc(context_.get(), centre.x(), centre.y(), radius, 0, 6.283185307179586);
  set_source(context_.get(), fill);
  cairo_fill_preserve(context_.get());
  set_source(context_.get(), rim);
  cairo_set_line_width(context_.get(), rim_width);
  cairo_stroke(context_.get());
}

void Image::select_font(double height, bool bold) {
  cairo_select_font_face(context_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context_.get(), height);
}

void Image::draw_text(double x, double y, const std::string& text, double height, Colour colour,
                      TextAlign align, bool bold) {
  cairo_surface_mark_dirty(surface_.get());
  const double width = align == TextAlign::kLeft ? 0 : text_width(text, height, bold);
  select_font(height, bold);
  set_source(context_.get(), colour);
  cairo_move_to(context_.get(),
                align == TextAlign::kLeft     ? x
                : align == TextAlign::kCentre ? x - width / 2
                                              : x - width,
                y);
  cairo_show_text(context_.get(), drawable(text).c_str());
}

double Image::text_width(const std::string& text, double height, bool bold) {
  select_font(height, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(context_.get(), drawable(text).c_str(), &extents);
  return extents.x_advance;
}

void Image::write_png(const std::filesystem::path& file) const {
  const auto temporary = temporary_beside(file);
  errno = 0;
  const cairo_status_t status =
      cairo_surface_write_to_png(surface_.get(), temporary.string().c_str());
  if (status != CAIRO_STATUS_SUCCESS) {
    const std::string reason =
        errno != 0 ? std::generic_category().message(errno) : cairo_status_to_string(status);
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw InputError(file.string(), "cannot be written: " + reason,
                     "give a folder that can be written to");
  }
  rename_into_place(temporary, file);
}

}  // namespace viewcover
