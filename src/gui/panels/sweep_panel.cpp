// The sweep along the bottom: how far it is, and the best directions as a table to sort and click.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"
#include "gui/panels/workspace.hpp"
#include "gui/view/direction.hpp"
#include "session/figures.hpp"
#include "session/sweep/sweep_stages.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_row = 34.0F, k_heading = 20.0F;  // layout units
constexpr float k_picture_width = 48.0F, k_picture_height = 30.0F;
/// Share of the window's height that the table takes unless it is expanded.
constexpr float k_share = 0.25F;
constexpr float k_bar_width = 132.0F;

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

void SweepPanel::draw_table(const PanelContext& context, std::span<const unsigned> pictures) {
  const Ui& ui = context.ui;
  const std::span<const SweepColumn> columns = sweep_columns();
  if (order_.follow(context.state.sweep.result)) first_ = 0;
  const glm::vec2 start = from_im(ImGui::GetCursorScreenPos());
  const float width = ImGui::GetContentRegionAvail().x;
  float left = start.x;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const SweepColumn& column = columns[k];
    const float column_width = column.width > 0.0F ? ui.px(column.width) : start.x + width - left;
    ImGui::SetCursorScreenPos(ImVec2(left, start.y));
    ImGui::PushID(static_cast<int>(k));
    const bool clicked =
        ImGui::InvisibleButton("heading", ImVec2(std::max(column_width, 1.0F), ui.px(k_heading)));
    ImGui::PopID();
    if (!column.help.empty()) tooltip(ui, {}, column.help);
    if (clicked && column.key != nullptr) order_.sort_by(k);
    const bool sorted = k == order_.column(), hovered = ImGui::IsItemHovered() && column.key != nullptr;
    const std::string name = sorted ? fmt::format("{} {}", column.name, order_.descending() ? "↓" : "↑")
                                    : std::string(column.name);
    const float inset = ui.px(column.right ? 8 : k == columns.size() - 1 ? 10 : 0);
    const float x = column.right ? left + column_width - inset - text_size(ui.fonts.small, name).x + ui.px(2)
                                 : left + inset;
    draw_text(list, ui.fonts.small, {x, start.y + ui.px(3)},
              hovered || sorted ? ui.colours->text : ui.colours->muted, name);
    left += column_width;
  }
  ImGui::SetCursorScreenPos(ImVec2(start.x, start.y + ui.px(k_heading)));

  const float window_height = ImGui::GetIO().DisplaySize.y;
  const float room = expanded_ ? window_height - ui.px(k_bar_height + 140) : k_share * window_height;
  const auto fits = static_cast<std::size_t>(std::max(room / ui.px(k_row), 2.0F));
  const std::vector<std::size_t>& rows = order_.rows();
  const std::size_t shown = std::min(fits, rows.size());
  if (ImGui::IsWindowHovered() && ImGui::GetIO().MouseWheel != 0.0F) {
    first_ = ImGui::GetIO().MouseWheel < 0.0F ? first_ + 1 : first_ - std::min<std::size_t>(first_, 1);
  }
  first_ = std::min(first_, rows.size() - shown);
  for (std::size_t k = first_; k < first_ + shown; ++k) {
    draw_row(context, rows[k], rows[k] < pictures.size() ? pictures[rows[k]] : 0);
  }
  draw_footer(context, shown);
}

void SweepPanel::draw_row(const PanelContext& context, std::size_t index, unsigned picture) {
  const Ui& ui = context.ui;
  const SweepCandidate& candidate = context.state.sweep.result->candidates[index];
  const glm::vec2 min = from_im(ImGui::GetCursorScreenPos());
  const glm::vec2 size(ImGui::GetContentRegionAvail().x, ui.px(k_row));
  const glm::vec2 max = min + size;
  ImGui::PushID(static_cast<int>(index));
  const bool clicked = ImGui::InvisibleButton("row", im(size));
  ImGui::SetItemAllowOverlap();
  const bool hovered = ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) ||
                       ImGui::IsMouseHoveringRect(im(min), im(max));
  const glm::dvec3 present = context.state.settings.direction();
  const bool here = std::abs(glm::dot(present, candidate.candidate.direction)) > 1.0 - 1e-10;
  std::string tip = all_reasons(candidate);
  if (candidate.pareto) tip += "\nNo other listed direction beats it in undercut, patches and depth alike.";
  if (const auto& tilt = candidate.tilt; tilt && !tilt->at_least()) {
    tip += fmt::format("\nLeans {:.2f}° at most, towards {}.", tilt->deg, direction_text(tilt->toward));
  }
  tooltip(ui, fmt::format("{}: {}", candidate.rank, direction_text(candidate.candidate.direction)), tip);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (hovered || here) {
    list.AddRectFilled(im(min), im(max), here ? ui.colours->field_hovered : ui.colours->field, ui.px(6));
  }
  const glm::vec2 pixels(candidate_picture_size(ui.scale));
  const glm::vec2 at(min.x + ui.px(3), std::round(min.y + 0.5F * (size.y - pixels.y)));
  draw_picture(list, picture, at, at + pixels, ui.px(4));
  float left = min.x;
  const std::span<const SweepColumn> columns = sweep_columns();
  for (const SweepColumn& column : columns) {
    const float width = column.width > 0.0F ? ui.px(column.width) : max.x - ui.px(k_row_height + 6) - left;
    if (column.text != nullptr) {
      const bool strong = column.name == "undercut" || column.name == "#";
      const bool quiet = column.name == "why" || column.name == "±";
      const SizedFont& font = strong                 ? ui.fonts.strong
                              : column.name == "why" ? ui.fonts.small
                                                     : ui.fonts.body;
      std::string text = column.text(context.state, candidate);
      const float inset = ui.px(column.width > 0.0F ? 8 : 10);
      if (column.width <= 0.0F && text_size(font, text).x > width - inset)
        text = candidate_kind_name(candidate.candidate.sources.front().kind);
      if (!column.right) text = fitted(font, text, width - (column.width > 0.0F ? 0.0F : inset));
      const float x = column.right ? left + width - inset - text_size(font, text).x
                                   : left + (column.width > 0.0F ? 0.0F : inset);
      draw_text(list, font, {x, std::round(0.5F * (min.y + max.y - font.size))},
                quiet ? ui.colours->muted : ui.colours->text, text);
    }
    left += width;
  }
  auto& compared = context.edits.sweep_choices.compared;
  const bool chosen = compared == index;
  bool compare = false;
  if (hovered || chosen) compare = compare_button(ui, {max.x - ui.px(16), 0.5F * (min.y + max.y)}, chosen);
  if (compare) {
    compared = chosen ? std::nullopt : std::optional(index);
  } else if (clicked) {
    context.edits.ask(&Commands::fly_to_direction, candidate.candidate.direction);
  }
  ImGui::PopID();
  ImGui::SetCursorScreenPos(ImVec2(min.x, max.y));
}

void SweepPanel::draw_footer(const PanelContext& context, std::size_t shown) {
  const Ui& ui = context.ui;
  const SweepResult& result = *context.state.sweep.result;
  const bool more = shown < order_.rows().size() || expanded_;
  const glm::vec2 start = from_im(ImGui::GetCursorScreenPos());
  const float width = ImGui::GetContentRegionAvail().x;
  if (!more && result.remarks.empty()) {
    ImGui::Dummy(ImVec2(width, ui.px(2)));
    return;
  }
  float used = 0.0F;
  if (more) {
    const std::string label =
        expanded_ ? "Less" : fmt::format("{} to {} of {}", first_ + 1, first_ + shown, order_.rows().size());
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
