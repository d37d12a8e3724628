#include "render/view_settings.hpp"

#include <algorithm>
#include <cmath>

namespace moldlight {

namespace {

Colour mixed(Colour a, Colour b, double share) {
  const auto channel = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
  };
  return {channel(a.r, b.r), channel(a.g, b.g), channel(a.b, b.b)};
}

constexpr Colour k_steel = {196, 200, 206};

}  // namespace

glm::vec3 screen_value(Colour colour) {
  return glm::vec3(static_cast<float>(colour.r), static_cast<float>(colour.g), static_cast<float>(colour.b)) /
         255.0F;
}

glm::vec3 light_value(Colour colour) {
  const glm::vec3 value = screen_value(colour);
  return value * value;
}

BackdropColours backdrop_colours(Theme theme) {
  if (theme == Theme::dark) return {{58, 62, 69}, {25, 27, 31}};
  return {{253, 253, 254}, {222, 226, 232}};
}

Colour steel_colour(Steel steel, Palette palette) {
  const Region formed = steel == Steel::core     ? Region::core
                        : steel == Steel::cavity ? Region::cavity
                                                 : Region::undercut;
  return mixed(region_colour(formed, palette), k_steel, 0.55);
}

Colour moved_steel_colour(Colour own) { return mixed(own, k_steel, 0.4); }

DraftScale draft_scale(double required_deg, Palette palette) {
  const double some = std::max(3.0, 2.0 * required_deg), much = std::max(10.0, 4.0 * required_deg);
  const Colour core = region_colour(Region::core, palette), cavity = region_colour(Region::cavity, palette);
  constexpr Colour k_white = {238, 240, 243}, k_amber = {232, 176, 44};
  return {{-much, -some, -required_deg, required_deg, some, much},
          {cavity, mixed(cavity, k_white, 0.4), mixed(cavity, k_white, 0.75), k_amber,
           mixed(core, k_white, 0.75), mixed(core, k_white, 0.4), core}};
}

}  // namespace moldlight
