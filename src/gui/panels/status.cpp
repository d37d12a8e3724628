// Cards for what goes on: the chosen face, loading, messages; and what a newcomer may do next, at the thing
// itself: one hint at a time, each until its thing was done or it was dismissed.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

/// With the shares of its regions; those that print as nothing are left out.
std::string face_line(const AppState& state) {
  const ChosenFace& face = *state.face;
  std::string line = "face";
  if (state.model->part.has_cad_faces) line += " " + grouped(std::to_string(face.number));
  if (!face.figures) return line + "  ·  measuring …";
  const double area = face.figures->areas.total();
  line += fmt::format("  ·  {} {}", grouped(fmt::format("{:.5g}", area)), powered_unit(state.model->part, 2));
  for (const Region region : k_regions) {
    const double percent = 100.0 * share(face.figures->areas[region], area);
    if (percent >= 0.05) line += fmt::format("  ·  {} {:.1f} %", region_name(region), percent);
  }
  const std::string least = draft_text(face.figures->least_draft_deg),
                    most = draft_text(face.figures->most_draft_deg);
  return line + "  ·  draft " + (least == most ? least : least + " … " + most);
}

/// Where a hint stands: beside the control, on this side of it.
struct HintPlace {
  Hint hint;
  std::string_view control, text;
  glm::vec2 side;  // from the control's middle: its right or left edge
};

constexpr HintPlace k_places[] = {
    {Hint::arrow, "core arrow", "Drag the arrow: regions and figures follow", {1.0F, 0.0F}},
    {Hint::verdict, "verdict", "The regions of the part along this direction", {-1.0F, 0.0F}},
    {Hint::sweep, "panel Direction", "Looking for the best parting direction", {1.0F, 0.0F}},
};

}  // namespace

void draw_chosen_face(const PanelContext& context) {
  const AppState& state = context.state;
  if (!state.model || !state.face) return;
  const Ui& ui = context.ui;
  const FreeArea area = context.free_area();
  place_window({area.middle_x(), static_cast<float>(area.max.y) - ui.px(12)}, {0.5F, 1.0F});
  ImGui::Begin("Chosen face", nullptr, k_card_window | ImGuiWindowFlags_NoInputs);
  draw_item_text(state.figures.pale ? ui.colours->muted : ui.colours->text, face_line(state));
  ImGui::End();
}

void draw_loading(const PanelContext& context) {
  if (!context.state.loading) return;
  const Ui& ui = context.ui;
  const Loading& loading = *context.state.loading;
  constexpr double k_at_once_s = 0.3;  // what is there sooner is not announced
  if (context.state.model && ui.now_s - loading.since_s < k_at_once_s) {
    ui.memory->wake_s = std::min(ui.memory->wake_s, loading.since_s + k_at_once_s);
    return;
  }
  place_window(glm::vec2(0.5F, 0.62F) * screen_size(), {0.5F, 0.5F});
  ImGui::Begin("Loading", nullptr, k_card_window);
  const float width = ui.px(320);
  heading(ui, fitted(ui.fonts.strong, std::filesystem::path(loading.path).filename().string(), width));
  hint(ui, loading.status.stage);
  progress_bar(ui, loading.status.fraction, width);
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  if (button(ui, "Cancel", {.width = width})) context.edits.ask(&Commands::cancel_loading);
  ImGui::End();
}

void draw_toasts(const PanelContext& context) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const FreeArea area = context.free_area();
  float top = ui.px(k_bar_height + 12);
  for (const Toast& toast : state.toasts) {
    const float width = std::min(ui.px(460), static_cast<float>(area.max.x - area.min.x) - ui.px(24));
    place_window({area.middle_x(), top}, {0.5F, 0.0F});
    ImGui::SetNextWindowBgAlpha(0.97F);
    ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.colours->popup);
    ImGui::Begin(fmt::format("Toast {}", toast.number).c_str(), nullptr, k_card_window);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    draw_icon(window_list(), toast.failure ? Icon::alert : Icon::check,
              {at.x + ui.px(8), at.y + 0.5F * ui.fonts.body.size}, ui.px(14),
              toast.failure ? ui.colours->warning : ui.colours->muted);
    put_cursor({at.x + ui.px(26), at.y});
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width - ui.px(60));
    draw_item_text(ui.colours->text, toast.text);
    ImGui::PopTextWrapPos();
    top += ImGui::GetWindowHeight() + ui.px(8);
    if (ImGui::IsWindowHovered() && ImGui::IsMouseClicked(0)) context.edits.ask(&Commands::dismiss_toasts);
    ImGui::End();
    ImGui::PopStyleColor();
  }
}

void draw_hints(const PanelContext& context) {
  const AppState& state = context.state;
  const Ui& ui = context.ui;
  const bool covered = state.dialogs != state.dialogs.none() || ui.memory->popups.any();
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
  draw_icon(window_list(), Icon::close, close.box.centre(), ui.px(12), ui.colours->on_accent);
  if (close.clicked) context.edits.hints_done.insert(place->hint);
  ImDrawList& list = window_list();
  list.PushClipRectFullScreen();
  list.AddTriangleFilled(tip, at + across * ui.px(7), at - across * ui.px(7), ui.colours->accent);
  list.PopClipRect();
  ImGui::End();
}

}  // namespace moldlight::gui
