#include "gui/panels/step_parts.hpp"

#include <fmt/format.h>

#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_note_line = 16.0F, k_note_inset = 22.0F;  // layout units
constexpr std::size_t k_most_note_lines = 8;

}  // namespace

void draw_note(const Ui& ui, const Note& note) {
  const glm::vec2 at = from_im(ImGui::GetCursorScreenPos());
  const float inset = ui.px(note.icon ? k_note_inset : 4.0F), width = ImGui::GetContentRegionAvail().x;
  const auto lines = lines_within(ui.fonts.small, note.text, width - inset, k_most_note_lines);
  ImGui::Dummy(ImVec2(width, ui.px(k_note_line) * static_cast<float>(lines.size())));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = faded(note.warning ? ui.colours->warning : ui.colours->text, note.alpha);
  if (note.icon)
    draw_icon(list, *note.icon, at + glm::vec2(ui.px(10), 0.5F * ui.px(k_note_line)), ui.px(11),
              note.warning ? colour : faded(ui.colours->muted, note.alpha));
  const float down = 0.5F * (ui.px(k_note_line) - ui.fonts.small.size);
  for (std::size_t k = 0; k < lines.size(); ++k)
    draw_text(list, {ui.fonts.small, colour},
              at + glm::vec2(inset, down + ui.px(k_note_line) * static_cast<float>(k)), lines[k]);
}

void draw_fact(const Ui& ui, std::string_view name, std::string_view value) {
  const float width = ImGui::GetContentRegionAvail().x;
  const glm::vec2 at = from_im(ImGui::GetCursorScreenPos());
  ImGui::Dummy(ImVec2(width, ui.px(20)));
  const float top = at.y + 0.5F * (ui.px(20) - ui.fonts.body.size);
  draw_text(*ImGui::GetWindowDrawList(), {ui.fonts.body, ui.colours->muted}, {at.x + ui.px(8), top}, name);
  const float room = width - text_size(ui.fonts.body, name).x - ui.px(28);
  draw_text_to({ui.fonts.body, ui.colours->text}, at.x + width - ui.px(8), top,
               fitted(ui.fonts.body, value, room));
}

void draw_news(const PanelContext& context, StepMemory& memory, const StepNews& news,
               const StepSettings& settings) {
  const Ui& ui = context.ui;
  const glm::vec2 start = from_im(ImGui::GetCursorScreenPos());
  const float width = ImGui::GetContentRegionAvail().x;
  const bool gear = settings.id != nullptr;
  const float room = width - (gear ? ui.px(k_row_height + 4) : 0.0F);
  ImGui::BeginGroup();
  const auto lines = lines_within(ui.fonts.body, news.text, room - ui.px(8), k_most_note_lines);
  const float line = ui.px(18), height = std::max(line * static_cast<float>(lines.size()), ui.px(4));
  ImGui::Dummy(ImVec2(width, gear ? std::max(height, ui.px(k_row_height)) : height));
  for (std::size_t k = 0; k < lines.size(); ++k)
    draw_text(*ImGui::GetWindowDrawList(),
              {ui.fonts.body, news.warning ? ui.colours->warning : ui.colours->text},
              start + glm::vec2(ui.px(4), ui.px(2) + line * static_cast<float>(k)), lines[k]);
  if (gear) {
    const glm::vec2 below = from_im(ImGui::GetCursorScreenPos());
    ImGui::SetCursorScreenPos(ImVec2(start.x + width - ui.px(k_row_height), start.y));
    if (icon_button(ui, {settings.id, Icon::settings, settings.tip, memory.settings}))
      memory.settings = !memory.settings;
    ImGui::SetCursorScreenPos(im(below));
  }
  ImGui::EndGroup();
  if (news.progress) progress_bar(ui, *news.progress, width);
  ImGui::Dummy(ImVec2(width, ui.px(2)));
}

void draw_two_lines(const Ui& ui, const ScreenBox& row, const TwoLines& texts) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float top = row.min.y + ui.px(5), left = row.min.x + ui.px(28);
  const float right = row.max.x - ui.px(texts.room + 8.0F);
  draw_text(list, {ui.fonts.strong, texts.colour}, {row.min.x + ui.px(8), top}, texts.number);
  draw_text_to({ui.fonts.body, texts.colour}, right, top, texts.figure);
  const float inset = texts.dot ? ui.px(13) : 0.0F;
  if (texts.dot)
    list.AddCircleFilled(ImVec2(left + ui.px(4), top + 0.5F * ui.fonts.body.size), 4.0F * ui.scale,
                         *texts.dot);
  const float room = right - left - inset - text_size(ui.fonts.body, texts.figure).x - ui.px(8);
  draw_text(list, {ui.fonts.body, texts.colour}, {left + inset, top},
            fitted(ui.fonts.body, texts.name, room));
  draw_text(list, {ui.fonts.small, texts.below_colour}, {left, row.min.y + ui.px(22)},
            fitted(ui.fonts.small, texts.below, right - left));
}

void draw_choices(const PanelContext& context, const ChoiceTable& table, RowCursor& cursor,
                  const std::function<void(std::size_t, const ScreenBox&)>& draw_row) {
  const Ui& ui = context.ui;
  const auto number_of = [&](std::size_t k) { return table.numbers.empty() ? k : table.numbers[k]; };
  const auto choose = [&](std::size_t k) {
    table.chosen = number_of(k);
    context.edits.ask(table.look, number_of(k));
  };
  const auto pressed = draw_list(ui, table.list, cursor, [&](std::size_t k) {
    const std::string id = fmt::format("{} {}", table.row, number_of(k) + 1);
    const bool here = table.chosen == number_of(k);
    const Row row = list_row(ui, {.id = id.c_str(),
                                  .height = table.list.row_height,
                                  .beside = table.beside,
                                  .chosen = here,
                                  .marked = cursor.is_at(k) || table.pointed == number_of(k)});
    draw_row(number_of(k), row.box);
    ImGui::SetCursorScreenPos(ImVec2(row.box.min.x, row.box.max.y));
    if (!row.clicked) return;
    if (here)
      table.chosen.reset();
    else
      choose(k);
  });
  if (pressed) choose(*pressed);
}

RowOptions typed_numbers(const PanelContext& context) {
  return {.refused = [&context](const std::string& why) { context.edits.ask(&Commands::say, why, true); }};
}

}  // namespace moldlight::gui
