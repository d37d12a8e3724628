// The thin bar on top: the part's name with recent files, and what is done with it.
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

namespace {

constexpr const char* k_recent = "recent";

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

void draw_part_name(const PanelContext& context) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  if (!state.model) return;
  const std::string file = fs::path(state.path).filename().string();
  const std::string name = fitted(ui.fonts.body, file, ui.px(260));
  const float width = text_size(ui.fonts.body, name).x + ui.px(36);
  if (button(ui, fmt::format("{}##part", name), {.width = width})) open_popup_below_item(ui, k_recent);
  name_item(ui, "part name");
  draw_icon(*ImGui::GetWindowDrawList(), Icon::chevron_down,
            {item_box().max.x - ui.px(11), item_box().centre().y}, ui.px(9), ui.colours->muted);
  tooltip(ui, file, state.path);
  draw_recent(context);
  ImGui::SameLine(0.0F, ui.px(10));
  const Part& part = state.model->part;
  const std::string facts = fmt::format("{} facets   {}", grouped(std::to_string(part.mesh.facets.size())),
                                        part.unit.empty() ? "" : part.unit);
  row_text(ui, {ui.fonts.small, ui.colours->muted}, text_size(ui.fonts.small, facts).x, facts);
  if (!state.model->warnings.empty()) {
    ImGui::SameLine(0.0F, ui.px(6));
    icon_button(ui, {"warnings", Icon::alert, fmt::format("{}", fmt::join(state.model->warnings, "\n"))});
  }
}

void draw_right(const PanelContext& context) {
  const Ui& ui = context.ui;
  Edits& edits = context.edits;
  const bool part = context.state.model != nullptr;
  const float step = ui.px(4);
  const int count = part ? 9 : 3;
  ImGui::SameLine(0.0F, 0.0F);
  ImGui::SetCursorPosX(ImGui::GetWindowWidth() - ui.px(12) -
                       static_cast<float>(count) * (ui.px(k_row_height) + step) - (part ? ui.px(16) : 0.0F));
  if (icon_button(ui, {"open", Icon::open, "Open a part (Ctrl+O)"})) {
    edits.dialogs.browser = true;
    edits.dialogs.browser_compares = false;
  }
  float gap = step;
  const auto item = [&](const char* id, Icon icon, std::string_view tip, bool chosen = false) {
    ImGui::SameLine(0.0F, std::exchange(gap, step));
    return icon_button(ui, {id, icon, tip, chosen});
  };
  if (part) {
    const bool compares = context.state.revisions.on();
    if (item("compare", Icon::revisions,
             compares ? "Leave the comparison (Ctrl+D)" : "Compare with another revision (Ctrl+D)", compares))
      edits.ask(&Commands::compare_or_leave);
    if (item("export", Icon::export_file, "Export what was measured (Ctrl+E)"))
      edits.dialogs.exporting = true;
    if (item("picture", Icon::picture, "Save a picture with the legend (F12)"))
      edits.ask(&Commands::take_picture);
    if (item("measure", Icon::ruler, "Measure between two places (R)", edits.measuring.has_value()))
      edits.measuring = edits.measuring ? std::nullopt : std::optional(Measuring{});
    gap = step + ui.px(16);
    ImGui::BeginDisabled(!context.state.can_undo);
    if (item("undo", Icon::undo, "Undo (Ctrl+Z)")) edits.ask(&Commands::undo);
    ImGui::EndDisabled();
    ImGui::BeginDisabled(!context.state.can_redo);
    if (item("redo", Icon::redo, "Redo (Ctrl+Y)")) edits.ask(&Commands::redo);
    ImGui::EndDisabled();
  }
  if (item("help", Icon::help, "Keys and mouse (H)", context.state.dialogs.help))
    edits.dialogs.help = !edits.dialogs.help;
  if (item("settings", Icon::settings, "Window settings", context.state.dialogs.settings))
    edits.dialogs.settings = !edits.dialogs.settings;
}

}  // namespace

void draw_top_bar(const PanelContext& context) {
  const Ui& ui = context.ui;
  const ImGuiIO& io = ImGui::GetIO();
  // The part may reach behind the bar where an undercut is seen from near.
  const bool near = io.MousePos.y < 2.0F * ui.px(k_bar_height) || !context.state.model ||
                    ui.memory->popups.any() || context.state.action_choices.chosen;
  ImGui::SetNextWindowPos(ImVec2(0, 0));
  ImGui::SetNextWindowSize(ImVec2(io.DisplaySize.x, ui.px(k_bar_height)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      ImVec2(ui.px(16), 0.5F * (ui.px(k_bar_height) - ui.px(k_row_height))));
  ImGui::PushStyleColor(ImGuiCol_WindowBg, near ? ui.colours->panel : IM_COL32(0, 0, 0, 0));
  ImGui::Begin("Bar", nullptr,
               k_fixed_window | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
  row_text(ui, {ui.fonts.strong, ui.colours->text}, text_size(ui.fonts.strong, "moldlight").x, "moldlight");
  ImGui::SameLine(0.0F, ui.px(16));
  draw_part_name(context);
  draw_right(context);
  ImGui::End();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar(4);
}

}  // namespace moldlight::gui
