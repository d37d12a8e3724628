// The arrow of the side action that is looked at, over the scene: its direction, and how far that may turn.
#pragma once

#include <glm/vec2.hpp>

#include "gui/draw/ui.hpp"
#include "gui/view/side_actions.hpp"

namespace moldlight::gui {

/// The direction across `parting` (unit) whose arrow from `tail` (unit frame) points where `at` (pixels) is.
/// Where two would, seen along the plane, the one nearer to `former` (unit).
struct SidePull {
  glm::dvec3 tail{0.0}, parting{0, 0, 1}, former{1, 0, 0};
};
[[nodiscard]] glm::dvec3 side_direction_at(const Camera& camera, const glm::ivec2& size, const SidePull& pull,
                                           const glm::vec2& at);

/// The arrow, the sector that is free for it, and what it is; `lively`: under the cursor or dragged.
void draw_side_arrow(const Ui& ui, const AppState& state, const glm::ivec2& size, bool lively);

}  // namespace moldlight::gui
