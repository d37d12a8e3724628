#include "actions/core_pins.hpp"

#include <algorithm>

#include <glm/geometric.hpp>

namespace moldlight {

namespace {

/// Of a pin through a hole and those that an action forms in line with it.
double pin_length(const SplitMesh& split, const Undercuts& undercuts, const CorePin& pin, std::size_t hole,
                  std::span<const std::size_t> formed) {
  double low = 0.0, high = 0.0;
  for (const std::size_t k : formed) {
    const glm::dvec3 between = undercuts.counted[k].centre - undercuts.counted[hole].centre;
    const double along = glm::dot(between, pin.axis);
    if (glm::length(between - along * pin.axis) > 0.5 * pin.width) continue;
    const double half = 0.5 * extent_along(split, undercuts.counted[k], pin.axis);
    low = std::min(low, along - half);
    high = std::max(high, along + half);
  }
  return high - low;
}

}  // namespace

void set_core_pins(const PartModel& model, const SplitMesh& split, const Release& release,
                   const Undercuts& undercuts, std::span<const UndercutPart> undercut_parts,
                   ActionPlan& plan) {
  constexpr double k_widest = 0.25;  // of the diagonal: more is no pin
  for (const UndercutPart& undercut_part : undercut_parts) {
    const auto action = std::ranges::find_if(plan.actions, [&](const SideAction& each) {
      return (is_slide(each.kind) || each.kind == ActionKind::insert) &&
             std::ranges::find(each.undercuts, undercut_part.undercut) != each.undercuts.end();
    });
    if (action == plan.actions.end() || !undercut_part.whole) continue;
    auto pin = core_pin_of(release, undercut_part.samples, k_widest);
    if (!pin) continue;
    pin->width *= model.frame.diagonal;
    pin->length = pin_length(split, undercuts, *pin, undercut_part.undercut, action->undercuts);
    if (!action->core_pin || action->core_pin->length * pin->width < pin->length * action->core_pin->width)
      action->core_pin = pin;
  }
}

}  // namespace moldlight
