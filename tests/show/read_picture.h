#pragma once

#include <cairo.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <stdexcept>

namespace viewcover::testing {

/// A PNG file, 24 bits a pixel.
class ReadPicture {
 public:
  explicit ReadPicture(const std::filesystem::path& file)
      : surface_(cairo_image_surface_create_from_png(file.string().c_str())) {
    if (cairo_surface_status(surface_) != CAIRO_STATUS_SUCCESS) {
      throw std::runtime_error(file.string() + " is no PNG file");
    }
  }
  ~ReadPicture() { cairo_surface_destroy(surface_); }
  ReadPicture(const ReadPicture&) = delete;
  ReadPicture& operator=(const ReadPicture&) = delete;

  int width() const { return cairo_image_surface_get_width(surface_); }
  int height() const { return cairo_image_surface_get_height(surface_); }
  /// 0xRRGGBB.
  std::uint32_t pixel(int x, int y) const {
    const auto* row = cairo_image_surface_get_data(surface_) +
                      static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(surface_);
    return reinterpret_cast<const std::uint32_t*>(row)[x] & 0xFFFFFF;
  }
  template <class Test>
  int count(Test&& test) const {
    int number = 0;
    for (int y = 0; y < height(); ++y) {
      for (int x = 0; x < width(); ++x) number += test(pixel(x, y)) ? 1 : 0;
    }
    return number;
  }

 private:
  cairo_surface_t* surface_;
};

}  // namespace viewcover::testing
