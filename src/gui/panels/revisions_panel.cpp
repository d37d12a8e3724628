// Changes against another revision, along the bottom: a row a change.
#include <array>

#include <fmt/format.h>

#include "compare/change_words.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/table_bar.hpp"
#include "gui/view/revision_view.hpp"

namespace moldlight::gui {

namespace {

using Of = RevisionChange::Of;

constexpr const char* k_revisions = "Revisions";
constexpr float k_change_row = 24.0F, k_change_line = 18.0F;  // layout units
constexpr float k_changes_share = 0.2F;  // of the window's height, that the table takes at most

constexpr std::array<ListColumn, 6> k_change_columns = {{
    {"#",
     "Undercuts and side actions come first, then surface, the largest area first. Unchanged ones come last.",
     8.0F, false},
    {"change", "", 58.0F, false},
    {"A", "Area before, in the part's unit squared. For changed surface: the area that is gone.", 316.0F,
     true},
    {"B", "Area now. For changed surface: the new area.", 412.0F, true},
    {"volume", "Volume that was added or removed, in the part's unit cubed, if both parts are closed.",
     516.0F, true},
    {"", "", 532.0F, false},
}};

/// The colours that a change is lit in, that of A and that of B beside each other.
void draw_swatch(const PanelContext& context, const RevisionChange& change, const glm::vec2& middle) {
  const Ui& ui = context.ui;
  Colour left = lit_colour(Lit::other_region), right = left;
  if (change.of == Of::place) {
    left = lit_colour(change.kind == ChangeKind::added ? Lit::added : Lit::gone);
    right = lit_colour(change.kind == ChangeKind::gone ? Lit::gone : Lit::added);
  } else if (change.of != Of::region) {
    left = right = region_colour(Region::undercut, context.state.settings.look.palette);
  }
  ImDrawList& list = window_list();
  const float half = ui.px(5);
  list.AddRectFilled(ImVec2(middle.x - half, middle.y - half), ImVec2(middle.x, middle.y + half),
                     packed(left));
  list.AddRectFilled(ImVec2(middle.x, middle.y - half), ImVec2(middle.x + half, middle.y + half),
                     packed(right));
}

void draw_revision_settings(const PanelContext& context) {
  const Ui& ui = context.ui;
  const PartLengths lengths(context.state);
  RevisionSettings& settings = context.edits.settings.revision;
  RowOptions numbers = typed_numbers(context);
  numbers.lengths = &lengths;
  numbers.unset = fmt::format("{:.3g}", usual_tolerance(lengths.diagonal).apart);
  option_table<CompareSettings>(ui, compare_options(), settings, numbers,
                                [&] { option_row(ui, revision_options().front(), settings, numbers); });
  const auto& result = context.state.revisions.result;
  if (result && result->comparison.alignment) {
    const Alignment& alignment = *result->comparison.alignment;
    hint(ui, fmt::format("B was aligned with A: {} {} off (rms), {} at most.", error_text(alignment.rms),
                         lengths.unit, error_text(alignment.largest)));
  }
}

void draw_change(const PanelContext& context, std::size_t number, const ScreenBox& row) {
  const Ui& ui = context.ui;
  const RevisionState& revisions = context.state.revisions;
  const Revisions& result = *revisions.result;
  const RevisionChange& change = result.changes[number];
  const float alpha = revisions.stale ? 0.6F : 1.0F;
  const ImU32 colour = faded(change.changed() ? ui.colours->text : ui.colours->muted, alpha);
  const ChangeWords words = ChangeWording(result.comparison).of(change);
  const float end = row.max.x - row.min.x;
  draw_cell(ui, row, k_change_columns[0], {ui.fonts.strong, colour}, std::to_string(number + 1));
  if (change.changed()) draw_swatch(context, change, {row.min.x + ui.px(44), row.centre().y});
  draw_cell(ui, row, k_change_columns[1], {ui.fonts.body, colour}, change_title(result, number), ui.px(180));
  const std::array<const std::string*, 3> figures = {&words.before, &words.now, &words.volume};
  for (std::size_t k = 0; k < figures.size(); ++k) {
    const bool is_figure = figures[k]->find_first_of("0123456789") != std::string::npos;
    const std::string unit = is_figure ? " " + powered_unit(context.state.model->part, k < 2 ? 2 : 3) : "";
    draw_cell(ui, row, k_change_columns[k + 2], {ui.fonts.body, colour}, *figures[k] + unit);
  }
  draw_cell(ui, row, k_change_columns[5], {ui.fonts.small, faded(ui.colours->muted, alpha)}, words.more,
            std::max(end - ui.px(k_change_columns[5].at + 8), ui.px(24)));
  tooltip(ui, change_title(result, number), fmt::format("{}\nClick to look at it in both.", words.more));
}

void draw_changes(const PanelContext& context, RowCursor& cursor) {
  const Ui& ui = context.ui;
  const Revisions& result = *context.state.revisions.result;
  if (!result.changes.empty()) draw_headings(ui, k_change_columns);
  const auto& hover = context.state.revisions.hover;
  ChoiceTable changes{.list = {.id = "changes",
                               .count = result.changes.size(),
                               .row_height = k_change_row,
                               .share = k_changes_share},
                      .row = "change",
                      .chosen = context.edits.revision_choices.chosen,
                      .look = &Commands::look_at_change};
  if (hover) changes.pointed = hover->change;
  draw_choices(context, changes, cursor,
               [&](std::size_t k, const ScreenBox& row) { draw_change(context, k, row); });
  const float width = room_left();
  const std::string regions = ChangeWording(result.comparison).regions();
  const glm::vec2 at = cursor_at();
  ImGui::Dummy(ImVec2(width, ui.px(k_change_line)));
  tooltip(ui, {}, regions);
  draw_text(ui.small(), {at.x + ui.px(8), at.y + 0.5F * (ui.px(k_change_line) - ui.fonts.small.size)},
            fitted(ui.fonts.small, regions, width - ui.px(16)));
}

BarNews revisions_news(const RevisionState& revisions) {
  if (revisions.awaited) return running_news(revisions.running, "comparing …");
  if (!revisions.error.empty()) return {.text = revisions.error, .warning = true, .tip = revisions.error};
  if (!revisions.result) return {};
  std::string text = comparison_verdict(revisions.result->comparison);
  if (revisions.stale) text = "Cancelled. The figures are of other settings. " + text;
  return {.text = text, .tip = text};
}

void draw_line(const PanelContext& context, RevisionsBar& bar, bool open) {
  constexpr float k_progress_width = 96.0F, k_cancel_width = 64.0F;  // layout units
  const Ui& ui = context.ui;
  BottomHeader header(ui, k_revisions);
  if (header.button({"leave revisions", Icon::close, "Leave the comparison (Ctrl+D)"}))
    context.edits.ask(&Commands::leave_revisions);
  if (header.button(
          {"fold revisions", open ? Icon::chevron_down : Icon::chevron_up, open ? "Fold up" : "Unfold"}))
    context.layout.fold_bottom(k_revisions, open);
  const bool settings = open && bar.settings;
  if (header.button({"revision options", Icon::settings, "Settings of the comparison", settings})) {
    bar.settings = !settings;
    context.layout.fold_bottom(k_revisions, false);
  }
  if (header.button({"exchange revisions", Icon::exchange, "Swap the revisions"}))
    context.edits.ask(&Commands::exchange_revisions);
  if (context.state.revisions.awaited) {
    header.place(ui.px(k_cancel_width));
    if (button(ui, "Cancel##revisions", {.width = ui.px(k_cancel_width)}))
      context.edits.ask(&Commands::cancel_revisions);
    name_item(ui, "cancel revisions");
  }
  const BarNews news = revisions_news(context.state.revisions);
  if (news.progress) header.progress(*news.progress, k_progress_width);
  header.end(news.text, news.warning ? ui.colours->warning : ui.colours->muted, news.tip);
}

}  // namespace

void draw_revisions_bar(const PanelContext& context, RevisionsBar& bar) {
  if (!context.state.revisions.on()) return;
  const bool open = context.layout.begin_bottom(context.ui, k_revisions);
  draw_line(context, bar, open);
  if (open && bar.settings) {
    draw_revision_settings(context);
  } else if (open && context.state.revisions.result) {
    draw_changes(context, bar.cursor);
  }
  context.layout.end();
}

}  // namespace moldlight::gui
