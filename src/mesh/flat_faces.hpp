// A mesh as CAD programs have it: facets that lie in one plane are a face, with straight edges around it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Numbers of vertices are the mesh's.
struct FlatFaces {
  struct Edge {
    VertexIndex from = 0, to = 0;
  };
  /// An edge in the walk around a face.
  struct Use {
    std::uint32_t edge = 0;
    bool backwards = false;
  };
  using Loop = std::vector<Use>;
  struct Face {
    glm::dvec3 point{0.0}, normal{0.0};  // of its plane; unit, outward
    std::vector<Loop> loops;             // the outer one first; counter-clockwise seen from outside
    std::uint32_t shell = 0;
  };
  /// Faces that hang together.
  struct Shell {
    double volume = 0.0;  // negative: of a void
    Bounds bounds = {};
  };

  std::vector<Edge> edges;  // between two faces, or at the rim of one
  std::vector<Face> faces;
  std::vector<Shell> shells;
};

/// Facets of one face lie within `tolerance` (mesh's unit) of its plane, and vertices between two edges that
/// are one within it of that edge. Facets that are thinner than that go with the one at their longest edge.
/// An edge of the mesh that is not of two facets which walk it in opposite ways is a rim of each of them.
[[nodiscard]] FlatFaces flat_faces(const TriangleMesh& mesh, double tolerance);

}  // namespace moldlight
