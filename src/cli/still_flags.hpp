// Flags of the pictures that commands draw.
#pragma once

#include <string>

#include <CLI/CLI.hpp>
#include <glm/vec2.hpp>

#include "session/still_picture.hpp"

namespace moldlight::cli {

/// Adds --size; `size` outlives the command and holds the default, `least` is in pixels.
CLI::Option* add_size_flag(CLI::App& command, glm::ivec2& size, const std::string& help,
                           const glm::ivec2& least = glm::ivec2(k_least_picture_px));

}  // namespace moldlight::cli
