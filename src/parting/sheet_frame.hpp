// Where the sheets of a part are.
#pragma once

#include <glm/vec3.hpp>

#include "parting/mold_halves.hpp"

namespace moldlight {

/// Where sheets are: in the mold's frame about a centre, in diagonals of the part.
struct SheetFrame {
  MoldFrame frame;
  glm::dvec3 centre{0.0};
  double diagonal = 1.0;

  [[nodiscard]] glm::dvec3 in_mold(const glm::dvec3& at) const {
    return frame.to_mold((at - centre) / diagonal);
  }
  [[nodiscard]] glm::dvec3 in_part(const glm::dvec3& at) const {
    return centre + diagonal * frame.to_part(at);
  }
};

}  // namespace moldlight
