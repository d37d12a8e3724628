// The sweep along the bottom: how far it is, and the best directions as a table to sort and click.
#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"
#include "gui/panels/workspace.hpp"
#include "gui/view/direction.hpp"
#include "session/figures.hpp"
#include "session/sweep/sweep_stages.hpp"
#include "session/sweep/sweep_texts.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_row = 34.0F, k_heading = 20.0F;  // layout units
constexpr float k_picture_width = 48.0F, k_picture_height = 30.0F;
/// Share of the window's height that the table takes unless it is expanded.
constexpr float k_share = 0.25F;
constexpr float k_bar_width = 132.0F;
constexpr std::size_t k_rank = 1;  // column

std::string time_text(double seconds) {
  if (seconds < 10.0) return fmt::format("{:.1f} s left", seconds);
  if (seconds < 100.0) return fmt::format("{:.0f} s left", seconds);
  return fmt::format("{:.0f} min left", seconds / 60.0);
}

std::string progress_text(const SweepProgress& progress) {
  if (progress.ending) return "ending with what is done";
  std::string text;
  if (progress.stage == sweep_stage::k_scoring) {
    text = progress.all ? fmt::format("{}/{}", grouped(std::to_string(progress.scored)),
                                      grouped(std::to_string(*progress.all)))
                        : grouped(std::to_string(progress.scored));
    if (progress.per_second > 0.0)
      text += fmt::format("  ·  {}/s", grouped(fmt::format("{:.0f}", progress.per_second)));
  } else {
    text = progress.stage.empty() ? "starting" : progress.stage;
  }
  if (progress.left_s) text += "  ·  " + time_text(*progress.left_s);
  return text;
}

std::string result_text(const AppState& state) {
  const SweepResult& result = *state.sweep.result;
  std::string text = fmt::format("{} directions in {:.1f} s",
                                 grouped(std::to_string(result.evaluated.size())), result.elapsed_s);
  if (!result.complete) text += "  ·  ended early";
  if (state.sweep.stale) text += "  ·  of other settings";
  return text;
}

/// Two halves, one of them filled.
bool compare_button(const Ui& ui, const glm::vec2& centre, bool chosen) {
  ImGui::SetCursorScreenPos(im(centre - glm::vec2(0.5F * ui.px(k_row_height))));
  const bool clicked = ImGui::InvisibleButton("compare", ImVec2(ui.px(k_row_height), ui.px(k_row_height)));
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = hovered || chosen ? ui.colours->text : ui.colours->muted;
  const glm::vec2 half(ui.px(7), ui.px(5));
  if (hovered || chosen) {
    list.AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                       chosen ? ui.colours->field_active : ui.colours->field_hovered, ui.px(6));
  }
  list.AddRect(im(centre - half), im(centre + half), colour, ui.px(2), 0, 1.25F * ui.scale);
  list.AddRectFilled(ImVec2(centre.x, centre.y - half.y), im(centre + half), colour, ui.px(2));
  tooltip(ui, {}, chosen ? "Back to one picture" : "See it beside the present direction");
  return clicked;
}

std::string fitting_reason(const Ui& ui, const Candidate& candidate, float width) {
  for (const std::string& text : shorter_reasons(candidate)) {
    if (text_size(ui.fonts.small, text).x <= width) return text;
  }
  return fitted(ui.fonts.small, candidate_kind_name(candidate.kind()), width);
}

}  // namespace

glm::ivec2 candidate_picture_size(float scale) {
  return glm::ivec2(std::lround(k_picture_width * scale), std::lround(k_picture_height * scale));
}

void SweepPanel::draw(const PanelContext& context, std::span<const unsigned> pictures) {
  const bool open = context.layout.begin_bottom(context.ui, "Sweep");
  draw_header(context, open);
  const SweepState& sweep = context.state.sweep;
  if (open && options_) {
    draw_sweep_options(context);
  } else if (open && sweep.result && !sweep.result->candidates.empty()) {
    draw_table(context, pictures);
  }
  context.layout.end();
}

void SweepPanel::draw_header(const PanelContext& context, bool open) {
  const Ui& ui = context.ui;
  const SweepState& sweep = context.state.sweep;
  const glm::vec2 start = from_im(ImGui::GetCursorScreenPos());
  const float width = ImGui::GetContentRegionAvail().x, height = ui.px(k_row_height);
  const float middle = start.y + 0.5F * height;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  draw_text(list, ui.fonts.strong, {start.x, middle - 0.5F * ui.fonts.strong.size}, ui.colours->text,
            "Sweep");

  // From the right: chevron, options, ball, start or cancel, bar; what is left is text.
  float right = start.x + width;
  const auto place = [&](float item_width) {
    right -= item_width;
    ImGui::SetCursorScreenPos(ImVec2(right, start.y));
    right -= ui.px(4);
  };
  place(height);
  if (icon_button(ui, "fold", open ? Icon::chevron_down : Icon::chevron_up, open ? "Fold up" : "Unfold"))
    context.layout.fold(open);
  place(height);
  if (icon_button(ui, "options", Icon::settings, "Options of the sweep", open && options_)) {
    options_ = !(open && options_);
    context.layout.fold(false);
  }
  if (sweep.map) {
    place(height);
    SweepChoices& choices = context.edits.sweep_choices;
    if (icon_button(ui, "ball", Icon::sphere, "The map of directions, large", choices.large_ball))
      choices.large_ball = !choices.large_ball;
  }
  const char* action = sweep.running ? "Cancel" : "Find directions";
  right -= ui.px(4);
  place(text_size(ui.fonts.body, action).x + ui.px(24));
  if (button(ui, action, {.width = 0.0F, .strong = !sweep.running && !sweep.map})) {
    context.edits.ask(sweep.running ? &Commands::cancel_sweep : &Commands::start_sweep);
    options_ = false;
  }
  if (sweep.running) {
    right -= ui.px(6);
    place(ui.px(k_bar_width));
    ImGui::SetCursorScreenPos(ImVec2(ImGui::GetCursorScreenPos().x, middle - ui.px(2)));
    progress_bar(ui, sweep.running->share, ui.px(k_bar_width));
  }
  const float left = start.x + text_size(ui.fonts.strong, "Sweep").x + ui.px(12);
  std::string text;
  ImU32 colour = ui.colours->muted;
  if (sweep.running) {
    text = progress_text(*sweep.running);
  } else if (sweep.result) {
    text = result_text(context.state);
  } else if (!sweep.error.empty()) {
    text = sweep.error;
    colour = ui.colours->warning;
  } else {
    text = "which way should the mold open?";
  }
  draw_text(list, ui.fonts.body, {left, middle - 0.5F * ui.fonts.body.size}, colour,
            fitted(ui.fonts.body, text, right - left - ui.px(8)));
  ImGui::SetCursorScreenPos(ImVec2(start.x, start.y + height));
  ImGui::Dummy(ImVec2(width, 0.0F));
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

/// The texts of a result that is not the one of the last call, or in another size.
bool SweepPanel::follow(const Ui& ui, const AppState& state) {
  if (result_ == state.sweep.result && scale_ == ui.scale) return false;
  result_ = state.sweep.result;
  scale_ = ui.scale;
  columns_ = {{.width = ui.px(k_picture_width)},
              {.heading = "#", .help = "Rank; directions with the same letter tie within the uncertainty."},
              {.heading = "direction"}};
  for (const DirectionFigure* figure : figure_columns(*result_))
    columns_.push_back({.figure = figure, .heading = figure->label, .help = figure->help});
  for (const SweepCandidate& candidate : result_->candidates) {
    columns_[k_rank].texts.push_back(fmt::format("{} {}", candidate.rank, candidate.tie));
    columns_[k_rank + 1].texts.push_back(with_minus(short_direction_text(candidate.candidate.direction)));
    for (std::size_t k = k_rank + 2; k < columns_.size(); ++k)
      columns_[k].texts.push_back(
          grouped(with_minus(figure_text(*columns_[k].figure, *state.model, candidate))));
  }
  for (SweepColumn& column : columns_) {
    column.width = std::max(column.width, text_size(ui.fonts.small, column.heading).x);
    for (const std::string& text : column.texts)
      column.width = std::max(column.width, text_size(ui.fonts.strong, text).x);
  }
  columns_.push_back({.heading = "why"});
  return true;
}

void SweepPanel::draw_headings(const Ui& ui) const {
  ImGui::TableSetupScrollFreeze(0, 1);
  for (const SweepColumn& column : columns_) {
    const bool is_rank = &column == &columns_[k_rank], is_last = &column == &columns_.back();
    ImGuiTableColumnFlags flags =
        is_last ? ImGuiTableColumnFlags_WidthStretch : ImGuiTableColumnFlags_WidthFixed;
    if (is_rank) flags |= ImGuiTableColumnFlags_DefaultSort;
    if (!is_rank && column.figure == nullptr) flags |= ImGuiTableColumnFlags_NoSort;
    ImGui::TableSetupColumn(column.heading.data(), flags, column.width);
  }
  const FontScope small(ui.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(0.0F, 0.0F));
  ImGui::TableNextRow(ImGuiTableRowFlags_Headers, ui.px(k_heading));
  for (const SweepColumn& column : columns_) {
    ImGui::TableNextColumn();
    const bool sorted = (ImGui::TableGetColumnFlags() & ImGuiTableColumnFlags_IsSorted) != 0;
    const glm::vec2 cell = from_im(ImGui::GetCursorScreenPos());
    const float room =
        ImGui::GetContentRegionAvail().x - (sorted ? std::round(0.65F * ui.fonts.small.size) : 0.0F);
    // ImGui would set the text of a column of figures to the left.
    ImGui::TableHeader(fmt::format("##{}", column.heading).c_str());
    if (column.heading.empty()) continue;
    const float inset = column.figure != nullptr ? room - text_size(ui.fonts.small, column.heading).x : 0.0F;
    draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small, cell + glm::vec2(inset, ui.px(3)),
              sorted || ImGui::IsItemHovered() ? ui.colours->text : ui.colours->muted, column.heading);
    ui.memory->controls[fmt::format("sort by {}", column.heading)] = {from_im(ImGui::GetItemRectMin()),
                                                                      from_im(ImGui::GetItemRectMax())};
    if (!column.help.empty()) tooltip(ui, {}, column.help);
  }
  ImGui::PopStyleVar();
}

void SweepPanel::draw_table(const PanelContext& context, std::span<const unsigned> pictures) {
  const Ui& ui = context.ui;
  const bool fresh = follow(ui, context.state);
  const std::size_t count = result_->candidates.size();
  const float window_height = ImGui::GetIO().DisplaySize.y;
  const float room = expanded_ ? window_height - ui.px(k_bar_height + 140) : k_share * window_height;
  const float fits = std::max(std::floor(room / ui.px(k_row)), 2.0F), all = static_cast<float>(count);
  constexpr ImGuiTableFlags k_flags = ImGuiTableFlags_Sortable | ImGuiTableFlags_ScrollY |
                                      ImGuiTableFlags_NoSavedSettings | ImGuiTableFlags_NoPadOuterX;
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(ui.px(4), 0.0F));
  ImGui::PushStyleColor(ImGuiCol_TableHeaderBg, 0U);
  if (ImGui::BeginTable("directions", static_cast<int>(columns_.size()), k_flags,
                        ImVec2(0.0F, ui.px(k_heading) + std::min(fits, all) * ui.px(k_row)))) {
    if (fresh) ImGui::SetScrollY(0.0F);
    draw_headings(ui);
    ImGuiTableSortSpecs* sorting = ImGui::TableGetSortSpecs();
    if (sorting != nullptr && (sorting->SpecsDirty || fresh)) {
      const ImGuiTableColumnSortSpecs& by = *sorting->Specs;
      rows_ = sorted_candidates(*result_, columns_[static_cast<std::size_t>(by.ColumnIndex)].figure,
                                by.SortDirection == ImGuiSortDirection_Descending);
      sorting->SpecsDirty = false;
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count), ui.px(k_row));
    while (clipper.Step()) {
      for (int k = clipper.DisplayStart; k < clipper.DisplayEnd; ++k) {
        const std::size_t index = rows_[static_cast<std::size_t>(k)];
        draw_row(context, index, index < pictures.size() ? pictures[index] : 0);
      }
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleColor();
  ImGui::PopStyleVar();
  draw_footer(context, fits < all || expanded_);
}

void SweepPanel::draw_row(const PanelContext& context, std::size_t index, unsigned picture) {
  const Ui& ui = context.ui;
  const SweepCandidate& candidate = result_->candidates[index];
  const glm::dvec3& direction = candidate.candidate.direction;
  const bool here = std::abs(glm::dot(context.state.settings.direction(), direction)) > 1.0 - 1e-10;
  ImGui::TableNextRow(ImGuiTableRowFlags_None, ui.px(k_row));
  ImGui::TableNextColumn();
  ImGui::PushID(static_cast<int>(index));
  const glm::vec2 corner = from_im(ImGui::GetCursorScreenPos());
  const bool clicked = ImGui::Selectable(
      "##row", here, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap,
      ImVec2(0.0F, ui.px(k_row)));
  const glm::vec2 min = from_im(ImGui::GetItemRectMin()), max = from_im(ImGui::GetItemRectMax());
  ui.memory->controls[fmt::format("direction {}", candidate.rank)] = {min, max};
  const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem |
                                            ImGuiHoveredFlags_AllowWhenOverlapped);
  std::string tip = reasons_text(candidate.candidate, candidate.candidate.sources.size());
  if (candidate.pareto) tip += "\nNo other listed direction beats it in undercut, patches and depth alike.";
  if (const auto& tilt = candidate.tilt; tilt && !tilt->at_least()) {
    tip += fmt::format("\nLeans {:.2f}° at most, towards {}.", tilt->deg, direction_text(tilt->toward));
  }
  tooltip(ui, fmt::format("{}: {}", candidate.rank, direction_text(direction)), tip);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const glm::vec2 pixels(candidate_picture_size(ui.scale));
  const glm::vec2 at(corner.x, std::round(min.y + 0.5F * (max.y - min.y - pixels.y)));
  draw_picture(list, picture, at, at + pixels, ui.px(4));
  for (const SweepColumn& column : std::span(columns_).subspan(k_rank)) {
    ImGui::TableNextColumn();
    const glm::vec2 cell = from_im(ImGui::GetCursorScreenPos());
    const float width = ImGui::GetContentRegionAvail().x;
    const bool is_figure = column.figure != nullptr, is_reason = column.texts.empty();
    const bool strong = is_figure ? column.figure->key == "undercut" : &column == &columns_[k_rank];
    const SizedFont& font = is_reason ? ui.fonts.small : strong ? ui.fonts.strong : ui.fonts.body;
    const std::string text = is_reason
                                 ? fitting_reason(ui, candidate.candidate, width - ui.px(k_row_height + 6))
                                 : column.texts[index];
    const bool quiet = is_reason || (is_figure && column.figure->kind == FigureKind::error);
    draw_text(list, font,
              {is_figure ? cell.x + width - text_size(font, text).x : cell.x,
               std::round(0.5F * (min.y + max.y - font.size))},
              quiet ? ui.colours->muted : ui.colours->text, text);
  }
  auto& compared = context.edits.sweep_choices.compared;
  const bool chosen = compared == index;
  bool compare = false;
  if (hovered || chosen) compare = compare_button(ui, {max.x - ui.px(16), 0.5F * (min.y + max.y)}, chosen);
  if (compare) {
    compared = chosen ? std::nullopt : std::optional(index);
  } else if (clicked) {
    context.edits.ask(&Commands::fly_to_direction, direction);
  }
  ImGui::PopID();
}

void SweepPanel::draw_footer(const PanelContext& context, bool more) {
  const Ui& ui = context.ui;
  const SweepResult& result = *context.state.sweep.result;
  const glm::vec2 start = from_im(ImGui::GetCursorScreenPos());
  const float width = ImGui::GetContentRegionAvail().x;
  if (!more && result.remarks.empty()) {
    ImGui::Dummy(ImVec2(width, ui.px(2)));
    return;
  }
  float used = 0.0F;
  if (more) {
    const std::string label = expanded_ ? "Less" : fmt::format("All {}", result.candidates.size());
    used = text_size(ui.fonts.small, label).x + ui.px(34);
    if (disclosure(ui, label, expanded_)) expanded_ = !expanded_;
  } else {
    ImGui::Dummy(ImVec2(width, ui.px(k_row_height)));
  }
  if (result.remarks.empty()) return;
  const std::string remark = fitted(ui.fonts.small, result.remarks.front(), width - used - ui.px(8));
  draw_text(*ImGui::GetWindowDrawList(), ui.fonts.small,
            {start.x + width - ui.px(8) - text_size(ui.fonts.small, remark).x,
             start.y + 0.5F * (ui.px(k_row_height) - ui.fonts.small.size)},
            ui.colours->muted, remark);
  std::string all;
  for (const std::string& each : result.remarks) all += (all.empty() ? "" : "\n") + each;
  tooltip(ui, {}, all);
}

}  // namespace moldlight::gui
