// What the bar of the mold says, also to what else asks.
#pragma once

#include "gui/panels/panels.hpp"

namespace moldlight::gui {

/// Not while directions are compared or chosen on the large ball, which leaves no room for it.
[[nodiscard]] bool has_mold_bar(const AppState& state);

/// Why there are no halves, where, and what to change; empty where there are. The solids must be there.
[[nodiscard]] std::string halves_refusal(const AppState& state);

/// A line of what is said of the halves.
struct HalvesLine {
  std::string text;
  bool doubt = false;  // something is to be done
};
[[nodiscard]] std::vector<HalvesLine> halves_lines(const AppState& state);

}  // namespace moldlight::gui
