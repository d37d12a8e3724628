// Cards of recommended directions: a picture of the part along each, its verdict, what it wins and costs.
#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_card_height = 98.0F, k_line_height = 15.0F;  // layout units
constexpr float k_picture_width = 78.0F, k_picture_height = 52.0F;
constexpr std::size_t k_most_lines = 4;

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

void draw_card(const PanelContext& context, std::size_t place, float width, unsigned picture) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const DirectionCard& card = state.sweep.cards[place];
  const Pressable item =
      pressable(ui, fmt::format("card {}", place + 1).c_str(), {width, ui.px(k_card_height)});
  const glm::vec2 min = item.box.min, max = item.box.max, inset(ui.px(6));
  ImDrawList& list = window_list();
  fill(list, {min, max}, item.hovered ? ui.colours->field_hovered : ui.colours->field, ui.px(6));
  if (card.here) list.AddRect(im(min), im(max), ui.colours->accent, ui.px(6), 0, 1.5F * ui.scale);
  const glm::vec2 corner = min + inset, picture_size(ui.px(k_picture_width), ui.px(k_picture_height));
  draw_picture(list, picture, {corner, corner + picture_size}, ui.px(4));
  draw_text(list, ui.note(), corner + glm::vec2(ui.px(2), picture_size.y + ui.px(4)),
            role(state.sweep, place));
  const float left = corner.x + picture_size.x + ui.px(10), room = max.x - inset.x - left;
  float top = corner.y;
  draw_text(list, ui.strong(), {left, top}, fitted(ui.fonts.strong, with_minus(card.name), room));
  top += ui.px(k_line_height + 4);
  std::size_t lines_left = k_most_lines;
  const auto write = [&](ImU32 colour, const std::string& text, std::size_t most) {
    for (const std::string& line : lines_within(ui.fonts.small, text, room, std::min(most, lines_left))) {
      draw_text(list, {ui.fonts.small, colour}, {left, top}, line);
      top += ui.px(k_line_height);
      --lines_left;
    }
  };
  const float alpha = state.figures.pale ? 0.4F : 1.0F;
  const MoldTrade& trade = card.trade;
  write(ui.colours->text, card.verdict, 2);
  // What it costs stands there in any case.
  if (!trade.wins.empty())
    write(faded(ui.colours->muted, alpha), fmt::format("+ {}", fmt::join(trade.wins, ", ")),
          trade.costs.empty() ? 3 : 2);
  if (!trade.costs.empty())
    write(faded(ui.colours->warning, alpha), fmt::format("− {}", fmt::join(trade.costs, ", ")), 2);
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

}  // namespace moldlight::gui
