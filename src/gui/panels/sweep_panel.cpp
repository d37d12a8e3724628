// The search for directions: how far it is, what it recommends, and the best ones as a table to sort and
// click.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/geometric.hpp>

#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/step_panels.hpp"
#include "mold/direction.hpp"
#include "sweep/axis_beside.hpp"
#include "sweep/sweep_texts.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_direction_row = 26.0F;                     // layout units
constexpr float k_tip_width = 154.0F, k_tip_height = 96.0F;  // of a direction's tooltip
/// Share of the window's height that the table takes.
constexpr float k_sweep_share = 0.25F;
/// Columns before those of figures: rank, direction. And the one after them, why.
constexpr std::size_t k_before_figures = 2;
constexpr float k_rank_width = 38.0F, k_direction_width = 136.0F, k_least_why = 140.0F;  // layout units
constexpr float k_column_gap = 8.0F, k_compare_room = k_row_height + 8.0F;

std::string time_text(double seconds) {
  if (seconds < 10.0) return fmt::format("{:.1f} s left", seconds);
  if (seconds < 100.0) return fmt::format("{:.0f} s left", seconds);
  return fmt::format("{:.0f} min left", seconds / 60.0);
}

std::string progress_text(const SweepProgress& progress) {
  if (progress.ending) return "ending with the results so far";
  std::string text = progress.stage.empty() ? "starting" : progress.stage;
  if (progress.left_s) text += "  ·  " + time_text(*progress.left_s);
  return text;
}

std::string result_text(const SweepState& sweep) {
  std::string text =
      fmt::format("{} directions in {:.1f} s", grouped(std::to_string(sweep.result->evaluated.size())),
                  sweep.result->elapsed_s);
  if (!sweep.result->complete) text += "  ·  ended early";
  if (sweep.stale) text += "  ·  of other settings";
  return text;
}

/// Straight from its table.
void draw_sweep_options(const PanelContext& context) {
  // Most of them range over many powers of ten, some from 0 on.
  const RowOptions numbers = typed_numbers(context);
  SweepSettings& settings = context.edits.sweep_choices.options;
  // In a low window there is no room for what is seldom set.
  constexpr float k_low_window = 680.0F;
  const bool low = screen_size().y < context.ui.px(k_low_window);
  static const std::vector<Option<SweepSettings>> k_usual = [] {
    std::vector<Option<SweepSettings>> usual(sweep_options().begin(), sweep_options().end());
    std::erase_if(usual, [](const auto& option) { return option.key == "worth_pct"; });
    return usual;
  }();
  option_table<SweepSettings>(context.ui, low ? std::span(k_usual) : sweep_options(), settings, numbers);
  for (const Option<SweepSettings>& option : sweep_options())
    if (is_wide(option)) option_row(context.ui, option, settings, numbers);
}

/// Two halves, one of them filled.
bool compare_button(const Ui& ui, const glm::vec2& centre, bool chosen) {
  put_cursor(centre - glm::vec2(0.5F * ui.px(k_row_height)));
  const bool clicked = ImGui::InvisibleButton("compare", ImVec2(ui.px(k_row_height), ui.px(k_row_height)));
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = window_list();
  const ImU32 colour = hovered || chosen ? ui.colours->text : ui.colours->muted;
  const glm::vec2 half(ui.px(7), ui.px(5));
  if (hovered || chosen) {
    list.AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                       chosen ? ui.colours->field_active : ui.colours->field_hovered, ui.px(6));
  }
  list.AddRect(centre - half, centre + half, colour, ui.px(2), 0, 1.25F * ui.scale);
  list.AddRectFilled(ImVec2(centre.x, centre.y - half.y), centre + half, colour, ui.px(2));
  tooltip(ui, {}, chosen ? "Back to one picture" : "Show it beside the present direction");
  return clicked;
}

/// Of a column, in layout units.
float width_of(FigureKind kind) {
  if (kind == FigureKind::actions) return 130.0F;
  if (kind == FigureKind::force) return 60.0F;
  if (kind == FigureKind::area || kind == FigureKind::volume) return 58.0F;
  return kind == FigureKind::error || kind == FigureKind::gap ? 50.0F : 44.0F;
}

/// With room for the mark of the column that is sorted by; layout units.
float figure_width(const Ui& ui, const DirectionFigure& figure) {
  const float heading = text_size(ui.fonts.small, std::string(figure.label) + " ↓").x / ui.scale;
  return std::max(width_of(figure.kind), heading) + k_column_gap;
}

/// Those that the table has room for.
std::vector<const DirectionFigure*> fitting_columns(const Ui& ui, const SweepResult& result) {
  std::vector<const DirectionFigure*> figures = figure_columns(result);
  float needed = k_rank_width + k_direction_width + k_least_why + k_compare_room;
  for (const DirectionFigure* figure : figures) needed += figure_width(ui, *figure);
  if (ui.px(needed) > room_left()) keep_brief(figures);
  return figures;
}

std::vector<SortedColumn> headings_of(const Ui& ui, const std::vector<const DirectionFigure*>& figures) {
  std::vector<SortedColumn> headings = {
      {.name = "#",
       .help = "Rank; directions with the same letter tie within the uncertainty.",
       .figure = false,
       .most_first = false,
       .width = k_rank_width},
      {.name = "direction", .figure = false, .width = k_direction_width, .sorts = false}};
  for (const DirectionFigure* figure : figures)
    headings.push_back({.name = std::string(figure->label),
                        .help = figure->help,
                        .most_first = false,
                        .width = figure_width(ui, *figure)});
  headings.push_back({.name = "why", .figure = false, .sorts = false});
  headings.push_back({.name = "", .width = k_compare_room - 12.0F, .sorts = false});
  return headings;
}

}  // namespace

glm::ivec2 candidate_picture_size(float scale) {
  return glm::ivec2(std::lround(k_tip_width * scale), std::lround(k_tip_height * scale));
}

void SweepPanel::draw(const PanelContext& context, std::span<const unsigned> pictures) {
  const Ui& ui = context.ui;
  const SweepState& sweep = context.state.sweep;
  ImGui::Dummy(ImVec2(1.0F, ui.px(2)));
  const char* action = sweep.running ? "Cancel" : "Find directions";
  const float gap = ui.px(4), icons = (sweep.map ? 2.0F : 1.0F) * (ui.px(k_row_height) + gap);
  if (button(ui, action, {.width = room_left() - icons, .strong = !sweep.running && !sweep.map})) {
    context.edits.ask(sweep.running ? &Commands::cancel_sweep : &Commands::start_sweep);
    if (below_ == Below::options) below_ = Below::nothing;
  }
  ImGui::SameLine(0.0F, gap);
  if (icon_button(ui, {"options", Icon::settings, "Options of the search", below_ == Below::options})) {
    below_ = below_ == Below::options ? Below::nothing : Below::options;
    context.layout.fold_bottom("Directions", false);
  }
  if (sweep.map) {
    bool& large = context.edits.sweep_choices.large_ball;
    ImGui::SameLine(0.0F, gap);
    if (icon_button(ui, {"large ball", Icon::sphere, "Enlarge the map of directions (M)", large}))
      large = !large;
  }
  if (sweep.running) progress_bar(ui, sweep.running->share, room_left());
  const std::string text = sweep.running  ? progress_text(*sweep.running)
                           : sweep.result ? result_text(sweep)
                                          : sweep.error;
  if (!text.empty()) hint(ui, text);
  if (!sweep.cards.empty()) draw_direction_cards(context, pictures);
  if (!sweep.result || sweep.result->candidates.empty()) return;
  const bool table = below_ == Below::table;
  if (disclosure(ui, "All directions", table)) {
    below_ = table ? Below::nothing : Below::table;
    context.layout.fold_bottom("Directions", false);
  }
  name_item(ui, "All directions");
}

void SweepPanel::draw_below(const PanelContext& context, std::span<const unsigned> pictures) {
  const Ui& ui = context.ui;
  const SweepState& sweep = context.state.sweep;
  // What was asked for is shown at once.
  if (std::exchange(seen_, sweep.result) != sweep.result) {
    below_ = sweep.result && !sweep.by_itself ? Below::table : Below::nothing;
    if (below_ == Below::table) context.layout.fold_bottom("Directions", false);
  }
  if (below_ == Below::table && (!sweep.result || sweep.result->candidates.empty())) below_ = Below::nothing;
  if (below_ == Below::nothing) return;
  if (context.layout.begin_bottom(ui, "Directions", 0.0F, below_ == Below::table ? k_wide_table : 0.0F)) {
    BottomHeader header(ui, "Directions");
    if (header.button({"close directions", Icon::close, "Close"})) below_ = Below::nothing;
    header.end(below_ == Below::table ? result_text(sweep) : "Options of the search", ui.colours->muted);
    if (below_ == Below::options) draw_sweep_options(context);
    if (below_ == Below::table) draw_table(context, pictures);
  } else {
    below_ = Below::nothing;  // another one was unfolded
  }
  context.layout.end();
}

std::vector<std::size_t> sorted_candidates(const SweepResult& result, const DirectionFigure* by,
                                           bool descending) {
  const auto key = [&](std::size_t k) {
    const SweepCandidate& candidate = result.candidates[k];
    // What is not known comes before all.
    return by == nullptr ? static_cast<double>(candidate.rank) : figure_value(*by, candidate).value_or(-1.0);
  };
  std::vector<std::size_t> rows(result.candidates.size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  std::stable_sort(rows.begin(), rows.end(), [&](std::size_t a, std::size_t b) {
    return descending ? key(a) > key(b) : key(a) < key(b);
  });
  return rows;
}

void SweepPanel::draw_table(const PanelContext& context, std::span<const unsigned> pictures) {
  const Ui& ui = context.ui;
  const std::shared_ptr<const SweepResult>& result = context.state.sweep.result;
  if (std::exchange(result_, result) != result) table_.forget();
  const Figures figures = fitting_columns(ui, *result);
  if (table_.draw_headings(ui, headings_of(ui, figures))) {
    const auto by = std::ranges::find(figures, table_.by(), &DirectionFigure::label);
    table_.rows = sorted_candidates(*result, by == figures.end() ? nullptr : *by, table_.descending());
  }
  const auto pressed =
      draw_list(ui,
                {.id = "table",
                 .count = result->candidates.size(),
                 .row_height = k_direction_row,
                 .share = k_sweep_share},
                table_.cursor, [&](std::size_t k) { draw_row(context, figures, k, pictures); });
  if (pressed)
    context.edits.ask(&Commands::fly_to_direction,
                      result->candidates[table_.rows[*pressed]].candidate.direction);
  draw_footer(context);
}

void SweepPanel::draw_row(const PanelContext& context, const Figures& figures, std::size_t place,
                          std::span<const unsigned> pictures) {
  const Ui& ui = context.ui;
  const std::size_t index = table_.rows[place];
  const SweepCandidate& candidate = result_->candidates[index];
  const glm::dvec3& direction = candidate.candidate.direction;
  const bool here = std::abs(glm::dot(context.state.settings.direction.unit(), direction)) > 1.0 - 1e-10;
  const std::string id = fmt::format("direction {}", candidate.rank);
  const Row row = list_row(ui, {.id = id.c_str(),
                                .height = k_direction_row,
                                .beside = k_compare_room,
                                .chosen = here,
                                .marked = table_.cursor.is_at(place)});
  std::string tip = reasons_text(candidate.candidate, candidate.candidate.sources.size());
  if (candidate.pareto)
    tip += "\nNo other direction listed is better in undercut area, number of undercuts and depth at once.";
  if (const auto& tilt = candidate.tilt; tilt && !tilt->at_least())
    tip += fmt::format("\nTilts {:.2f}° at most, towards {}.", tilt->deg, direction_text(tilt->toward, 3));
  if (candidate.axis) tip += "\n" + with_minus(axis_beside_text(*context.state.model, candidate));
  if (begin_tooltip(ui)) {
    heading(ui, fmt::format("{}: {}", candidate.rank, with_minus(direction_words(direction))));
    draw_item_text(ui.colours->muted, tip);
    const glm::vec2 pixels(candidate_picture_size(ui.scale)), at = cursor_at();
    ImGui::Dummy(pixels);
    draw_picture(window_list(), index < pictures.size() ? pictures[index] : 0, {at, at + pixels}, ui.px(4));
    end_tooltip();
  }
  const auto cell = [&](std::size_t column, const SizedFont& font, ImU32 colour, std::string_view text) {
    table_.draw_cell(ui, row.box, column, {font, colour}, text);
  };
  const ImU32 normal = ui.colours->text, quiet = ui.colours->muted;
  cell(0, ui.fonts.strong, normal, fmt::format("{} {}", candidate.rank, candidate.tie));
  cell(1, ui.fonts.body, normal, with_minus(direction_words(direction)));
  for (std::size_t k = 0; k < figures.size(); ++k) {
    const DirectionFigure& figure = *figures[k];
    const SizedFont& font = figure.key == "undercut" ? ui.fonts.strong : ui.fonts.body;
    std::string text = grouped(with_minus(figure_text(figure, *context.state.model, candidate)));
    if (figure.kind == FigureKind::actions) text = fitted(font, text, ui.px(width_of(figure.kind)));
    cell(k_before_figures + k, font, figure.kind == FigureKind::error ? quiet : normal, text);
  }
  auto& compared = context.edits.sweep_choices.compared;
  const bool chosen = compared == index;
  cell(k_before_figures + figures.size(), ui.fonts.small, quiet, reasons_text(candidate.candidate));
  if ((row.hovered || chosen) &&
      compare_button(ui, {row.box.max.x - ui.px(16), row.box.centre().y}, chosen)) {
    compared = chosen ? std::nullopt : std::optional(index);
  } else if (row.clicked) {
    context.edits.ask(&Commands::fly_to_direction, direction);
  }
  put_cursor({row.box.min.x, row.box.max.y});
}

void SweepPanel::draw_footer(const PanelContext& context) {
  const Ui& ui = context.ui;
  const std::vector<std::string>& remarks = context.state.sweep.result->remarks;
  const float width = room_left();
  if (remarks.empty()) return ImGui::Dummy(ImVec2(width, ui.px(2)));
  const Lettering quiet = ui.note();
  row_text(ui, quiet, width, fitted(ui.fonts.small, remarks.front(), width));
  tooltip(ui, {}, fmt::format("{}", fmt::join(remarks, "\n")));
}

}  // namespace moldlight::gui
