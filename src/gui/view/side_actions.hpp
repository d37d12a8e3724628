// Side actions as the scene shows them: when each moves while the mold opens; of the one that is looked at
// the arrow of its direction, how far that may turn, and what would have to be open for its undercut to need
// none.
#pragma once

#include <optional>
#include <string>

#include "actions/mold_opening.hpp"
#include "gui/app_state.hpp"
#include "gui/draw/ui.hpp"

namespace moldlight::gui {

/// The undercut of another plan that is this one; nothing where there is none near it.
[[nodiscard]] std::optional<std::size_t> nearest_undercut(const ActionPlan& plan, const Undercut& undercut);

/// The action of the undercut that is looked at; null for none.
[[nodiscard]] const SideAction* chosen_action(const AppState& state);

/// Which way an undercut is pulled: from its middle.
struct SideArrow {
  glm::dvec3 tail{0.0}, direction{1, 0, 0};  // unit frame; unit
  std::optional<TurnInterval> free;  // that the direction may turn about the parting direction, where known
  bool released = true;              // else it is a proposal for an undercut that nothing releases
};
/// Of the undercut that is looked at; nothing for what turns or is stripped.
[[nodiscard]] std::optional<SideArrow> side_arrow(const AppState& state);
/// Length of the arrow, unit frame: the same on the screen however near the part is seen.
[[nodiscard]] inline double side_arrow_length(const Camera& camera) { return 0.17 * camera.height; }

/// Adds a direction for the actions to take, in place of `former` where that is one that the user has given.
void give_side_direction(ActionSettings& settings, const std::optional<glm::dvec3>& former,
                         const glm::dvec3& direction);
/// Whether an action moves along this direction (unit), to rounding.
[[nodiscard]] bool is_along(const SideAction& action, const glm::dvec3& direction);
/// The direction among the user's own that this is; nothing where it is none.
[[nodiscard]] std::optional<std::size_t> own_direction(const ActionSettings& settings,
                                                       const glm::dvec3& direction);

/// The bodies of the plan, or those of the mold of several pieces that is looked at; null for none.
[[nodiscard]] std::shared_ptr<const std::vector<ViewBody>> shown_bodies(const AppState& state);
/// Where each body of the plan is drawn, unit frame: in a mold that opens all of them, by how far it has, but
/// for those that its steel has where that is seen; in a closed one that of the chosen action, out by a share
/// [0, 1] of its travel. They leave with their halves. Sheets leave one after the other. None where none is
/// to be seen.
[[nodiscard]] std::vector<glm::dmat4> body_places(const AppState& state, double open, double share,
                                                  bool steel);
/// Corners of the bodies where body_places() draws them, and of the steel that actions move.
[[nodiscard]] std::vector<glm::vec3> points_of_bodies(const AppState& state, double open, bool steel);
/// What a picture of an undercut is to show, unit frame: it, its action's body in place and out, and the
/// arrow.
[[nodiscard]] std::vector<glm::vec3> surroundings(const AppState& state, std::size_t undercut);
/// "halves 34.2 mm", "piece 2, -z": what moves then, and how far it has, or where to.
[[nodiscard]] std::string opening_text(const AppState& state, double open);

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
