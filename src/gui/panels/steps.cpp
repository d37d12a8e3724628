// The steps along the top: how each stands, and where one goes on from the last of them.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "classify/number_format.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/step_parts.hpp"
#include "mold/direction.hpp"
#include "study/verdict.hpp"

namespace moldlight::gui {

namespace {

using Sign = StepMark::Sign;

constexpr std::size_t k_longest_direction = 3;  // letters, of one that has room: "-x"

StepMark part_mark(const AppState& state) {
  std::vector<std::string> faults = state.model->warnings;
  if (state.model->part.unit.empty()) faults.insert(faults.begin(), "The file states no unit.");
  if (faults.empty()) return {Sign::good, {}, "The mesh is in order."};
  return {Sign::warning, {}, fmt::format("{}", fmt::join(faults, " "))};
}

StepMark direction_mark(const AppState& state) {
  const std::string words = with_minus(direction_words(state.settings.direction.unit()));
  StepMark mark{Sign::none, words.size() <= k_longest_direction ? words : std::string(),
                "Along " + words + "."};
  const auto& cards = state.sweep.cards;
  if (std::ranges::any_of(cards, &DirectionCard::offered)) {
    mark.sign = Sign::warning;
    mark.tip += " Another direction is better.";
  } else if (!cards.empty() && cards.front().here) {
    mark.sign = Sign::good;
    mark.tip += " This is the recommended direction.";
  } else if (state.sweep.running) {
    mark.sign = Sign::working;
  }
  return mark;
}

StepMark undercuts_mark(const AppState& state) {
  const VerdictCard card = verdict_card(state);
  if (!card.verdict) return {state.figures.error.empty() ? Sign::working : Sign::warning, {}, card.sentence};
  const Verdict& verdict = *card.verdict;
  if (card.good()) return {Sign::good, {}, card.sentence};
  const bool left = verdict.state == VerdictState::not_releasable;
  return {left || verdict.state == VerdictState::unknown ? Sign::warning : Sign::none,
          verdict.undercuts > 0 ? std::to_string(verdict.undercuts) : std::string(), card.sentence};
}

StepMark line_mark(const MoldState& mold) {
  if (mold.line_awaited) return {Sign::working, {}, "The parting line is being looked for."};
  if (!mold.line) return {mold.error.empty() ? Sign::none : Sign::warning, {}, mold.error};
  return {Sign::good, {}, mold.line->verdict};
}

StepMark draft_mark(const AppState& state) {
  const auto& line = state.mold.line;
  if (!line || !line->draft) return {};
  const std::size_t walls = line->draft->walls.size();
  std::string sentence = draft_sentence(*state.model, *line->draft);
  if (walls == 0) return {Sign::good, {}, std::move(sentence)};
  return {Sign::warning, std::to_string(walls), std::move(sentence)};
}

StepMark mold_mark(const AppState& state) {
  const MoldState& mold = state.mold;
  if (mold.solids_awaited) return {Sign::working, {}, "The halves are being made."};
  if (!mold.solids) return {Sign::none, {}, mold.error.empty() ? "The halves are made here." : mold.error};
  const std::vector<HalvesLine> lines = halves_lines(state);
  const auto doubt = std::ranges::find_if(lines, &HalvesLine::doubt);
  if (doubt != lines.end()) return {Sign::warning, {}, doubt->text};
  return {Sign::good, {}, "The halves are made and checked."};
}

}  // namespace

StepMark step_mark(const AppState& state, Step step) {
  switch (step) {
    case Step::part:
      return part_mark(state);
    case Step::direction:
      return direction_mark(state);
    case Step::undercuts:
      return undercuts_mark(state);
    case Step::parting_line:
      return line_mark(state.mold);
    case Step::draft:
      return draft_mark(state);
    case Step::mold:
      return mold_mark(state);
    case Step::report:
      break;
  }
  return {.tip = "Pictures, tables, meshes and the mold as files."};
}

void draw_report_step(const PanelContext& context) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  for (const Step step : {Step::part, Step::direction, Step::undercuts, Step::parting_line, Step::draft}) {
    const StepMark mark = step_mark(state, step);
    heading(ui, step_title(step));
    draw_note(ui, {.text = mark.tip.empty() ? std::string_view("Not known yet.") : mark.tip,
                   .icon = mark.sign == Sign::warning ? std::optional(Icon::alert)
                           : mark.sign == Sign::good  ? std::optional(Icon::check)
                                                      : std::nullopt,
                   .warning = mark.sign == Sign::warning});
    ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
  }
  const float width = ImGui::GetContentRegionAvail().x;
  const float half = std::floor(0.5F * (width - ui.px(4)));
  if (button(ui, "Page (HTML)", {.width = half, .strong = true}))
    context.edits.ask(&Commands::make_report, false);
  tooltip(ui, {}, "Writes the report of the mold beside the part, as one page for a browser.");
  ImGui::SameLine(0.0F, ui.px(4));
  if (button(ui, "Paper (PDF)", {.width = half})) context.edits.ask(&Commands::make_report, true);
  tooltip(ui, {}, "Writes the same report as a PDF for A4 paper.");
  if (button(ui, "Present", {.width = width})) context.edits.ask(&Commands::present);
  tooltip(ui, {}, "The part and a caption alone (F5). The keys of the steps work there, too.");
  if (button(ui, "Save a picture …", {.width = width})) context.edits.ask(&Commands::take_picture);
  if (button(ui, "Export what was measured …", {.width = width})) context.edits.dialogs.exporting = true;
  if (button(ui, "Export the mold …", {.width = width})) context.edits.dialogs.exporting_mold = true;
}

void draw_caption(const PanelContext& context) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const std::string tip = step_mark(state, state.step).tip;
  const bool verdict = state.step == Step::report || tip.empty();
  const glm::vec2 window = from_im(ImGui::GetIO().DisplaySize);
  const float width = std::min(ui.px(720), window.x - ui.px(64));
  place_window({0.5F * window.x, window.y - ui.px(20)}, {0.5F, 1.0F});
  ImGui::Begin("Caption", nullptr, k_card_window | ImGuiWindowFlags_NoInputs);
  const auto lines = lines_within(
      ui.fonts.strong, verdict ? verdict_card(state).sentence : tip.substr(0, tip.find('\n')), width, 3);
  hint(ui, fmt::format("{} · along {}{}", std::filesystem::path(state.path).filename().string(),
                       with_minus(direction_words(state.settings.direction.unit())),
                       verdict ? "" : fmt::format(" · {}", step_title(state.step))));
  for (const std::string& line : lines) heading(ui, line);
  ImGui::End();
}

void draw_drawer_tab(const PanelContext& context) {
  const Ui& ui = context.ui;
  Drawer& drawer = context.edits.drawer;
  if (context.state.drawer != Drawer::none || context.state.revisions.on()) return;
  const glm::vec2 size(ui.px(k_panel_width), ui.px(k_tab_height));
  const glm::vec2 corner(ui.px(12), ImGui::GetIO().DisplaySize.y - ui.px(12) - size.y);
  place_window(corner, glm::vec2(0.0F));
  ImGui::SetNextWindowSize(im(size));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::Begin("##Drawer tab", nullptr, k_fixed_window);
  const Pressable tab = pressable(ui, "Shadow maps", size);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (tab.hovered) fill(list, tab.box, ui.colours->field, ui.px(8));
  const float middle = tab.box.centre().y;
  draw_icon(list, Icon::chevron_up, {tab.box.max.x - ui.px(18), middle}, ui.px(9), ui.colours->muted);
  draw_text(list, {ui.fonts.strong, ui.colours->text},
            {corner.x + ui.px(12), middle - 0.5F * ui.fonts.strong.size}, "Shadow maps");
  if (tab.clicked) drawer = Drawer::maps;
  tooltip(ui, "Shadow maps", "Direction, τ, kernel, edge thickness and resolution, live.");
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace moldlight::gui
