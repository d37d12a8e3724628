// The search for directions: how far it is, what it recommends, and the best ones as a table to sort and
// click.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glm/geometric.hpp>
#include <imgui_internal.h>

#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/step_panels.hpp"
#include "mold/direction.hpp"
#include "sweep/axis_beside.hpp"
#include "sweep/sweep_texts.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_direction_row = 26.0F, k_heading = 20.0F;  // layout units
constexpr float k_tip_width = 154.0F, k_tip_height = 96.0F;  // of a direction's tooltip
/// Share of the window's height that the table takes.
constexpr float k_sweep_share = 0.25F;
/// Columns before those of figures: rank, direction. And the one after them, why.
constexpr std::size_t k_before_figures = 2;
constexpr float k_rank_width = 30.0F, k_direction_width = 128.0F, k_least_why = 80.0F;  // layout units

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

float figure_width(const Ui& ui, const DirectionFigure& figure) {
  // With room for the mark of the column that is sorted by.
  return std::max(ui.px(width_of(figure.kind)), text_size(ui.fonts.small, figure.label).x + ui.px(8));
}

/// Those that the table has room for.
std::vector<const DirectionFigure*> fitting_columns(const Ui& ui, const SweepResult& result) {
  std::vector<const DirectionFigure*> figures = figure_columns(result);
  const float gap = ui.px(8);
  float needed = ui.px(k_rank_width + k_direction_width + k_least_why) + 3.0F * gap;
  for (const DirectionFigure* figure : figures) needed += figure_width(ui, *figure) + gap;
  if (needed > room_left()) keep_brief(figures);
  return figures;
}

/// Sorts by the present column, or the other way round where the table is sorted by it.
void turn_sorting(bool sorted) {
  const int column = ImGui::TableGetColumnIndex();
  const ImGuiTableSortSpecs* const sorting = ImGui::TableGetSortSpecs();
  const bool rises = sorted && sorting->Specs->SortDirection == ImGuiSortDirection_Ascending;
  ImGui::TableSetColumnSortDirection(
      column, rises ? ImGuiSortDirection_Descending : ImGuiSortDirection_Ascending, false);
}

void draw_headings(const Ui& ui, const std::vector<const DirectionFigure*>& figures) {
  struct Heading {
    std::string_view name, help;
    float width;
    ImGuiTableColumnFlags flags;
    bool is_figure = false;
  };
  constexpr ImGuiTableColumnFlags k_fixed = ImGuiTableColumnFlags_WidthFixed,
                                  k_not = ImGuiTableColumnFlags_NoSort;
  std::vector<Heading> headings = {{"#", "Rank; directions with the same letter tie within the uncertainty.",
                                    ui.px(k_rank_width), k_fixed | ImGuiTableColumnFlags_DefaultSort},
                                   {"direction", "", ui.px(k_direction_width), k_fixed | k_not}};
  for (const DirectionFigure* figure : figures)
    headings.push_back({figure->label, figure->help, figure_width(ui, *figure), k_fixed, true});
  headings.push_back({"why", "", 0.0F, ImGuiTableColumnFlags_WidthStretch | k_not});
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const Heading& heading : headings)
    ImGui::TableSetupColumn(heading.name.data(), heading.flags, heading.width);
  const FontScope small(ui.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.0F, 0.0F));
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, ui.px(k_heading));
  for (const Heading& heading : headings) {
    ImGui::TableNextColumn();
    const bool sorted = (ImGui::TableGetColumnFlags() & ImGuiTableColumnFlags_IsSorted) != 0;
    const glm::vec2 cell = cursor_at();
    const float room = room_left() - (sorted ? std::round(0.65F * ui.fonts.small.size) : 0.0F);
    // ImGui would set the text of a column of figures to the left.
    ImGui::TableHeader(fmt::format("##{}", heading.name).c_str());
    const float inset = heading.is_figure ? room - text_size(ui.fonts.small, heading.name).x : 0.0F;
    draw_text({ui.fonts.small, sorted || ImGui::IsItemHovered() ? ui.colours->text : ui.colours->muted},
              cell + glm::vec2(inset, ui.px(3)), heading.name);
    const std::string name = fmt::format("sort by {}", heading.name);
    const ScreenBox box = item_box();
    ui.memory->controls[name] = box;
    const bool sorts = (heading.flags & k_not) == 0;
    if (sorts && has_keyboard(ui, name, box) && ui.memory->keyboard.takes(ControlKey::press))
      turn_sorting(sorted);
    if (!heading.help.empty()) tooltip(ui, {}, heading.help);
  }
  ImGui::PopStyleVar();
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
  if (context.layout.begin_bottom(ui, "Directions")) {
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
  const bool fresh = result_ != result;
  const std::size_t count = result->candidates.size();
  const float room = k_sweep_share * screen_size().y;
  const float fits = std::max(std::floor(room / ui.px(k_direction_row)), 2.0F),
              all = static_cast<float>(count);
  const Figures figures = fitting_columns(ui, *result);
  constexpr ImGuiTableFlags k_flags = ImGuiTableFlags_Sortable | ImGuiTableFlags_ScrollY |
                                      ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_NoPadOuterX;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(ui.px(4), 0.0F));
  ImGui::PushStyleColor(ImGuiCol_TableHeaderBg, 0U);
  // ImGui keeps the widths with which a table began.
  ImGui::PushID(static_cast<int>(ui.px(k_direction_width)));
  if (ImGui::BeginTable("directions", static_cast<int>(k_before_figures + figures.size()) + 1, k_flags,
                        ImVec2(0.0F, ui.px(k_heading) + std::min(fits, all) * ui.px(k_direction_row)))) {
    if (fresh) ImGui::SetScrollY(0.0F);
    draw_headings(ui, figures);
    ImGuiTableSortSpecs* sorting = ImGui::TableGetSortSpecs();
    if (sorting->SpecsDirty || fresh) {
      result_ = result;
      const auto column = static_cast<std::size_t>(sorting->Specs->ColumnIndex);
      rows_ =
          sorted_candidates(*result, column < k_before_figures ? nullptr : figures[column - k_before_figures],
                            sorting->Specs->SortDirection == ImGuiSortDirection_Descending);
      sorting->SpecsDirty = false;
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count), ui.px(k_direction_row));
    cursor_.scroll(ui.px(k_direction_row), std::min(fits, all) * ui.px(k_direction_row));
    while (clipper.Step()) {
      for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k)
        draw_row(context, figures, static_cast<std::size_t>(k), pictures);
    }
    ImGui::EndTable();
    if (const auto pressed = cursor_.follow(ui, "table", static_cast<std::size_t>(fits), count))
      context.edits.ask(&Commands::fly_to_direction, result->candidates[rows_[*pressed]].candidate.direction);
  }
  ImGui::PopID();
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  draw_footer(context);
}

void SweepPanel::draw_row(const PanelContext& context, const Figures& figures, std::size_t place,
                          std::span<const unsigned> pictures) {
  const Ui& ui = context.ui;
  const std::size_t index = rows_[place];
  const SweepCandidate& candidate = result_->candidates[index];
  const glm::dvec3& direction = candidate.candidate.direction;
  const bool here = std::abs(glm::dot(context.state.settings.direction.unit(), direction)) > 1.0 - 1e-10;
  ImGui::TableNextRow(ImGuiTableRowFlags_None, ui.px(k_direction_row));
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(index));
  const bool clicked = ImGui::Selectable(
      "##row", here, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap,
      ImVec2(0.0F, ui.px(k_direction_row)));
  const ScreenBox box = item_box();
  if (cursor_.is_at(place))
    window_list().AddRect(box.min, box.max, ui.colours->accent, ui.px(4), 0, 1.5F * ui.scale);
  ui.memory->controls[fmt::format("direction {}", candidate.rank)] = box;
  const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem |
                                            ImGuiHoveredFlags_AllowWhenOverlapped);
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
  ImDrawList& list = window_list();

  const auto cell = [&](const SizedFont& font, ImU32 colour, const std::string& text, bool to_the_right) {
    const float inset = to_the_right ? room_left() - text_size(font, text).x : 0.0F;
    draw_text(list, {font, colour},
              {ImGui::GetCursorScreenPos().x + inset, box.centre().y - 0.5F * font.size}, text);
  };
  const ImU32 normal = ui.colours->text, quiet = ui.colours->muted;
  ImGui::SameLine(0.0F, 0.0F);
  cell(ui.fonts.strong, normal, fmt::format("{} {}", candidate.rank, candidate.tie), false);
  ImGui::TableNextColumn();
  cell(ui.fonts.body, normal, fitted(ui.fonts.body, with_minus(direction_words(direction)), room_left()),
       false);
  for (const DirectionFigure* figure : figures) {
    ImGui::TableNextColumn();
    const SizedFont& font = figure->key == "undercut" ? ui.fonts.strong : ui.fonts.body;
    const std::string text = grouped(with_minus(figure_text(*figure, *context.state.model, candidate)));
    cell(font, figure->kind == FigureKind::error ? quiet : normal,
         figure->kind == FigureKind::actions ? fitted(font, text, room_left()) : text, true);
  }
  auto& compared = context.edits.sweep_choices.compared;
  const bool chosen = compared == index, comparable = hovered || chosen;
  ImGui::TableNextColumn();
  const float room = room_left() - ui.px(comparable ? k_row_height + 6 : 0.0F);
  cell(ui.fonts.small, quiet, fitted(ui.fonts.small, reasons_text(candidate.candidate), room), false);
  if (comparable && compare_button(ui, {box.max.x - ui.px(16), box.centre().y}, chosen)) {
    compared = chosen ? std::nullopt : std::optional(index);
  } else if (clicked) {
    context.edits.ask(&Commands::fly_to_direction, direction);
  }
  ImGui::PopID();
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
