// The colours of a picture by theme, as the shaders take them.
#pragma once

#include <array>

#include <glm/vec3.hpp>

#include "render/view_geometry.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

/// sRGB in [0, 1].
[[nodiscard]] glm::vec3 screen_value(Colour colour);
/// The squares of that: what light adds up in.
[[nodiscard]] glm::vec3 light_value(Colour colour);

/// The backdrop's gradient; a flat one is `below`.
struct BackdropColours {
  Colour above, below;
};
[[nodiscard]] BackdropColours backdrop_colours(Theme theme);

/// Colours of the draft angle, from steep undersides to steep tops: band k lies between limits k - 1 and k
/// (in degrees, ascending); the middle band is what counts as near-vertical.
struct DraftScale {
  std::array<double, 6> limits_deg{};
  std::array<Colour, 7> colours{};
};
[[nodiscard]] DraftScale draft_scale(double required_deg, Palette palette);

/// Of a body of the mold: a paler sister of the colour of what it forms.
[[nodiscard]] Colour steel_colour(Steel steel, Palette palette);

inline constexpr Colour k_plain_surface = {199, 203, 209};
inline constexpr Colour k_cut_surface = {176, 170, 160};
inline constexpr Colour k_hover_mark = {255, 255, 255};
inline constexpr Colour k_difference_mark = {202, 60, 255};
inline constexpr Colour k_tube = {255, 190, 40}, k_chosen_tube = {255, 246, 214};
inline constexpr Colour k_block_mark = {255, 204, 102};

}  // namespace moldlight
