#pragma once

#include <string>
#include <vector>

#include "show/image.h"
#include "show/shading.h"

namespace viewcover {

/// The strip below a picture that says what its colours mean.
class Legend {
 public:
  Legend(const Shading& shading, int width);

  void set_caption(std::string caption) { caption_ = std::move(caption); }
  void add_entry(Colour colour, std::string text);
  void add_regions(bool chosen, bool viewpoints);

  /// Pixels.
  int height() const;
  /// Draws it across the picture, from row `top` down.
  void draw(Image& image, int top) const;

 private:
  double text_height() const { return width_ / 72.0; }
  void draw_ramp(Image& image, double& x, double y) const;
  void draw_entry(Image& image, double& x, double y, const LegendEntry& entry, bool dot) const;

  const Shading& shading_;
  int width_;
  std::string caption_;
  std::vector<LegendEntry> places_;  ///< regions and the like
  bool dot_ = false;
};

}  // namespace viewcover
