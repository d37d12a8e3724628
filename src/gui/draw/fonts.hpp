// The system's sans-serif at exact pixel sizes, with digits of one width so that figures stand in columns.
#pragma once

#include <string>
#include <vector>

#include <imgui.h>

namespace moldlight::gui {

/// A face of a font file.
struct FontFile {
  std::string path;
  int face = 0;
};

/// The first of k_font_families (picture/canvas.hpp) that is installed, in a regular or a semibold weight
/// (or the nearest); an empty path where there is none.
[[nodiscard]] FontFile find_interface_font(bool semibold);
/// One with many symbols, for the characters that the first lacks; an empty path where there is none.
[[nodiscard]] FontFile find_symbol_font();

/// A font and the size to draw it at, in ImGui's measure (line height).
struct SizedFont {
  ImFont* font = nullptr;
  float size = 0.0F;
};

struct Fonts {
  SizedFont body, strong, small, title;
};

/// Fills the atlas for `scale` pixels per layout unit; ImGui's own font where the system has none. What the
/// atlas held is gone. `bytes` keeps the files' contents, which the atlas points to.
[[nodiscard]] Fonts load_fonts(ImFontAtlas& atlas, float scale, std::vector<std::string>& bytes);

}  // namespace moldlight::gui
