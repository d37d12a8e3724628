// The options of the sweep, unfolded in its panel.
#include <algorithm>

#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"
#include "session/sweep/direction_figures.hpp"

namespace moldlight::gui {

namespace {

constexpr int k_columns = 3;

void draw_kinds(const PanelContext& context) {
  const Ui& ui = context.ui;
  std::vector<CandidateKind>& kinds = context.edits.sweep_choices.options.kinds;
  const std::vector<CandidateKind> all = all_candidate_kinds();
  for (const CandidateKind kind : all) {
    const std::string name(candidate_kind_name(kind));
    const float width = text_size(ui.fonts.body, name).x + ui.px(18);
    if (kind != all.front()) ImGui::SameLine(0.0F, ui.px(4));
    const auto found = std::find(kinds.begin(), kinds.end(), kind);
    const bool clicked = chip(ui, name, found != kinds.end(), width);
    tooltip(ui, {}, "A source of candidate directions.");
    if (!clicked) continue;
    if (found != kinds.end()) {
      kinds.erase(found);
    } else {
      kinds.push_back(kind);
      std::sort(kinds.begin(), kinds.end());
    }
  }
}

void draw_objective(const PanelContext& context) {
  Objective& objective = context.edits.sweep_choices.options.objective;
  const std::vector<std::string> names = objective_names();
  const std::vector<std::string_view> words(names.begin(), names.end());
  const auto found = std::find(names.begin(), names.end(), objective.text);
  int index = found == names.end() ? -1 : static_cast<int>(found - names.begin());
  if (choice(context.ui, "Best is the least", words, index, objective.text != SweepSettings{}.objective.text))
    objective = parse_objective(words[static_cast<std::size_t>(index)]);
}

}  // namespace

void draw_sweep_options(const PanelContext& context) {
  // Most of them range over many powers of ten, some from 0 on.
  const TypedNumbers numbers{[&](const std::string& why) { context.edits.ask(&Commands::say, why, true); }};
  if (ImGui::BeginTable("options", k_columns,
                        ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoSavedSettings)) {
    for (const Option<SweepSettings>& option : sweep_options()) {
      ImGui::TableNextColumn();
      option_row(context.ui, option, context.edits.sweep_choices.options, numbers);
    }
    ImGui::EndTable();
  }
  draw_objective(context);
  draw_kinds(context);
}

}  // namespace moldlight::gui
