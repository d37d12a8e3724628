// The window's colours and ImGui's style. Nothing here is saturated: colour belongs to the regions.
#pragma once

#include <imgui.h>

#include "gui/store/settings.hpp"
#include "mold/region.hpp"

namespace moldlight::gui {

/// Packed as ImGui packs them.
struct ThemeColours {
  ImU32 panel, panel_border, popup;          // behind text
  ImU32 text, muted;                         // text: figures and labels; units and hints
  ImU32 field, field_hovered, field_active;  // behind a value
  ImU32 fill, accent, on_accent;             // a slider's filled part, knobs and chosen words, text on them
  ImU32 line;                                // separators
  ImU32 scrim;                               // over the scene under a dialog
  ImU32 warning;
};

[[nodiscard]] const ThemeColours& theme_colours(Theme theme);

/// Sets every colour and length of ImGui's style; `scale` is pixels per layout unit.
void apply_style(Theme theme, float scale);

/// `alpha` times the colour's own.
[[nodiscard]] ImU32 faded(ImU32 colour, float alpha);
[[nodiscard]] ImU32 packed(const Colour& colour, float alpha = 1.0F);
[[nodiscard]] ImU32 mixed(ImU32 a, ImU32 b, float share_of_b);

}  // namespace moldlight::gui
