// The side action that is looked at, over the scene: the arrow of its direction, and how far that may turn;
// and what would have to be open for its undercut to need none.
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

/// The change that makes the undercut free that is looked at; null for none, and while none is known.
[[nodiscard]] const DesignChange* chosen_change(const AppState& state);

/// The outline of the window where it leaves the part, lines along the parting direction to the undercut, and
/// how large it is.
void draw_undercut_window(const Ui& ui, const AppState& state, const glm::ivec2& size);

}  // namespace moldlight::gui
