// What is to be said first of a part and a direction.
#pragma once

#include <optional>
#include <string>

#include "gui/panels/panels.hpp"

namespace moldlight::gui {

/// The study's verdict as the window shows it.
struct VerdictCard {
  std::optional<Verdict> verdict;  // none while nothing is measured, or the direction moves
  std::string sentence;            // its sentence, or what is known meanwhile

  /// Shown with a tick.
  [[nodiscard]] bool good() const { return verdict && verdict->good(); }
};
[[nodiscard]] VerdictCard verdict_card(const AppState& state);

/// "1 slide, 2 lifters · 49.2 mm² left"; what comes of the plan of side actions.
[[nodiscard]] std::string actions_summary(const AppState& state);

/// At the top of the legend.
void draw_verdict(const PanelContext& context);

}  // namespace moldlight::gui
