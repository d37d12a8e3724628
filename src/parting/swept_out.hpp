// What of a solid between the halves a slide can take out with it, where several actions form that solid.
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"
#include "parting/slide_blank.hpp"

namespace moldlight {

/// Closed solids that fill the whole between them: what nothing of the rest stands before on its way out, and
/// the rest. Walls between them are along the way.
struct SweptOut {
  TriangleMesh moved;
  std::vector<TriangleMesh> left;
};
/// `body`: closed, with the whole of the blank's end in its surface; all in one frame, in diagonals of the
/// part. `way`: unit. Nothing where they do not close. Throws Cancelled.
[[nodiscard]] std::optional<SweptOut> swept_out(const TriangleMesh& body, const SlideBlank& blank,
                                                const glm::dvec3& way, const Progress& progress);

}  // namespace moldlight
