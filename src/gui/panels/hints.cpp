// What a newcomer may do next, said at the thing itself: one hint at a time, each until its thing was done or
// it was dismissed.
#include <algorithm>

#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

/// Where a hint stands: beside the control, on this side of it.
struct HintPlace {
  Hint hint;
  std::string_view control, text;
  glm::vec2 side;  // from the control's middle: its right or left edge
};

constexpr HintPlace k_places[] = {
    {Hint::arrow, "core arrow", "Drag the arrow: regions and figures follow", {1.0F, 0.0F}},
    {Hint::verdict, "verdict", "What becomes of the part along this direction", {-1.0F, 0.0F}},
    {Hint::sweep, "Find directions", "Looks for the best parting direction", {-1.0F, 0.0F}},
};

}  // namespace

void draw_hints(const PanelContext& context) {
  const AppState& state = context.state;
  Dialogs none;
  none.panels_hidden = state.dialogs.panels_hidden;
  const Ui& ui = context.ui;
  const bool covered = !(state.dialogs == none) || ui.memory->popups.any();
  if (!state.shows_hints || !state.model || state.dialogs.panels_hidden || covered) return;
  const auto place = std::ranges::find_if(
      k_places, [&](const HintPlace& each) { return !state.hints_done.contains(each.hint); });
  if (place == std::end(k_places)) return;
  const auto control = ui.memory->controls.find(place->control);
  if (control == ui.memory->controls.end()) return;
  const ScreenBox& box = control->second;
  const glm::vec2 at = box.centre() + place->side * (0.5F * (box.max - box.min) + glm::vec2(ui.px(16)));
  const glm::vec2 tip = at - place->side * ui.px(8), across(place->side.y, place->side.x);
  place_window(at, 0.5F - 0.5F * place->side);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.colours->accent);
  ImGui::Begin("##Hint", nullptr, k_card_window);
  ImGui::PopStyleColor();
  row_text(ui, {ui.fonts.body, ui.colours->on_accent}, text_size(ui.fonts.body, place->text).x, place->text);
  ImGui::SameLine(0.0F, ui.px(6));
  const Pressable close = pressable(ui, "dismiss the hint", glm::vec2(ui.px(k_row_height)));
  draw_icon(*ImGui::GetWindowDrawList(), Icon::close, close.box.centre(), ui.px(12), ui.colours->on_accent);
  if (close.clicked) context.edits.hints_done.insert(place->hint);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.PushClipRectFullScreen();
  list.AddTriangleFilled(im(tip), im(at + across * ui.px(7)), im(at - across * ui.px(7)), ui.colours->accent);
  list.PopClipRect();
  ImGui::End();
}

}  // namespace moldlight::gui
