// The thin bar on top: the part's name with recent files, the steps, and what is done at any time.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

namespace {

constexpr const char* k_recent = "recent";
constexpr float k_icon_step = 4.0F, k_group_gap = 8.0F;        // layout units
constexpr float k_least_name = 72.0F, k_widest_name = 260.0F;  // of the part, layout units

void draw_recent(const PanelContext& context) {
  const Ui& ui = context.ui;
  constexpr float k_popup_width = 320.0F;  // layout units
  if (!begin_popup(ui, k_recent, ui.px(k_popup_width))) return;
  if (menu_item(ui, context.state.revisions.on() ? "Leave the comparison" : "Compare with…"))
    context.edits.ask(&Commands::compare_or_leave);
  const auto offer = [&](const std::string& path) {
    const std::string name =
        fitted(ui.fonts.body, fs::path(path).filename().string(), ui.px(k_popup_width - 48));
    if (menu_item(ui, fmt::format("{}##{}", name, path))) context.edits.ask(&Commands::open_part, path);
    tooltip(ui, {}, path);
  };
  if (!context.state.recent.empty()) hint(ui, "Recent");
  for (const std::string& path : context.state.recent) offer(path);
  if (!context.state.shipped.empty()) hint(ui, "Shipped with moldlight");
  for (const std::string& path : context.state.shipped) offer(path);
  end_popup(ui);
}

/// In so many pixels.
void draw_part_name(const PanelContext& context, float room) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const std::string file = fs::path(state.path).filename().string();
  const std::string name = fitted(ui.fonts.body, file, room - ui.px(36));
  const float width = text_size(ui.fonts.body, name).x + ui.px(36);
  if (button(ui, fmt::format("{}##part", name), {.width = width})) open_popup_below_item(ui, k_recent);
  name_item(ui, "part name");
  draw_icon(window_list(), Icon::chevron_down, {item_box().max.x - ui.px(11), item_box().centre().y},
            ui.px(9), ui.colours->muted);
  tooltip(ui, file, state.path);
  draw_recent(context);
}

/// Of the buttons at the right end, pixels.
float right_width(const Ui& ui, bool part) {
  const float buttons = static_cast<float>(part ? 7 : 3) * (ui.px(k_row_height) + ui.px(k_icon_step));
  return buttons + ui.px(part ? 12.0F + k_group_gap : 12.0F);
}

/// Most of them do what a key does.
void draw_right(const PanelContext& context) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const bool part = state.model != nullptr, compares = state.revisions.on();
  float left = ImGui::GetWindowWidth() - right_width(ui, part), gap = 0.0F;
  const auto item = [&](const IconButtonSpec& spec, const KeyPress& key, bool enabled = true) {
    ImGui::SameLine(std::exchange(left, 0.0F), std::exchange(gap, ui.px(k_icon_step)));
    ImGui::BeginDisabled(!enabled);
    const bool clicked = icon_button(ui, spec);
    ImGui::EndDisabled();
    if (clicked && key.key != 0) apply_shortcut(key, state, context.edits);
    return clicked;
  };
  item({"open", Icon::open, "Open a part (Ctrl+O)"}, {'O', true});
  if (part) {
    item({"compare", Icon::revisions,
          compares ? "Leave the comparison (Ctrl+D)" : "Compare with another revision (Ctrl+D)", compares},
         {'D', true});
    item({"measure", Icon::ruler, "Measure between two places (R)", context.edits.measuring.has_value()},
         {'R'});
    gap = ui.px(k_icon_step) + ui.px(k_group_gap);
    item({"undo", Icon::undo, "Undo (Ctrl+Z)"}, {'Z', true}, state.can_undo);
    item({"redo", Icon::redo, "Redo (Ctrl+Y)"}, {'Y', true}, state.can_redo);
  }
  item({"help", Icon::help, "Keys and mouse (H)", state.dialogs.help}, {'H'});
  if (item({"settings", Icon::settings, "Window settings", state.dialogs.settings}, {}))
    context.edits.dialogs.settings = !context.edits.dialogs.settings;
}

}  // namespace

void draw_top_bar(const PanelContext& context) {
  const Ui& ui = context.ui;
  const ImGuiIO& io = ImGui::GetIO();
  ImGui::SetNextWindowPos(ImVec2(0, 0));
  ImGui::SetNextWindowSize(ImVec2(io.DisplaySize.x, ui.px(k_bar_height)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      ImVec2(ui.px(16), 0.5F * (ui.px(k_bar_height) - ui.px(k_row_height))));
  ImGui::Begin("Bar", nullptr,
               k_fixed_window | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
  if (context.state.model) {
    const float strip = strip_width(context), gap = ui.px(16);
    const float room = io.DisplaySize.x - right_width(ui, true) - strip - 3.0F * gap;
    draw_part_name(context, std::clamp(room, ui.px(k_least_name), ui.px(k_widest_name)));
    // In the middle of the window, where the buttons and the part's name leave that free.
    const float least = item_box().max.x + gap, most = io.DisplaySize.x - right_width(ui, true) - gap - strip;
    ImGui::SameLine(0.0F, 0.0F);
    ImGui::SetCursorPosX(std::max(least, std::min(most, std::round(0.5F * (io.DisplaySize.x - strip)))));
    draw_strip(context);
  } else {
    row_text(ui, ui.strong(), text_size(ui.fonts.strong, "moldlight").x, "moldlight");
  }
  draw_right(context);
  ImGui::End();
  ImGui::PopStyleVar(4);
}

}  // namespace moldlight::gui
