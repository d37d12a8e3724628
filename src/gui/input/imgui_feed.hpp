// Recorded input for ImGui, where no platform backend feeds it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "gui/input/keys.hpp"

namespace moldlight::gui {

struct ImguiInput {
  glm::ivec2 size{0};  // pixels
  double delta_s = 0.0;
  glm::vec2 mouse{0.0F};
  std::array<bool, 3> buttons{};  // left, right, middle
  float wheel = 0.0F;
  bool ctrl = false, shift = false, alt = false;
  std::vector<KeyPress> keys;  // pressed in this frame
  std::string text;            // typed in this frame, UTF-8
};
/// Call it before ImGui::NewFrame, once a frame.
void feed(const ImguiInput& input);

}  // namespace moldlight::gui
