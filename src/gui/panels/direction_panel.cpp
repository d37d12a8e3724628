// The parting direction: a ball to grab and to read, which has the directions as the camera sees the part,
// fields to type into, the usual axes, bookmarks.
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "gui/draw/widgets.hpp"
#include "gui/jobs/loaded_part.hpp"
#include "gui/panels/panels.hpp"
#include "gui/view/direction.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_ball_size = 108.0F, k_figure_bar_width = 120.0F;  // layout units

void draw_axis_buttons(const PanelContext& context) {
  const Ui& ui = context.ui;
  Direction& present = context.edits.settings.direction;
  const float gap = ui.px(4);
  const float width = std::floor((room_left() - 2.0F * gap) / 3.0F);
  for (const double sign : {1.0, -1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 direction(0.0);
      direction[axis] = sign;
      if (axis > 0) ImGui::SameLine(0.0F, gap);
      const std::string label = fmt::format("{}{}", sign > 0 ? "+" : "−", "XYZ"[axis]);
      if (button(ui, label, {.width = width, .strong = false, .chosen = present.given() == direction}))
        present = direction;
    }
  }
}

void draw_bookmarks(const PanelContext& context) {
  const Ui& ui = context.ui;
  if (!begin_popup(ui, "bookmarks")) return;
  auto& bookmarks = context.edits.bookmarks;
  heading(ui, "Bookmarks");
  if (button(ui, "Keep this direction", {.width = ui.px(232)})) context.edits.keep_bookmark();
  for (std::size_t k = 0; k < bookmarks.size(); ++k) {
    ImGui::PushID(static_cast<int>(k));
    if (icon_button(ui, {"go", Icon::bookmark, "Take this direction"})) {
      context.edits.settings.direction = bookmarks[k].direction;
      if (bookmarks[k].actions) context.edits.settings.actions = *bookmarks[k].actions;
    }
    ImGui::SameLine();
    std::array<char, 128> note{};
    std::snprintf(note.data(), note.size(), "%s", bookmarks[k].note.c_str());
    if (text_field(ui, "##note", note, {.hint = "note", .width = ui.px(172)}))
      bookmarks[k].note = note.data();
    ImGui::SameLine();
    const bool removed = icon_button(ui, {"remove", Icon::close, "Forget it"});
    ImGui::PopID();
    if (removed) {
      bookmarks.erase(bookmarks.begin() + static_cast<std::ptrdiff_t>(k));
      break;
    }
  }
  end_popup(ui);
}

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
    draw_tagged_text(
        ui, ball.list,
        {.lettering = ui.note(), .at = at - 0.5F * text_size(ui.fonts.small, name), .text = name});
  }
}

void drag_ball(const PanelContext& context, BallDrag& drag, const Ball& ball) {
  const glm::vec2 mouse = mouse_at();
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
  for (const auto& [key, toward] : steps)
    if (keyboard.takes(key)) direction = nudged(direction.unit(), toward, camera.toward_viewer(), k_step_deg);
}

}  // namespace

void draw_direction_fields(const PanelContext& context) {
  const Ui& ui = context.ui;
  Direction& present = context.edits.settings.direction;
  const float gap = ui.px(4), room = room_left();
  const float third = std::floor((room - 2.0F * gap) / 3.0F), half = std::floor((room - gap) / 2.0F);
  glm::dvec3 direction = present.given();
  bool typed = false;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) ImGui::SameLine(0.0F, gap);
    const std::string name(1, "xyz"[axis]);
    typed = number_field(ui, name.c_str(), direction[axis], {name, 3, third}) || typed;
  }
  if (typed && direction != glm::dvec3(0.0)) present = direction;
  Angles angles = angles_of(present.unit());
  bool turned = number_field(ui, "azimuth", angles.azimuth_deg, {"azimuth °", 1, half});
  tooltip(ui, "Azimuth", "Angle about z, from x towards y, in degrees.");
  ImGui::SameLine(0.0F, gap);
  turned = number_field(ui, "elevation", angles.elevation_deg, {"elevation °", 1, half}) || turned;
  tooltip(ui, "Elevation", "Angle above the xy plane, in degrees.");
  if (turned) present = direction_of(angles);
}

void draw_direction_controls(const PanelContext& context, BallDrag& drag) {
  const Ui& ui = context.ui;
  draw_ball(context, drag, ui.px(k_ball_size));
  const glm::vec2 ball_max = item_box().max;
  ImGui::SameLine(0.0F, ui.px(12));
  ImGui::BeginGroup();
  draw_axis_buttons(context);
  if (icon_button(ui, {"flip", Icon::flip, "Flip: core and cavity change sides (X)"}))
    context.edits.settings.direction = tidy(-context.edits.settings.direction.given());
  ImGui::SameLine(0.0F, ui.px(4));
  if (icon_button(ui, {"along", Icon::up, "Look along the parting direction (0)"}))
    context.edits.ask(&Commands::look_along_direction);
  ImGui::SameLine(0.0F, ui.px(4));
  if (icon_button(
          ui, {"bookmark", Icon::bookmark, "Bookmarks of directions", !context.state.bookmarks.empty()})) {
    open_popup_below_item(ui, "bookmarks");
  }
  draw_bookmarks(context);
  ImGui::EndGroup();
  if (context.state.sweep.map && context.state.sweep.map->worst > 0.0) {
    const float left = ball_max.x + ui.px(12), right = left + ui.px(k_figure_bar_width);
    draw_colour_bar(context, {left, ball_max.y - ui.px(22)}, right - left);
  }
  draw_direction_fields(context);
}

void draw_ball(const PanelContext& context, BallDrag& drag, float size) {
  const Ui& ui = context.ui;
  ImGui::InvisibleButton("ball", ImVec2(size, size));
  name_item(ui, "ball");
  const glm::vec2 min = item_box().min;
  if (has_keyboard(ui, "ball", item_box())) nudge_ball(context);
  ImDrawList& list = window_list();
  const Ball ball{list, context.state.camera, min + glm::vec2(0.5F * size), 0.5F * size - ui.px(3)};
  drag_ball(context, drag, ball);
  const SweepState& sweep = context.state.sweep;
  const bool mapped = sweep.map && !sweep.map->field.empty();
  const glm::dvec2 mouse = ball.disc(mouse_at());
  const bool read = mapped && ImGui::IsItemHovered() && !ImGui::IsMouseDown(0) && glm::length(mouse) < 1.0;
  if (!drag.active && !mapped) {
    tooltip(ui, "Direction ball",
            "Drag to turn the parting direction; hold Ctrl to snap to the part's own directions.");
  }
  if (mapped && ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0))
    context.edits.sweep_choices.large_ball = !context.state.sweep_choices.large_ball;

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
        if (point.front) list.AddCircleFilled(ball.screen(point), 2.5F * ui.scale, ui.colours->text);
      }
    }
  }
  if (mapped) draw_sweep_marks(ui, ball, sweep);
  list.AddLine(ball.centre, at, faded(ui.colours->text, marker.front ? 0.8F : 0.3F), 1.5F * ui.scale);
  if (marker.front) {
    list.AddCircleFilled(at, 5.5F * ui.scale, mapped ? IM_COL32(20, 14, 18, 220) : IM_COL32(0, 0, 0, 70));
    list.AddCircleFilled(at, 4.0F * ui.scale, dark || mapped ? IM_COL32_WHITE : IM_COL32(30, 32, 35, 255));
  } else {
    list.AddCircle(at, 4.5F * ui.scale, faded(ui.colours->text, 0.6F), 0, 1.5F * ui.scale);
  }
  draw_axis_names(ui, ball, at);
  if (read) describe_direction(context, ball_direction(ball.camera, {mouse, true}));
}

}  // namespace moldlight::gui
