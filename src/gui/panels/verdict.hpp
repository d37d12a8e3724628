// What is to be said first of a part and a direction.
#pragma once

#include <optional>
#include <string>

#include "gui/panels/panels.hpp"

namespace moldlight::gui {

struct Verdict {
  bool free = false;     // of undercuts, as far as can be told
  std::string sentence;  // empty while nothing is measured; what is behind a " · " is of side actions
  std::string best;      // what a sweep says to it; empty where none has run or nothing is to be gained
  std::optional<glm::dvec3> better;  // the direction that has less undercut
  std::string best_help;             // more of it
};
[[nodiscard]] Verdict verdict_of(const AppState& state);

/// Whether the part has undercuts, as far as can be told.
[[nodiscard]] bool has_undercuts(const AppState& state);
/// "1 slide, 2 lifters · 49.2 mm² left"; what comes of the plan of side actions.
[[nodiscard]] std::string actions_summary(const AppState& state);

/// "555.6 mm²", or that there is none.
[[nodiscard]] std::string undercut_text(const Part& part, const SweepCandidate& candidate);
/// At the top of the legend.
void draw_verdict(const PanelContext& context);

}  // namespace moldlight::gui
