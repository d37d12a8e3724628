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
/// own. Exact: an axis of the part. Shape: normals and edges of planes. Even: one of many.
enum class PullSource : std::uint8_t { wish, exact, shape, even };

struct PullCandidate {
  glm::dvec3 direction{1, 0, 0};  // unit
  PullSource source = PullSource::even;
};

/// What the surface of one undercut suggests, both senses: axes of round walls, normals of its planes, the
/// edges between them, its mean normal; each as it is, if it is within the incline of the plane across
/// `direction`, and put into that plane. The user's directions are among them.
[[nodiscard]] std::vector<PullCandidate> own_pulls(const PartModel& model, const SplitMesh& split,
                                                   const Undercut& undercut, const glm::dvec3& direction,
                                                   const ActionSettings& settings);

/// Every 5 degrees in the plane across `direction`.
[[nodiscard]] std::vector<PullCandidate> pull_fan(const glm::dvec3& direction);

/// All round: what a loose insert may be taken off along, beside own_pulls() of any incline.
[[nodiscard]] std::vector<PullCandidate> pull_sphere();

/// Angle to the plane across `direction`, degrees, [-90, 90].
[[nodiscard]] double elevation_deg(const glm::dvec3& pull, const glm::dvec3& direction);

}  // namespace moldlight
