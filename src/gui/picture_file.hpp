// Pictures of the window as PNG files.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <glm/vec2.hpp>

namespace moldlight::gui {

/// RGBA8, rows from above; the alpha is ignored. The file is replaced whole or not at all; throws FileError.
void write_picture(const std::string& path, const glm::ivec2& size, std::span<const std::uint8_t> rgba);

}  // namespace moldlight::gui
