#include "actions/mold_opening.hpp"

#include <algorithm>
#include <array>

namespace moldlight {

namespace {

/// Ends of the three stages on the slider: what moves has as much of it as the others, however long its way.
std::array<double, 3> stage_ends(const OpeningWays& ways) {
  const double slides = ways.first > 0.0 ? 1.0 : 0.0, lifters = ways.last > 0.0 ? 1.0 : 0.0;
  const double stages = slides + 1.0 + lifters;
  return {slides / stages, (slides + 1.0) / stages, 1.0};
}

}  // namespace

bool goes_first(const SideAction& action) {
  return action.kind != ActionKind::lifter && action.kind != ActionKind::insert && action.travel > 0.0;
}

std::string first_moves_text(const ActionPlan& plan) {
  ActionCounts counts{};
  std::size_t all = 0;
  for (const SideAction& action : plan.actions) {
    if (!goes_first(action)) continue;
    ++counts[static_cast<std::size_t>(action.kind)];
    ++all;
  }
  std::string text = actions_text(counts);
  if (const std::size_t last = text.rfind(", "); last != std::string::npos) text.replace(last, 2, " and ");
  return text + (all == 1 ? " moves out first." : " move out first.");
}

OpeningWays ways_of(const ActionPlan* plan) {
  OpeningWays ways;
  if (plan == nullptr) return ways;
  for (const SideAction& action : plan->actions) {
    double& way = goes_first(action) ? ways.first : ways.last;
    way = std::max(way, action.travel);
  }
  return ways;
}

OpenedMold opened_mold(const ActionPlan* plan, double open) {
  const auto ends = stage_ends(ways_of(plan));
  const auto done = [&](double from, double to) {
    return to > from ? std::clamp((open - from) / (to - from), 0.0, 1.0) : 0.0;
  };
  return {.slides = done(0.0, ends[0]), .halves = done(ends[0], ends[1]), .lifters = done(ends[1], ends[2])};
}

double slides_end(const ActionPlan* plan) { return stage_ends(ways_of(plan))[0]; }

}  // namespace moldlight
