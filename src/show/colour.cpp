#include "show/colour.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace viewcover {
namespace {

std::uint8_t mixed(std::uint8_t a, std::uint8_t b, double t) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * t));
}

Colour along(std::span<const Colour> stops, double t) {
  const double place = std::clamp(t, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  return mixed(stops[below], stops[below + 1], place - static_cast<double>(below));
}

}  // namespace

Colour mixed(Colour a, Colour b, double t) {
  return {mixed(a.red, b.red, t), mixed(a.green, b.green, t), mixed(a.blue, b.blue, t)};
}

Colour ramp(double t) {
  constexpr std::array<Colour, 5> kStops = {
      {{34, 62, 120}, {36, 112, 150}, {66, 160, 158}, {148, 205, 160}, {250, 243, 190}}};
  return along(kStops, t);
}

Colour missed_ramp(double t) {
  constexpr std::array<Colour, 3> kStops = {{{250, 205, 140}, {236, 130, 30}, {170, 50, 0}}};
  return along(kStops, t);
}

Colour excess_ramp(double t) {
  constexpr std::array<Colour, 3> kStops = {{{170, 205, 235}, {70, 140, 200}, {10, 60, 140}}};
  return along(kStops, t);
}

Colour category(std::size_t number) {
  constexpr std::array<Colour, 8> kColours = {{{230, 159, 0},
                                               {86, 180, 233},
                                               {0, 158, 115},
                                               {240, 228, 66},
                                               {40, 110, 178},
                                               {213, 94, 0},
                                               {204, 121, 167},
                                               {176, 176, 170}}};
  return kColours[number % kColours.size()];
}

}  // namespace viewcover
