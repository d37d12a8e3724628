// The parting direction: a ball to grab, fields to type into, the usual axes, bookmarks.
#include <cmath>

#include <fmt/format.h>

#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"
#include "gui/view/direction.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_ball_size = 108.0F, k_figure_bar_width = 120.0F;  // layout units

void draw_axis_buttons(const PanelContext& context) {
  const Ui& ui = context.ui;
  Direction& present = context.edits.settings.direction;
  const float gap = ui.px(4);
  const float width = std::floor((ImGui::GetContentRegionAvail().x - 2.0F * gap) / 3.0F);
  for (const double sign : {1.0, -1.0}) {
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 direction(0.0);
      direction[axis] = sign;
      if (axis > 0) ImGui::SameLine(0.0F, gap);
      const std::string label = fmt::format("{}{}", sign > 0 ? "+" : "−", "XYZ"[axis]);
      if (button(ui, label, {.width = width, .strong = false, .chosen = present.given() == direction})) {
        present = direction;
      }
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

void draw_fields(const PanelContext& context) {
  const Ui& ui = context.ui;
  Direction& present = context.edits.settings.direction;
  const float gap = ui.px(4), room = ImGui::GetContentRegionAvail().x;
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
  bool turned = number_field(ui, "azimuth", angles.azimuth_deg, {"az °", 1, half});
  tooltip(ui, "Azimuth", "About z, from x towards y, in degrees.");
  ImGui::SameLine(0.0F, gap);
  turned = number_field(ui, "elevation", angles.elevation_deg, {"el °", 1, half}) || turned;
  tooltip(ui, "Elevation", "Above the xy plane, in degrees.");
  if (turned) present = direction_of(angles);
}

}  // namespace

void draw_direction_panel(const PanelContext& context, BallDrag& drag) {
  const Ui& ui = context.ui;
  if (context.layout.begin(ui, "Direction")) {
    draw_ball(context, drag, ui.px(k_ball_size));
    const glm::vec2 ball_max = from_im(ImGui::GetItemRectMax());
    ImGui::SameLine(0.0F, ui.px(12));
    ImGui::BeginGroup();
    draw_axis_buttons(context);
    if (icon_button(ui, {"flip", Icon::flip, "Flip: core and cavity change sides (X)"})) {
      context.edits.settings.direction = tidy(-context.edits.settings.direction.given());
    }
    ImGui::SameLine(0.0F, ui.px(4));
    if (icon_button(ui, {"along", Icon::up, "Look along the parting direction (0)"})) {
      context.edits.ask(&Commands::look_along_direction);
    }
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
    draw_fields(context);
  }
  context.layout.end();
}

}  // namespace moldlight::gui
