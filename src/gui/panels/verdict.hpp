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
  std::string best;  // what a sweep says to it; empty where none has run or nothing is to be gained
  std::optional<glm::dvec3> better;  // the direction that has less undercut
  std::string best_help;             // more of it

  /// Shown with a tick.
  [[nodiscard]] bool good() const { return verdict && verdict->good(); }
};
[[nodiscard]] VerdictCard verdict_card(const AppState& state);

/// "1 slide, 2 lifters · 49.2 mm² left"; what comes of the plan of side actions.
[[nodiscard]] std::string actions_summary(const AppState& state);

/// "555.6 mm²", or that there is none.
[[nodiscard]] std::string undercut_text(const PartModel& model, const SweepCandidate& candidate);
/// At the top of the legend.
void draw_verdict(const PanelContext& context);

}  // namespace moldlight::gui
