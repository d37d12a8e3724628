#include <fmt/format.h>

#include "classify/figures.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_card_width = 212.0F, k_card_row = 20.0F, k_from_line = 16.0F;  // layout units

void draw_row(const Ui& ui, const char* name, const std::string& figure, const std::string& exact) {
  ImGui::InvisibleButton(name, ImVec2(ui.px(k_card_width), ui.px(k_card_row)));
  const glm::vec2 min = from_im(ImGui::GetItemRectMin()), max = from_im(ImGui::GetItemRectMax());
  ui.memory->controls[fmt::format("measured {}", name)] = {min, max};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) list.AddRectFilled(im(min), im(max), ui.colours->field, ui.px(4));
  const float top = 0.5F * (min.y + max.y - ui.fonts.body.size);
  draw_text(list, {ui.fonts.body, ui.colours->muted}, {min.x + ui.px(4), top}, name);
  draw_text_to({ui.fonts.strong, ui.colours->text}, max.x - ui.px(4), top, figure);
  copy_menu(ui, name, exact);
}

void draw_card(const PanelContext& context, const MeasuredPair& pair, const glm::vec2& beside) {
  const Ui& ui = context.ui;
  const int rows = pair.between_planes ? 5 : 4;
  const ImVec2 padding = ImGui::GetStyle().WindowPadding, spacing = ImGui::GetStyle().ItemSpacing;
  const glm::vec2 size(
      ui.px(k_card_width) + 2.0F * padding.x,
      2.0F * padding.y + static_cast<float>(rows) * (ui.px(k_card_row) + spacing.y) - spacing.y);
  const FreeArea area = context.layout.free_area(context.state.dialogs.panels_hidden);
  place_window(area.beside(beside, size, ui.px(k_from_line)), {0.0F, 0.0F});
  ImGui::Begin("Measured", nullptr, k_card_window);
  const auto length = [&](const char* name, double value) {
    const std::string unit = length_unit(context.state.model->part);
    draw_row(ui, name, fmt::format("{:.4g} {}", value, unit), real_text(value));
  };
  length("distance", pair.distance);
  length("along the direction", pair.along);
  length("across it", pair.across);
  if (pair.between_planes) length("between the planes", *pair.between_planes);
  draw_row(ui, "angle of the normals", fmt::format("{:.1f}°", pair.angle_deg), real_text(pair.angle_deg));
  ImGui::End();
}

}  // namespace

void draw_measuring(const PanelContext& context) {
  const AppState& state = context.state;
  if (!state.measuring) return;
  const Ui& ui = context.ui;
  std::vector<MeasuredPlace> places = state.measuring->places;
  const bool clicked = places.size() == 2;
  if (places.size() == 1 && state.hover) places.push_back(measured_place(*state.model, state.hover->point));
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const glm::ivec2 window(ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y);
  std::vector<glm::vec2> seen;
  for (const MeasuredPlace& place : places) {
    const auto pixel = project(state.camera, window, glm::dvec3(state.model->frame.to_unit(place.at)));
    if (!pixel) return;
    seen.emplace_back(*pixel);
  }
  if (seen.size() == 2) {
    list.AddLine(im(seen[0]), im(seen[1]), ui.colours->panel, 4.0F * ui.scale);
    list.AddLine(im(seen[0]), im(seen[1]), ui.colours->text, 2.0F * ui.scale);
  }
  for (const glm::vec2& end : seen) {
    list.AddCircleFilled(im(end), ui.px(5), ui.colours->panel);
    list.AddCircleFilled(im(end), ui.px(3), ui.colours->text);
  }
  if (seen.size() < 2) {
    const FreeArea area = context.layout.free_area(state.dialogs.panels_hidden);
    draw_tag(ui, {area.middle_x(), static_cast<float>(area.min.y) + ui.px(24)},
             places.empty() ? "Measure: click a place on the part" : "and another one", ui.colours->text);
    return;
  }
  const MeasuredPair pair = measured(places[0], places[1], state.settings.direction.unit());
  const glm::vec2 middle = 0.5F * (seen[0] + seen[1]);
  // Beside the line that was clicked; until then the cursor's own readout is in the way of a card.
  if (clicked) {
    draw_card(context, pair, middle);
  } else {
    draw_tag(ui, middle, fmt::format("{:.4g} {}", pair.distance, length_unit(state.model->part)),
             ui.colours->text);
  }
}

}  // namespace moldlight::gui
