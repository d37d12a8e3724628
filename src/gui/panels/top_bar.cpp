// The bar on top: the part's name with what is done with it, the steps, undo and the program's own things.
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "gui/draw/widgets.hpp"
#include "gui/panels/step_parts.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

namespace {

constexpr const char* k_part_menu = "part menu";
constexpr float k_gap = 4.0F, k_inset = 12.0F;                 // layout units
constexpr float k_least_name = 88.0F, k_widest_name = 220.0F;  // of the part, layout units
constexpr float k_step_inset = 9.0F, k_step_sign = 15.0F;      // layout units
constexpr float k_step_height = 28.0F;

void draw_part_menu(const PanelContext& context) {
  const Ui& ui = context.ui;
  Edits& edits = context.edits;
  constexpr float k_popup_width = 320.0F;  // layout units
  if (!begin_popup(ui, k_part_menu, ui.px(k_popup_width))) return;
  if (menu_item(ui, "Open …")) {
    edits.dialogs.browser = true;
    edits.dialogs.browser_compares = false;
  }
  if (menu_item(ui, context.state.revisions.on() ? "Leave the comparison" : "Compare with …"))
    edits.ask(&Commands::compare_or_leave);
  if (menu_item(ui, "Measure", {.chosen = edits.measuring.has_value()}))
    edits.measuring = edits.measuring ? std::nullopt : std::optional(Measuring{});
  if (menu_item(ui, "Save a picture …")) edits.ask(&Commands::take_picture);
  if (menu_item(ui, "Export …")) edits.dialogs.exporting = true;
  const auto offer = [&](const std::string& path) {
    const std::string name =
        fitted(ui.fonts.body, fs::path(path).filename().string(), ui.px(k_popup_width - 48));
    if (menu_item(ui, fmt::format("{}##{}", name, path))) edits.ask(&Commands::open_part, path);
    tooltip(ui, {}, path);
  };
  if (!context.state.recent.empty()) hint(ui, "Recent");
  for (const std::string& path : context.state.recent) offer(path);
  if (!context.state.shipped.empty()) hint(ui, "Shipped with moldlight");
  for (const std::string& path : context.state.shipped) offer(path);
  end_popup(ui);
}

void draw_part_name(const PanelContext& context, float room) {
  const Ui& ui = context.ui;
  const std::string file = fs::path(context.state.path).filename().string();
  const std::string name = fitted(ui.fonts.strong, file, room - ui.px(36));
  const Pressable part =
      pressable(ui, "part name", {text_size(ui.fonts.strong, name).x + ui.px(36), ui.px(k_step_height)});
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (part.hovered) fill(list, part.box, ui.colours->field_hovered, ui.px(6));
  draw_text(list, {ui.fonts.strong, ui.colours->text},
            {part.box.min.x + ui.px(8), part.box.centre().y - 0.5F * ui.fonts.strong.size}, name);
  draw_icon(list, Icon::chevron_down, {part.box.max.x - ui.px(13), part.box.centre().y}, ui.px(9),
            ui.colours->muted);
  tooltip(ui, file, context.state.path);
  if (part.clicked) open_popup_below_item(ui, k_part_menu);
  draw_part_menu(context);
}

/// A step as it is written: its number where there is room, its name, what its mark says.
struct StepTab {
  Step step;
  StepMark mark;
  std::string number = {};
  float width = 0.0F;  // pixels
};

std::vector<StepTab> step_tabs(const PanelContext& context, bool numbered) {
  const Ui& ui = context.ui;
  std::vector<StepTab> tabs;
  for (std::size_t k = 0; k < k_step_titles.size(); ++k) {
    StepTab tab{.step = static_cast<Step>(k), .mark = step_mark(context.state, static_cast<Step>(k))};
    if (numbered) tab.number = fmt::format("{} ", k + 1);
    tab.width = 2.0F * ui.px(k_step_inset) + text_size(ui.fonts.body, tab.number).x +
                text_size(ui.fonts.strong, k_step_titles[k]).x;
    if (!tab.mark.text.empty()) tab.width += ui.px(6) + text_size(ui.fonts.body, tab.mark.text).x;
    // Signs come and go while one works: their place stays.
    if (tab.step != Step::report) tab.width += ui.px(k_step_sign);
    tabs.push_back(std::move(tab));
  }
  return tabs;
}

void draw_step_tab(const PanelContext& context, const StepTab& tab) {
  const Ui& ui = context.ui;
  const std::string id = fmt::format("step {}", static_cast<int>(tab.step) + 1);
  const Pressable item = pressable(ui, id.c_str(), {tab.width, ui.px(k_step_height)});
  const bool here = context.state.step == tab.step;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (here || item.hovered)
    fill(list, item.box, here ? ui.colours->field_active : ui.colours->field_hovered, ui.px(6));
  glm::vec2 at(item.box.min.x + ui.px(k_step_inset), 0.0F);
  const auto write = [&](const SizedFont& font, ImU32 colour, std::string_view text) {
    draw_text(list, {font, colour}, {at.x, item.box.centre().y - 0.5F * font.size}, text);
    at.x += text_size(font, text).x;
  };
  write(ui.fonts.body, ui.colours->muted, tab.number);
  write(here ? ui.fonts.strong : ui.fonts.body, here || item.hovered ? ui.colours->text : ui.colours->muted,
        step_title(tab.step));
  using MarkSign = StepMark::Sign;
  const bool warns = tab.mark.sign == MarkSign::warning;
  if (!tab.mark.text.empty()) {
    at.x += ui.px(6);
    write(ui.fonts.body, warns ? ui.colours->warning : ui.colours->text, tab.mark.text);
  }
  const glm::vec2 sign(at.x + ui.px(10), item.box.centre().y);
  if (tab.mark.sign == MarkSign::good) draw_icon(list, Icon::check, sign, ui.px(11), ui.colours->text);
  if (warns) draw_icon(list, Icon::alert, sign, ui.px(12), ui.colours->warning);
  if (tab.mark.sign == MarkSign::working)
    list.AddCircle(im(sign), ui.px(3), ui.colours->muted, 0, 1.5F * ui.scale);
  tooltip(ui, fmt::format("{} ({})", step_title(tab.step), static_cast<int>(tab.step) + 1), tab.mark.tip);
  if (item.clicked) context.edits.step = tab.step;
}

void draw_right(const PanelContext& context) {
  const Ui& ui = context.ui;
  Edits& edits = context.edits;
  const bool part = context.state.model != nullptr;
  const float step = ui.px(k_gap);
  ImGui::SetCursorPos(ImVec2(ImGui::GetWindowWidth() - ui.px(k_inset) -
                                 static_cast<float>(part ? 4 : 3) * (ui.px(k_row_height) + step),
                             0.5F * (ui.px(k_bar_height) - ui.px(k_row_height))));
  const auto item = [&](const char* id, Icon icon, std::string_view tip, bool chosen = false) {
    const bool clicked = icon_button(ui, {id, icon, tip, chosen});
    ImGui::SameLine(0.0F, step);
    return clicked;
  };
  if (part) {
    ImGui::BeginDisabled(!context.state.can_undo);
    if (item("undo", Icon::undo, "Undo (Ctrl+Z)")) edits.ask(&Commands::undo);
    ImGui::EndDisabled();
    ImGui::BeginDisabled(!context.state.can_redo);
    if (item("redo", Icon::redo, "Redo (Ctrl+Y)")) edits.ask(&Commands::redo);
    ImGui::EndDisabled();
  } else if (item("open", Icon::open, "Open a part (Ctrl+O)")) {
    edits.dialogs.browser = true;
    edits.dialogs.browser_compares = false;
  }
  if (item("help", Icon::help, "Keys and mouse (H)", context.state.dialogs.help))
    edits.dialogs.help = !edits.dialogs.help;
  if (item("settings", Icon::settings, "Window settings", context.state.dialogs.settings))
    edits.dialogs.settings = !edits.dialogs.settings;
}

void draw_steps(const PanelContext& context) {
  const Ui& ui = context.ui;
  const float right = ImGui::GetWindowWidth() - 2.0F * ui.px(k_inset) - 4.0F * ui.px(k_row_height + k_gap);
  const auto width_of = [&](const std::vector<StepTab>& tabs) {
    float width = 0.0F;
    for (const StepTab& tab : tabs) width += tab.width + ui.px(k_gap);
    return width;
  };
  const float room = right - ui.px(k_inset + 8);
  std::vector<StepTab> tabs = step_tabs(context, true);
  if (width_of(tabs) + ui.px(k_least_name) > room) tabs = step_tabs(context, false);
  const float name = std::clamp(room - width_of(tabs), ui.px(k_least_name), ui.px(k_widest_name));
  draw_part_name(context, name);
  ImGui::SameLine(0.0F, ui.px(8));
  for (const StepTab& tab : tabs) {
    draw_step_tab(context, tab);
    ImGui::SameLine(0.0F, ui.px(k_gap));
  }
}

}  // namespace

void draw_top_bar(const PanelContext& context) {
  const Ui& ui = context.ui;
  ImGui::SetNextWindowPos(ImVec2(0, 0));
  ImGui::SetNextWindowSize(ImVec2(ImGui::GetIO().DisplaySize.x, ui.px(k_bar_height)));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0F);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                      ImVec2(ui.px(k_inset), 0.5F * (ui.px(k_bar_height) - ui.px(k_step_height))));
  ImGui::Begin("Bar", nullptr,
               k_fixed_window | ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollWithMouse);
  if (context.state.model)
    draw_steps(context);
  else
    row_text(ui, {ui.fonts.strong, ui.colours->text}, text_size(ui.fonts.strong, "moldlight").x, "moldlight");
  draw_right(context);
  ImGui::End();
  ImGui::PopStyleVar(4);
}

}  // namespace moldlight::gui
