#include <algorithm>
#include <array>

#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"
#include "mold/sweep/ranking.hpp"

namespace moldlight::gui {

namespace {

constexpr int k_columns = 3;

/// A number is typed here: most of them range over many powers of ten, some from 0 on.
bool number_row(const PanelContext& context, const Option<SweepSettings>& option, double value,
                int decimals) {
  const Ui& ui = context.ui;
  SweepSettings& settings = context.edits.sweep_choices.options;
  const std::string before = option_text(option, settings), standard = option_text(option, SweepSettings{});
  std::string after = before;
  if (number_field(ui, option.key.data(), option.label, value, decimals, ImGui::GetContentRegionAvail().x)) {
    after = real_text(value);
  }
  if (option_menu(ui, option.label, option.help, before, standard, before != standard)) after = standard;
  if (after == before) return false;
  try {
    set_option(option, settings, after);
    return true;
  } catch (const UsageError& error) {
    context.edits.ask(&Commands::say, std::string(error.what()), true);
    return false;
  }
}

void option_cell(const PanelContext& context, const Option<SweepSettings>& option) {
  SweepSettings& settings = context.edits.sweep_choices.options;
  if (const auto* integer = std::get_if<IntegerKind<SweepSettings>>(&option.kind)) {
    number_row(context, option, settings.*integer->member, 0);
  } else if (const auto* real = std::get_if<RealKind<SweepSettings>>(&option.kind)) {
    number_row(context, option, settings.*real->member, detail::decimals_of(real->step));
  } else {
    option_row(context.ui, option, settings);
  }
}

void draw_kinds(const PanelContext& context) {
  const Ui& ui = context.ui;
  std::vector<CandidateKind>& kinds = context.edits.sweep_choices.options.kinds;
  const std::vector<CandidateKind> all = all_candidate_kinds();
  float room = ImGui::GetContentRegionAvail().x;
  for (const CandidateKind kind : all) {
    const std::string name(candidate_kind_name(kind));
    const float width = text_size(ui.fonts.body, name).x + ui.px(18);
    if (kind != all.front()) {
      ImGui::SameLine(0.0F, ui.px(4));
      room -= ui.px(4);
    }
    room -= width;
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
  std::string& objective = context.edits.sweep_choices.options.objective;
  std::array<std::string_view, k_criterion_count> words{};
  int index = -1;
  for (std::size_t k = 0; k < k_criterion_count; ++k) {
    words[k] = criterion_name(static_cast<Criterion>(k));
    if (objective == words[k]) index = static_cast<int>(k);
  }
  if (choice(context.ui, "Best is the least", words, index, objective != SweepSettings{}.objective)) {
    objective = words[static_cast<std::size_t>(index)];
  }
}

}  // namespace

void draw_sweep_options(const PanelContext& context) {
  if (ImGui::BeginTable("options", k_columns,
                        ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoSavedSettings)) {
    for (const Option<SweepSettings>& option : sweep_options()) {
      ImGui::TableNextColumn();
      option_cell(context, option);
    }
    ImGui::EndTable();
  }
  draw_objective(context);
  draw_kinds(context);
}

}  // namespace moldlight::gui
