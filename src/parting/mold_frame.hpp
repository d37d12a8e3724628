// The mold's own axes: z is the parting direction.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace moldlight {

/// Right-handed orthonormal axes.
struct MoldFrame {
  glm::dvec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

  [[nodiscard]] glm::dvec3 to_mold(const glm::dvec3& part) const {
    return {glm::dot(part, x), glm::dot(part, y), glm::dot(part, z)};
  }
  [[nodiscard]] glm::dvec3 to_part(const glm::dvec3& mold) const {
    return mold.x * x + mold.y * y + mold.z * z;
  }
};

/// For a unit direction. Along an axis of the part the mold's axes are the part's, in another order, so that
/// coordinates stay what they are to the bit.
[[nodiscard]] MoldFrame mold_frame(const glm::dvec3& direction);

/// 0, 1, 2 where the direction is along that axis of the part, either way; else -1.
[[nodiscard]] int axis_of(const glm::dvec3& direction);

}  // namespace moldlight
