// The figures of two directions that are seen side by side, and their difference.
#include <array>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "classify/figures.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_comparison_width = 344.0F, k_figure_row = 20.0F;  // layout units

/// A table of four columns: the name, and three figures set to the right.
class Rows {
 public:
  explicit Rows(const Ui& ui)
      : ui_(ui), at_(from_im(ImGui::GetCursorScreenPos())), width_(ui.px(k_comparison_width)) {}

  void add(std::string_view name, const std::array<std::string, 3>& figures, ImU32 colour,
           std::optional<ImU32> swatch = std::nullopt) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float text_top = at_.y + 0.5F * (ui_.px(k_figure_row) - ui_.fonts.body.size);
    if (swatch) {
      const glm::vec2 min(at_.x, at_.y + ui_.px(5));
      list.AddRectFilled(im(min), im(min + glm::vec2(ui_.px(10))), *swatch, ui_.px(3));
    }
    draw_text(list, {ui_.fonts.body, colour}, {at_.x + ui_.px(18), text_top}, name);
    for (std::size_t k = 0; k < figures.size(); ++k) {
      const float right = at_.x + width_ - static_cast<float>(2 - k) * ui_.px(88);
      draw_text_to({k == 2 ? ui_.fonts.strong : ui_.fonts.body, k == 2 ? ui_.colours->text : colour}, right,
                   text_top, figures[k]);
    }
    at_.y += ui_.px(k_figure_row);
  }
  void finish() {
    const glm::vec2 start = from_im(ImGui::GetCursorScreenPos());
    ImGui::Dummy(ImVec2(width_, at_.y - start.y));
  }

 private:
  const Ui& ui_;
  glm::vec2 at_;
  float width_;
};

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
  const glm::vec2 start = from_im(ImGui::GetCursorScreenPos());
  Rows rows(ui);
  const bool known = state.figures.shown && !state.figures.pale;
  const FigureColumn column(state.model->geometry.total_area);
  rows.add("", {"left", fmt::format("right, {}", other.rank), "left − right"}, ui.colours->muted);
  for (const Region region : k_regions) {
    const double right = other.classification.areas[region];
    const double left = known ? state.figures.shown->areas[region] : 0.0;
    rows.add(facts(region).title,
             {known ? grouped(column.text(left)) : "…", grouped(column.text(right)),
              known ? with_sign(column, left - right) : "…"},
             ui.colours->text, packed(region_colour(region, state.settings.look.palette)));
  }
  rows.add("Undercut ±",
           {known ? error_text(state.figures.shown->uncertainty.total()) : "…",
            error_text(other.classification.uncertainty.total()),
            known ? error_text(std::hypot(state.figures.shown->uncertainty.total(),
                                          other.classification.uncertainty.total()))
                  : "…"},
           ui.colours->muted);
  rows.finish();
  ImGui::SetCursorScreenPos(ImVec2(start.x - ui.px(6), start.y - ui.px(3)));
  if (icon_button(ui, {"close comparison", Icon::close, "Back to one picture (Esc)"})) {
    context.edits.sweep_choices.compared.reset();
  }
  ImGui::End();
}

}  // namespace moldlight::gui
