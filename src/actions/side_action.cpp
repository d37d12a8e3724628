#include "actions/side_action.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace moldlight {

bool has_room(const SideAction& action) {
  constexpr double k_rounding = 1e-6;  // of single precision, share of the length
  return action.kind != ActionKind::lifter ||
         action.clear_to >= (action.travel + action.room_needed) * (1.0 - k_rounding);
}

const SideAction* action_of(const ActionPlan& plan, std::size_t patch) {
  const auto found = std::ranges::find_if(plan.actions, [&](const SideAction& action) {
    return std::ranges::find(action.patches, patch) != action.patches.end();
  });
  return found == plan.actions.end() ? nullptr : &*found;
}

std::string unreleased_text(const ActionPlan& plan, std::size_t patch) {
  const std::optional<ActionPin>& pin = plan.patches[patch].pin;
  if (pin && !pin->kind) return "left as it is";
  return fmt::format("{} releases {}",
                     pin ? fmt::format("no {}", facts(*pin->kind).singular) : "nothing that was tried",
                     action_of(plan, patch) == nullptr ? "it" : "the rest of it");
}

bool is_stuck(double left, double area, double lateral) {
  constexpr double k_stuck_share = 0.005;
  return left > k_stuck_share * area && left > lateral * lateral;
}

ActionTotals totals_of(const ActionPlan& plan, double lateral) {
  ActionTotals totals{.unreleased_area = plan.unreleased_area};
  for (const SideAction& action : plan.actions) ++totals.counts[static_cast<std::size_t>(action.kind)];
  for (std::size_t k = 0; k < plan.unreleased.size(); ++k) {
    const double left = plan.unreleased_areas[k];
    if (!is_stuck(left, plan.patches[plan.unreleased[k]].undercut.area, lateral)) continue;
    ++totals.stuck;
    totals.stuck_area += left;
  }
  return totals;
}

UndercutTotals undercut_totals(const ActionPlan& plan) {
  UndercutTotals totals{
      .count = plan.patches.size(), .specks = plan.dropped, .speck_area = plan.dropped_area};
  for (const UndercutReport& patch : plan.patches) totals.area += patch.undercut.area;
  return totals;
}

std::string actions_text(const std::array<std::size_t, k_action_kinds>& counts) {
  std::string text;
  for (std::size_t kind = 0; kind < k_action_kinds; ++kind) {
    if (counts[kind] == 0) continue;
    const ActionFacts& each = facts(static_cast<ActionKind>(kind));
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", counts[kind],
                        counts[kind] == 1 ? each.singular : each.plural);
  }
  return text.empty() ? "none" : text;
}

std::string actions_text(const ActionPlan& plan) { return actions_text(totals_of(plan, 0.0).counts); }

}  // namespace moldlight
