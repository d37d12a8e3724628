// The direction ball: the directions as the camera sees the part, to grab and to read.
#include <array>
#include <utility>

#include <glm/geometric.hpp>

#include "gui/draw/widgets.hpp"
#include "gui/jobs/loaded_part.hpp"
#include "gui/panels/panels.hpp"
#include "gui/view/direction.hpp"

namespace moldlight::gui {

namespace {

/// Those that the marker does not cover.
void draw_axis_names(const Ui& ui, const Ball& ball, const glm::vec2& marker) {
  constexpr std::string_view k_names = "XYZ";
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    const BallPoint point = ball.point(direction);
    if (!point.front) continue;
    const glm::vec2 at = ball.centre + 0.86F * (ball.screen(point) - ball.centre);
    if (glm::distance(at, marker) < ui.px(14)) continue;
    const std::string_view name = k_names.substr(axis, 1);
    draw_tagged_text(ui, ball.list,
                     {.lettering = {ui.fonts.small, ui.colours->muted},
                      .at = at - 0.5F * text_size(ui.fonts.small, name),
                      .text = name});
  }
}

void drag_ball(const PanelContext& context, BallDrag& drag, const Ball& ball) {
  const glm::vec2 mouse = from_im(ImGui::GetIO().MousePos);
  if (ImGui::IsItemActivated()) {
    const BallPoint marker = ball.point(context.edits.settings.direction.unit());
    const glm::vec2 to_marker = ball.screen(marker) - mouse;
    const bool gripped = glm::length(to_marker) < context.ui.px(10);
    drag = {.active = true,
            .gripped = gripped,
            .back = gripped && !marker.front,
            .grip = gripped ? to_marker : glm::vec2(0.0F)};
  }
  if (!ImGui::IsItemActive() || !drag.active) {
    drag.active = false;
    return;
  }
  context.edits.dragging = true;
  if (drag.gripped && !ImGui::IsMouseDragging(0, 3.0F)) return;
  glm::dvec3 direction = ball_direction(ball.camera, {ball.disc(mouse + drag.grip), !drag.back});
  if (ImGui::GetIO().KeyCtrl) direction = snapped_to(context.state.features, direction);
  context.edits.settings.direction = direction;
}

/// The arrow keys, as they move the direction where no control has the keyboard.
void nudge_ball(const PanelContext& context) {
  constexpr double k_step_deg = 1.0;
  const Camera& camera = context.state.camera;
  Keyboard& keyboard = context.ui.memory->keyboard;
  Direction& direction = context.edits.settings.direction;
  const std::array<std::pair<ControlKey, glm::dvec3>, 4> steps = {{{ControlKey::left, -camera.right()},
                                                                   {ControlKey::right, camera.right()},
                                                                   {ControlKey::up, camera.up()},
                                                                   {ControlKey::down, -camera.up()}}};
  for (const auto& [key, toward] : steps) {
    if (keyboard.takes(key)) direction = nudged(direction.unit(), toward, camera.toward_viewer(), k_step_deg);
  }
}

}  // namespace

void draw_ball(const PanelContext& context, BallDrag& drag, float size) {
  const Ui& ui = context.ui;
  ImGui::InvisibleButton("ball", ImVec2(size, size));
  ui.memory->controls["ball"] = {from_im(ImGui::GetItemRectMin()), from_im(ImGui::GetItemRectMax())};
  const glm::vec2 min = from_im(ImGui::GetItemRectMin());
  const ScreenBox box{min, from_im(ImGui::GetItemRectMax())};
  if (has_keyboard(ui, "ball", box)) nudge_ball(context);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const Ball ball{list, context.state.camera, min + glm::vec2(0.5F * size), 0.5F * size - ui.px(3)};
  drag_ball(context, drag, ball);
  const SweepState& sweep = context.state.sweep;
  const bool mapped = sweep.map && !sweep.map->field.empty();
  const glm::dvec2 mouse = ball.disc(from_im(ImGui::GetIO().MousePos));
  const bool read = mapped && ImGui::IsItemHovered() && !ImGui::IsMouseDown(0) && glm::length(mouse) < 1.0;
  if (!drag.active && !mapped) {
    tooltip(ui, "Direction ball",
            "Drag to turn the parting direction; hold Ctrl to snap to the part's own directions.");
  }
  if (mapped && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) {
    context.edits.sweep_choices.large_ball = !context.state.sweep_choices.large_ball;
  }

  const bool dark = context.state.window.theme == Theme::dark;
  const BareBall bare{.light = dark ? IM_COL32(88, 93, 100, 255) : IM_COL32(255, 255, 255, 255),
                      .dark = dark ? IM_COL32(34, 36, 40, 255) : IM_COL32(176, 182, 189, 255)};
  draw_sphere(ball, mapped ? &*sweep.map : nullptr, bare);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 across(0.0);
    across[axis] = 1.0;
    draw_circle(ball, across, 90.0, {faded(ui.colours->text, 0.16F), 1.0F});
  }
  const BallPoint marker = ball.point(context.edits.settings.direction.unit());
  const glm::vec2 at = ball.screen(marker);
  if (ImGui::GetIO().KeyCtrl) {
    for (const FeatureDirection& feature : context.state.features) {
      for (const glm::dvec3& direction : {feature.direction, -feature.direction}) {
        const BallPoint point = ball.point(direction);
        if (point.front) list.AddCircleFilled(im(ball.screen(point)), 2.5F * ui.scale, ui.colours->text);
      }
    }
  }
  if (mapped) draw_sweep_marks(ui, ball, sweep);
  list.AddLine(im(ball.centre), im(at), faded(ui.colours->text, marker.front ? 0.8F : 0.3F), 1.5F * ui.scale);
  if (marker.front) {
    list.AddCircleFilled(im(at), 5.5F * ui.scale, mapped ? IM_COL32(20, 14, 18, 220) : IM_COL32(0, 0, 0, 70));
    list.AddCircleFilled(im(at), 4.0F * ui.scale,
                         dark || mapped ? IM_COL32_WHITE : IM_COL32(30, 32, 35, 255));
  } else {
    list.AddCircle(im(at), 4.5F * ui.scale, faded(ui.colours->text, 0.6F), 0, 1.5F * ui.scale);
  }
  draw_axis_names(ui, ball, at);
  if (read) tell_direction(context, ball_direction(ball.camera, {mouse, true}));
}

}  // namespace moldlight::gui
