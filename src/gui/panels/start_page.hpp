// What the window shows before there is a part.
#pragma once

#include <span>

#include "gui/panels/panels.hpp"

namespace moldlight::gui {

/// Side of the shipped parts' pictures, layout units.
inline constexpr float k_start_picture_size = 124.0F;

/// `thumbnails`: textures of the shipped parts, in their order; 0 where there is none yet.
void draw_start_page(const PanelContext& context, std::span<const unsigned> thumbnails);

}  // namespace moldlight::gui
