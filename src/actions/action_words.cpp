#include "actions/action_words.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "classify/number_format.hpp"

namespace moldlight {

namespace {

/// Directions about the parting direction are given by their azimuth.
std::string turn_text(double from_deg, double to_deg) {
  return with_minus(fmt::format("{:.1f} to {:.1f}°", from_deg, to_deg));
}

}  // namespace

std::string shared_text(const SideAction& action, std::size_t undercut) {
  std::vector<std::size_t> others;
  for (const std::size_t found : action.undercuts)
    if (found != undercut) others.push_back(found + 1);
  return others.empty() ? std::string() : fmt::format(" · with {}", fmt::join(others, ", "));
}

std::string meets_text(const ActionPlan& plan, const SideAction& action) {
  std::vector<std::size_t> others;
  for (const std::size_t other : action.meets) others.push_back(plan.actions[other].undercuts.front() + 1);
  return others.empty()
             ? std::string()
             : fmt::format(" · meets the {} of {}", action.kind == ActionKind::lifter ? "lifter" : "slide",
                           fmt::join(others, ", "));
}

std::string detail_text(const SideAction& action, const std::string& unit) {
  switch (action.kind) {
    case ActionKind::unscrew:
      return fmt::format("pitch {:.2f} {} · {:.2f} turns{}", std::abs(action.about->pitch), unit,
                         action.about->turns, action.about->pitch < 0.0 ? " · left-handed" : "");
    case ActionKind::strip:
      return fmt::format("strain {:.1f} %", 100.0 * action.about->strain);
    case ActionKind::lifter:
      return fmt::format("stroke {:.1f} {} · free {}", *action.stroke, unit,
                         turn_text(action.interval.from_deg, action.interval.to_deg));
    case ActionKind::insert:
      return "taken off by hand";
    default:
      return "free " + turn_text(action.interval.from_deg, action.interval.to_deg);
  }
}

std::string others_text(const ActionPlan& plan, std::size_t undercut, const SideAction& first) {
  std::string text;
  for (const SideAction& action : plan.actions) {
    if (&action != &first && std::ranges::find(action.undercuts, undercut) != action.undercuts.end())
      text += fmt::format(" · and {}", facts(action.kind).singular);
  }
  return text;
}

}  // namespace moldlight
