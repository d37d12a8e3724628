// Icons drawn as strokes, so that they are sharp at every scale and need no font.
#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <imgui.h>

namespace moldlight::gui {

enum class Icon : std::uint8_t {
  open,
  export_file,
  picture,
  ruler,
  undo,
  redo,
  help,
  settings,
  flip,
  bookmark,
  chevron_down,
  chevron_up,
  chevron_left,
  chevron_right,
  close,
  check,
  alert,
  folder,
  file,
  up,
  sphere,
  revisions,
  exchange,
};

/// Draws the icon into a square of `size` pixels around `centre`.
void draw_icon(ImDrawList& list, Icon icon, const glm::vec2& centre, float size, ImU32 colour);

}  // namespace moldlight::gui
