// The part: what the file has, its unit, the body that is molded, and the tolerances of its regions.

#include <fmt/format.h>
#include <glm/common.hpp>

#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

/// The bodies of the file, and which of them is shown.
struct Bodies {
  std::vector<std::string> names;
  std::size_t chosen = 0;  // from 1; 0: all as one part
};

Bodies bodies_of(const Part& part) {
  if (part.chosen_body > 0) return {part.file_bodies, part.chosen_body};
  Bodies all;
  for (const Body& body : part.bodies) all.names.push_back(body.name);
  return all;
}

std::string body_text(const Bodies& bodies, std::size_t number) {
  if (number == 0) return fmt::format("all {}", bodies.names.size());
  const std::string& name = bodies.names[number - 1];
  return name.empty() ? fmt::format("{}", number) : fmt::format("{}  {}", number, name);
}

void list_bodies(const Ui& ui, const Bodies& bodies, std::size_t& wanted) {
  if (!begin_popup(ui, "bodies", ui.px(280))) return;
  for (std::size_t number = 0; number <= bodies.names.size(); ++number) {
    const std::string text =
        fmt::format("{}##{}", fitted(ui.fonts.body, body_text(bodies, number), ui.px(240)), number);
    if (menu_item(ui, text, {.chosen = number == bodies.chosen})) wanted = number;
    name_item(ui, fmt::format("body {}", number));
  }
  end_popup(ui);
}

/// The unit that the part has; choosing one names or converts it, a reset leaves it to the file.
void draw_unit(const PanelContext& context) {
  const Option<ReadOptions>& option = option_named(reading_options(), "unit");
  const Words& words = std::get<TextKind<ReadOptions>>(option.kind).words;
  std::string& wanted = context.edits.reading.unit;
  const std::string chosen = wanted, as_in_the_file;
  int index = static_cast<int>(std::ranges::find(words, context.state.model->part.unit) - words.begin());
  if (choice(context.ui, {option.label, !chosen.empty()}, words, index))
    wanted = words[static_cast<std::size_t>(index)];
  if (option_menu(context.ui, {option.label, option.help, chosen, as_in_the_file})) wanted.clear();
}

/// Goes through the bodies one by one, or opens the list of them.
void draw_body(const PanelContext& context) {
  const Ui& ui = context.ui;
  const Bodies bodies = bodies_of(context.state.model->part);
  const std::size_t count = bodies.names.size();
  if (count < 2) return;
  std::size_t wanted = bodies.chosen;
  const float gap = ui.px(4), arrow = ui.px(k_row_height);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(8));
  row_text(ui, ui.muted(), ui.px(64), "Body");
  ImGui::SameLine(0.0F, 0.0F);
  const float width = room_left() - 2.0F * (arrow + gap);
  if (icon_button(ui, {"previous body", Icon::chevron_left, "Previous body"}))
    wanted = (wanted + count) % (count + 1);
  ImGui::SameLine(0.0F, gap);
  const std::string shown = fitted(ui.fonts.body, body_text(bodies, bodies.chosen), width - ui.px(16));
  if (button(ui, fmt::format("{}##body", shown), {.width = width})) open_popup_below_item(ui, "bodies");
  name_item(ui, "body");
  list_bodies(ui, bodies, wanted);
  ImGui::SameLine(0.0F, gap);
  if (icon_button(ui, {"next body", Icon::chevron_right, "Next body"})) wanted = (wanted + 1) % (count + 1);
  if (wanted != bodies.chosen) context.edits.reading.body = wanted == 0 ? "all" : fmt::format("{}", wanted);
  if (bodies.chosen == 0) hint(ui, "All bodies as one part. Choose the body that is molded.");
}

}  // namespace

void draw_part_controls(const PanelContext& context) {
  const Ui& ui = context.ui;
  const PartModel& model = *context.state.model;
  glm::vec3 least(0.0F), most(0.0F);
  for (const glm::vec3& point : context.state.extremes) {
    least = glm::min(least, point);
    most = glm::max(most, point);
  }
  const glm::dvec3 size = model.frame.diagonal * glm::dvec3(most - least);
  hint(ui, fmt::format("{} facets · {} × {} × {} {}", grouped(std::to_string(model.part.mesh.facets.size())),
                       rounded(size.x), rounded(size.y), rounded(size.z), length_unit(model.part)));
  for (const std::string& repair : model.part.repairs) hint(ui, repair);
  for (const std::string& warning : model.warnings) {
    const glm::vec2 at = cursor_at();
    draw_icon(window_list(), Icon::alert, at + glm::vec2(ui.px(6), ui.px(8)), ui.px(12), ui.colours->warning);
    ImGui::Indent(ui.px(18));
    hint(ui, warning);
    ImGui::Unindent(ui.px(18));
  }
  ImGui::Dummy(ImVec2(1.0F, ui.px(2)));
  draw_unit(context);
  draw_body(context);
  option_row(ui, option_named(reading_options(), "repair"), context.edits.reading);
  MethodSettings& method = context.edits.settings.method;
  const PartLengths lengths(context.state);
  option_row(ui, option_named(method_options(), "tau_deg"), method);
  option_row(
      ui, option_named(method_options(), "tolerance"), method,
      {.lengths = &lengths, .unset = fmt::format("{:.3g}", lateral_tolerance(method, lengths.diagonal))});
}

}  // namespace moldlight::gui
