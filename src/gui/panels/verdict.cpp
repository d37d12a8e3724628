// One sentence on the part as it is: can two plates mold it along this direction?
#include "gui/panels/verdict.hpp"

#include <algorithm>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "classify/figures.hpp"
#include "gui/draw/widgets.hpp"

namespace moldlight::gui {

namespace {

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
  ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
}

}  // namespace moldlight::gui
