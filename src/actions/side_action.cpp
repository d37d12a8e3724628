#include "actions/side_action.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace moldlight {

bool has_room(const SideAction& action) {
  constexpr double k_enough = 0.99;  // of the room: a travel is found more finely than a room is meant
  return action.kind != ActionKind::lifter ||
         action.clear_to >= action.travel + k_enough * action.room_needed;
}

std::string_view reject_text(RejectReason reason) {
  constexpr std::array<std::string_view, 10> k_texts = {"no room for its thickness beyond its travel",
                                                        "no way out along its half after its travel",
                                                        "no place for its stem down to the ejector plate",
                                                        "its travel is longer than ejectors drive it",
                                                        "its core pin is too thin",
                                                        "its body hits the part",
                                                        "its body hits another one",
                                                        "the rest of its undercut is not released",
                                                        "the part would stretch too far",
                                                        "it leans more than an inclined slide may"};
  return k_texts[static_cast<std::size_t>(reason)];
}

std::string_view stage_text(HitStage stage) {
  return stage == HitStage::rest  ? "at rest"
         : stage == HitStage::way ? "on its way"
                                  : "as the part leaves its half";
}

const SideAction* action_of(const ActionPlan& plan, std::size_t undercut) {
  const auto found = std::ranges::find_if(plan.actions, [&](const SideAction& action) {
    return std::ranges::find(action.undercuts, undercut) != action.undercuts.end();
  });
  return found == plan.actions.end() ? nullptr : &*found;
}

std::string action_title(const ActionPlan& plan, std::size_t action) {
  return fmt::format("{} {}", facts(plan.actions[action].kind).singular, action + 1);
}

std::string released_by_text(const ActionPlan& plan, std::size_t undercut) {
  std::vector<std::string> titles;
  for (std::size_t k = 0; k < plan.actions.size(); ++k)
    if (std::ranges::count(plan.actions[k].undercuts, undercut) > 0) titles.push_back(action_title(plan, k));
  if (titles.empty()) return unreleased_text(plan, undercut);
  const bool in_part = std::ranges::count(plan.unreleased, undercut) > 0;
  return fmt::format("{}{}", fmt::join(titles, " and "), in_part ? ", in part" : "");
}

std::string unreleased_text(const ActionPlan& plan, std::size_t undercut) {
  const std::optional<ActionPin>& pin = plan.undercuts[undercut].pin;
  if (pin && !pin->kind) return "left as it is";
  if (plan.undercuts[undercut].closed_void) return "a closed void, which no mold forms";
  return fmt::format("{} releases {}",
                     pin ? fmt::format("no {}", facts(*pin->kind).singular) : "no action tried",
                     action_of(plan, undercut) == nullptr ? "it" : "the rest of it");
}

std::size_t speck_count(const ActionPlan& plan) {
  return static_cast<std::size_t>(std::ranges::count(plan.specks, false, &Speck::of_undercut));
}

double speck_area(const ActionPlan& plan) {
  double area = 0.0;
  for (const Speck& speck : plan.specks) area += speck.of_undercut ? 0.0 : speck.area;
  return area;
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
    if (!is_stuck(left, plan.undercuts[plan.unreleased[k]].undercut.area, lateral)) continue;
    ++totals.stuck;
    totals.stuck_area += left;
  }
  return totals;
}

UndercutTotals undercut_totals(const ActionPlan& plan) {
  UndercutTotals totals{
      .count = plan.undercuts.size(), .specks = speck_count(plan), .speck_area = speck_area(plan)};
  for (const UndercutReport& noted : plan.undercuts) totals.area += noted.undercut.area;
  return totals;
}

std::string actions_text(const ActionCounts& counts) {
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
