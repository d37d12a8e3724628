// The columns of the table of directions: what they show and how they sort.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "gui/app_state.hpp"

namespace moldlight::gui {

struct SweepColumn {
  std::string_view name, help;
  float width = 0.0F;  // layout units; 0: what is left
  bool right = true;   // set to the right
  std::string (*text)(const AppState& state, const SweepCandidate& candidate);
  double (*key)(const SweepCandidate& candidate);  // null: cannot be sorted by
};
[[nodiscard]] std::span<const SweepColumn> sweep_columns();

/// Whether another candidate of the result is in the same tie group.
[[nodiscard]] bool ties(const SweepResult& result, const SweepCandidate& candidate);
/// "axis of 4 cylinders or cones, 3.1 % of the surface"; the first of the sources, or all of them, a line
/// each.
[[nodiscard]] std::string first_reason(const SweepCandidate& candidate);
[[nodiscard]] std::string all_reasons(const SweepCandidate& candidate);

}  // namespace moldlight::gui
