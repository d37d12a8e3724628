// Directions in which a side action may pull an undercut.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "actions/action_settings.hpp"
#include "actions/undercut.hpp"

namespace moldlight {

/// Where a direction comes from: what it says about how well it is meant, the best first. Wish: the user's
/// own. Exact: the axis of a round wall of the undercut. Part: where most of the part's walls face. Shape:
/// normals and edges of planes of the undercut. Even: one of many.
enum class PullSource : std::uint8_t { wish, exact, part, shape, even };

struct PullCandidate {
  glm::dvec3 direction{1, 0, 0};  // unit
  PullSource source = PullSource::even;
  bool of_hole = false;  // exact, and its wall faces the axis
};

/// What the part, and the surface of one undercut, suggest, both senses: directions of the part's walls, axes
/// of round walls, normals of its planes, the edges between them, its mean normal; each as it is, if it is
/// within the incline of the plane across the parting direction, and put into that plane. The user's
/// directions are among them. The best meant first, then by where they point.
struct PulledSurface {
  const PartModel& model;
  const SplitMesh& split;
  const PartAxes& axes;
};
[[nodiscard]] std::vector<PullCandidate> own_pulls(const PulledSurface& surface, const Undercut& undercut,
                                                   const ActionSettings& settings);

/// Every 5 degrees in the plane across the parting direction, from x on.
[[nodiscard]] std::vector<PullCandidate> pull_fan(const PartAxes& axes);

/// All round: what a loose insert may be taken off along, beside own_pulls() of any incline.
[[nodiscard]] std::vector<PullCandidate> pull_sphere(const PartAxes& axes);

/// Angle to the plane across `direction`, degrees, [-90, 90].
[[nodiscard]] double elevation_deg(const glm::dvec3& pull, const glm::dvec3& direction);

}  // namespace moldlight
