// One sentence on the part as it is: can two plates mold it along this direction? And where the best
// direction is.
#include "gui/panels/verdict.hpp"

#include <fmt/format.h>

#include "classify/figures.hpp"
#include "gui/draw/widgets.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/sweep_texts.hpp"

namespace moldlight::gui {

namespace {

std::string undercuts_text(std::optional<std::size_t> known) {
  if (!known) return "Undercut";
  const std::size_t count = *known;
  if (count == 0) return "Undercut in specks";
  return count == 1 ? "1 undercut" : fmt::format("{} undercuts", grouped(std::to_string(count)));
}

/// Nothing that could be told from none.
bool is_free(const Classification& result) {
  return result.areas[Region::undercut] <= result.uncertainty.total();
}

/// "best found: +Z, 555.6 mm²"; a direction that is no axis is told by its tooltip.
std::string best_text(const Part& part, const SweepCandidate& best) {
  std::string axis = short_direction_text(best.candidate.direction);
  axis = axis.size() == 2 ? axis + ", " : std::string();
  return "best found: " + axis + undercut_text(part, best);
}

std::string best_help(const SweepCandidate& best) {
  const auto count = figure_value(direction_figure("patches"), best);
  return direction_text(best.candidate.direction, 3) +
         (count ? "\n" + undercuts_text(static_cast<std::size_t>(*count)) : "");
}

}  // namespace

std::string undercut_text(const Part& part, const SweepCandidate& candidate) {
  if (is_free(candidate.classification)) return "no undercut";
  const FigureColumn column(candidate.classification.total_area);
  return fmt::format("{} {}", grouped(column.text(undercut_area(candidate))), powered_unit(part, 2));
}

namespace {

std::string taken_text(const ActionPlan& plan) {
  return plan.actions.empty() ? "no side action releases them" : actions_text(plan);
}

}  // namespace

bool has_undercuts(const AppState& state) { return state.figures.shown && !is_free(*state.figures.shown); }

std::string actions_summary(const AppState& state) {
  const ActionPlan& plan = *state.actions.plan;
  std::string text = taken_text(plan);
  if (plan.unreleased_area > 0.0 && !plan.actions.empty())
    text += fmt::format(" · {} {} left", grouped(fmt::format("{:.3g}", plan.unreleased_area)),
                        powered_unit(state.model->part, 2));
  return text;
}

Verdict verdict_of(const AppState& state) {
  Verdict verdict;
  if (!state.model || !state.figures.shown) return verdict;
  const Classification& here = *state.figures.shown;
  verdict.free = is_free(here);
  if (verdict.free) {
    verdict.sentence = "Two-plate mold: no undercut";
    return verdict;
  }
  const ActionsState& actions = state.actions;
  const bool planned = is_settled(actions) && !actions.plan->patches.empty();
  verdict.sentence = fmt::format("{}, {} {}", undercuts_text(state.figures.undercuts),
                                 grouped(FigureColumn(here.total_area).text(here.areas[Region::undercut])),
                                 powered_unit(state.model->part, 2));
  if (planned) verdict.sentence += " · " + taken_text(*actions.plan);
  const SweepState& sweep = state.sweep;
  if (sweep.running) {
    verdict.best = "looking for the best direction …";
  } else if (sweep.result && !sweep.stale && !sweep.result->candidates.empty()) {
    const SweepCandidate& best = sweep.result->candidates.front();
    const double doubt = best.classification.uncertainty.total() + here.uncertainty.total();
    if (undercut_area(best) < here.areas[Region::undercut] - doubt) {
      verdict.best = best_text(state.model->part, best);
      verdict.best_help = best_help(best);
      verdict.better = best.candidate.direction;
    } else {
      verdict.best = "no direction that was tried has less";
    }
  }
  return verdict;
}

void draw_verdict(const PanelContext& context) {
  const Ui& ui = context.ui;
  const Verdict verdict = verdict_of(context.state);
  const float alpha = context.state.figures.pale ? 0.4F : 1.0F;
  const float width = ImGui::GetContentRegionAvail().x;
  const float room = width - ui.px(26);
  // What has no room in one line has two, the second of side actions.
  const bool whole = text_size(ui.fonts.strong, verdict.sentence).x <= room;
  const std::size_t mark = whole ? std::string::npos : verdict.sentence.find(" · ");
  const std::string first = verdict.sentence.substr(0, mark);
  const std::string second = mark == std::string::npos ? "" : verdict.sentence.substr(mark + 4);
  const Pressable sentence = pressable(ui, "verdict", {width, ui.px(second.empty() ? 22 : 40)});
  const glm::vec2 at = sentence.box.min;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (sentence.hovered && !verdict.free)
    list.AddRectFilled(im(at), im(sentence.box.max), ui.colours->field, ui.px(6));
  if (!verdict.free) tooltip(ui, "Undercuts", "Click to look at them from where most of them is seen (U).");
  if (sentence.clicked || sentence.pressed) context.edits.ask(&Commands::look_at_undercuts);
  draw_icon(list, verdict.free ? Icon::check : Icon::alert, at + glm::vec2(ui.px(12), ui.px(11)), ui.px(14),
            faded(verdict.free ? ui.colours->text : ui.colours->warning, alpha));
  draw_text(list, {ui.fonts.strong, faded(ui.colours->text, alpha)},
            at + glm::vec2(ui.px(26), 0.5F * (ui.px(22) - ui.fonts.strong.size)),
            fitted(ui.fonts.strong, first, room));
  const SizedFont& font = text_size(ui.fonts.body, second).x <= room ? ui.fonts.body : ui.fonts.small;
  draw_text(list, {font, faded(ui.colours->text, alpha)}, at + glm::vec2(ui.px(26), ui.px(21)),
            fitted(font, second, room));
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
