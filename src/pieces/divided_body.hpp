// A body between the halves that no single direction releases, divided by planes into bodies that move out
// along one direction each.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// A direction in the mold's frame, and its number.
struct PieceWay {
  std::size_t direction = 0;
  glm::dvec3 way{0, 0, 1};  // unit
};

/// Lengths in diagonals of the part, in the mold's frame.
struct DivisionTask {
  const TriangleMesh& part;
  std::vector<PieceWay> ways;  // the first that goes is taken
  double tolerance = 0.0;      // so much of the part may stand in a way
};

struct BodyShare {
  TriangleMesh mesh;
  std::optional<std::size_t> direction;  // none: it stays
};

/// The body whole where a direction releases it or where no plane parts off enough of it; else its shares. A
/// plane is parallel to a face of the body or leans from it to the way of what it parts off, which moves away
/// from it; of planes that part off about as much one across an axis comes first. Throws Cancelled.
[[nodiscard]] std::vector<BodyShare> divided_body(const DivisionTask& task, TriangleMesh body,
                                                  const Progress& progress);

}  // namespace moldlight
