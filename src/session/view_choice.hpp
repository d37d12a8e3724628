// From where a part is best looked at.
#pragma once

#include <glm/gtc/quaternion.hpp>
#include <glm/vec3.hpp>

#include "session/classification.hpp"
#include "session/part_model.hpp"

namespace moldlight {

/// Orientation of a camera (render/camera.hpp) with the parting direction upward, from the side on which most
/// undercut surface is seen, each bit of it counted by how frontal it is; without undercuts, on which most
/// surface of any kind is. The same for the same input, whatever the number of threads.
[[nodiscard]] glm::dquat revealing_orientation(const PartModel& model, const Classification& result);

}  // namespace moldlight
