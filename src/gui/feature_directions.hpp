// Directions that the part's own shape suggests; the direction snaps to them while Ctrl is held.
#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "session/part_model.hpp"

namespace moldlight::gui {

struct FeatureDirection {
  glm::dvec3 direction{0, 0, 1};  // unit; its opposite is meant too
  std::string reason;
};

/// The axes of the file, axes of round walls, normals of large planes, directions along much wall area.
[[nodiscard]] std::vector<FeatureDirection> feature_directions(const PartModel& model,
                                                               const Progress& progress);

/// The nearest feature or its opposite, however far; the direction itself where there is no feature.
[[nodiscard]] glm::dvec3 snapped_to(const std::vector<FeatureDirection>& features,
                                    const glm::dvec3& direction);

}  // namespace moldlight::gui
