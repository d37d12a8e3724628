// One sentence on the part as it is: can two plates mold it along this direction? And where the best
// direction is.
#include "gui/panels/verdict.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "classify/figures.hpp"
#include "gui/draw/widgets.hpp"
#include "mold/direction_words.hpp"
#include "sweep/sweep_texts.hpp"

namespace moldlight::gui {

namespace {

/// Less than this share of the present undercut is no reason to turn.
constexpr double k_least_gain = 0.02;

/// "best found: z, 555.6 mm²"; a direction that is no axis stands in its tooltip.
std::string best_text(const PartModel& model, const SweepCandidate& best) {
  const NearestAxis nearest = nearest_axis(best.candidate.direction);
  const std::string axis = nearest.is_met() ? with_minus(nearest.name) + ", " : std::string();
  return "best found: " + axis + undercut_text(model, best);
}

std::string best_help(const PartModel& model, const SweepCandidate& best) {
  const std::optional<Verdict> verdict = verdict_of(model, best);
  return with_minus(direction_words(best.candidate.direction)) + (verdict ? "\n" + verdict->sentence : "");
}

void add_best(const AppState& state, VerdictCard& card) {
  const SweepState& sweep = state.sweep;
  if (sweep.running) {
    card.best = "looking for the best direction …";
  } else if (sweep.result && !sweep.stale && !sweep.result->candidates.empty()) {
    const Classification& here = *state.figures.shown;
    const SweepCandidate& best = sweep.result->candidates.front();
    const double area = here.areas[Region::undercut];
    const double doubt = best.classification.uncertainty.total() + here.uncertainty.total();
    if (undercut_area(best) < std::min(area - doubt, (1.0 - k_least_gain) * area)) {
      card.best = best_text(*state.model, best);
      card.best_help = best_help(*state.model, best);
      card.better = best.candidate.direction;
    } else {
      card.best = "no direction that was tried has less";
    }
  }
}

/// Words in lines that are no wider, the last with an ellipsis where there are more.
std::vector<std::string> lines_within(const SizedFont& font, std::string_view text, float width,
                                      std::size_t most) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    std::size_t end = text.size();
    while (end != std::string_view::npos && end > 0 &&
           text_size(font, std::string(text.substr(0, end))).x > width)
      end = text.rfind(' ', end - 1);
    if (end == std::string_view::npos || end == 0 || lines.size() + 1 == most) {
      lines.push_back(fitted(font, text, width));
      break;
    }
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  return lines;
}

std::string tooltip_text(const VerdictCard& card) {
  std::string text = card.sentence;
  if (card.verdict)
    for (const std::string& reason : card.verdict->reasons) text += "\n" + reason;
  if (card.verdict && card.verdict->undercuts > 0)
    text += "\nClick to look at the undercuts from where most of them is seen (U).";
  else if (card.verdict && card.verdict->specks > 0)
    text += "\nClick to look at the largest mark that is ignored (U).";
  return text;
}

}  // namespace

std::string undercut_text(const PartModel& model, const SweepCandidate& candidate) {
  if (candidate.undercuts && candidate.undercuts->count == 0) return "no undercut";
  const FigureColumn column(candidate.classification.total_area);
  return fmt::format("{} {}", grouped(column.text(undercut_area(candidate))), powered_unit(model.part, 2));
}

std::string actions_summary(const AppState& state) {
  const ActionPlan& plan = *state.actions.plan;
  std::string text = plan.actions.empty() ? "no side action releases them" : actions_text(plan);
  if (plan.unreleased_area > 0.0 && !plan.actions.empty())
    text += fmt::format(" · {} {} left",
                        grouped(rounded_area(plan.unreleased_area, state.model->geometry.total_area)),
                        powered_unit(state.model->part, 2));
  return text;
}

VerdictCard verdict_card(const AppState& state) {
  VerdictCard card;
  if (!state.model || !state.figures.shown) return card;
  card.verdict = state.verdict;
  if (card.verdict) {
    card.sentence = card.verdict->sentence;
  } else {
    const Classification& here = *state.figures.shown;
    card.sentence =
        fmt::format("Undercut, {} {}", grouped(rounded_area(here.areas[Region::undercut], here.total_area)),
                    powered_unit(state.model->part, 2));
  }
  if (!card.good()) add_best(state, card);
  return card;
}

void draw_verdict(const PanelContext& context) {
  constexpr float k_line = 18.0F, k_low_window = 680.0F;
  const Ui& ui = context.ui;
  // In a low window the panels below need the room; the tooltip has it all.
  const std::size_t most_lines = ImGui::GetIO().DisplaySize.y < ui.px(k_low_window) ? 2 : 4;
  const VerdictCard verdict = verdict_card(context.state);
  const float alpha = context.state.figures.pale ? 0.4F : 1.0F;
  const float width = ImGui::GetContentRegionAvail().x;
  const float room = width - ui.px(26);
  const std::vector<std::string> lines = lines_within(ui.fonts.strong, verdict.sentence, room, most_lines);
  const float height = ui.px(4.0F + k_line * static_cast<float>(lines.size()));
  const Pressable sentence = pressable(ui, "verdict", {width, height});
  const glm::vec2 at = sentence.box.min;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (sentence.hovered && !verdict.good())
    list.AddRectFilled(im(at), im(sentence.box.max), ui.colours->field, ui.px(6));
  tooltip(ui, "Verdict", tooltip_text(verdict));
  if (sentence.clicked || sentence.pressed) context.edits.ask(&Commands::look_at_undercuts);
  draw_icon(list, verdict.good() ? Icon::check : Icon::alert, at + glm::vec2(ui.px(12), ui.px(11)), ui.px(14),
            faded(verdict.good() ? ui.colours->text : ui.colours->warning, alpha));
  for (std::size_t k = 0; k < lines.size(); ++k)
    draw_text(list, {ui.fonts.strong, faded(ui.colours->text, alpha)},
              at + glm::vec2(ui.px(26), 0.5F * (ui.px(22) - ui.fonts.strong.size) +
                                            ui.px(k_line) * static_cast<float>(k)),
              lines[k]);
  if (!verdict.best.empty()) {
    ImGui::Indent(ui.px(26));
    const float button_width = verdict.better ? ui.px(72) : 0.0F;
    const float beside = room - button_width;
    row_text(ui, {ui.fonts.small, ui.colours->muted}, beside, fitted(ui.fonts.small, verdict.best, beside));
    if (verdict.better) {
      ImGui::SameLine(0.0F, 0.0F);
      if (button(ui, "Go there", {.width = button_width, .strong = true}))
        context.edits.ask(&Commands::fly_to_direction, *verdict.better);
      tooltip(ui, "The best direction found", verdict.best_help);
    }
    ImGui::Unindent(ui.px(26));
  }
  ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
}

}  // namespace moldlight::gui
