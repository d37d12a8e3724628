// From where a part is best looked at.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "classify/part_model.hpp"
#include "mold/exact/split_mesh.hpp"

namespace moldlight {

/// Orientation of a camera (render/camera.hpp) with the parting direction upward, from the side on which most
/// undercut surface is seen, each bit of it counted by how frontal it is; without undercuts, on which most
/// surface of any kind is. `direction` is a unit vector, `split` the part's mesh split for it. The same for
/// the same input, whatever the number of threads.
[[nodiscard]] glm::dquat revealing_orientation(const PartModel& model, const SplitMesh& split,
                                               const glm::dvec3& direction);

}  // namespace moldlight
