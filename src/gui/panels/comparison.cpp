// The figures of two directions that are seen side by side, and their difference.
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "classify/number_format.hpp"
#include "gui/draw/bottom_panel.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_comparison_width = 344.0F, k_figure_row = 20.0F;  // layout units
constexpr std::array<ListColumn, 4> k_comparison_columns = {
    {{"", "", 18.0F, false}, {"", "", 168.0F, true}, {"", "", 256.0F, true}, {"", "", 344.0F, true}}};

}  // namespace

std::string with_sign(const FigureColumn& column, double value) {
  std::string text = column.text(std::abs(value));
  const bool none = text.find_first_not_of("0.") == std::string::npos;
  return none ? "0" : (value < 0.0 ? "−" : "+") + grouped(text);
}

void draw_comparison(const PanelContext& context) {
  const AppState& state = context.state;
  const auto& compared = state.sweep_choices.compared;
  if (!compared || !state.sweep.result || *compared >= state.sweep.result->candidates.size()) return;
  const Ui& ui = context.ui;
  const SweepCandidate& other = state.sweep.result->candidates[*compared];
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  place_window({0.5F * window.x, ui.px(k_bar_height + 8)}, {0.5F, 0.0F});
  ImGui::Begin("##Comparison", nullptr, k_card_window);
  const glm::vec2 start = cursor_at();
  const auto add = [&](const std::array<std::string, 4>& texts, ImU32 colour, ImU32 swatch = 0) {
    const glm::vec2 at = cursor_at();
    ImGui::Dummy(ImVec2(ui.px(k_comparison_width), ui.px(k_figure_row)));
    const glm::vec2 min(at.x, at.y + ui.px(5));
    fill(window_list(), {min, min + glm::vec2(ui.px(10))}, swatch, ui.px(3));
    for (std::size_t k = 0; k < texts.size(); ++k)
      draw_cell(ui, item_box(), k_comparison_columns[k],
                {k == 3 ? ui.fonts.strong : ui.fonts.body, k == 3 ? ui.colours->text : colour}, texts[k]);
  };
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
  const bool known = state.figures.shown && !state.figures.pale;
  const FigureColumn column(state.model->geometry.total_area);
  add({"", "left", fmt::format("right, {}", other.rank), "left − right"}, ui.colours->muted);
  for (const Region region : k_regions) {
    const double right = other.classification.areas[region];
    const double left = known ? state.figures.shown->areas[region] : 0.0;
    add({std::string(facts(region).title), known ? grouped(column.text(left)) : "…",
         grouped(column.text(right)), known ? with_sign(column, left - right) : "…"},
        ui.colours->text, packed(region_colour(region, state.settings.look.palette)));
  }
  add({"Undercut ±", known ? error_text(state.figures.shown->uncertainty.total()) : "…",
       error_text(other.classification.uncertainty.total()),
       known ? error_text(std::hypot(state.figures.shown->uncertainty.total(),
                                     other.classification.uncertainty.total()))
             : "…"},
      ui.colours->muted);
  ImGui::PopStyleVar();
  put_cursor({start.x - ui.px(6), start.y - ui.px(3)});
  if (icon_button(ui, {"close comparison", Icon::close, "Back to one picture (Esc)"})) {
    context.edits.sweep_choices.compared.reset();
  }
  ImGui::End();
}

}  // namespace moldlight::gui
