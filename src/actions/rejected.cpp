#include "actions/rejected.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <set>
#include <utility>
#include <vector>

namespace moldlight {

namespace {

/// Whether actions of the mold that can be built release all of an undercut.
bool is_well_released(const ActionPlan& plan, std::size_t undercut) {
  return std::ranges::find(plan.unreleased, undercut) == plan.unreleased.end() &&
         std::ranges::all_of(plan.actions, [&](const SideAction& action) {
           return std::ranges::find(action.undercuts, undercut) == action.undercuts.end() ||
                  action.kind != ActionKind::insert;
         });
}

/// Without the reason why it was.
RejectedAction rejected_pull(const PartModel& model, const UndercutPart& undercut_part, const Pull& pull) {
  const glm::dvec3 at(undercut_part.samples.front().position);
  return {.undercut = undercut_part.undercut,
          .kind = pull.kind,
          .direction = pull.direction,
          .travel = pull.travel * model.frame.diagonal,
          .core_side = pull.core_side,
          .place = model.frame.center + model.frame.diagonal * at,
          .room = std::numeric_limits<double>::infinity()};
}

void add_lifters_without_room(const PartModel& model, std::span<const UndercutPart> undercut_parts,
                              ActionPlan& plan) {
  std::set<std::size_t> known;  // the whole undercut comes before its parts
  for (const UndercutPart& undercut_part : undercut_parts) {
    if (undercut_part.rejected.empty() || !known.insert(undercut_part.undercut).second ||
        is_well_released(plan, undercut_part.undercut))
      continue;
    const Pull& pull = undercut_part.rejected.front();
    RejectedAction rejected = rejected_pull(model, undercut_part, pull);
    rejected.reason = pull.lack->reason;
    rejected.place = model.frame.center + model.frame.diagonal * glm::dvec3(pull.lack->at.position);
    rejected.room = pull.lack->room * model.frame.diagonal;
    plan.rejected.push_back(rejected);
  }
}

void add_thin_pins(const PartModel& model, std::span<const UndercutPart> undercut_parts, ActionPlan& plan) {
  const double diagonal = model.frame.diagonal;
  for (const UndercutPart& undercut_part : undercut_parts) {
    if (!undercut_part.thin || is_well_released(plan, undercut_part.undercut)) continue;
    const UndercutSample& at = undercut_part.samples.front();
    plan.rejected.push_back({.undercut = undercut_part.undercut,
                             .kind = ActionKind::slide,
                             .direction = undercut_part.thin->axis,
                             .reason = RejectReason::thin_pin,
                             .place = model.frame.center + diagonal * glm::dvec3(at.position),
                             .room = std::numeric_limits<double>::infinity(),
                             .width = undercut_part.thin->width * diagonal});
  }
}

void add_steep_slides(const PartModel& model, std::span<const UndercutPart> undercut_parts,
                      const glm::dvec3& direction, ActionPlan& plan) {
  for (const UndercutPart& undercut_part : undercut_parts) {
    if (!undercut_part.steep || is_well_released(plan, undercut_part.undercut)) continue;
    RejectedAction rejected = rejected_pull(model, undercut_part, *undercut_part.steep);
    rejected.reason = RejectReason::too_steep;
    rejected.lean_deg = std::abs(elevation_deg(rejected.direction, direction));
    plan.rejected.push_back(rejected);
  }
}

}  // namespace

void keep_rejected(const PartModel& model, std::span<const UndercutPart> undercut_parts,
                   std::span<const RejectedAction> rings, const glm::dvec3& direction, ActionPlan& plan) {
  std::vector<RejectedAction> hitting = std::exchange(plan.rejected, {});
  add_steep_slides(model, undercut_parts, direction, plan);
  add_lifters_without_room(model, undercut_parts, plan);
  add_thin_pins(model, undercut_parts, plan);
  std::ranges::copy_if(rings, std::back_inserter(plan.rejected),
                       [&](const RejectedAction& ring) { return !is_well_released(plan, ring.undercut); });
  for (RejectedAction& rejected : hitting) {
    const auto known = std::ranges::find_if(plan.rejected, [&](const RejectedAction& other) {
      return other.undercut == rejected.undercut && other.kind == rejected.kind;
    });
    if (known == plan.rejected.end() && !is_well_released(plan, rejected.undercut)) {
      plan.rejected.push_back(rejected);
    } else if (known != plan.rejected.end() && known->reason == RejectReason::no_room &&
               rejected.travel < known->travel) {
      *known = rejected;  // the shorter one had room
    }
  }
  std::ranges::stable_sort(plan.rejected, {}, &RejectedAction::undercut);
}

}  // namespace moldlight
