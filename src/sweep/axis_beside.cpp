#include "sweep/axis_beside.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "classify/figure_table.hpp"
#include "mold/direction.hpp"

namespace moldlight {

namespace {

constexpr double k_same_deg = 0.02;

bool is_axis(const CandidateSource& source) {
  return source.kind >= CandidateKind::axis && source.kind <= CandidateKind::perpendicular;
}

}  // namespace

std::vector<Candidate> axes_of(std::span<const Candidate> candidates) {
  std::vector<Candidate> axes;
  std::ranges::copy_if(candidates, std::back_inserter(axes), [](const Candidate& candidate) {
    return std::ranges::any_of(candidate.sources, is_axis);
  });
  return axes;
}

std::optional<AxisBeside> axis_beside(std::span<const Candidate> axes, const glm::dvec3& direction,
                                      double tau_deg) {
  std::optional<AxisBeside> found;
  for (const Candidate& axis : axes) {
    const double angle = line_angle_deg(axis.direction, direction);
    if (angle <= k_same_deg) return std::nullopt;
    if (found || angle > tau_deg) continue;
    found =
        AxisBeside{.direction = glm::dot(axis.direction, direction) < 0.0 ? -axis.direction : axis.direction,
                   .reason = std::ranges::find_if(axis.sources, is_axis)->reason,
                   .angle_deg = angle,
                   .classification = {}};
  }
  return found;
}

std::string axis_beside_text(const PartModel& model, const SweepCandidate& candidate) {
  if (!candidate.axis) return {};
  const AxisBeside& axis = *candidate.axis;
  const FigureStyle style(model);
  const auto area = [&style](double value) { return style.with_unit(FigureKind::area, value); };
  return fmt::format(
      "{:.2g}° from {} ({}): {} undercut, reverse draft {} in place of {}", axis.angle_deg,
      direction_words(axis.direction), axis.reason, area(axis.classification.areas[Region::undercut]),
      area(axis.classification.reverse_draft.area), area(candidate.classification.reverse_draft.area));
}

}  // namespace moldlight
