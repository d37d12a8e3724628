// Cards of recommended directions: a picture of the part along each, its verdict, what it wins and costs. And
// the figures of two directions that are seen side by side, with their difference.
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "classify/figure_table.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/bottom_panel.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_card_height = 84.0F, k_line_height = 15.0F, k_title_extra = 4.0F;  // layout units
constexpr float k_picture_width = 78.0F, k_picture_height = 52.0F;
constexpr std::size_t k_most_lines = 4;

// Of the comparison.
constexpr float k_comparison_width = 344.0F, k_figure_row = 20.0F;  // layout units
constexpr std::array<ListColumn, 4> k_comparison_columns = {
    {{"", "", 18.0F, false}, {"", "", 168.0F, true}, {"", "", 256.0F, true}, {"", "", 344.0F, true}}};

/// What the card is, below its picture.
std::string_view role(const SweepState& sweep, std::size_t place) {
  if (place > 0) return sweep.cards[place].here ? "this one" : "instead";
  return sweep.result->recommended->provisional ? "best so far" : "recommended";
}

/// What a direction wins and costs, a line each, below its verdict.
std::string card_help(const DirectionCard& card) {
  std::string text = card.verdict;
  for (const std::string& each : card.trade.wins) text += "\n+ " + each;
  for (const std::string& each : card.trade.costs) text += "\n− " + each;
  return text;
}

/// As many of what it wins, or costs, as two lines have room for, the first in any case.
std::vector<std::string> trade_lines(const Ui& ui, std::string_view sign, std::span<const std::string> all,
                                     float room) {
  for (std::size_t count = all.size(); count > 0; --count) {
    auto lines = lines_within(
        ui.fonts.small,
        fmt::format("{} {}{}", sign, fmt::join(all.first(count), ", "), count < all.size() ? ", …" : ""),
        room, k_most_lines);
    if (lines.size() <= 2 || count == 1) return lines;
  }
  return {};
}

void draw_card(const PanelContext& context, std::size_t place, float width, unsigned picture) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const DirectionCard& card = state.sweep.cards[place];
  const glm::vec2 inset(ui.px(6)), picture_size(ui.px(k_picture_width), ui.px(k_picture_height));
  const float beside = picture_size.x + ui.px(10), room = width - 2.0F * inset.x - beside;
  const float alpha = state.figures.pale ? 0.4F : 1.0F;
  std::vector<std::pair<Lettering, std::string>> lines;
  const auto write = [&](const Lettering& lettering, const std::vector<std::string>& texts) {
    for (const std::string& text : texts) lines.emplace_back(lettering, text);
  };
  const auto small = [&](ImU32 colour) { return Lettering{ui.fonts.small, faded(colour, alpha)}; };
  write(ui.strong(), lines_within(ui.fonts.strong, with_minus(card.name), room, 2));
  const std::size_t titles = lines.size();
  write({ui.fonts.small, ui.colours->text}, lines_within(ui.fonts.small, card.verdict, room, k_most_lines));
  write(small(ui.colours->muted), trade_lines(ui, "+", card.trade.wins, room));
  write(small(ui.colours->warning), trade_lines(ui, "−", card.trade.costs, room));
  const float height = 2.0F * inset.y + ui.px(k_line_height) * static_cast<float>(lines.size()) +
                       ui.px(k_title_extra) * static_cast<float>(titles);
  const Pressable item = pressable(ui, fmt::format("card {}", place + 1).c_str(),
                                   {width, std::max(ui.px(k_card_height), height)});
  const glm::vec2 min = item.box.min, max = item.box.max, corner = min + inset;
  ImDrawList& list = window_list();
  fill(list, {min, max}, item.hovered ? ui.colours->field_hovered : ui.colours->field, ui.px(6));
  if (card.here) list.AddRect(min, max, ui.colours->accent, ui.px(6), 0, 1.5F * ui.scale);
  draw_picture(list, picture, {corner, corner + picture_size}, ui.px(4));
  draw_text(list, ui.note(), corner + glm::vec2(ui.px(2), picture_size.y + ui.px(4)),
            role(state.sweep, place));
  glm::vec2 at(corner.x + beside, corner.y);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    draw_text(list, lines[k].first, at, lines[k].second);
    at.y += ui.px(k < titles ? k_line_height + k_title_extra : k_line_height);
  }
  tooltip(ui, card.name, card_help(card));
  if (item.clicked || item.pressed) context.edits.ask(&Commands::fly_to_direction, card.direction);
}

}  // namespace

void draw_direction_cards(const PanelContext& context, std::span<const unsigned> pictures) {
  const std::vector<DirectionCard>& cards = context.state.sweep.cards;
  const float width = room_left();
  for (std::size_t k = 0; k < cards.size(); ++k)
    draw_card(context, k, width, cards[k].candidate < pictures.size() ? pictures[cards[k].candidate] : 0);
}

void draw_comparison(const PanelContext& context) {
  const AppState& state = context.state;
  const auto& compared = state.sweep_choices.compared;
  if (!compared || !state.sweep.result || *compared >= state.sweep.result->candidates.size()) return;
  const Ui& ui = context.ui;
  const SweepCandidate& other = state.sweep.result->candidates[*compared];
  place_window({0.5F * screen_size().x, ui.px(k_bar_height + 8)}, {0.5F, 0.0F});
  ImGui::Begin("##Comparison", nullptr, k_card_window);
  const glm::vec2 start = cursor_at();
  const auto add = [&](const std::array<std::string, 4>& texts, ImU32 colour, ImU32 swatch = 0) {
    const glm::vec2 at = cursor_at();
    ImGui::Dummy(ImVec2(ui.px(k_comparison_width), ui.px(k_figure_row)));
    const glm::vec2 min(at.x, at.y + ui.px(5));
    fill(window_list(), {min, min + glm::vec2(ui.px(10))}, swatch, ui.px(3));
    for (std::size_t k = 0; k < texts.size(); ++k)
      draw_cell(ui, item_box(), k_comparison_columns[k],
                {k == 3 ? ui.fonts.strong : ui.fonts.body, k == 3 ? ui.colours->text : colour}, texts[k]);
  };
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
  const bool known = state.figures.shown && !state.figures.pale;
  const FigureStyle style(*state.model);
  add({"", "left", fmt::format("right, {}", other.rank), "left − right"}, ui.colours->muted);
  for (const Region region : k_regions) {
    const double right = other.classification.areas[region];
    const double left = known ? state.figures.shown->areas[region] : 0.0;
    add({std::string(facts(region).title), known ? grouped(style.text(FigureKind::area, left)) : "…",
         grouped(style.text(FigureKind::area, right)),
         known ? with_minus(grouped(style.change(FigureKind::area, left - right))) : "…"},
        ui.colours->text, packed(region_colour(region, state.settings.look.palette)));
  }
  add({"Undercut ±", known ? error_text(state.figures.shown->uncertainty.total()) : "…",
       error_text(other.classification.uncertainty.total()),
       known ? error_text(std::hypot(state.figures.shown->uncertainty.total(),
                                     other.classification.uncertainty.total()))
             : "…"},
      ui.colours->muted);
  ImGui::PopStyleVar();
  put_cursor({start.x - ui.px(6), start.y - ui.px(3)});
  if (icon_button(ui, {"close comparison", Icon::close, "Back to one picture (Esc)"}))
    context.edits.sweep_choices.compared.reset();
  ImGui::End();
}

}  // namespace moldlight::gui
