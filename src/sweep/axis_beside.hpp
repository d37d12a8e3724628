// The axis of the part that a direction leans from by less than the required draft: walls along it lean back
// for that direction, which undercut alone does not always show.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "classify/part_model.hpp"
#include "sweep/candidates/candidate.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight {

/// Axes of the file and of round walls, normals of planes, and what much surface is perpendicular to.
[[nodiscard]] std::vector<Candidate> axes_of(std::span<const Candidate> candidates);

/// Of the axes within `tau_deg` of the direction or its opposite the one that comes first, on the direction's
/// side; none where the direction is one of them, up to what merges candidates.
[[nodiscard]] std::optional<AxisBeside> axis_beside(std::span<const Candidate> axes,
                                                    const glm::dvec3& direction, double tau_deg);

/// "0.43° from z: 12.3 mm² undercut, reverse draft 0 in place of 5.1 mm²"; empty where there is none beside.
[[nodiscard]] std::string axis_beside_text(const PartModel& model, const SweepCandidate& candidate);

}  // namespace moldlight
