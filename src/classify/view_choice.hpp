// From where a part is best looked at.
#pragma once

#include <memory>
#include <span>

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "classify/part_model.hpp"
#include "mold/exact/split_mesh.hpp"

namespace moldlight {

/// Orientation of a camera (render/camera.hpp) with `up` (unit) upward, from the side on which most undercut
/// surface is seen, each bit of it counted by how frontal it is; without undercuts, on which most surface of
/// any kind is. `splits` are the part's mesh split for one parting direction or several, each of which counts
/// the same. The same for the same input, whatever the number of threads.
[[nodiscard]] glm::dquat revealing_orientation(const PartModel& model,
                                               std::span<const std::shared_ptr<const SplitMesh>> splits,
                                               const glm::dvec3& up);

}  // namespace moldlight
