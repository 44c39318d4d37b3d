#include "show/legend.h"

namespace viewcover {
namespace {

constexpr Colour kFaint{120, 124, 130};

}  // namespace

Legend::Legend(const Shading& shading, int width) : shading_(shading), width_(width) {}

void Legend::add_entry(Colour colour, std::string text) {
  places_.push_back({colour, std::move(text)});
}

void Legend::add_regions(bool chosen, bool viewpoints) {
  add_entry(mixed({255, 255, 255}, kRegionColour, 0.85), "viewing region");
  if (chosen) add_entry(kChosenColour, "chosen");
  dot_ = viewpoints;
}

int Legend::height() const { return static_cast<int>(text_height() * 5); }

void Legend::draw_entry(Image& image, double& x, double y, const LegendEntry& entry,
                        bool dot) const {
  const double text = text_height(), box = text;
  if (dot) {
    image.draw_dot({x + box / 2, y - box / 2 + text * 0.1}, box * 0.36, entry.colour, kInk,
                   box / 9);
  } else {
    image.fill_rectangle(x, y - box * 0.9, box * 1.5, box, entry.colour);
    image.outline_rectangle(x, y - box * 0.9, box * 1.5, box, kFaint, box / 16);
  }
  x += dot ? box * 1.3 : box * 1.9;
  image.draw_text(x, y, entry.text, text, kInk);
  x += image.text_width(entry.text, text) + text * 1.1;
}

void Legend::draw_ramp(Image& image, double& x, double y) const {
  const double text = text_height();
  const int width = static_cast<int>(text * 12);
  image.draw_text(x, y, "1", text, kInk);
  x += image.text_width("1", text) + text * 0.4;
  for (int i = 0; i < width; ++i) {
    image.fill_rectangle(x + i, y - text * 0.9, 1, text, ramp((i + 0.5) / width));
  }
  image.outline_rectangle(x, y - text * 0.9, width, text, kFaint, text / 16);
  x += width + text * 0.4;
  const std::string end = std::to_string(shading_.ramp_end);
  image.draw_text(x, y, end, text, kInk);
  x += image.text_width(end, text) + text * 1.1;
}

void Legend::draw(Image& image, int top) const {
  const double text = text_height(), left = text * 1.2;
  const double first = top + text * 1.6, second = top + text * 3.6;
  image.draw_text(left, first, caption_, text, kInk, TextAlign::kLeft, true);
  double x = left;
  image.draw_text(x, second, shading_.title + ":", text, kInk);
  x += image.text_width(shading_.title + ":", text) + text * 0.7;
  for (const LegendEntry& entry : shading_.entries) draw_entry(image, x, second, entry, false);
  if (shading_.ramp_end > 0) draw_ramp(image, x, second);
  if (places_.empty()) return;
  // The places stand at the right end, if there is room, else after the colours.
  double width = 0;
  for (const LegendEntry& entry : places_) {
    width += text * 3.0 + image.text_width(entry.text, text);
  }
  if (dot_) width += text * 1.3 + image.text_width("viewpoint", text);
  x = std::max(x + text, width_ - left - width);
  for (const LegendEntry& entry : places_) draw_entry(image, x, second, entry, false);
  if (dot_) draw_entry(image, x, second, {kViewpointColour, "viewpoint"}, true);
}

}  // namespace viewcover
