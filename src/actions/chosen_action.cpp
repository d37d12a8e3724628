#include "actions/chosen_action.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

constexpr std::size_t k_corners = 64;        // deepest ones that a travel is found for
constexpr std::size_t k_turned = 200;        // samples that show how far a lifter may turn
constexpr double k_fine_step = 1.0 / 512.0;  // of travels, share of the diagonal
constexpr double k_rank_turn_deg = 0.01;     // how finely a turn is found for a rank

/// Where a travel is found: what lies farthest against the pull, and some of the rest.
std::vector<UndercutSample> deepest(const ChosenContext& context,
                                    const std::vector<UndercutPart>& undercut_parts,
                                    const ActionOption& option, const std::vector<UndercutSample>& samples,
                                    const glm::dvec3& pull) {
  const auto some = static_cast<std::ptrdiff_t>(std::min(samples.size(), 2 * k_corners));
  std::vector<UndercutSample> chosen(samples.begin(), samples.begin() + some);
  for (const std::size_t k : option.undercut_parts) {
    if (!undercut_parts[k].whole) continue;
    const auto corners = deepest_corners(
        context.model, context.split, context.undercuts.counted[undercut_parts[k].undercut], pull, k_corners);
    chosen.insert(chosen.end(), corners.begin(), corners.end());
  }
  return chosen;
}

/// How far they move, specks that stay behind aside, until the part is in the way of one: `travel` or more.
double reach_of(const Release& release, std::span<const UndercutSample> samples, const glm::dvec3& pull,
                double travel) {
  double reach = std::numeric_limits<double>::infinity();
  for (const UndercutSample& sample : samples) {
    const double length = release.free_length(sample, pull);
    if (length >= travel) reach = std::min(reach, length);
  }
  return reach;
}

}  // namespace

double clear_length(const Release& release, std::span<const UndercutSample> samples, LifterWay way) {
  constexpr double k_resolved = 1e-7;
  FreeLengths lengths(release, samples, way.pull);
  double bad = way.length;
  for (const double longer : {1.002, 1.01, 1.05}) {
    double good = way.length = longer * bad;
    if (!release.clears(lengths, way)) continue;
    while (good - bad > k_resolved) {
      way.length = 0.5 * (good + bad);
      (release.clears(lengths, way) ? good : bad) = way.length;
    }
    return good;
  }
  return bad;
}

SideAction chosen_action(const ChosenContext& context, const std::vector<UndercutPart>& undercut_parts,
                         const ActionOption& option) {
  const Release& release = context.pulls.release();
  const double diagonal = context.model.frame.diagonal;
  const std::vector<UndercutSample> samples = samples_of(undercut_parts, option.undercut_parts);
  Pull pull = option.pull;
  SideAction action;
  for (const std::size_t k : option.undercut_parts) {
    action.undercuts.push_back(undercut_parts[k].undercut);
    action.area += undercut_parts[k].area();
  }
  std::ranges::sort(action.undercuts);
  action.undercuts.erase(std::unique(action.undercuts.begin(), action.undercuts.end()),
                         action.undercuts.end());
  action.kind = pull.kind;
  action.about = pull.about;
  if (pull.kind == ActionKind::lifter) {
    const glm::dvec3& axis = context.pulls.direction();
    LifterWay way{pull.direction, pull.core_side ? axis : -axis, pull.travel};
    way.length = pull.travel =
        clear_length(release, deepest(context, undercut_parts, option, samples, pull.direction), way);
    action.stroke = pull.travel * diagonal / std::tan(glm::radians(context.settings.lifter_angle_deg));
    action.clear_to = reach_of(release, samples, pull.direction, pull.travel) * diagonal;
    action.room_needed = context.pulls.lifter_room() * diagonal;
    for (const std::size_t k : option.undercut_parts) {
      std::optional<Stem> stem = context.pulls.stem_of(undercut_parts[k].samples, way);
      if (!stem) continue;
      stem->top = context.model.frame.center + diagonal * stem->top;
      stem->width *= diagonal;
      stem->behind *= diagonal;
      action.stems.push_back(*stem);
    }
    if (context.detail == PlanDetail::whole)
      pull.interval =
          release.lifter_turn(std::span(samples).first(std::min(samples.size(), k_turned)), way, axis);
  } else if (is_slide(pull.kind)) {
    const double resolved_deg = context.detail == PlanDetail::whole ? k_exact_turn_deg : k_rank_turn_deg;
    if (!pull.kept) {
      pull = context.pulls.in_the_middle(samples, {pull.direction, pull.source}, pull.kind, resolved_deg);
      pull = context.pulls.on_part_axis(samples, pull).value_or(pull);
    }
    pull = context.pulls.on_file_axis(samples, pull);
    context.pulls.set_travel(deepest(context, undercut_parts, option, samples, pull.direction), k_fine_step,
                             pull);
  }
  const double clearance = is_slide(pull.kind) ? context.settings.clearance_mm * context.unit_per_mm : 0.0;
  action.travel = pull.travel * diagonal + clearance;
  action.direction = pull.direction;
  action.interval = pull.interval;
  action.core_side = pull.core_side;
  return action;
}

}  // namespace moldlight
