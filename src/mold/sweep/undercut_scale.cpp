#include "mold/sweep/undercut_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace moldlight {

namespace {

// Evenly spaced; lightness falls from 96 to 14.
constexpr std::array<Colour, 7> k_stops = {{{0xFD, 0xF4, 0xE3},
                                            {0xFA, 0xD2, 0xA6},
                                            {0xF4, 0xA2, 0x72},
                                            {0xE2, 0x6A, 0x55},
                                            {0xB7, 0x3A, 0x4F},
                                            {0x75, 0x1F, 0x46},
                                            {0x36, 0x12, 0x2E}}};

}  // namespace

double undercut_scale(double area, double worst) {
  return worst > 0.0 ? std::sqrt(std::clamp(area / worst, 0.0, 1.0)) : 0.0;
}

Colour undercut_scale_colour(double place) {
  const double at = std::clamp(place, 0.0, 1.0) * (k_stops.size() - 1);
  const std::size_t k = std::min(static_cast<std::size_t>(at), k_stops.size() - 2);
  const double f = at - static_cast<double>(k);
  const auto mix = [f](std::uint8_t a, std::uint8_t b) {
    return static_cast<std::uint8_t>(std::lround(a + f * (b - a)));
  };
  const Colour &a = k_stops[k], &b = k_stops[k + 1];
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

}  // namespace moldlight
