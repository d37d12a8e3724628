#include "gui/panels/workspace.hpp"

#include <fmt/format.h>

#include "base/shown_text.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/store/files.hpp"

namespace moldlight::gui {

namespace {

std::vector<HelpLine> mouse_help(NavigationPreset preset) {
  constexpr std::array<std::array<const char*, 2>, 4> k_drags = {{{"Left drag", "Right or middle drag"},
                                                                  {"Middle drag", "Ctrl + middle drag"},
                                                                  {"Shift + middle drag", "Middle drag"},
                                                                  {"Middle drag", "Shift + middle drag"}}};
  const auto& [turn, shift] = k_drags[static_cast<std::size_t>(preset)];
  return {{turn, "turn"}, {shift, "shift"}, {"Wheel", "zoom to the cursor"}};
}

/// The lines that have the words; nothing where there is none.
void draw_lines(const Ui& ui, std::string_view title, std::vector<HelpLine> lines, const std::string& words) {
  std::erase_if(lines, [&](const HelpLine& line) {
    return lower_letters(fmt::format("{} {}", line.keys, line.meaning)).find(words) == std::string::npos;
  });
  if (lines.empty()) return;
  heading(ui, title);
  ImGui::Dummy(ImVec2(1, ui.px(2)));
  const float left = ImGui::GetCursorPosX();
  for (const HelpLine& line : lines) {
    draw_item_text(ui.colours->text, line.keys);
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + ui.px(148));
    draw_item_text(ui.colours->muted, line.meaning);
  }
  ImGui::Dummy(ImVec2(1, ui.px(10)));
}

}  // namespace

void Workspace::draw(const PanelContext& context, const Textures& textures) {
  const Dialogs& dialogs = context.state.dialogs;
  if (context.state.presented) {
    draw_presented(context);
    draw_picture_dialog(context, picture_);
    return draw_toasts(context);
  }
  if (!dialogs.panels_hidden) {
    draw_top_bar(context);
    if (context.state.model) {
      const StepPictures pictures{textures.candidates, textures.bodies};
      steps_.draw(context, pictures);
      draw_regions_panel(context);
      draw_look_panel(context);
      draw_maps_drawer(context, textures.maps);
      steps_.draw_below(context, pictures);
      draw_revisions_bar(context, revisions_);
      draw_large_ball(context, large_ball_);
      draw_comparison(context);
    }
  }
  if (!dialogs.panels_hidden) batch_.draw(context, textures.batch);
  if (context.state.model) {
    draw_view_cube(context);
    draw_chosen_face(context);
    draw_measuring(context);
    draw_draft_marks(context);
    draw_cursor_readout(context);
  }
  draw_start_page(context, textures.shipped_parts);
  draw_loading(context);
  draw_large_map(context, textures.maps);
  browser_.draw(context);
  draw_dropped(context);
  export_.draw(context);
  mold_export_.draw(context);
  draw_picture_dialog(context, picture_);
  draw_finishes_dialog(context, finishes_);
  draw_film_dialog(context, film_);
  draw_settings(context);
  help_.draw(context);
  draw_toasts(context);
}

void HelpSheet::draw(const PanelContext& context) {
  const bool opens = context.state.dialogs.help && !open_;
  open_ = context.state.dialogs.help;
  if (!open_) return;
  if (opens) filter_.fill(0);
  const Ui& ui = context.ui;
  if (begin_dialog(ui, "Help", {0, 0})) {
    text_field(ui, "##search", filter_, {.hint = "search", .width = ui.px(280), .starts = opens});
    ImGui::SameLine();
    if (button(ui, "Documentation"))
      context.edits.commands.emplace_back(
          [](Commands& commands) { commands.say(open_documentation(), false); });
    ImGui::Dummy(ImVec2(ui.px(840), ui.px(4)));
    const std::string words = lower_letters(filter_.data());
    const float left = ImGui::GetCursorPosX();
    ImGui::BeginGroup();
    draw_lines(ui, "Direction", help_lines(HelpLine::Group::direction), words);
    draw_lines(ui, "Mouse", mouse_help(context.state.window.navigation), words);
    ImGui::EndGroup();
    ImGui::SameLine();
    ImGui::SetCursorPosX(left + ui.px(440));
    ImGui::BeginGroup();
    draw_lines(ui, "View", help_lines(HelpLine::Group::view), words);
    draw_lines(ui, "Program", help_lines(HelpLine::Group::program), words);
    ImGui::EndGroup();
  }
  if (end_dialog(ui)) context.edits.dialogs.help = false;
}

void draw_dropped(const PanelContext& context) {
  const auto& dropped = context.state.dialogs.dropped;
  if (!dropped) return;
  const Ui& ui = context.ui;
  Edits& edits = context.edits;
  const auto name = [&](const std::string& path) {
    return fitted(ui.fonts.body, std::filesystem::path(path).filename().string(), ui.px(240));
  };
  if (begin_dialog(ui, "Dropped", {ui.px(440), 0.0F})) {
    heading(ui, name(*dropped));
    hint(ui, fmt::format("Compared, it is the new revision of {}.", name(context.state.path)));
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    if (button(ui, "Open", {.width = ui.px(112), .strong = true})) {
      edits.ask(&Commands::open_part, *dropped);
      edits.dialogs.dropped.reset();
    }
    ImGui::SameLine();
    if (button(ui, "Compare", {.width = ui.px(112)})) {
      edits.ask(&Commands::compare_with, *dropped);
      edits.dialogs.dropped.reset();
    }
    ImGui::SameLine();
    if (button(ui, "Cancel", {.width = ui.px(96)})) edits.dialogs.dropped.reset();
  }
  if (end_dialog(ui)) edits.dialogs.dropped.reset();
}

void draw_settings(const PanelContext& context) {
  if (!context.state.dialogs.settings) return;
  const Ui& ui = context.ui;
  if (begin_dialog(ui, "Window settings", {ui.px(420), 0.0F})) {
    heading(ui, "Window");
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    for (const Option<WindowSettings>& option : window_options())
      option_row(ui, option, context.edits.window);
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    bool beside = context.state.notes_beside;
    if (context.state.model && toggle(ui, {"Keep settings and bookmarks beside the part"}, beside))
      context.edits.ask(&Commands::save_notes_beside, beside);
    if (button(ui, "Put the panels back in place")) context.edits.ask(&Commands::reset_layout);
    ImGui::SameLine();
    if (button(ui, "Close", {.width = 0.0F, .strong = true})) context.edits.dialogs.settings = false;
  }
  if (end_dialog(ui)) context.edits.dialogs.settings = false;
}

}  // namespace moldlight::gui
