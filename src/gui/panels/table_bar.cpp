#include "gui/panels/table_bar.hpp"

#include <fmt/format.h>

#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"

namespace moldlight::gui {

BarNews running_news(const std::optional<JobStatus>& running, const char* usual) {
  const bool named = running && !running->stage.empty();
  return {.text = named ? running->stage + " …" : usual, .progress = running ? running->fraction : 0.0};
}

void TableBar::draw_inside(const PanelContext& context, const TableBarParts& parts) {
  constexpr float k_line = 16.0F;  // layout units
  constexpr std::size_t k_most_lines = 6;
  const Ui& ui = context.ui;
  const BarNews& news = parts.news;
  const glm::vec2 start = cursor_at();
  const float width = room_left();
  const float left = start.x + ui.px(8), button = parts.options == nullptr ? 0.0F : ui.px(k_row_height + 4);
  const std::vector<std::string> lines =
      lines_within(ui.fonts.small, news.text, start.x + width - button - left, k_most_lines);
  const float height =
      std::max(ui.px(k_line) * static_cast<float>(lines.size()) + ui.px(6), ui.px(k_row_height));
  ImGui::Dummy(ImVec2(width - button, height));
  if (!news.tip.empty()) tooltip(ui, {}, news.tip);
  for (std::size_t k = 0; k < lines.size(); ++k)
    draw_text({ui.fonts.small, news.warning ? ui.colours->warning : ui.colours->text},
              {left, start.y + ui.px(4) + ui.px(k_line) * static_cast<float>(k)}, lines[k]);
  if (parts.options != nullptr) {
    put_cursor({start.x + width - ui.px(k_row_height), start.y});
    if (icon_button(ui, {parts.options, Icon::settings, parts.options_hint, settings_}))
      settings_ = !settings_;
    put_cursor({start.x, start.y + height});
  }
  if (news.progress) progress_bar(ui, *news.progress, width);
  if (settings_ && parts.settings) {
    parts.settings();
  } else if (parts.table) {
    parts.table(cursor_);
  }
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
    put_cursor({row.box.min.x, row.box.max.y});
    if (!row.clicked) return;
    if (here)
      table.chosen.reset();
    else
      choose(k);
  });
  if (pressed) choose(*pressed);
  if (table.tiny.empty()) return;
  if (table.look_at_tiny == nullptr) return hint(ui, table.tiny);
  if (disclosure(ui, table.tiny, false)) context.edits.ask(table.look_at_tiny);
  name_item(ui, "tiny");
  tooltip(ui, {}, "Click to look at the largest of them.");
}

RowOptions typed_numbers(const PanelContext& context) {
  return {.refused = [&context](const std::string& why) { context.edits.ask(&Commands::say, why, true); }};
}

}  // namespace moldlight::gui
