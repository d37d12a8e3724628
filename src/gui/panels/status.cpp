// Cards for what goes on: the chosen face, loading, messages; and what a newcomer may do next, at the thing
// itself: one hint at a time, each until its thing was done or it was dismissed.
#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <utility>

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

/// What is said beside a control, on this side of it: of a hint, or of a step of the tour.
template <typename Of>
struct HintPlace {
  Of of;
  std::string_view control, text;
  glm::vec2 side;  // from the control's middle: its right or left edge
};

constexpr HintPlace<Hint> k_places[] = {
    {Hint::arrow, "core arrow", "Drag the arrow: regions and figures follow", {1.0F, 0.0F}},
    {Hint::verdict, "verdict", "The regions of the part along this direction", {-1.0F, 0.0F}},
    {Hint::sweep, "panel Direction", "Looking for the best parting direction", {1.0F, 0.0F}},
};

/// A minute, if nobody presses a key.
constexpr double k_stop_s = 7.5;
constexpr HintPlace<Step> k_tour[] = {
    {Step::direction, "core arrow", "The mold opens along this arrow. Drag its tip.", {1.0F, 0.0F}},
    {Step::direction, "verdict", "The verdict on this direction, in one sentence", {-1.0F, 0.0F}},
    {Step::direction, "panel Direction", "Better directions come here. Click a card.", {1.0F, 0.0F}},
    {Step::undercuts, "panel Undercuts", "Each undercut, with what releases it", {1.0F, 0.0F}},
    {Step::parting_line, "panel Parting line", "Where the halves meet. Drag the handle.", {1.0F, 0.0F}},
    {Step::draft, "draft chart", "How much draft the walls have, and lack", {1.0F, 0.0F}},
    {Step::mold, "panel Mold", "The mold halves. Press O to open them.", {1.0F, 0.0F}},
    {Step::report, "panel Report", "Pictures, files, the report. H has all keys.", {1.0F, 0.0F}},
};

/// A card that points at a control, with buttons; which was pressed, by its place, if any.
std::optional<std::size_t> point_at(const PanelContext& context, const ScreenBox& box, glm::vec2 side,
                                    std::string_view text,
                                    std::span<const std::pair<const char*, Icon>> buttons) {
  const Ui& ui = context.ui;
  std::optional<std::size_t> pressed;
  // Not over the panels on the right: else on the left, or below.
  const float width = text_size(ui.fonts.body, text).x + 2.0F * ImGui::GetStyle().WindowPadding.x +
                      ui.px(16) + static_cast<float>(buttons.size()) * ui.px(k_row_height + 6);
  const FreeArea free = context.free_area();
  if (side.x > 0.0F && box.max.x + width > static_cast<float>(free.max.x))
    side = box.min.x - width > static_cast<float>(free.min.x) ? -side : glm::vec2(0.0F, 1.0F);
  const glm::vec2 at = box.centre() + side * (0.5F * (box.max - box.min) + glm::vec2(ui.px(16)));
  const glm::vec2 tip = at - side * ui.px(8), across(side.y, side.x);
  place_window(at, 0.5F - 0.5F * side);
  ImGui::PushStyleColor(ImGuiCol_WindowBg, ui.colours->accent);
  ImGui::Begin("##Hint", nullptr, k_card_window);
  ImGui::PopStyleColor();
  row_text(ui, {ui.fonts.body, ui.colours->on_accent}, text_size(ui.fonts.body, text).x, text);
  for (std::size_t k = 0; k < buttons.size(); ++k) {
    ImGui::SameLine(0.0F, ui.px(6));
    const Pressable item = pressable(ui, buttons[k].first, glm::vec2(ui.px(k_row_height)));
    draw_icon(window_list(), buttons[k].second, item.box.centre(), ui.px(12), ui.colours->on_accent);
    if (item.clicked) pressed = k;
  }
  ImDrawList& list = window_list();
  list.PushClipRectFullScreen();
  list.AddTriangleFilled(tip, at + across * ui.px(7), at - across * ui.px(7), ui.colours->accent);
  list.PopClipRect();
  ImGui::End();
  return pressed;
}

/// Goes on by itself.
void draw_tour(const PanelContext& context) {
  const Ui& ui = context.ui;
  auto& tour = context.edits.tour;
  const HintPlace<Step>& stop = k_tour[tour->stop];
  if (tour->since_s == 0.0) {
    tour->since_s = ui.now_s;
    context.edits.enter(stop.of);
  } else if (context.state.step != stop.of) {
    return tour.reset();  // who goes elsewhere needs no guide
  }
  const auto control = ui.memory->controls.find(stop.control);
  std::optional<std::size_t> pressed;
  if (control != ui.memory->controls.end())
    pressed = point_at(context, control->second, stop.side,
                       fmt::format("{}   {} of {}", stop.text, tour->stop + 1, std::size(k_tour)),
                       std::array<std::pair<const char*, Icon>, 2>{
                           {{"go on", Icon::chevron_right}, {"end the tour", Icon::close}}});
  ui.memory->wake_s = std::min(ui.memory->wake_s, tour->since_s + k_stop_s);
  if (pressed == 1) return tour.reset();
  if (!pressed && ui.now_s < tour->since_s + k_stop_s) return;
  tour = {.stop = tour->stop + 1};
  if (tour->stop == std::size(k_tour)) tour.reset();
}

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
  constexpr double k_at_once_s = 0.3;  // a body of a file that is in memory is there sooner: not announced
  const bool in_memory = context.state.bodies.whole && loading.path == context.state.path;
  if (in_memory && ui.now_s - loading.since_s < k_at_once_s) {
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

void draw_presented(const PanelContext& context) {
  const Ui& ui = context.ui;
  const Presented& shown = *context.state.presented;
  constexpr double k_keys_s = 4.0;
  if (shown.fading != 0)
    scene_list().AddImage(texture_id(shown.fading), ImVec2(0, 0), screen_size(), ImVec2(0, 1), ImVec2(1, 0),
                          IM_COL32(255, 255, 255, static_cast<int>(255.0 * shown.fade)));
  const auto lines = lines_within(ui.fonts.title, shown.caption, 0.8F * screen_size().x, 2);
  place_window({0.5F * screen_size().x, screen_size().y - ui.px(16)}, {0.5F, 1.0F});
  ImGui::Begin("Caption", nullptr, k_card_window | ImGuiWindowFlags_NoInputs);
  const glm::vec2 start = cursor_at();
  float width = 0.0F;
  for (const std::string& line : lines) width = std::max(width, text_size(ui.fonts.title, line).x);
  for (std::size_t k = 0; k < lines.size(); ++k)
    draw_text({ui.fonts.title, ui.colours->text},
              start + glm::vec2(0.5F * (width - text_size(ui.fonts.title, lines[k]).x),
                                ui.fonts.title.size * static_cast<float>(k)),
              lines[k]);
  ImGui::Dummy(ImVec2(width, ui.fonts.title.size * static_cast<float>(lines.size())));
  ImGui::End();
  if (shown.recording || (shown.time_s > k_keys_s && !shown.paused)) return;
  draw_tag(ui, {0.5F * screen_size().x, ui.px(24)},
           shown.paused ? "Space goes on" : "Space pauses, F12 takes a picture, Esc ends", ui.colours->text);
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
  if (state.tour && state.figures.shown) return draw_tour(context);
  const auto place =
      std::ranges::find_if(k_places, [&](const auto& each) { return !state.hints_done.contains(each.of); });
  if (place == std::end(k_places) || state.tour) return;
  const auto control = ui.memory->controls.find(place->control);
  if (control == ui.memory->controls.end() || state.step != Step::direction) return;
  const glm::vec2 at = control->second.centre();
  const FreeArea free = context.free_area();
  if (place->of == Hint::arrow &&
      (at.x < static_cast<float>(free.min.x) || at.x > static_cast<float>(free.max.x)))
    return;  // behind a panel
  if (point_at(context, control->second, place->side, place->text,
               std::array<std::pair<const char*, Icon>, 1>{{{"dismiss the hint", Icon::close}}}))
    context.edits.hints_done.insert(place->of);
}

}  // namespace moldlight::gui
