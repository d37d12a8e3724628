// The faces of a part: what a designer takes for one surface, a plane, a round wall, a fillet. Those of CAD
// where the file has them; else facets put together by how the surface bends.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/adjacency.hpp"
#include "mesh/facet_geometry.hpp"
#include "mesh/part.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight {

/// Every facet is in one face.
struct Faces {
  std::vector<std::uint32_t> of_facet;
  std::vector<std::uint32_t> starts;  // of each face among the members, and one more
  std::vector<FacetIndex> members;    // ascending within a face

  [[nodiscard]] std::size_t count() const { return starts.size() - 1; }
  [[nodiscard]] std::span<const FacetIndex> facets(std::uint32_t face) const {
    return std::span(members).subspan(starts[face], starts[face + 1] - starts[face]);
  }
};

/// Facets that lie in one plane make a plate; plates are one face where they are steps of one bend: it is
/// below 20 degrees (a full turn in 19 steps or more), the plates are about as wide, and one of them bends on
/// to a third. So a round wall is one face, a plane ends where its fillet begins, and a roof has two sides.
/// In the order of their first facets; a face hangs together.
[[nodiscard]] Faces smooth_faces(const TriangleMesh& mesh, const FacetGeometry& geometry,
                                 const Adjacency& adjacency);

/// The faces of CAD, numbered as in the file, some of which may be empty, with what a repair added as the
/// last one; else smooth_faces(), numbered by which of their facets the file lists first.
[[nodiscard]] Faces part_faces(const Part& part, const FacetGeometry& geometry, const Adjacency& adjacency);

}  // namespace moldlight
