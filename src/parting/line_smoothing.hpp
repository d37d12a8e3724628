// The parting line, straightened where the mesh is wavy: on surface that either half may form it need not run
// along the mesh's edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "parting/assignment.hpp"

namespace moldlight {

/// Moves points of closed loops over free surface of one assignment, which must outlive it.
class LineSmoother {
 public:
  explicit LineSmoother(const Assignment& assignment);

  /// A loop of the mesh: edge k runs from vertex k to the next.
  struct Loop {
    std::span<const VertexIndex> vertices;
    std::span<const std::uint32_t> edges;
  };

  /// Where the loop's vertices go. A point moves where neither of its edges is a crease, over free pieces
  /// around its vertex and those next to them, if length plus three times the climb of its edges becomes
  /// less, and if points between it and its neighbours, too, are nearer to free pieces than to others and no
  /// farther off them than a ten-thousandth of the diagonal. All stay where they are if nothing of note is
  /// gained.
  [[nodiscard]] std::vector<glm::dvec3> smoothed(const Loop& loop) const;

 private:
  struct Nearest {
    glm::dvec3 free{0.0};                   // nearest point on a free piece
    double to_free = 0.0, to_others = 0.0;  // distances; infinite where there are none
  };
  [[nodiscard]] std::vector<PieceIndex> around(VertexIndex vertex) const;
  [[nodiscard]] Nearest nearest(std::span<const PieceIndex> pieces, const glm::dvec3& at) const;
  [[nodiscard]] bool may_run(std::span<const PieceIndex> near_a, std::span<const PieceIndex> near_b,
                             const glm::dvec3& a, const glm::dvec3& b) const;

  const Assignment& assignment_;
  std::vector<std::uint32_t> first_;  // of each vertex, in pieces_
  std::vector<PieceIndex> pieces_;    // around every vertex
  double tolerance_ = 0.0;
};

}  // namespace moldlight
