// The parting line and the mold: what is said of the line and of the halves, also to what else asks.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/table_bar.hpp"
#include "gui/view/mold_view.hpp"
#include "parting/mold_report.hpp"
#include "pieces/pieces_report.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_loop_row = 40.0F, k_mold_line = 16.0F;  // layout units
constexpr float k_loops_share = 0.4F;  // of the window's height, that the table takes at most

constexpr std::array<ListColumn, 3> k_loop_columns = {{
    {"#", "", 8.0F, false},
    {"loop", "Outer line, shut-off of a through hole, or rim of a side action.", 36.0F, false},
    {"length", "", 232.0F, true},  // beside a scroll bar
}};

/// The faces that a hand has given to a half: a click forgets them.
void draw_cosmetic(const PanelContext& context) {
  const Ui& ui = context.ui;
  std::string& cosmetic = context.edits.settings.mold.cosmetic;
  for (const bool core : {true, false}) {
    const std::vector<std::uint32_t> faces = cosmetic_faces(cosmetic, core);
    if (faces.empty()) continue;
    const std::string_view half = core ? "core" : "cavity";
    ImGui::SameLine(0.0F, ui.px(4));
    const std::string label = fmt::format("{} to the {}  ×", plural(faces.size(), "face"), half);
    const bool forgotten = chip(ui, label, true);
    name_item(ui, fmt::format("faces to the {}", half));
    tooltip(ui, "Faces assigned by hand",
            "Saved with the part; the flag --cosmetic does the same. Click to remove them.");
    if (!forgotten) continue;
    for (const std::uint32_t face : faces) cosmetic = cosmetic_with(cosmetic, face, std::nullopt);
    break;
  }
}

/// The height: that which is given, or that which was found until one is typed.
void draw_height(const PanelContext& context, const RowOptions& numbers) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  auto& given = context.edits.settings.mold.parting_height;
  const float width = room_left(), cross = given ? ui.px(k_row_height + 4) : 0.0F;
  double height = parting_height(state);
  const HeightRange range = height_range(state);
  const std::string label =
      fmt::format("{}, {}", given ? "Height" : "Height (auto)", length_unit(state.model->part));
  if (number_field(ui, "parting_height", height, {label, 2, width - cross})) {
    if (height > range.low && height < range.high) {
      given = height;
    } else {
      numbers.refused(fmt::format("The halves can meet between {} and {}, within the part",
                                  with_minus(figure(range.low)), with_minus(figure(range.high))));
    }
  }
  tooltip(ui, "Parting height", option_named(mold_options(), "parting_height").help);
  if (!given) return;
  ImGui::SameLine(0.0F, ui.px(4));
  if (icon_button(ui, {"find the height", Icon::close, "Find the height again"})) given.reset();
}

void draw_mold_settings(const PanelContext& context) {
  const PartLengths lengths(context.state);
  RowOptions numbers = typed_numbers(context);
  numbers.lengths = &lengths;
  numbers.unset = fmt::format("{:.1f}", block_margin({}, context.state.model->frame.diagonal));
  option_table<MoldSettings>(context.ui, mold_options(), context.edits.settings.mold, numbers);
}

void draw_loop(const PanelContext& context, std::size_t number, const ScreenBox& row) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const PartingLoop& loop = state.mold.line->line.loops[number];
  const ImU32 normal = faded(ui.colours->text, state.mold.line_awaited ? 0.75F : 1.0F);
  const FigureStyle style(*state.model);
  const auto length = [&](double value) { return style.with_unit(FigureKind::length, value); };
  const ScreenBox upper{row.min, {row.max.x, row.min.y + ui.px(22)}};
  draw_cell(ui, upper, k_loop_columns[0], {ui.fonts.strong, normal}, std::to_string(number + 1));
  draw_cell(ui, upper, k_loop_columns[1], {ui.fonts.body, normal}, loop_name(loop.kind));
  draw_cell(ui, upper, k_loop_columns[2], {ui.fonts.body, normal}, length(loop.length));
  const bool level = loop.climb() < lateral_tolerance(state.settings.method, state.model->frame.diagonal);
  draw_second_line(ui, row, k_loop_columns[1].at,
                   with_minus(level ? fmt::format("level at {}", length(loop.high))
                                    : fmt::format("{} to {} · steepest {:.0f}°",
                                                  grouped(style.text(FigureKind::length, loop.low)),
                                                  length(loop.high), loop.steepest_deg)));
  tooltip(ui, fmt::format("Loop {}: {}", number + 1, loop_name(loop.kind)),
          with_minus(fmt::format("{} long, from {} to {} along the direction\nsteepest edge {:.0f}°, "
                                 "projected area {}\nClick to look at it.",
                                 length(loop.length), length(loop.low), length(loop.high), loop.steepest_deg,
                                 style.with_unit(FigureKind::area, std::abs(loop.area)))));
}

void draw_loops(const PanelContext& context, RowCursor& cursor) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const std::vector<PartingLoop>& all = state.mold.line->line.loops;
  std::vector<std::size_t> shown;
  for (std::size_t k = 0; k < all.size(); ++k)
    if (!all[k].tiny) shown.push_back(k);
  const ChoiceTable loops{
      .list = {.id = "loops", .count = shown.size(), .row_height = k_loop_row, .share = k_loops_share},
      .row = "loop",
      .chosen = context.edits.mold_choices.loop,
      .look = &Commands::look_at_loop,
      .numbers = shown,
      .tiny = tiny_text(all.size() - shown.size())};
  draw_choices(context, loops, cursor,
               [&](std::size_t k, const ScreenBox& row) { draw_loop(context, k, row); });
  ImGui::Dummy(ImVec2(1.0F, ui.px(2)));
  draw_height(context, typed_numbers(context));
  bool& moves = context.edits.mold_choices.moves_faces;
  if (chip(ui, "Move faces", moves)) moves = !moves;
  tooltip(ui, "Move faces",
          "Click a face that either half could form to move it to the other half. Ctrl + click or V does "
          "this at any time.");
  draw_cosmetic(context);
}

/// What is known of the bodies: their figures, and what is wrong with them.
void draw_lines(const PanelContext& context, const std::vector<HalvesLine>& halves, float alpha) {
  const Ui& ui = context.ui;
  const float width = room_left();
  for (const HalvesLine& each : halves) {
    if (each.figure.empty()) {
      (each.doubt ? warning : hint)(ui, each.text);
      continue;
    }
    const glm::vec2 at = cursor_at();
    ImGui::Dummy(ImVec2(width, ui.px(k_mold_line)));
    draw_text({ui.fonts.small, faded(ui.colours->muted, alpha)}, at + glm::vec2(ui.px(8), 0.0F), each.text);
    draw_text_to({ui.fonts.small, faded(ui.colours->text, alpha)}, at.x + width - ui.px(8), at.y,
                 each.figure);
  }
}

/// How many pieces, with what each number leaves, and the sentence on those that are looked at.
void draw_pieces(const PanelContext& context) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  auto& chosen = context.edits.mold_choices.pieces;
  if (chip(ui, "Several pieces", chosen.has_value()))
    chosen = chosen ? std::nullopt : std::optional(static_cast<std::size_t>(PiecesSettings().most));
  tooltip(
      ui, "Several pieces",
      "Directions of a mold of more than two pieces, and what each forms. The slider removes the pieces one "
      "after the other.");
  const MoldOfPieces* const shown = shown_pieces(state);
  if (!chosen || shown == nullptr) return;
  const FigureStyle style(*state.model);
  for (std::size_t k = 0; k < state.mold.pieces.size(); ++k) {
    const PiecesResult& result = *state.mold.pieces[k].result;
    const std::string label = fmt::format("{}: {} left", result.count(),
                                          grouped(style.with_unit(FigureKind::area, result.left_area)));
    if (chip(ui, label, shown->result.get() == &result, k == 0)) chosen = k;
    name_item(ui, fmt::format("{} pieces", result.count()));
    tooltip(ui, plural(result.count(), "piece"), with_minus(pieces_sentence(*state.model, result)));
  }
  if (!shown->solids) return;
  const std::string refusal = sentence_of(solids_refusal(*state.model, *shown->solids));
  draw_lines(
      context,
      {shown->has_solids() ? HalvesLine{plural(shown->solids->solids.size(), "solid") + " with certificate"}
                           : HalvesLine{with_minus(refusal), true}},
      1.0F);
}

/// What is known of the line, or of the halves; while one of them is found, how far that is.
BarNews mold_news(const MoldState& mold, bool awaited, const std::string& known) {
  if (awaited) return running_news(mold.running, "finding the parting line …");
  if (!mold.error.empty()) return {.text = mold.error, .warning = true};
  return {.text = known};
}

/// The solids must be there.
SaidHalves said_halves(const AppState& state) {
  const MoldState& mold = state.mold;
  return {.model = *state.model,
          .settings = state.settings.mold,
          .halves = mold.solids->halves(),
          .line = mold.line ? &mold.line->line : nullptr,
          .by_action = mold.solids->pieces ? &mold.solids->pieces->of_inserts : nullptr};
}

}  // namespace

std::string halves_refusal(const AppState& state) { return halves_refusal(said_halves(state)); }

std::vector<HalvesLine> halves_lines(const AppState& state) {
  return state.mold.solids ? halves_lines(said_halves(state)) : std::vector<HalvesLine>();
}

void draw_line_panel(const PanelContext& context, TableBar& bar) {
  const MoldState& mold = context.state.mold;
  TableBarParts parts{.news = mold_news(mold, mold.line_awaited, mold.line ? mold.line->verdict : "")};
  if (mold.line) parts.table = [&](RowCursor& cursor) { draw_loops(context, cursor); };
  bar.draw_inside(context, parts);
}

void draw_mold_panel(const PanelContext& context, TableBar& bar) {
  const Ui& ui = context.ui;
  const MoldState& mold = context.state.mold;
  // Above what changes its height while a hand is at the slider.
  const bool opens = context.state.settings.look.open_mold < 1.0;
  if (button(ui, opens ? "Open the mold (O)" : "Close the mold (O)", {.width = room_left(), .strong = opens}))
    apply_shortcut({.key = 'O'}, context.state, context.edits);
  name_item(ui, "play the shot");
  draw_opening(context);
  const MoldOfPieces* const pieces = shown_pieces(context.state);
  if (pieces == nullptr) option_row(ui, option_named(window_options(), "halves"), context.edits.window);
  TableBarParts parts{
      .options = "mold options",
      .options_hint = "Settings of the mold",
      .news = mold_news(mold, mold.running || mold.line_awaited || mold.solids_awaited,
                        pieces != nullptr ? with_minus(pieces_sentence(*context.state.model, *pieces->result))
                        : !is_settled(mold)            ? ""
                        : mold.solids->halves().made() ? "Both halves are made and checked."
                                                       : "No halves can be made."),
      .settings = [&] { draw_mold_settings(context); }};
  parts.table = [&](RowCursor&) {
    draw_pieces(context);
    if (pieces != nullptr) return;
    ImGui::Dummy(ImVec2(1.0F, ui.px(2)));
    draw_lines(context, halves_lines(context.state), mold.solids_awaited ? 0.6F : 1.0F);
    ImGui::Dummy(ImVec2(1.0F, ui.px(2)));
    if (button(ui, "Export the mold…", {.width = room_left()})) context.edits.dialogs.exporting_mold = true;
    name_item(ui, "export mold");
  };
  bar.draw_inside(context, parts);
}

}  // namespace moldlight::gui
